//! Swift's power law of the total plastic strain.

use std::sync::Arc;

use super::{Curve, STRAIN_EXPONENT};
use crate::job::fields::{Field, record};
use crate::job::{Domain, PositiveF64};
use crate::material::{HardeningLaw, hardening};

record! {
    /// q = σ_y (1 + ε_p/ε_0)^n.
    pub struct Swift("swift", "Swift") {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Domain::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Strain offset ε_0.
        pub strain_offset: PositiveF64 =
            Field::pure(1e-9..=1e3).label("Strain offset", "ε_0").example(0.002),
        /// Exponent n.
        pub exponent: PositiveF64 = Field::pure(STRAIN_EXPONENT).label("Exponent", "n").example(0.2),
    }
}

impl Curve for Swift {
    fn law(&self, _: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(hardening::Swift {
            yield_stress: self.yield_stress.get(),
            strain_offset: self.strain_offset.get(),
            exponent: self.exponent.get(),
        })
    }
}
