//! Straight hardening.

use std::sync::Arc;

use super::Curve;
use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, NonNegativeF64, PositiveF64};
use crate::material::{HardeningLaw, hardening};

record! {
    /// A straight line beyond the yield stress.
    pub struct Bilinear("bilinear", "Bilinear") where rules {
        /// Yield stress σ_y.
        pub yield_stress: PositiveF64 =
            Field::quantity(Domain::Stress).label("Yield stress", "σ_y").example(500.0),
        /// Slope E_t of stress over total strain beyond yield, below E; 0 is perfectly plastic.
        pub tangent_modulus: NonNegativeF64 =
            Field::quantity(Domain::TangentModulus).label("Tangent modulus", "E_t").example(10_500.0),
    }
}

fn rules(known: &Known) -> Vec<FieldError> {
    let (slope, young_modulus) = (known.figure("tangent_modulus"), known.figure("young_modulus"));
    let below = slope.zip(young_modulus).is_none_or(|(slope, limit)| slope < limit);
    unless(below, "/tangent_modulus", "must be less than `young_modulus`").into_iter().collect()
}

impl Curve for Bilinear {
    fn law(&self, young_modulus: f64) -> Arc<dyn HardeningLaw> {
        let (yield_stress, slope) = (self.yield_stress.get(), self.tangent_modulus.get());
        Arc::new(hardening::StraightLine::of_tangent(yield_stress, slope, young_modulus))
    }
}
