//! Kinematic hardening: backstress terms, for any hardening law.

use crate::job::fields::{Field, read_record, record};
use crate::job::reader::Cursor;
use crate::job::{Domain, NonNegativeF64, PositiveF64, Units};
use crate::material;

record! {
    /// One term of the backstress X, with dX = 2/3 C dε_p - γ X dp: Prager's law where γ is zero,
    /// Armstrong and Frederick's elsewhere; several terms are Chaboche's.
    #[derive(Copy)]
    pub struct BackstressTerm("", "Backstress") {
        /// Modulus C.
        pub modulus: PositiveF64 = Field::quantity(Domain::Modulus).label("Modulus", "C").example(20_000.0),
        /// Rate of recovery γ.
        pub rate: NonNegativeF64 = Field::pure(0.0..=1e6).label("Rate", "γ").example(100.0),
    }
}

impl From<&BackstressTerm> for material::BackstressTerm {
    fn from(term: &BackstressTerm) -> Self {
        Self { modulus: term.modulus.get(), rate: term.rate.get() }
    }
}

impl BackstressTerm {
    /// Largest number of terms in a material.
    pub const MAX_TERMS: usize = 4;

    pub(in crate::job) fn read_all(cursor: Cursor<'_>, units: Option<Units>) -> Option<Vec<Self>> {
        cursor.array(0..=Self::MAX_TERMS, |item| {
            read_record(&item.object()?, None, units, None, &[])
        })
    }
}
