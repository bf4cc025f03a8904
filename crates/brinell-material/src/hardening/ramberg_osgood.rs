//! Ramberg and Osgood's power law.

use super::{HardeningLaw, Inverse, is_same};

/// `ε_p = ε_0 (q/σ_0)^m`.
///
/// # Reference
/// W. Ramberg, W. R. Osgood, *Description of stress-strain curves by three parameters*, NACA TN
/// 902 (1943).
#[derive(Debug, Clone, PartialEq)]
pub struct RambergOsgood {
    /// σ_0 \[MPa\].
    pub reference_stress: f64,
    /// ε_0.
    pub reference_strain: f64,
    /// m.
    pub exponent: f64,
}

impl RambergOsgood {
    /// The law of an offset a, `ε_0 = a σ_0 / E`.
    pub fn of_offset(
        reference_stress: f64,
        offset: f64,
        exponent: f64,
        young_modulus: f64,
    ) -> Self {
        Self {
            reference_stress,
            reference_strain: offset * reference_stress / young_modulus,
            exponent,
        }
    }
}

impl HardeningLaw for RambergOsgood {
    fn yield_stress(&self) -> f64 {
        0.0
    }

    /// The reference stress, by convention.
    fn nominal_yield_stress(&self) -> f64 {
        self.reference_stress
    }

    fn flow_stress(&self) -> f64 {
        self.stress(0.002).max(1.5 * self.reference_stress)
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.reference_stress
            * (plastic_strain / self.reference_strain).powf(self.exponent.recip())
    }

    /// Infinite at zero plastic strain unless `m = 1`.
    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let stress = self.stress(plastic_strain);
        let slope = if plastic_strain > 0.0 {
            stress / (self.exponent * plastic_strain)
        } else if self.exponent > 1.0 {
            f64::INFINITY
        } else {
            self.reference_stress / self.reference_strain
        };
        (stress, slope)
    }

    /// Given directly; the curve itself has an infinite slope at the origin.
    fn inverse(&self, stress: f64) -> Option<Inverse> {
        if stress <= 0.0 {
            let slope = if self.exponent > 1.0 {
                0.0
            } else {
                self.reference_strain / self.reference_stress
            };
            return Some(Inverse { plastic_strain: 0.0, slope });
        }
        let plastic_strain =
            self.reference_strain * (stress / self.reference_stress).powf(self.exponent);
        Some(Inverse { plastic_strain, slope: self.exponent * plastic_strain / stress })
    }

    fn is_like(&self, other: &(dyn HardeningLaw + 'static)) -> bool {
        is_same(self, other)
    }
}
