//! The extent of a track and its columns.

use crate::Layers;
use crate::track::TrackGrid;

use super::error::TrackError;
use super::problem::RollingProblem;

/// Factor of the window, the depth and the length of a track that cuts off contact or yield.
const ENLARGEMENT: f64 = 1.5;

/// Columns and extent of a track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TrackDesign {
    /// Elastic semi-axes along and across the travel \[mm\]; the half-width of a line twice.
    pub semi_axes: [f64; 2],
    /// Columns over the first, and cells over the second.
    pub columns: usize,
    /// Length of the track over the first.
    pub length: f64,
    /// Friction that decides on the first layer.
    pub friction: f64,
    pub enlargements: usize,
    pub is_line: bool,
}

impl TrackDesign {
    /// The track of a problem with so many columns over the half-width.
    pub fn new(problem: &RollingProblem, columns: usize) -> Self {
        Self {
            semi_axes: problem.semi_axes(),
            columns,
            length: problem.length(),
            friction: problem.load.friction,
            enlargements: 0,
            is_line: problem.is_line(),
        }
    }

    /// Cells and layers. A larger track of an ellipse is wider and deeper, and not longer.
    pub fn lay(&self) -> Result<(TrackGrid, Layers), TrackError> {
        let (factor, columns) = self.extent();
        let semi_axes = self.semi_axes.map(|axis| factor * axis);
        let grid = if self.is_line {
            TrackGrid::of_line(semi_axes[0], columns, self.length)?
        } else {
            TrackGrid::of_ellipse(semi_axes, columns, self.length / factor)?
        };
        Ok((grid, grid.layers(semi_axes, self.friction)?))
    }

    /// The factor on all extents, and the cells over what the semi-axes become by it: all follow
    /// the contact that the grid is made for.
    fn extent(&self) -> (f64, usize) {
        let factor = ENLARGEMENT.powi(i32::try_from(self.enlargements).unwrap_or(i32::MAX));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some thousands at most"
        )]
        let columns = (factor * self.columns as f64).round() as usize;
        (columns as f64 / self.columns as f64, columns)
    }

    /// The shorter semi-axis \[mm\].
    pub const fn shorter(&self) -> f64 {
        self.semi_axes[0].min(self.semi_axes[1])
    }
}
