//! Corners of a surface.

use super::ROUNDING;

/// Least opening slope of an edge, a corner at which pressure is unbounded and columns are graded;
/// least ratio of the slopes on its two sides. Both allow for rounding.
const EDGE: f64 = 0.25 * (1.0 - ROUNDING);
const STEEPER: f64 = 2.0 * (1.0 + ROUNDING);

/// A corner of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Where it is \[mm\].
    pub x: f64,
    /// Slopes of the surface's height to the left and to the right.
    pub slopes: [f64; 2],
    /// Whether the surface is smooth there and the corner exists only in the mesh.
    pub is_rounded: bool,
}

impl Corner {
    /// Decrease of the slope; positive at a convex corner.
    pub fn opening(&self) -> f64 {
        self.slopes[0] - self.slopes[1]
    }

    /// Side on which a contact ends at an edge: +1 for the right, -1 for the left, where the
    /// surface falls off much more steeply than on the other side; 0 without an edge.
    pub fn edge(&self) -> f64 {
        let [left, right] = self.slopes;
        if self.opening() < EDGE {
            0.0
        } else if right.abs() > STEEPER * left.abs() {
            1.0
        } else if left.abs() > STEEPER * right.abs() {
            -1.0
        } else {
            0.0
        }
    }
}
