//! The job as mechanics sees it: two outlines with materials and supports.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::analytical::{ElasticConstants, effective_modulus, effective_modulus_plane_stress};
use crate::fem::assembly::{MaterialModel, out_of_plane};
use crate::fem::element::StressState;
use crate::fem::mesh::Outline;
use crate::job::{Analysis, Body, Deformable, Job, Material, Support};
use crate::material::{
    BackstressTerm, DeformationPlasticity, ElasticModuli, FlowPlasticity, HardeningLaw, OutOfPlane,
    ReturnMapping,
};

/// Two bodies whose surfaces first touch where their gap is smallest.
pub(crate) struct Problem {
    pub stress_state: StressState,
    /// Upper and lower body.
    pub bodies: [ProblemBody; 2],
    /// Whether symmetry is made use of where there is one.
    pub use_symmetry: bool,
    /// Abscissa of the smallest gap \[mm\].
    pub first_contact_x: f64,
    /// The smallest gap as the outlines are given \[mm\]; gaps are counted from it.
    pub smallest_gap: f64,
}

pub(crate) struct ProblemBody {
    pub outline: Outline,
    /// `None` for a rigid body.
    pub material: Option<Deformable>,
    /// Its constitutive model.
    pub model: Option<Arc<dyn MaterialModel>>,
    pub support: Support,
}

/// Makes the constitutive model of a material.
pub type ModelOf = fn(&Deformable, OutOfPlane) -> Arc<dyn MaterialModel>;

/// The paper's theory of plasticity.
pub(crate) fn deformation_theory(material: &Deformable, out_of_plane: OutOfPlane) -> Arc<dyn MaterialModel> {
    Arc::new(DeformationPlasticity::new(material, out_of_plane))
}

/// Flow theory, which follows a history of loads.
pub(crate) fn flow_theory(material: &Deformable, out_of_plane: OutOfPlane) -> Arc<dyn MaterialModel> {
    let Some(law) = material.hardening_law() else { return deformation_theory(material, out_of_plane) };
    let elastic = ElasticModuli::from(material.elastic());
    let mapping = ReturnMapping::new(law, elastic.shear);
    let terms = material.backstress();
    // As many terms as there are, because every point keeps one tensor for each.
    match *terms {
        [] => Arc::new(FlowPlasticity::new(elastic, mapping, [], out_of_plane)),
        [a] => Arc::new(FlowPlasticity::new(elastic, mapping, [&a].map(BackstressTerm::from), out_of_plane)),
        [a, b] => {
            Arc::new(FlowPlasticity::new(elastic, mapping, [&a, &b].map(BackstressTerm::from), out_of_plane))
        }
        [a, b, c] => {
            let terms = [&a, &b, &c].map(BackstressTerm::from);
            Arc::new(FlowPlasticity::new(elastic, mapping, terms, out_of_plane))
        }
        [a, b, c, d, ..] => {
            let terms = [&a, &b, &c, &d].map(BackstressTerm::from);
            Arc::new(FlowPlasticity::new(elastic, mapping, terms, out_of_plane))
        }
    }
}

/// Samples in search of the smallest gap.
const GAP_SAMPLES: u32 = 4000;

impl Problem {
    pub fn of(job: &Job) -> Self {
        Self::with_models(job, deformation_theory)
    }

    /// The problem of a job with other constitutive models than those of its materials.
    pub fn with_models(job: &Job, model: ModelOf) -> Self {
        let stress_state = match job.analysis {
            Analysis::PlaneStrain => StressState::PlaneStrain,
            Analysis::PlaneStress => StressState::PlaneStress,
            Analysis::Axisymmetric => StressState::Axisymmetric,
        };
        let body = |body: &Body| {
            let material = match &body.material {
                Material::Rigid => None,
                Material::Deformable(material) => Some(material.clone()),
            };
            ProblemBody {
                outline: Outline::of(&body.shape),
                model: material.as_ref().map(|material| model(material, out_of_plane(stress_state))),
                material,
                support: body.support,
            }
        };
        let mut problem = Self {
            stress_state,
            bodies: [body(&job.upper), body(&job.lower)],
            use_symmetry: true,
            first_contact_x: 0.0,
            smallest_gap: 0.0,
        };
        problem.find_smallest_gap();
        problem
    }

    /// The same bodies without their hardening curves.
    pub fn without_plasticity(&self) -> Self {
        let out_of_plane = out_of_plane(self.stress_state);
        let elastic = |body: &ProblemBody| {
            let material = body.material.as_ref().map(Deformable::without_plasticity);
            ProblemBody {
                outline: body.outline.clone(),
                model: material.as_ref().map(|material| deformation_theory(material, out_of_plane)),
                material,
                support: body.support,
            }
        };
        Self { bodies: self.bodies.each_ref().map(elastic), ..*self }
    }

    /// Force over the area of a contact of this half-width \[MPa\].
    pub fn mean_pressure(&self, force: f64, half_width: f64) -> f64 {
        match self.stress_state {
            StressState::PlaneStrain | StressState::PlaneStress => force / (2.0 * half_width),
            StressState::Axisymmetric => force / (PI * half_width * half_width),
        }
    }

    /// Looks for the smallest gap; where it is reached again and again, the place nearest to the origin counts.
    fn find_smallest_gap(&mut self) {
        if self.bodies.iter().all(|body| body.outline.curvature().is_some()) {
            return;
        }
        let (left, right) = self.span();
        let left = if self.stress_state == StressState::Axisymmetric { 0.0 } else { left };
        let place = |k: u32| left + (right - left) * f64::from(k) / f64::from(GAP_SAMPLES);
        let origin: (f64, f64) = (self.initial_gap(0.0), 0.0);
        let (gap, x) =
            (0..=GAP_SAMPLES).map(|k| (self.initial_gap(place(k)), place(k))).fold(origin, |best, found| {
                let same = (found.0 - best.0).abs() <= 1e-12 * (right - left);
                let better = if same { found.1.abs() < best.1.abs() } else { found.0 < best.0 };
                if better { found } else { best }
            });
        self.smallest_gap = gap;
        self.first_contact_x = x;
    }

    /// Whether both bodies are deformable and mirror images of each other.
    pub fn bodies_are_equal(&self) -> bool {
        let [upper, lower] = &self.bodies;
        upper.material.is_some()
            && upper.outline == lower.outline
            && upper.material == lower.material
            && upper.support == lower.support
    }

    /// Initial gap `δ0 = f_u + f_l` at an abscissa \[mm\], zero where the surfaces first touch.
    pub fn initial_gap(&self, x: f64) -> f64 {
        -self.bodies.iter().map(|body| body.outline.height(x)).sum::<f64>() - self.smallest_gap
    }

    /// Whether one half of the bodies stands for the whole.
    pub fn is_symmetric(&self) -> bool {
        self.stress_state == StressState::Axisymmetric || (self.use_symmetry && self.has_symmetric_outlines())
    }

    /// Whether the answer is symmetric, even if the whole is meshed.
    pub fn has_symmetric_outlines(&self) -> bool {
        self.bodies.iter().all(|body| body.outline.is_symmetric())
    }

    /// Whether the surfaces may touch away from the zone around the smallest gap.
    pub fn may_touch_elsewhere(&self) -> bool {
        self.bodies.iter().any(|body| body.outline.curvature().is_none())
    }

    /// Sum of the curvatures at the origin \[1/mm\]; `None` where a surface is no arc.
    pub fn curvature(&self) -> Option<f64> {
        let [upper, lower] = &self.bodies;
        Some(upper.outline.curvature()? + lower.outline.curvature()?)
    }

    /// Effective modulus E* \[MPa\]; infinite for two rigid bodies.
    pub fn effective_modulus(&self) -> f64 {
        let constants = self.bodies.each_ref().map(|body| {
            let elastic = body.material.as_ref()?.elastic();
            Some(ElasticConstants {
                young_modulus: elastic.young_modulus.get(),
                poisson_ratio: elastic.poisson_ratio.get(),
            })
        });
        match self.stress_state {
            StressState::PlaneStrain | StressState::Axisymmetric => effective_modulus(constants),
            StressState::PlaneStress => effective_modulus_plane_stress(constants),
        }
    }

    /// Outlines of the bodies that deform.
    pub fn deformable_outlines(&self) -> impl Iterator<Item = &Outline> {
        self.bodies.iter().filter(|body| body.material.is_some()).map(|body| &body.outline)
    }

    /// The part of the tangential axis where both bodies have a surface \[mm\].
    pub fn span(&self) -> (f64, f64) {
        let spans = self.bodies.each_ref().map(|body| body.outline.span());
        (spans[0].0.max(spans[1].0), spans[0].1.min(spans[1].1))
    }

    /// A pressure that a fully plastic contact of the softer body bears \[MPa\]; infinite for elastic bodies.
    pub fn hardness(&self) -> f64 {
        let hardness = |body: &ProblemBody| Some(2.6 * body.hardening()?.flow_stress());
        self.bodies.iter().filter_map(hardness).fold(f64::INFINITY, f64::min)
    }
}

impl ProblemBody {
    /// The hardening law of a body that can yield.
    pub fn hardening(&self) -> Option<&dyn HardeningLaw> {
        self.model.as_ref()?.hardening()
    }

    /// Stress at which it begins to yield \[MPa\]; `None` if it cannot, or does from the first load on.
    pub fn yield_stress(&self) -> Option<f64> {
        Some(self.hardening()?.yield_stress()).filter(|stress| *stress > 0.0)
    }
}
