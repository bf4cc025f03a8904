//! Voce's saturating law.

use super::HardeningLaw;

/// `q = σ_y + (σ_s - σ_y)(1 - exp(-b ε_p))`.
///
/// # Reference
/// E. Voce, *The relationship between stress and strain for homogeneous deformation*, J. Inst. Metals 74 (1948)
/// 537–562.
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

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).0
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let rest = (self.saturation_stress - self.yield_stress) * (-self.rate * plastic_strain).exp();
        (self.saturation_stress - rest, self.rate * rest)
    }
}
