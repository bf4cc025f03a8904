//! Straight hardening.

use super::HardeningLaw;

/// `q = σ_y + H ε_p` with the plastic modulus `H = E_t / (1 - E_t/E)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Bilinear {
    /// σ_y \[MPa\].
    pub yield_stress: f64,
    /// H \[MPa\].
    pub plastic_modulus: f64,
}

impl HardeningLaw for Bilinear {
    fn yield_stress(&self) -> f64 {
        self.yield_stress
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
}
