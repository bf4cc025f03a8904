//! Voce's exponential saturation.

use std::sync::Arc;

use super::{Curve, HardeningLaw};
use crate::job::fields::{Field, Known, record, unless};
use crate::job::{FieldError, PositiveF64, Quantity};

record! {
    /// q = σ_y + (σ_s − σ_y) (1 − exp(−b ε_p)).
    pub struct Voce("voce", "Voce") where rules {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Quantity::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Saturation stress σ_s, at least σ_y.
        pub saturation_stress: PositiveF64 =
            Field::quantity(Quantity::Stress).label("Saturation", "σ_s").example(750.0),
        /// Rate b.
        pub rate: PositiveF64 = Field::pure(1e-6..=1e6).label("Rate", "b").example(50.0),
    }
}

fn rules(known: &Known) -> Vec<FieldError> {
    let (first, last) = (known.figure("yield_stress"), known.figure("saturation_stress"));
    let rises = first.zip(last).is_none_or(|(first, last)| last >= first);
    unless(rises, "/saturation_stress", "must be at least `yield_stress`").into_iter().collect()
}

impl Curve for Voce {
    fn law(&self, _: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(self.clone())
    }
}

/// # Reference
/// E. Voce, *The relationship between stress and strain for homogeneous deformation*, J. Inst. Metals 74 (1948)
/// 537–562.
impl HardeningLaw for Voce {
    fn yield_stress(&self) -> f64 {
        self.yield_stress.get()
    }

    /// Halfway to saturation.
    fn flow_stress(&self) -> f64 {
        0.5 * (self.yield_stress.get() + self.saturation_stress.get())
    }

    fn stress(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).0
    }

    fn slope(&self, plastic_strain: f64) -> f64 {
        self.stress_and_slope(plastic_strain).1
    }

    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        // Without cancellation at small strains, however high the saturation stress.
        let range = self.saturation_stress.get() - self.yield_stress.get();
        let gained = -(-self.rate.get() * plastic_strain).exp_m1();
        (self.yield_stress.get() + range * gained, self.rate.get() * range * (1.0 - gained))
    }
}
