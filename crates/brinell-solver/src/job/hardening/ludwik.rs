//! Ludwik's power law beside the yield stress.

use std::sync::Arc;

use super::{Curve, HardeningLaw, STRAIN_EXPONENT};
use crate::job::fields::{Field, record};
use crate::job::{PositiveF64, Quantity};

record! {
    /// q = σ_y + k ε_p^n.
    pub struct Ludwik("ludwik", "Ludwik") {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Quantity::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Coefficient k.
        pub coefficient: PositiveF64 =
            Field::quantity(Quantity::Stress).label("Coefficient", "k").example(500.0),
        /// Exponent n.
        pub exponent: PositiveF64 = Field::pure(STRAIN_EXPONENT).label("Exponent", "n").example(0.5),
    }
}

impl Curve for Ludwik {
    fn law(&self, _: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(self.clone())
    }
}

/// # Reference
/// P. Ludwik, *Elemente der technologischen Mechanik* (1909).
impl HardeningLaw for Ludwik {
    fn yield_stress(&self) -> f64 {
        self.yield_stress.get()
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.yield_stress.get() + self.coefficient.get() * plastic_strain.powf(self.exponent.get())
    }

    /// Infinite at zero plastic strain unless `n = 1`.
    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        let hardening = self.coefficient.get() * plastic_strain.powf(self.exponent.get());
        let slope = if plastic_strain > 0.0 {
            self.exponent.get() * hardening / plastic_strain
        } else if self.exponent.get() < 1.0 {
            f64::INFINITY
        } else {
            self.coefficient.get()
        };
        (self.yield_stress.get() + hardening, slope)
    }
}
