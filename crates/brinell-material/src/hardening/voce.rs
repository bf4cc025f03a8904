//! Voce's law.

use super::{HardeningLaw, is_same};

/// `q = σ_y + (σ_s - σ_y) (1 - exp(-b ε_p))`.
#[derive(Debug, Clone, PartialEq)]
pub struct Voce {
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// σ_s \[MPa\].
    pub saturation_stress: f64,
    /// b.
    pub rate: f64,
}

impl HardeningLaw for Voce {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// Halfway to saturation.
    fn flow_stress(&self) -> f64 {
        0.5 * (self.yield_stress + self.saturation_stress)
    }

    fn largest_stress(&self) -> f64 {
        self.saturation_stress.max(self.yield_stress)
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).0
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        // Without cancellation at small strains, however high the saturation stress.
        let range = self.saturation_stress - self.yield_stress;
        let gained = -(-self.rate * plastic_strain).exp_m1();
        (self.yield_stress + range * gained, self.rate * range * (1.0 - gained))
    }

    fn is_like(&self, other: &(dyn HardeningLaw + 'static)) -> bool {
        is_same(self, other)
    }
}
