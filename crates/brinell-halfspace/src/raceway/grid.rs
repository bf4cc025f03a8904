//! Columns and rows of a track of finite width.

use crate::{GridError, Layers, SurfaceGrid};

/// Length of the track over the semi-axis along the travel.
///
/// The material is a ring of this period. From 12 to 20 the groove changes by 0.9 %.
pub const RACEWAY_LENGTH: f64 = 12.0;
/// Half the width of the track over the semi-axis across it: what a ball of 6 k leaves stays in.
const ACROSS: f64 = 1.45;
/// Length of the window in which bodies may touch, over the semi-axis.
const WINDOW: f64 = 3.2;
/// First layer over the shorter side of a cell, growth of the layers, and depth over the shorter
/// semi-axis.
const FIRST_LAYER: f64 = 0.75;
const GROWTH: f64 = 1.1;
const DEPTH: f64 = 2.4;
/// Friction from which the first layers may decide, and the first layer and growth of the layers
/// then.
const FRICTION_OF_SURFACE: f64 = 0.25;
const THIN: [f64; 2] = [0.25, 1.12];
/// Cells of the surface of a track: a hundred times those of a fine one.
const MOST_CELLS: usize = 1 << 20;
const MOST: usize = 2 * MOST_CELLS;

/// Cells on the surface of a track: columns along a ring, with the load in the middle, and rows
/// across it that lie symmetrically about the axis y = 0.
///
/// Column i has its middle at `x = (i - nx/2) hx`. The load moves in +x: material enters at column
/// nx-1 and leaves at column 0. All fields are those of `y > 0`: row j has its middle at `y = (j +
/// ½) hy`, and a field its values in rows of nx. Bodies touch in a window of columns round the
/// middle, over the whole width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RacewayGrid {
    pub(super) nx: usize,
    pub(super) rows: usize,
    pub(super) hx: f64,
    pub(super) hy: f64,
    pub(super) first: usize,
    window: usize,
}

impl RacewayGrid {
    /// A ring of at least `nx` columns and so many rows on each side of its axis, cells of `hx ×
    /// hy` \[mm\], with a window of at least `window` columns, an odd number. nx is rounded up to a
    /// multiple of eight without large factors.
    ///
    /// # Errors
    /// [`GridError`]: too few or too many cells, a window longer than the ring, or sides that are
    /// not positive.
    pub fn new(
        nx: usize,
        rows: usize,
        [hx, hy]: [f64; 2],
        window: usize,
    ) -> Result<Self, GridError> {
        if nx > MOST_CELLS || rows > MOST_CELLS || nx.saturating_mul(rows) > MOST_CELLS {
            return Err(GridError::TooManyColumns(nx));
        }
        let (nx, window) = (length_of_ring(nx), window | 1);
        if rows < 2 || window < 3 || window >= nx {
            return Err(GridError::TooFewCells(nx, rows));
        }
        if !(hx > 0.0 && hy > 0.0 && hx.is_finite() && hy.is_finite()) {
            return Err(GridError::CellSize(hx, hy));
        }
        Ok(Self { nx, rows, hx, hy, first: nx / 2 - window / 2, window })
    }

    /// The track of a contact with these semi-axes along and across the travel \[mm\], with so
    /// many cells over each: a ring of [`RACEWAY_LENGTH`], or of another length over the semi-axis
    /// along the travel.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_contact(
        [a, b]: [f64; 2],
        resolution: usize,
        length: f64,
    ) -> Result<Self, GridError> {
        let count = |length: f64| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "at most twice as many as are refused"
            )]
            let count = (length * resolution as f64).ceil().clamp(0.0, MOST as f64) as usize;
            count
        };
        let rows = count(ACROSS).next_multiple_of(2);
        let sides = [a, b].map(|axis| axis / resolution as f64);
        Self::new(count(length), rows, sides, 2 * (count(WINDOW) / 2) + 1)
    }

    /// Layers for the contact of these semi-axes \[mm\] under this friction: thin at the surface
    /// where friction decides.
    ///
    /// # Errors
    /// [`GridError::Faces`].
    pub fn layers(&self, [a, b]: [f64; 2], friction: f64) -> Result<Layers, GridError> {
        let [first, growth] =
            if friction.abs() >= FRICTION_OF_SURFACE { THIN } else { [FIRST_LAYER, GROWTH] };
        Layers::graded(first * self.hx.min(self.hy), growth, DEPTH * a.min(b))
    }

    /// Number of columns of the ring.
    pub const fn n_columns(&self) -> usize {
        self.nx
    }

    /// Number of rows on each side of the axis.
    pub const fn n_rows(&self) -> usize {
        self.rows
    }

    /// Cells of half the track.
    pub const fn n_cells(&self) -> usize {
        self.nx * self.rows
    }

    /// Sides of a cell along x and y \[mm\].
    pub const fn sides(&self) -> [f64; 2] {
        [self.hx, self.hy]
    }

    /// Area of a cell \[mm²\].
    pub fn cell_area(&self) -> f64 {
        self.hx * self.hy
    }

    /// Length of the ring \[mm\].
    pub fn length(&self) -> f64 {
        self.nx as f64 * self.hx
    }

    /// Half the width of the track \[mm\].
    pub fn half_width(&self) -> f64 {
        self.rows as f64 * self.hy
    }

    /// Columns in which bodies may touch.
    pub const fn window(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.window
    }

    /// x of the middle of a column \[mm\].
    pub fn x(&self, i: usize) -> f64 {
        (i as f64 - (self.nx / 2) as f64) * self.hx
    }

    /// y of the middle of a row \[mm\].
    pub fn y(&self, j: usize) -> f64 {
        (j as f64 + 0.5) * self.hy
    }

    /// The cells of the window on both sides of the axis, on which contact is solved.
    ///
    /// # Errors
    /// As [`SurfaceGrid::new`]; none of a grid that exists.
    pub fn surface(&self) -> Result<SurfaceGrid, GridError> {
        SurfaceGrid::new(self.window, 2 * self.rows, self.hx, self.hy)
    }

    /// Means over both sides of the axis of a value in the cells of the window: row by row.
    pub(super) fn halved(&self, whole: &[f64], half: &mut [f64]) {
        let ny = 2 * self.rows;
        for (i, cells) in whole.chunks_exact(ny).enumerate() {
            for j in 0..self.rows {
                half[j * self.window + i] =
                    0.5 * (cells[self.rows + j] + cells[self.rows - 1 - j]);
            }
        }
    }
}

/// The smallest multiple of eight from `least` on without a prime factor above 11.
fn length_of_ring(least: usize) -> usize {
    let is_smooth = |mut n: usize| {
        for factor in [2, 3, 5, 7, 11] {
            while n.is_multiple_of(factor) {
                n /= factor;
            }
        }
        n == 1
    };
    let mut n = least.max(8).next_multiple_of(8);
    while !is_smooth(n) {
        n += 8;
    }
    n
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_have_the_cells_of_the_contact() {
        let grid = RacewayGrid::of_contact([0.5, 0.8], 10, RACEWAY_LENGTH).unwrap();
        assert_eq!((grid.n_columns(), grid.n_rows(), grid.window().len()), (120, 16, 33));
        assert!(grid.x(60).abs() < 1e-15 && (grid.y(0) - 0.04).abs() < 1e-15);
        let surface = grid.surface().unwrap();
        assert!((surface.x(0) - grid.x(grid.window().start)).abs() < 1e-12);
        assert!((surface.y(16) - grid.y(0)).abs() < 1e-12);
        assert_eq!(RacewayGrid::of_contact([0.5, 0.8], 7, 12.0).unwrap().n_columns(), 88);
        for (axes, resolution, length) in [
            ([0.5, 0.5], 0, 12.0),
            ([0.5, 0.5], 10, 3.0),
            ([0.5, 0.5], 10, f64::NAN),
            ([0.5, 0.5], 10, f64::INFINITY),
            ([0.5, 0.5], usize::MAX, 12.0),
            ([0.0, 0.5], 10, 12.0),
            ([0.5, f64::NAN], 10, 12.0),
        ] {
            let grid = RacewayGrid::of_contact(axes, resolution, length);
            assert!(grid.is_err(), "{axes:?} {resolution} {length}");
        }
    }
}
