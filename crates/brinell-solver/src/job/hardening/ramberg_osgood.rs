//! Ramberg and Osgood's power law.

use std::sync::Arc;

use super::{Curve, HardeningLaw, Inverse};
use crate::job::fields::{Field, record};
use crate::job::{PositiveF64, Quantity};

record! {
    /// ε_p = a (σ_0/E) (q/σ_0)^m.
    pub struct RambergOsgood("ramberg_osgood", "Ramberg–Osgood") {
        /// Reference stress σ_0.
        pub reference_stress: PositiveF64 =
            Field::quantity(Quantity::Stress).label("Reference stress", "σ_0").example(500.0),
        /// Offset a.
        pub offset: PositiveF64 = Field::pure(1e-9..=1e6).label("Offset", "a").example(0.3),
        /// Exponent m, from linear to, for every purpose, perfectly plastic.
        pub exponent: PositiveF64 = Field::pure(1.0..=200.0).label("Exponent", "m").example(5.0),
    }
}

impl Curve for RambergOsgood {
    fn law(&self, young_modulus: f64) -> Arc<dyn HardeningLaw> {
        let (reference_stress, exponent) = (self.reference_stress.get(), self.exponent.get());
        let reference_strain = self.offset.get() * reference_stress / young_modulus;
        Arc::new(PowerCurve { reference_stress, reference_strain, exponent })
    }
}

/// `ε_p = ε_0 (q/σ_0)^m`.
///
/// # Reference
/// W. Ramberg, W. R. Osgood, *Description of stress-strain curves by three parameters*, NACA TN 902 (1943).
#[derive(Debug)]
struct PowerCurve {
    /// σ_0 \[MPa\].
    reference_stress: f64,
    /// ε_0 = `a σ_0 / E`.
    reference_strain: f64,
    /// m.
    exponent: f64,
}

impl HardeningLaw for PowerCurve {
    fn yield_stress(&self) -> f64 {
        0.0
    }

    /// The reference stress, by convention.
    fn nominal_yield_stress(&self) -> f64 {
        self.reference_stress
    }

    fn flow_stress(&self) -> f64 {
        1.5 * self.reference_stress
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.reference_stress * (plastic_strain / self.reference_strain).powf(self.exponent.recip())
    }

    /// Infinite at zero plastic strain unless `m = 1`.
    fn slope(&self, plastic_strain: f64) -> f64 {
        if plastic_strain > 0.0 {
            self.stress(plastic_strain) / (self.exponent * plastic_strain)
        } else if self.exponent > 1.0 {
            f64::INFINITY
        } else {
            self.reference_stress / self.reference_strain
        }
    }

    /// Given directly; the curve itself has an infinite slope at the origin.
    fn inverse(&self, stress: f64) -> Option<Inverse> {
        if stress <= 0.0 {
            let slope = if self.exponent > 1.0 { 0.0 } else { self.reference_strain / self.reference_stress };
            return Some(Inverse { plastic_strain: 0.0, slope });
        }
        let plastic_strain = self.reference_strain * (stress / self.reference_stress).powf(self.exponent);
        Some(Inverse { plastic_strain, slope: self.exponent * plastic_strain / stress })
    }
}
