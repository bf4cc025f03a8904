//! The job as mechanics sees it: two outlines with materials and supports.

use crate::analytical::{ElasticConstants, HertzLine, effective_modulus};
use crate::mesh::Outline;
use crate::model::{Body, Deformable, Hardening, Job, Material, Support};

/// Two bodies in contact at the origin.
pub(super) struct Problem {
    /// Upper and lower body.
    pub bodies: [ProblemBody; 2],
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
        Self { bodies: [body(&job.upper), body(&job.lower)] }
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

    /// Sum of the curvatures of both surfaces at the origin \[1/mm\].
    pub fn curvature(&self) -> f64 {
        self.bodies.iter().map(|body| body.outline.curvature()).sum()
    }

    /// Whether one half of the bodies stands for the whole.
    pub fn is_symmetric(&self) -> bool {
        self.bodies.iter().all(|body| body.outline.is_symmetric())
    }

    /// Hertz's contact of the same bodies under a force \[N/mm\]; `None` if the surfaces do not open away from
    /// the origin.
    pub fn hertz(&self, force: f64) -> Option<HertzLine> {
        let constants = |body: &ProblemBody| {
            let elastic = body.material.as_ref()?.elastic();
            Some(ElasticConstants {
                young_modulus: elastic.young_modulus.get(),
                poisson_ratio: elastic.poisson_ratio.get(),
            })
        };
        let modulus = effective_modulus(self.bodies.each_ref().map(constants));
        let opens = self.curvature() > 0.0 && modulus.is_finite();
        opens.then(|| HertzLine::new(force, self.curvature().recip(), modulus))
    }

    /// Half-width for sizing the first mesh \[mm\]: Hertz's, or what a fully plastic contact of the softer body
    /// needs to carry the force, whichever is more.
    pub fn first_half_width(&self, force: f64) -> Option<f64> {
        let hertz = self.hertz(force)?;
        let hardness = |body: &ProblemBody| Some(2.6 * flow_stress(body.material.as_ref()?.plasticity()?));
        let softest = self.bodies.iter().filter_map(hardness).fold(f64::INFINITY, f64::min);
        Some(hertz.half_width().max(force / (2.0 * softest)))
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
