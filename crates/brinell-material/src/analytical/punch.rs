//! The ceiling of contact pressure: Prandtl's flat punch on a rigid-plastic half-plane.

use std::f64::consts::PI;

/// Mean pressure under a flat punch at plastic collapse, `(2 + π) k [MPa]`, plane strain.
///
/// `k = shear_yield_stress [MPa]`. With von Mises' `k = σ_y/√3` this is 2.968 `σ_y`. A deeply
/// plastic line contact approaches it from below.
///
/// # Reference
/// L. Prandtl (1920); R. Hill, *The Mathematical Theory of Plasticity* (1950), ch. IX.
pub const fn prandtl_mean_pressure(shear_yield_stress: f64) -> f64 {
    (2.0 + PI) * shear_yield_stress
}

/// Yield stress in shear by von Mises, `k = σ_y / √3`.
pub fn shear_yield_von_mises(yield_stress: f64) -> f64 {
    yield_stress / 3.0_f64.sqrt()
}

/// Yield stress in shear by Tresca, `k = σ_y / 2`.
pub const fn shear_yield_tresca(yield_stress: f64) -> f64 {
    0.5 * yield_stress
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ceiling_in_yield_stresses() {
        assert!((prandtl_mean_pressure(shear_yield_von_mises(1.0)) - 2.968).abs() < 5e-4);
        assert!((prandtl_mean_pressure(shear_yield_tresca(1.0)) - 2.571).abs() < 5e-4);
    }
}
