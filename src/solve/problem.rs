//! The job as mechanics sees it: two outlines with materials and supports.

use crate::analytical::{ElasticConstants, HertzLine, YieldOnset, effective_modulus, effective_radius};
use crate::mesh::Outline;
use crate::model::{Body, Deformable, Hardening, Job, Material, Support};
use crate::plasticity::{HardeningLaw, UniaxialCurve};

/// The elastic contact of the same bodies in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticReference {
    /// Hertz's contact under the same force.
    pub hertz: HertzLine,
    /// Effective radius \[mm\].
    pub effective_radius: f64,
    /// Force at which the first body begins to yield \[N/mm\]; `None` if none has a yield stress.
    pub yield_onset_force: Option<f64>,
}

impl ElasticReference {
    /// The reference for a job under a force \[N/mm\]; `None` where Hertz's theory does not apply.
    pub fn of(job: &Job, force: f64) -> Option<Self> {
        let problem = Problem::of(job);
        let (effective_radius, modulus) = problem.effective()?;
        let onset = |body: &ProblemBody| {
            let material = body.material.as_ref()?;
            let yield_stress = UniaxialCurve::of(material)?.yield_stress();
            let ratio = YieldOnset::line_von_mises(material.elastic().poisson_ratio.get());
            (yield_stress > 0.0).then(|| ratio.line_force(yield_stress, effective_radius, modulus))
        };
        let yield_onset_force = problem.bodies.iter().filter_map(onset).reduce(f64::min);
        let hertz = HertzLine::new(force, effective_radius, modulus);
        Some(Self { hertz, effective_radius, yield_onset_force })
    }
}

/// Two bodies in contact at the origin.
pub(super) struct Problem {
    /// Upper and lower body.
    pub bodies: [ProblemBody; 2],
    /// Whether symmetry is made use of where there is one.
    pub use_symmetry: bool,
}

pub(super) struct ProblemBody {
    pub outline: Outline,
    /// `None` for a rigid body.
    pub material: Option<Deformable>,
    pub support: Support,
}

impl Problem {
    pub fn of(job: &Job) -> Self {
        let body = |body: &Body| ProblemBody {
            outline: Outline::of(&body.shape),
            material: match &body.material {
                Material::Rigid => None,
                Material::Deformable(material) => Some(material.clone()),
            },
            support: body.support,
        };
        Self { bodies: [body(&job.upper), body(&job.lower)], use_symmetry: true }
    }

    /// Whether both bodies are deformable and mirror images of each other.
    pub fn bodies_are_equal(&self) -> bool {
        let [upper, lower] = &self.bodies;
        upper.material.is_some()
            && upper.outline == lower.outline
            && upper.material == lower.material
            && upper.support == lower.support
    }

    /// Initial gap `δ0 = f_u + f_l` at an abscissa \[mm\].
    pub fn initial_gap(&self, x: f64) -> f64 {
        -self.bodies.iter().map(|body| body.outline.height(x)).sum::<f64>()
    }

    /// Whether one half of the bodies stands for the whole.
    pub fn is_symmetric(&self) -> bool {
        self.use_symmetry && self.bodies.iter().all(|body| body.outline.is_symmetric())
    }

    /// Effective radius \[mm\] and modulus \[MPa\] of Hertz's theory; `None` if the surfaces do not open away from
    /// the origin.
    fn effective(&self) -> Option<(f64, f64)> {
        let constants = |body: &ProblemBody| {
            let elastic = body.material.as_ref()?.elastic();
            Some(ElasticConstants {
                young_modulus: elastic.young_modulus.get(),
                poisson_ratio: elastic.poisson_ratio.get(),
            })
        };
        let radius = effective_radius(self.bodies.each_ref().map(|body| body.outline.curvature()));
        let modulus = effective_modulus(self.bodies.each_ref().map(constants));
        (radius > 0.0 && radius.is_finite() && modulus.is_finite()).then_some((radius, modulus))
    }

    /// Half-width for sizing the first mesh \[mm\]: Hertz's, or what a fully plastic contact of the softer body
    /// needs to carry the force, whichever is more.
    pub fn first_half_width(&self, force: f64) -> Option<f64> {
        let (radius, modulus) = self.effective()?;
        let hertz = HertzLine::new(force, radius, modulus);
        let hardness = |body: &ProblemBody| Some(2.6 * flow_stress(body.material.as_ref()?.plasticity()?));
        let softest = self.bodies.iter().filter_map(hardness).fold(f64::INFINITY, f64::min);
        Some(hertz.half_width().max(force / (2.0 * softest)))
    }

    /// Outlines of the bodies that deform.
    pub fn deformable_outlines(&self) -> impl Iterator<Item = &Outline> {
        self.bodies.iter().filter(|body| body.material.is_some()).map(|body| &body.outline)
    }

    /// How many bodies deform.
    pub fn deformable_count(&self) -> usize {
        self.deformable_outlines().count()
    }

    /// Narrowest half-span of the surfaces \[mm\].
    pub fn half_span(&self) -> f64 {
        self.bodies.iter().map(|body| body.outline.half_span()).fold(f64::INFINITY, f64::min)
    }
}

/// A stress at which the material flows noticeably \[MPa\].
fn flow_stress(law: &Hardening) -> f64 {
    match law {
        Hardening::Bilinear { yield_stress, .. } => 1.2 * yield_stress.get(),
        Hardening::RambergOsgood { reference_stress, .. } => 1.5 * reference_stress.get(),
        _ => f64::INFINITY,
    }
}
