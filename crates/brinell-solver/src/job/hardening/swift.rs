//! Swift's power law of the total plastic strain.

use std::sync::Arc;

use super::{Curve, HardeningLaw, STRAIN_EXPONENT};
use crate::job::fields::{Field, record};
use crate::job::{PositiveF64, Quantity};

record! {
    /// q = σ_y (1 + ε_p/ε_0)^n.
    pub struct Swift("swift", "Swift") {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Quantity::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Strain offset ε_0.
        pub strain_offset: PositiveF64 =
            Field::pure(1e-9..=1e3).label("Strain offset", "ε_0").example(0.002),
        /// Exponent n.
        pub exponent: PositiveF64 = Field::pure(STRAIN_EXPONENT).label("Exponent", "n").example(0.2),
    }
}

impl Curve for Swift {
    fn law(&self, _: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(self.clone())
    }
}

/// # Reference
/// H. W. Swift, *Plastic instability under plane stress*, J. Mech. Phys. Solids 1 (1952) 1–18.
impl HardeningLaw for Swift {
    fn yield_stress(&self) -> f64 {
        self.yield_stress.get()
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.yield_stress.get() * (1.0 + plastic_strain / self.strain_offset.get()).powf(self.exponent.get())
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let stress = self.stress(plastic_strain);
        (stress, self.exponent.get() * stress / (self.strain_offset.get() + plastic_strain))
    }
}
