//! Ludwik's power law beside the yield stress.

use std::sync::Arc;

use super::{Curve, STRAIN_EXPONENT};
use crate::job::fields::{Field, record};
use crate::job::{Domain, PositiveF64};
use crate::material::{HardeningLaw, hardening};

record! {
    /// q = σ_y + k ε_p^n.
    pub struct Ludwik("ludwik", "Ludwik") {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Domain::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Coefficient k.
        pub coefficient: PositiveF64 =
            Field::quantity(Domain::Stress).label("Coefficient", "k").example(500.0),
        /// Exponent n.
        pub exponent: PositiveF64 = Field::pure(STRAIN_EXPONENT).label("Exponent", "n").example(0.5),
    }
}

impl Curve for Ludwik {
    fn law(&self, _: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(hardening::Ludwik {
            yield_stress: self.yield_stress.get(),
            coefficient: self.coefficient.get(),
            exponent: self.exponent.get(),
        })
    }
}
