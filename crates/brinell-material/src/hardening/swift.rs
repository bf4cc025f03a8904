//! Swift's law.

use super::{HardeningLaw, is_same};

/// `q = σ_y (1 + ε_p/ε_0)^n`.
#[derive(Debug, Clone, PartialEq)]
pub struct Swift {
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// ε_0.
    pub strain_offset: f64,
    /// n.
    pub exponent: f64,
}

impl HardeningLaw for Swift {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.yield_stress * (1.0 + plastic_strain / self.strain_offset).powf(self.exponent)
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let stress = self.stress(plastic_strain);
        (stress, self.exponent * stress / (self.strain_offset + plastic_strain))
    }

    fn is_like(&self, other: &(dyn HardeningLaw + 'static)) -> bool {
        is_same(self, other)
    }
}
