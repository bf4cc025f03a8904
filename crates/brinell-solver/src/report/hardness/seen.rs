//! What is seen of each load of a hardness test.

use crate::job::{HardnessTest, TestScale};

/// Force, half-width and approach at the end of an increment.
pub(in crate::report) type Increment = [f64; 3];

/// One load of the test.
#[derive(Debug, Clone)]
pub(in crate::report) struct Seen {
    pub force: f64,
    pub approach: f64,
    pub half_width: f64,
    pub stiffness: f64,
    pub dent: f64,
    /// Whether the specimen has yielded.
    pub has_yielded: bool,
    /// Place and height of the highest point of the specimen.
    pub highest: [f64; 2],
    /// `[x, height]` of the surface.
    pub surface: Vec<[f64; 2]>,
    /// The increments on the mesh and on the coarse one.
    pub increments: [Vec<Increment>; 2],
    pub is_converged: bool,
}

pub(super) const fn is_pyramid(test: &HardnessTest) -> bool {
    matches!(test.scale, TestScale::Hv | TestScale::Berkovich)
}
