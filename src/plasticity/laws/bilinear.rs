//! Straight hardening.

use crate::plasticity::HardeningLaw;

/// `q = σ_y + H ε_p` with the plastic modulus `H = E_t / (1 - E_t/E)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Bilinear {
    /// σ_y \[MPa\].
    pub(in crate::plasticity) yield_stress: f64,
    /// H \[MPa\].
    pub(in crate::plasticity) plastic_modulus: f64,
    /// 3G \[MPa\].
    pub(in crate::plasticity) triple_shear: f64,
}

impl HardeningLaw for Bilinear {
    #[inline]
    fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// Closed form: `ε_p = max(0, (3G ε_q - σ_y) / (3G + H))`.
    #[inline]
    fn equivalent_stress(&self, equivalent_strain: f64) -> f64 {
        let trial = self.triple_shear * equivalent_strain;
        let excess = (trial - self.yield_stress).max(0.0);
        trial - self.triple_shear * excess / (self.triple_shear + self.plastic_modulus)
    }
}
