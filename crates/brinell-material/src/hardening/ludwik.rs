//! Ludwik's law.

use super::{HardeningLaw, is_same};

/// `q = σ_y + k ε_p^n`.
#[derive(Debug, Clone, PartialEq)]
pub struct Ludwik {
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// k \[MPa\].
    pub coefficient: f64,
    /// n.
    pub exponent: f64,
}

impl HardeningLaw for Ludwik {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.yield_stress + self.coefficient * plastic_strain.powf(self.exponent)
    }

    /// Infinite at zero plastic strain unless `n = 1`.
    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let hardening = self.coefficient * plastic_strain.powf(self.exponent);
        let slope = if plastic_strain > 0.0 {
            self.exponent * hardening / plastic_strain
        } else if self.exponent < 1.0 {
            f64::INFINITY
        } else {
            self.coefficient
        };
        (self.yield_stress + hardening, slope)
    }

    fn is_like(&self, other: &(dyn HardeningLaw + 'static)) -> bool {
        is_same(self, other)
    }
}
