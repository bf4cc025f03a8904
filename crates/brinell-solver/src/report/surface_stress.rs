//! What is not known of the stress at the surface below the middle of a contact that has yielded.

use crate::material::analytical::Stress;
use crate::solver::{BodySolution, StepSolution, surface_stress_error, surface_stress_in_middle};

/// Error of the stress over the largest von Mises stress from which on it is told.
const UNCERTAIN: f64 = 0.08;

/// A stress at the surface that plastic strain below it leaves uncertain.
pub(super) struct UncertainStress {
    /// Its error \[MPa\]: what plastic strain changes below the surface, or by what the stress is
    /// above the largest that elements have borne, if that is more.
    pub error: f64,
    /// The stress along the surface \[MPa\].
    along: f64,
    /// Von Mises' stress \[MPa\].
    von_mises: f64,
    /// Factor of the stresses of the law.
    strength: f64,
}

impl UncertainStress {
    /// That of a body; `None` where it is known, and of a body that has not yielded.
    pub fn of(step: &StepSolution, body: &BodySolution) -> Option<Self> {
        if body.max_plastic_strain() == 0.0 {
            return None;
        }
        let known = surface_stress_in_middle(step, body)?;
        let points = body.stress.points.iter().flatten();
        let largest = points.map(|point| point.largest_von_mises).fold(0.0, f64::max);
        // From one side of the yield surface to the other.
        let error =
            surface_stress_error(step, body, step.middle).max(known.beyond).min(2.0 * largest);
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

    /// By how much the least stress along the surface may be below that of the normal below the
    /// middle \[MPa\].
    pub fn below(&self, least_stress: f64) -> f64 {
        (least_stress - (self.along - self.error)).max(0.0)
    }

    /// By how much the largest von Mises stress over the strength may be above that of the same
    /// normal \[MPa\].
    pub fn above(&self, largest_von_mises: f64) -> f64 {
        ((self.von_mises + self.error) / self.strength - largest_von_mises).max(0.0)
    }
}
