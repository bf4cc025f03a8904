//! Ramberg and Osgood's power law.

use std::sync::Arc;

use super::Curve;
use crate::job::fields::{Field, record};
use crate::job::{Domain, PositiveF64};
use crate::material::{HardeningLaw, hardening};

record! {
    /// ε_p = a (σ_0/E) (q/σ_0)^m.
    pub struct RambergOsgood("ramberg_osgood", "Ramberg–Osgood") {
        /// Reference stress σ_0.
        pub reference_stress: PositiveF64 =
            Field::quantity(Domain::Stress).label("Reference stress", "σ_0").example(500.0),
        /// Offset a.
        pub offset: PositiveF64 = Field::pure(1e-9..=1e6).label("Offset", "a").example(0.3),
        /// Exponent m, from linear to, for every purpose, perfectly plastic.
        pub exponent: PositiveF64 = Field::pure(1.0..=200.0).label("Exponent", "m").example(5.0),
    }
}

impl Curve for RambergOsgood {
    fn law(&self, young_modulus: f64) -> Arc<dyn HardeningLaw> {
        let (stress, offset, exponent) =
            (self.reference_stress.get(), self.offset.get(), self.exponent.get());
        Arc::new(hardening::RambergOsgood::of_offset(stress, offset, exponent, young_modulus))
    }
}
