//! Meshes that serve for a load and the next one.

use brinell_contact::ContactLoad;

/// Factor by which a mesh is finer than requested if a smaller load follows.
const FALLING_RESERVE: f64 = 1.2;

/// Returns the factor by which a mesh is finer than requested, so that it serves for a smaller
/// next load. A larger contact fits into the margin of the zone.
pub(crate) fn resolution_reserve(load: ContactLoad, next: Option<ContactLoad>) -> f64 {
    match next {
        Some(next) if next.magnitude() < load.magnitude() => FALLING_RESERVE,
        _ => 1.0,
    }
}
