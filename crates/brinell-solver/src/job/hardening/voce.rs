//! Voce's exponential saturation.

use std::sync::Arc;

use super::Curve;
use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};
use crate::material::{HardeningLaw, hardening};

record! {
    /// q = σ_y + (σ_s − σ_y) (1 − exp(−b ε_p)).
    pub struct Voce("voce", "Voce") where rules {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Domain::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Saturation stress σ_s, at least σ_y.
        pub saturation_stress: PositiveF64 =
            Field::quantity(Domain::Stress).label("Saturation", "σ_s").example(750.0),
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
        Arc::new(hardening::Voce {
            yield_stress: self.yield_stress.get(),
            saturation_stress: self.saturation_stress.get(),
            rate: self.rate.get(),
        })
    }
}
