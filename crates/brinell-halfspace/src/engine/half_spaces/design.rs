//! The extent of a grid and its cells.

use crate::{Layers, SurfaceGrid};

use super::error::HalfSpaceError;
use super::problem::{Expected, MOST_CELLS_ALONG};

/// Half a side of the grid over the semi-axis. From the prototype in Python.
const REACH: f64 = 1.6;
/// Thickness of the first layer over the shorter side of a cell, and growth of the layers times
/// cells along a side. From the prototype in Python.
const FIRST_LAYER: f64 = 0.75;
const GROWTH: f64 = 1.92;
/// Depth of the layers over the shorter semi-axis. From the prototype in Python.
const DEPTH: f64 = 2.6;
/// Overload of a ball, and what is left of it for a line, beyond which plastic zones are wider and
/// deeper than that; they grow with its square root. Perfectly plastic balls and ellipsoids of
/// radii 10 and 100 mm, overloads 3 to 30, reach within 0.9 of these grids.
const WIDE_ZONE: f64 = 8.0;
const WIDE_ZONE_OF_LINES: f64 = 4.0;
/// Reach of a grid beyond the ends of a roller, over the half-width of the contact.
const BEYOND_ENDS: f64 = 1.0;
/// Sides of cells along a roller over those across it, as long as they are not more than so many
/// times as many.
const ROLLER_ASPECT: f64 = 4.0;
/// Depth of the layers below heights over half the shorter side, and their growth.
const PATCH_DEPTH: f64 = 0.5;
const PATCH_GROWTH: f64 = 1.2;
/// Factor by which cells grow at least where contact or plastic strain has reached the end of a
/// grid.
const ENLARGEMENT: f64 = 1.3;
/// Half a side and depth of a grid over what yields on it.
const MARGIN: f64 = 1.1;

/// Layout of a grid. The expected reach over the semi-axes sets the number of cells. Where contact
/// or plastic strain reaches farther, the cells grow and not their number, which bounds the memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GridDesign {
    /// Semi-axes along x and y, or more where plastic strain reaches far beyond them \[mm\].
    pub semi_axes: [f64; 2],
    /// Cells over each of them.
    pub cells: f64,
    /// Half sides over the semi-axes.
    reach: [f64; 2],
    /// Depth of the layers over the shorter semi-axis.
    depth: f64,
    /// Factor on all depths.
    stretch: f64,
    /// Half the length of a roller along y, which cells do not go across \[mm\], and whether it
    /// touches from end to end.
    pub half_length: Option<f64>,
    is_line: bool,
    /// Cells along y over those along x.
    finer: f64,
    /// Cells of heights, and cells over a semi-axis for which the grid has as many.
    patch: Option<([usize; 2], f64)>,
    pub enlargements: usize,
}

impl GridDesign {
    /// For the contact that is expected, and a job that asks for `asked` cells.
    pub fn new(expected: Expected, cells: f64, asked: f64) -> Self {
        let Expected { semi_axes: [a, b], half_length, is_line, patch, overload, .. } = expected;
        let wide = WIDE_ZONE_OF_LINES + (WIDE_ZONE - WIDE_ZONE_OF_LINES) * (a / b);
        let beyond = (overload / wide).sqrt().max(1.0) - 1.0;
        // Beyond the ends of a long contact plastic strain reaches as far as beside it.
        let reach = [1.0 + beyond, 1.0 + beyond * a / b].map(|factor| REACH * factor);
        let reach = [
            reach[0],
            if is_line { 1.0 + BEYOND_ENDS * (1.0 + beyond) * a / b } else { reach[1] },
        ];
        let finer =
            if is_line { (b / (ROLLER_ASPECT * a)).clamp(1.0, MOST_CELLS_ALONG) } else { 1.0 };
        let depth = DEPTH * (1.0 + beyond);
        let semi_axes = [a, b];
        let (stretch, enlargements) = (1.0, 0);
        let patch = patch.map(|patch| (patch, asked));
        let (reach, depth) =
            if patch.is_some() { ([1.0; 2], PATCH_DEPTH) } else { (reach, depth) };
        Self {
            semi_axes,
            cells,
            reach,
            depth,
            stretch,
            half_length,
            is_line,
            finer,
            patch,
            enlargements,
        }
    }

    /// Whether the grid is that of heights.
    pub const fn is_patch(&self) -> bool {
        self.patch.is_some()
    }

    /// Returns this design with other cells.
    pub fn with_cells(self, cells: f64) -> Self {
        Self { cells, ..self }
    }

    /// A grid for both.
    pub fn union(self, other: Self) -> Self {
        let larger = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        Self {
            semi_axes: larger(self.semi_axes, other.semi_axes),
            reach: larger(self.reach, other.reach),
            depth: self.depth.max(other.depth),
            stretch: self.stretch.max(other.stretch),
            is_line: self.is_line || other.is_line,
            finer: self.finer.max(other.finer),
            ..self
        }
    }

    /// Returns a design of the same number of cells around a contact and the plastic region below
    /// it, by the reach of both \[mm\]; this design where nothing touches.
    pub fn fitted(self, contact: [f64; 2], plastic: [f64; 3]) -> Self {
        let mut axes = contact;
        if self.patch.is_some() || axes[0].min(axes[1]) <= 0.0 {
            return self;
        }
        if let Some(half_length) = self.half_length.filter(|_| self.is_line) {
            axes[1] = half_length;
        }
        let zone = plastic.map(|reach| MARGIN * reach);
        let semi_axes = [0, 1].map(|k| axes[k].max(zone[k] / self.reach[k]));
        let stretch = (zone[2] / (self.depth * semi_axes[0].min(semi_axes[1]))).max(1.0);
        Self { semi_axes, stretch, ..self }
    }

    /// A larger grid, for one whose ends along x, along y or in depth are reached, and that would
    /// be `fitted` so.
    pub fn enlarged(self, fitted: Self, reached: [bool; 3]) -> Self {
        let factor = reached.map(|reached| if reached { ENLARGEMENT } else { 1.0 });
        let [x, y] = self.semi_axes;
        let least = Self {
            semi_axes: [factor[0] * x, factor[1] * y],
            enlargements: self.enlargements + 1,
            ..self
        };
        let next = least.union(fitted);
        let stretch = factor[2] * self.stretch * self.shorter() / next.shorter();
        Self { stretch: stretch.max(1.0), ..next }
    }

    /// The shorter semi-axis \[mm\].
    pub fn shorter(&self) -> f64 {
        self.semi_axes[0].min(self.semi_axes[1])
    }

    /// Cells of the surface and layers below them.
    pub fn grid(&self) -> Result<(SurfaceGrid, Layers), HalfSpaceError> {
        if let Some((cells, asked)) = self.patch {
            return self.grid_of_patch(cells, self.cells / asked);
        }
        let [a, b] = self.semi_axes;
        let cells = [self.cells, self.cells * self.finer];
        let (hx, mut hy) = (a / cells[0], b / cells[1]);
        let mut over_semi_axes = cells;
        if let Some(half_length) = self.half_length {
            hy = half_length / (half_length / hy).ceil();
            over_semi_axes[1] = b / hy;
        }
        let sides = [hx, hy];
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small positive number"
        )]
        let counts = [0, 1].map(|k| 2 * (self.reach[k] * over_semi_axes[k]).ceil() as usize);
        let grid = SurfaceGrid::new(counts[0], counts[1], sides[0], sides[1])?;
        let growth = 1.0 + GROWTH / (2.0 * REACH * self.cells);
        let first = FIRST_LAYER * sides[0].min(sides[1]);
        let layers = Layers::graded(
            self.stretch * first,
            growth,
            self.stretch * self.depth * self.shorter(),
        )?;
        Ok((grid, layers))
    }
}

impl GridDesign {
    /// The grid of heights, with this part of its cells along each side. Layers grow faster than
    /// elsewhere, because there are many cells to a side.
    fn grid_of_patch(
        &self,
        cells: [usize; 2],
        part: f64,
    ) -> Result<(SurfaceGrid, Layers), HalfSpaceError> {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 512")]
        let counts = cells.map(|count| ((count as f64 * part).round() as usize).clamp(2, count));
        let sides = [0, 1].map(|k| 2.0 * self.semi_axes[k] / counts[k] as f64);
        let grid = SurfaceGrid::new(counts[0], counts[1], sides[0], sides[1])?;
        let first = FIRST_LAYER * sides[0].min(sides[1]);
        let depth = self.stretch * self.depth * self.shorter();
        Ok((grid, Layers::graded(first, PATCH_GROWTH, depth)?))
    }
}
