//! Straight hardening.

use super::{HardeningLaw, is_same};

/// `q = σ_y + H ε_p`.
#[derive(Debug, Clone, PartialEq)]
pub struct StraightLine {
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// H \[MPa\].
    pub plastic_modulus: f64,
}

impl StraightLine {
    /// The line of slope E_t over total strain beyond yield, `H = E_t / (1 - E_t/E)`.
    pub fn of_tangent(yield_stress: f64, tangent_modulus: f64, young_modulus: f64) -> Self {
        Self {
            yield_stress,
            plastic_modulus: tangent_modulus / (1.0 - tangent_modulus / young_modulus),
        }
    }
}

impl HardeningLaw for StraightLine {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    fn largest_stress(&self) -> f64 {
        if self.plastic_modulus > 0.0 { f64::INFINITY } else { self.yield_stress }
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.yield_stress + self.plastic_modulus * plastic_strain
    }

    fn slope(&self, _plastic_strain: f64) -> f64 {
        self.plastic_modulus
    }

    fn polyline(&self) -> Option<Vec<[f64; 2]>> {
        Some(vec![[0.0, self.yield_stress]])
    }

    fn is_like(&self, other: &(dyn HardeningLaw + 'static)) -> bool {
        is_same(self, other)
    }
}
