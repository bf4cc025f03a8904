//! Straight hardening.

use crate::material::HardeningLaw;

/// `q = σ_y + H ε_p` with the plastic modulus `H = E_t / (1 - E_t/E)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Bilinear {
    /// σ_y \[MPa\].
    pub(in crate::material) yield_stress: f64,
    /// H \[MPa\].
    pub(in crate::material) plastic_modulus: f64,
    /// 3G \[MPa\].
    pub(in crate::material) triple_shear: f64,
}

impl HardeningLaw for Bilinear {
    #[inline]
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// Closed form: `q = (3G σ_y + H 3G ε_q) / (3G + H)` beyond yield.
    #[inline]
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        let trial = self.triple_shear * equivalent_strain;
        let flowing = self.triple_shear * self.yield_stress + self.plastic_modulus * trial;
        trial.min(flowing / (self.triple_shear + self.plastic_modulus))
    }
}
