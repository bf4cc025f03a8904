//! Undeformed outlines.
//!
//! Every shape is described in its own frame: the contact starts at the origin, `x` is tangential, and
//! [`height`](Shape::Profile) is counted along the outward normal. Both bodies use the same convention, so
//! swapping `upper` and `lower` mirrors the problem.

use serde::Serialize;

use super::PositiveF64;

/// The undeformed outline of a body.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Shape {
    /// The half of a circular cylinder (a sphere in axisymmetry) that faces the other body, cut at its
    /// diametral plane, where it is supported.
    Cylinder {
        /// Radius R \[mm\].
        radius: PositiveF64,
    },
    /// A rectangle with its upper face in contact and its base supported.
    Block {
        /// Full width \[mm\], centred on the contact.
        width: PositiveF64,
        /// Height of the rectangle below the contact \[mm\].
        depth: PositiveF64,
    },
    /// A block with a concave circular trough across its upper face.
    Groove {
        /// Radius of the trough \[mm\].
        radius: PositiveF64,
        /// Full width \[mm\]; at most twice the radius.
        width: PositiveF64,
        /// Depth from the bottom of the trough to the base \[mm\].
        depth: PositiveF64,
    },
    /// A block whose upper face follows measured or designed points.
    Profile {
        /// `[x, height]` \[mm\], x strictly increasing; interpolated without overshoot.
        points: Vec<[f64; 2]>,
        /// Depth from height 0 to the base \[mm\].
        depth: PositiveF64,
    },
}
