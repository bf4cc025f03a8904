//! What is seen of each load of a hardness test.

use crate::job::{HardnessTest, TestScale};

/// One load of the test.
#[derive(Debug, Clone)]
pub(in crate::report) struct Seen {
    pub force: f64,
    pub approach: f64,
    /// Relative error of the approach.
    pub approach_bar: Option<f64>,
    pub half_width: f64,
    pub spacing: f64,
    pub stiffness: f64,
    pub dent: f64,
    /// Whether the specimen has yielded.
    pub has_yielded: bool,
    /// Place and height of the highest point of the specimen.
    pub highest: [f64; 2],
    /// `[x, height]` of the surface.
    pub surface: Vec<[f64; 2]>,
    /// Force and half-width of the increments.
    pub increments: Vec<[f64; 2]>,
    pub is_converged: bool,
}

pub(super) const fn is_pyramid(test: &HardnessTest) -> bool {
    matches!(test.scale, TestScale::Hv | TestScale::Berkovich)
}
