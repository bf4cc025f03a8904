//! Writing a job back in its own units.

use serde::ser::SerializeMap;

use super::{Quantity, Units};

/// A part of a job beside the units in which it is to be written.
pub(super) struct InUnits<'a, T>(pub &'a T, pub Units);

impl<T> InUnits<'_, T> {
    /// Writes one dimensional member.
    pub fn entry<M: SerializeMap>(
        &self,
        map: &mut M,
        key: &'static str,
        quantity: Quantity,
        core: impl Into<f64>,
    ) -> Result<(), M::Error> {
        map.serialize_entry(key, &quantity.to_wire(self.1, core.into()))
    }
}
