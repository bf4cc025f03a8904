//! The answer of a hardness test.
//!
//! The edge of a contact lies between two nodes, so that the half-width under a force scatters by
//! an element. Meyer's law `F = k d^m`, fitted by least squares to the increments from a quarter of
//! the force on, has the radius a under the force; its standard error and 0.3 h/a bound the error.
//!
//! Beside the mean pressure p stands that of published results with large strains. Balls: D.
//! Tabor, *The Hardness of Metals* (1951), `p = 2.8 σ(0.2 a/R)` with full plasticity. Cones of
//! 70.3°: M. Dao et al., Acta Mater. 49 (2001) 3899, `p/E* = 0.268536 (0.9952495 − h_r/h_m)^1.1142735`
//! from the depths under load and after it, and their loading curvature F/h² from the stress at a
//! plastic strain of 3.3 %.

mod answer;
mod found;
mod remarks;
mod result;
mod seen;

use self::found::Found;
pub use self::result::{HardnessReport, OliverPharrReport};
pub(super) use self::seen::Seen;
use self::seen::is_pyramid;
use super::error_bars::under_its_force;
use super::findings::Finding;
use super::validity;
use crate::job::{Job, Material};
use crate::solver::{SolveStatus, StepSolution};
use crate::units::UnitConverter;

/// Tabor's strains of a ball over a/R and of a pyramid.
const BALL_STRAIN: f64 = 0.2;
const PYRAMID_STRAIN: f64 = 0.08;
/// Strain of Dao's curvature.
const DAO_STRAIN: f64 = 0.033;

/// The loads of a test, as they are solved.
#[derive(Debug, Clone, Default)]
pub(super) struct HardnessSeen(Vec<Seen>);

impl HardnessSeen {
    /// Records a load.
    pub fn see(&mut self, load: Option<Seen>) {
        self.0.extend(load);
    }

    /// Returns the number of the largest load, from 0.
    pub fn loaded(&self, job: &Job) -> Option<usize> {
        let force = job.load.hardness()?.force();
        self.0.iter().position(|seen| seen.force >= 0.999 * force)
    }

    /// Returns the report, or `None` of another job and where the largest force has no answer.
    pub fn finish(self, job: &Job, write: UnitConverter) -> Option<HardnessReport> {
        let test = job.load.hardness()?;
        let loaded = self.loaded(job)?;
        let Material::Deformable(specimen) = &job.lower.material else { return None };
        let indenter = test.elastic()?;
        let modulus = 1.0
            / (1.0 / specimen.elastic().plane_strain_modulus()
                + 1.0 / indenter.plane_strain_modulus());
        let law = specimen.hardening_law();
        let found = Found::of(test, job, &self.0, loaded)?;
        let strain = match test.slope() {
            None => BALL_STRAIN * found.radius / test.radius(),
            Some(_) => PYRAMID_STRAIN,
        };
        let flow_stress = law.as_ref().map(|law| law.stress(strain));
        let published = found.published(modulus, flow_stress);
        let curvature = law
            .as_ref()
            .filter(|_| is_pyramid(test))
            .and_then(|law| dao_curvature(modulus, law.stress(DAO_STRAIN)));
        let curvature_bias = curvature
            .map(|curvature| found.load().force / found.load().approach.powi(2) / curvature - 1.0);
        Some(HardnessReport {
            test: test.name(),
            number: found.number(),
            relative_error: found.relative_error(),
            number_error: found.number_error(),
            bias: published.map(|(pressure, _)| found.pressure() / pressure - 1.0),
            bias_source: published.map(|(_, source)| source.to_owned()),
            force: write.force(found.load().force),
            diameter: write.length(found.diameter()),
            depth: write.length(found.load().dent),
            depth_error: found.depth_error(),
            permanent_depth: found.unloaded().map(|seen| write.length(seen.dent)),
            rim_diameter: found
                .unloaded()
                .filter(|seen| seen.highest[1] > 0.0)
                .map(|seen| write.length(2.0 * seen.highest[0].abs())),
            pile_up: write.length(found.edge_height()),
            mean_pressure: write.stress(found.pressure()),
            meyer_exponent: found.fit.map(|fit| fit.exponent),
            representative_strain: law.as_ref().map(|_| strain),
            flow_stress: flow_stress.map(|stress| write.stress(stress)),
            constraint: flow_stress.map(|stress| found.pressure() / stress),
            oliver_pharr: found.oliver_pharr(modulus, write),
            curvature_bias,
            least_thickness: found.least_thickness().map(|least| write.length(least)),
            remarks: validity::remarks(&found.findings(published.is_some()), write),
        })
    }
}

/// Returns what is seen of a load of a hardness test; `None` of another job.
pub(super) fn indentation(job: &Job, step: &StepSolution, findings: &[Finding]) -> Option<Seen> {
    job.load.hardness()?;
    // The last iteration of a step that was stopped has no displacements.
    let specimen = step.field.bodies[1].as_ref().filter(|_| !step.status.is_stopped())?;
    let surface = specimen.surface();
    let highest = surface.iter().copied().fold([0.0; 2], |a, b| if b[1] > a[1] { b } else { a });
    let increments = step.path.increments.iter();
    Some(Seen {
        force: step.figures.force,
        approach: step.figures.approach,
        approach_bar: under_its_force(step, findings).and_then(|bars| bars.approach),
        half_width: step.figures.half_width,
        spacing: step.field.spacing,
        stiffness: step.field.unloading_stiffness,
        dent: specimen.dent_depth(),
        has_yielded: specimen.has_yielded(),
        highest,
        surface,
        increments: increments.map(|end| [end.force, end.half_width]).collect(),
        is_converged: step.status == SolveStatus::Converged,
    })
}

/// Dao's loading curvature of an E* and the stress at his strain, within the moduli over stress of
/// his materials \[MPa\].
fn dao_curvature(modulus: f64, stress: f64) -> Option<f64> {
    let x = (modulus / stress).ln();
    let ratio = ((-1.131 * x + 13.635) * x - 30.594) * x + 29.267;
    (3.0..6.3).contains(&x).then_some(ratio * stress)
}
