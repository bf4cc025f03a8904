//! Meshes of the two bodies: half-O-grids, columns through layers, and polar grids of a pin in a
//! hole.
//!
//! Each body is meshed in its own frame: the contact starts at the origin, `x` is tangential, `y`
//! points out of the body, so the material lies at `y <= surface(x)`. The upper body of a job is
//! the mirror image, so that two equal bodies share one mesh.
//!
//! ```text
//!   y ^   contact zone: columns of width h, the same abscissae on both bodies
//!     +--+--+--+--+----_____          free surface
//!     |  |  |  |  |   /    /  ‾‾--
//!     +--+--+--+--+--/    /      \    rings: thickness grows geometrically outward,
//!     |  |  |  |  | /    /        |   interpolated in (ln r, φ), a conformal map, so that
//!     +--+--+--+--+     /         |   right angles survive between block and outer boundary
//!     |    \    \      /          |
//!     +-----------------+---------+   support
//! ```

mod corner;
mod error;
mod frame;
mod half_o_grid;
mod interpolation;
mod layer;
mod locator;
mod outline;
mod polar;
mod quadrilaterals;
mod quality;
mod rounding;
mod smoothing;
mod zone;

pub use corner::Corner;
pub use error::{MESHED_SLOPE, MeshError};
pub use frame::SurfaceFrame;
pub use half_o_grid::Refinement;
pub use locator::{Locator, Place};
pub use outline::{FarBoundary, Outline, Ring};
pub use quadrilaterals::Mesh;
pub use quality::Quality;
pub use rounding::ROUNDING;
pub use zone::ContactZone;

/// Estimates the number of nodes of a mesh.
pub fn estimated_nodes(outline: &Outline, zone: &ContactZone, refinement: Refinement) -> usize {
    if let Some(ring) = outline.ring() {
        return polar::estimated_nodes(ring, zone, refinement);
    }
    let in_columns = || layer::estimated_nodes(outline, zone, refinement);
    if layer::is_layer(outline, zone) {
        return in_columns();
    }
    let in_rings = half_o_grid::estimated_nodes(outline, zone, refinement);
    if layer::is_flat(outline) { in_rings.max(in_columns()) } else { in_rings }
}

/// Powers with which the shape of the free surface fades into the body; the first one that gives a
/// valid mesh counts.
const FADES: [i32; 4] = [1, 2, 4, 8];

impl Mesh {
    /// Meshes a body around a contact zone.
    ///
    /// # Errors
    /// [`MeshError::ZoneBeyondBody`] if the zone is too wide for the body, [`MeshError::TooSteep`]
    /// or [`MeshError::Inverted`] if an element has a Jacobian that is not positive.
    pub fn generate(
        outline: &Outline,
        zone: &ContactZone,
        refinement: Refinement,
    ) -> Result<Self, MeshError> {
        if let Some(ring) = outline.ring() {
            let mesh = polar::generate(outline, ring, zone, refinement)?;
            return quality::require_positive_jacobians(&mesh).map(|()| mesh);
        }
        if layer::is_layer(outline, zone) {
            let mesh = layer::generate(outline, zone, refinement)?;
            return quality::require_positive_jacobians(&mesh).map(|()| mesh);
        }
        // Beside an off-centre zone on a narrow body the curved surface can fold the rings. A
        // steeper fade keeps its influence near the surface.
        let centre = [zone.centre(), outline.height(zone.centre())];
        let mut outcome = Err(MeshError::Inverted { element: 0 });
        for unfold in [false, true] {
            for fade in FADES {
                let mut mesh = half_o_grid::generate(outline, zone, refinement, fade)?;
                if unfold {
                    smoothing::unfold(&mut mesh, centre);
                }
                outcome = quality::require_positive_jacobians(&mesh).map(|()| mesh);
                if outcome.is_ok() {
                    return outcome;
                }
            }
        }
        if let Some([x, slope]) = outline.steepest().filter(|[_, slope]| *slope > MESHED_SLOPE) {
            return Err(MeshError::TooSteep { x, slope });
        }
        if layer::has_walls(outline) {
            let mesh = layer::generate(outline, zone, refinement)?;
            return quality::require_positive_jacobians(&mesh).map(|()| mesh);
        }
        outcome
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A zone of a part of the largest that fits, `shift` of the way to where it touches the end
    /// of that.
    fn zone(
        outline: &Outline,
        part: f64,
        shift: f64,
        columns: usize,
        symmetric: bool,
    ) -> ContactZone {
        let (left, right) = outline.span();
        let reach = 0.8 * right.min(-left);
        let half = part * reach;
        if symmetric {
            return ContactZone::uniform(0.0, half, columns, symmetric);
        }
        let centre = shift * (reach - half);
        ContactZone::uniform(centre - half, centre + half, 2 * columns, symmetric)
    }

    fn outlines() -> impl Strategy<Value = Outline> {
        let parabola = (1.0..100.0f64, 1.0..20.0f64).prop_map(|(flatness, room)| {
            let face =
                (-40..=40).map(|k| f64::from(k) * 0.25).map(|x| [x, -x * x / (20.0 * flatness)]);
            Outline::through(&face.collect::<Vec<_>>(), true, 5.0 / flatness + room)
        });
        let groove = (10.5..100.0f64, 1.0..40.0f64)
            .prop_map(|(radius, depth)| Outline::arc(-radius.recip(), 10.0, depth));
        prop_oneof![
            Just(Outline::arc(0.1, 10.0, 10.0)),
            (-4.0..3.5f64).prop_map(|decades| Outline::arc(0.0, 10.0, 10f64.powf(decades))),
            (1.2..8.0f64, 0.0..3.5f64).prop_map(|(exponent, decades)| Outline::power(
                exponent,
                20.0,
                20.0,
                9.0 + 10f64.powf(decades)
            )),
            groove,
            parabola,
        ]
    }

    /// Rings fold below the zone: columns take their place.
    #[test]
    fn a_shallow_groove_is_meshed() {
        let outline = Outline::arc(-10.5f64.recip(), 10.0, 1.0);
        let zone = zone(&outline, 0.775_711_419_760_809_9, 0.0, 4, false);
        assert!(Mesh::generate(&outline, &zone, Refinement { growth: 1.5 }).is_ok());
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]
        #[test]
        #[ignore = "full"]
        fn every_zone_that_fits_is_meshed(
            outline in outlines(),
            part in 0.001..1.0f64,
            shift in -1.0..1.0f64,
            columns in 4..64usize,
            symmetric: bool
        ) {
            let zone = zone(&outline, part, shift, columns, symmetric);
            let refinement = Refinement { growth: 1.0 + 2.0 / columns as f64 };
            let mesh = Mesh::generate(&outline, &zone, refinement);
            prop_assert!(mesh.is_ok(), "{:?}", mesh.err());
        }
    }
}
