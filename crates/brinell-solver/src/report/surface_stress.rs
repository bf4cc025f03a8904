//! Uncertainty of the stress at the surface below the middle of a contact with plastic strain.

use crate::material::analytical::Stress;
use crate::solver::{BodySolution, StepSolution, surface_stress_error, surface_stress_in_middle};

/// Error of the stress over the largest von Mises stress above which the error is reported.
const UNCERTAIN: f64 = 0.1;

/// A stress at the surface that is uncertain because of plastic strain below the surface.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct UncertainStress {
    /// Error of the stress \[MPa\]: the larger of its change below the surface by plastic strain,
    /// and of its excess over the largest stress in the elements.
    pub error: f64,
    /// Stress along the surface \[MPa\].
    along: f64,
    /// Von Mises stress \[MPa\].
    von_mises: f64,
    /// Local strength: factor of the stresses of the hardening law.
    strength: f64,
}

impl UncertainStress {
    /// Returns the uncertain stress of a body. Returns `None` if the error is small, or if the
    /// body has not yielded.
    pub fn of(step: &StepSolution, body: &BodySolution) -> Option<Self> {
        if body.max_plastic_strain() == 0.0 {
            return None;
        }
        let known = surface_stress_in_middle(step, body)?;
        let points = body.stress.points.iter().flatten();
        let largest = points.map(|point| point.largest_von_mises).fold(0.0, f64::max);
        // The bound is the diameter of the yield surface.
        let error = surface_stress_error(step, body, step.field.middle)
            .max(known.beyond)
            .min(2.0 * largest);
        let position = body.mesh.nodes[known.node as usize];
        let [sigma_x, sigma_y, sigma_z, tau_xy] = known.stress;
        let stress =
            Stress { sigma_x, sigma_y, sigma_z, tau_xy }.along(body.mesh.frame.normal(position));
        (error > UNCERTAIN * largest).then(|| Self {
            error,
            along: stress.sigma_x,
            von_mises: stress.von_mises(),
            strength: body.model.strength(position),
        })
    }

    /// Returns by how much the true least stress along the surface may lie below `least_stress` of
    /// the normal through the middle \[MPa\].
    pub fn below(&self, least_stress: f64) -> f64 {
        (least_stress - (self.along - self.error)).max(0.0)
    }

    /// Returns by how much the true largest von Mises stress over the strength may exceed
    /// `largest_von_mises` of the same normal \[MPa\].
    pub fn above(&self, largest_von_mises: f64) -> f64 {
        ((self.von_mises + self.error) / self.strength - largest_von_mises).max(0.0)
    }
}
