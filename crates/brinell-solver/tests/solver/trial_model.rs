//! A constitutive model that the solver does not know: the seam between them is all that it needs.

use std::sync::Arc;

use brinell_solver::fem::assembly::MaterialModel;
use brinell_solver::fem::mesh::Outline;
use brinell_solver::inputs::run_with;
use brinell_solver::job::Job;
use brinell_solver::material::{
    ConstitutiveModel, ElasticModuli, FlowPlasticity, HardeningLaw, OutOfPlane, PointResponse,
    ReturnMapping, Solid, von_mises,
};
use brinell_solver::solver::{ModelOf, Options, Solution, SolveStatus, Unobserved};

use crate::problems::assert_within;

/// Incremental J2 plasticity with `q = σ_y + H p`, where the out-of-plane strain is known: the
/// radial return of J. C. Simo, T. J. R. Hughes, *Computational Inelasticity* (1998), box 3.1.
#[derive(Debug)]
struct LinearIsotropicFlow {
    elastic: ElasticModuli,
    law: Arc<dyn HardeningLaw>,
    yield_stress: f64,
    plastic_modulus: f64,
}

#[derive(Debug, Clone, Copy, Default)]
struct Memory {
    /// `[ε_xx, ε_yy, ε_zz, γ_xy]`.
    plastic_strain: [f64; 4],
    accumulated: f64,
}

impl ConstitutiveModel for LinearIsotropicFlow {
    type State = Memory;

    fn elastic(&self) -> ElasticModuli {
        self.elastic
    }

    fn out_of_plane(&self) -> OutOfPlane {
        OutOfPlane::Strained
    }

    fn hardening(&self) -> Option<&dyn HardeningLaw> {
        Some(&*self.law)
    }

    fn has_memory(&self) -> bool {
        true
    }

    fn update(&self, strain: [f64; 4], state: &Memory) -> (PointResponse, Memory) {
        let elastic_strain = std::array::from_fn(|k| strain[k] - state.plastic_strain[k]);
        let trial = self.elastic.stress(elastic_strain, OutOfPlane::Strained);
        let equivalent = von_mises(trial);
        let excess = equivalent - self.yield_stress - self.plastic_modulus * state.accumulated;
        let growth = (excess / (3.0 * self.elastic.shear + self.plastic_modulus)).max(0.0);
        let mean = (trial[0] + trial[1] + trial[2]) / 3.0;
        let normal = [trial[0] - mean, trial[1] - mean, trial[2] - mean, 2.0 * trial[3]]
            .map(|deviator| if growth > 0.0 { 1.5 * deviator / equivalent } else { 0.0 });
        let memory = Memory {
            plastic_strain: std::array::from_fn(|k| state.plastic_strain[k] + growth * normal[k]),
            accumulated: state.accumulated + growth,
        };
        let stress = self.elastic.stress(
            std::array::from_fn(|k| strain[k] - memory.plastic_strain[k]),
            OutOfPlane::Strained,
        );
        let response = PointResponse {
            stress,
            secant_shear: self.elastic.shear,
            equivalent_plastic_strain: memory.accumulated,
            yielded: memory.accumulated > 0.0,
            ..PointResponse::default()
        };
        (response, memory)
    }
}

fn trial_model(material: &Solid, _: &Outline, _: OutOfPlane) -> Arc<dyn MaterialModel> {
    let law = Arc::clone(material.hardening_law().unwrap());
    // E = 210 GPa and a tangent modulus of 5 %: H = E E_t / (E - E_t).
    Arc::new(LinearIsotropicFlow {
        elastic: material.moduli(),
        yield_stress: law.yield_stress(),
        plastic_modulus: 210_000.0 * 0.05 / 0.95,
        law,
    })
}

/// The solver's own flow theory, backward Euler over an increment as a whole.
fn own_model(material: &Solid, _: &Outline, out_of_plane: OutOfPlane) -> Arc<dyn MaterialModel> {
    let elastic = material.moduli();
    let mapping = ReturnMapping::new(Arc::clone(material.hardening_law().unwrap()), elastic.shear);
    Arc::new(FlowPlasticity::new(elastic, mapping, [], out_of_plane).with_substeps(1))
}

fn solve(model: ModelOf) -> Solution {
    let body = r#"{"shape": {"type": "cylinder", "radius": 20}, "material": {"young_modulus": 210000,
        "poisson_ratio": 0.3,
        "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10500}}}"#;
    let job = format!(
        r#"{{"analysis": "plane_strain", "upper": {body}, "lower": {body},
        "load": {{"history": [{{"force": 306}}, {{"force": 612.6106}}, {{"force": 0}}]}},
        "mesh": {{"elements_per_half_width": 10}},
        "solver": {{"theory": "flow", "increments": 1, "tolerance": 1e-9}}}}"#
    );
    let job = Job::from_json(job.as_bytes()).unwrap();
    run_with(&job, Options { model: Some(model), ..Options::default() }, &mut Unobserved).unwrap()
}

#[test]
fn a_model_with_a_state_is_solved_as_it_is() {
    let (trial, own) = (solve(trial_model), solve(own_model));
    assert_eq!(trial.steps.len(), 3);
    // Every increment ends a load: those on the way to one end before the tolerance.
    for (trial, own) in trial.steps.iter().zip(&own.steps) {
        assert_eq!(trial.status, SolveStatus::Converged);
        assert_eq!(trial.path.increments.len(), 1);
        assert_within(trial.figures.approach, own.figures.approach, 1e-8);
    }
    assert_within(trial.steps[1].figures.peak_pressure, own.steps[1].figures.peak_pressure, 1e-8);
    // A dent stays.
    assert!(trial.steps[2].figures.approach > 1e-3, "{}", trial.steps[2].figures.approach);
}
