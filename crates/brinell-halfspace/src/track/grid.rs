//! Columns and rows of a track.

use std::ops::Range;

use super::fault::TrackFault;
use super::figures::work_along;
use crate::transform::fast_length;
use crate::{GridError, Layers, SurfaceGrid};

/// Length of the track of a line over the half-width of the contact.
///
/// The material is a ring of this period. With 16, 32 and 64 half-widths the groove of a first pass
/// is 1.075, 1.034 and 1.021e-3 a; with friction every pass adds to this error.
pub const LENGTH_OF_LINE: f64 = 32.0;
/// Length of the track of an ellipse over the semi-axis along the travel. From 12 to 20 the groove
/// changes by 0.9 %.
pub const LENGTH_OF_ELLIPSE: f64 = 12.0;
/// Columns on each side of the load that may flow, in tenths of the ring.
///
/// Columns 0 and N-1 are neighbours, and the whole plastic change of a pass jumps between them, which
/// it does on no real track. Material that flowed there would take its stress for that of the
/// load. This far from the load the strain of a sound pass has long ended.
const LIVE: usize = 3;

/// Length of the window in which bodies may touch, over the semi-axis along the travel.
const WINDOW: f64 = 3.2;
/// Half the width of the track of an ellipse over the semi-axis across it: what a ball of 6 k leaves
/// stays in.
const ACROSS: f64 = 1.45;
/// Friction from which the first layers may decide: with a backstress well below the 0.37 of perfect
/// plasticity.
const FRICTION_OF_SURFACE: f64 = 0.25;

/// A hundred times the columns of the fine track of a line.
const MOST_COLUMNS: usize = 1 << 18;
/// A hundred times the cells of the fine track of an ellipse.
const MOST_CELLS: usize = 1 << 20;
const MOST: f64 = (2 * MOST_CELLS) as f64;

/// Layers below a track, in the shorter side of a cell and the shorter semi-axis.
struct Proportions {
    /// The first layer and the growth of the others.
    usual: [f64; 2],
    /// The same where friction decides at the surface.
    thin: [f64; 2],
    depth: f64,
}

const OF_LINE: Proportions = Proportions { usual: [0.75, 1.06], thin: [0.25, 1.08], depth: 3.0 };
const OF_ELLIPSE: Proportions = Proportions { usual: [0.75, 1.1], thin: [0.25, 1.12], depth: 2.4 };

/// Cells on the surface of a track: columns along a ring, with the load in the middle. A line has
/// one row of unit thickness; an ellipse rows across the track that lie symmetrically about the
/// axis y = 0.
///
/// Column i has its middle at `x = (i - nx/2) hx`. The load moves in +x: material enters at column
/// nx-1 and leaves at column 0. Fields of bodies are those of `y > 0`: row j has its middle at `y =
/// (j + ½) hy`, and a field its values in rows of nx. Bodies touch in a window of columns round the
/// middle, over the whole width; *surface fields* have the cells of the window, column by column
/// and on both sides of the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackGrid {
    nx: usize,
    rows: usize,
    hx: f64,
    hy: f64,
    first: usize,
    window: usize,
    is_line: bool,
}

impl TrackGrid {
    /// The track of a line: a ring of at least `n` columns of width `h` \[mm\] with a window of at
    /// least `window` columns, an odd number. n is rounded up to an even number without large
    /// factors.
    ///
    /// # Errors
    /// [`GridError`]: too few or too many columns, a window longer than the ring, or a width that
    /// is not positive.
    pub fn line(n: usize, h: f64, window: usize) -> Result<Self, GridError> {
        if n > MOST_COLUMNS {
            return Err(GridError::TooManyColumns(n));
        }
        let (nx, window) = (fast_length(n), window | 1);
        if nx < 4 || window < 3 || window >= nx {
            return Err(GridError::TooFewCells(nx, window));
        }
        if !(h > 0.0 && h.is_finite()) {
            return Err(GridError::CellSize(h, h));
        }
        let first = nx / 2 - window / 2;
        Ok(Self { nx, rows: 1, hx: h, hy: 1.0, first, window, is_line: true })
    }

    /// The track of an ellipse: a ring of at least `nx` columns and so many rows on each side of
    /// its axis, cells of `hx × hy` \[mm\], with a window of at least `window` columns, an odd
    /// number. nx is rounded up to a multiple of eight without large factors.
    ///
    /// # Errors
    /// [`GridError`]: too few or too many cells, a window longer than the ring, or sides that are
    /// not positive.
    pub fn ellipse(
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
        let first = nx / 2 - window / 2;
        Ok(Self { nx, rows, hx, hy, first, window, is_line: false })
    }

    /// The track of a line contact of half-width a \[mm\] with so many columns a half-width: a ring
    /// of [`LENGTH_OF_LINE`], or of another length over a.
    ///
    /// # Errors
    /// As [`line`](Self::line).
    pub fn of_line(half_width: f64, resolution: usize, length: f64) -> Result<Self, GridError> {
        let count = |length: f64| whole(length * resolution as f64);
        Self::line(count(length), half_width / resolution as f64, count(WINDOW))
    }

    /// The track of a contact with these semi-axes along and across the travel \[mm\], with so
    /// many cells over each: a ring of [`LENGTH_OF_ELLIPSE`], or of another length over the
    /// semi-axis along the travel.
    ///
    /// # Errors
    /// As [`ellipse`](Self::ellipse).
    pub fn of_ellipse(
        [a, b]: [f64; 2],
        resolution: usize,
        length: f64,
    ) -> Result<Self, GridError> {
        let count = |length: f64| whole((length * resolution as f64).ceil());
        let rows = count(ACROSS).next_multiple_of(2);
        let sides = [a, b].map(|axis| axis / resolution as f64);
        Self::ellipse(count(length), rows, sides, count(WINDOW))
    }

    /// Layers for the contact of these semi-axes \[mm\] under this friction: thin at the surface
    /// where friction decides.
    ///
    /// # Errors
    /// [`GridError::Faces`].
    pub fn layers(&self, [a, b]: [f64; 2], friction: f64) -> Result<Layers, GridError> {
        let Proportions { usual, thin, depth } = if self.is_line { OF_LINE } else { OF_ELLIPSE };
        let [first, growth] = if friction.abs() >= FRICTION_OF_SURFACE { thin } else { usual };
        let shorter = if self.is_line { self.hx } else { self.hx.min(self.hy) };
        Layers::graded(first * shorter, growth, depth * a.min(b))
    }

    /// Whether the contact is a line.
    pub const fn is_line(&self) -> bool {
        self.is_line
    }

    /// Number of columns of the ring.
    pub const fn n_columns(&self) -> usize {
        self.nx
    }

    /// Number of rows of a field, on one side of the axis; 1 of a line.
    pub const fn n_rows(&self) -> usize {
        self.rows
    }

    /// Cells of a layer of a field.
    pub const fn n_cells(&self) -> usize {
        self.nx * self.rows
    }

    /// Width of a column \[mm\].
    pub const fn column(&self) -> f64 {
        self.hx
    }

    /// Sides of a cell along x and y \[mm\]; unit thickness of a line.
    pub const fn sides(&self) -> [f64; 2] {
        [self.hx, self.hy]
    }

    /// Area of a cell \[mm²\]; of a line on unit thickness.
    pub fn cell_area(&self) -> f64 {
        self.hx * self.hy
    }

    /// Sides of the axis for which a row stands.
    pub const fn n_sides(&self) -> f64 {
        if self.is_line { 1.0 } else { 2.0 }
    }

    /// Width of all the cells for which a row stands \[mm\].
    pub fn row_width(&self) -> f64 {
        self.n_sides() * self.hy
    }

    /// Length of the ring \[mm\].
    pub fn length(&self) -> f64 {
        self.nx as f64 * self.hx
    }

    /// Half the width of the track of an ellipse \[mm\].
    pub fn half_width(&self) -> f64 {
        self.rows as f64 * self.hy
    }

    /// Columns in which bodies may touch.
    pub const fn window(&self) -> Range<usize> {
        self.first..self.first + self.window
    }

    /// Columns that may flow. Material enters at the last one.
    pub(super) const fn live(&self) -> Range<usize> {
        let half = LIVE * self.nx / 10;
        self.nx / 2 - half..self.nx / 2 + half
    }

    /// x of the middle of the columns of the window \[mm\].
    pub fn places(&self) -> Vec<f64> {
        self.window().map(|i| self.x(i)).collect()
    }

    /// x of the middle of a column \[mm\].
    pub fn x(&self, i: usize) -> f64 {
        (i as f64 - (self.nx / 2) as f64) * self.hx
    }

    /// y of the middle of a row \[mm\]; 0 of a line.
    pub fn y(&self, j: usize) -> f64 {
        if self.is_line { 0.0 } else { (j as f64 + 0.5) * self.hy }
    }

    /// Cells of a surface field in each column.
    const fn across(&self) -> usize {
        if self.is_line { 1 } else { 2 * self.rows }
    }

    /// y of the cells of a surface field in each column \[mm\]; 0 of a line.
    pub fn places_across(&self) -> impl Iterator<Item = f64> + Clone {
        let Self { rows, hy, is_line, .. } = *self;
        let y = move |j: usize| (j as f64 + 0.5 - rows as f64) * hy;
        (0..self.across()).map(move |j| if is_line { 0.0 } else { y(j) })
    }

    /// The surface field of a value at each place.
    pub fn sample(&self, value: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        let mut field = Vec::with_capacity(self.window * self.across());
        for i in self.window() {
            field.extend(self.places_across().map(|y| value(self.x(i), y)));
        }
        field
    }

    /// A surface field with x reversed.
    pub fn reversed(&self, field: &[f64]) -> Vec<f64> {
        field.chunks_exact(self.across()).rev().flatten().copied().collect()
    }

    /// A surface field on the axis, the mean of both rows beside it.
    pub fn along(&self, field: &[f64]) -> Vec<f64> {
        if self.is_line {
            return field.to_vec();
        }
        let columns = field.chunks_exact(self.across());
        columns.map(|cells| 0.5 * (cells[self.rows - 1] + cells[self.rows])).collect()
    }

    /// A surface field across the track, in the middle of the load.
    pub fn in_the_middle<'a>(&self, field: &'a [f64]) -> &'a [f64] {
        &field[self.across() * (self.window / 2)..][..self.across()]
    }

    /// The cells of the window of an ellipse, on which contact is solved.
    ///
    /// # Errors
    /// As [`SurfaceGrid::new`]; none of a grid that exists.
    pub fn surface(&self) -> Result<SurfaceGrid, GridError> {
        SurfaceGrid::new(self.window, self.across(), self.hx, self.hy)
    }

    /// Means over both sides of the axis of a surface field: row by row.
    pub(super) fn halved(&self, whole: &[f64], half: &mut [f64]) {
        if self.is_line {
            return half.copy_from_slice(whole);
        }
        for (i, cells) in whole.chunks_exact(self.across()).enumerate() {
            for j in 0..self.rows {
                half[j * self.window + i] =
                    0.5 * (cells[self.rows + j] + cells[self.rows - 1 - j]);
            }
        }
    }

    /// Adds the value of each row and column of the window to a surface field, on both sides.
    pub(super) fn add_to(&self, whole: &mut [f64], value: impl Fn(usize, usize) -> f64) {
        for (i, cells) in whole.chunks_exact_mut(self.across()).enumerate() {
            if self.is_line {
                cells[0] += value(0, i);
                continue;
            }
            for j in 0..self.rows {
                let value = value(j, i);
                cells[self.rows + j] += value;
                cells[self.rows - 1 - j] += value;
            }
        }
    }

    /// Why pressures in the cells of the window are cut off, if they are.
    ///
    /// # Errors
    /// [`TrackFault::Window`], [`TrackFault::Edge`].
    pub fn holds(&self, pressure: &[f64]) -> Result<(), TrackFault> {
        let (across, touches) =
            (self.across(), |cells: &[f64]| cells.iter().any(|pressure| *pressure > 0.0));
        if touches(&pressure[..across]) || touches(&pressure[pressure.len() - across..]) {
            return Err(TrackFault::Window { width: self.window as f64 * self.hx });
        }
        let at_edge = |cells: &[f64]| cells[0] > 0.0 || cells[across - 1] > 0.0;
        if !self.is_line && pressure.chunks_exact(across).any(at_edge) {
            return Err(TrackFault::Edge { half_width: self.half_width() });
        }
        Ok(())
    }

    /// The force against which a contact is pushed, `F = Σ p ∂δ0/∂x hx hy` \[N\], of a line on
    /// unit thickness \[N/mm\], of a pressure and the gap of the undeformed bodies.
    ///
    /// Of free rolling it is the plastic work and the change of the stored energy of all bodies,
    /// per length of travel.
    pub fn rolling_force(&self, gap: &[f64], pressure: &[f64]) -> f64 {
        let across = self.across();
        let row = |field: &[f64], j: usize| -> Vec<f64> {
            field.iter().skip(j).step_by(across).copied().collect()
        };
        let of_row = |j: usize| work_along(&row(pressure, j), &row(gap, j));
        self.hy * (0..across).map(of_row).sum::<f64>()
    }
}

/// A number of cells; what is beyond all tracks saturates, and is refused.
fn whole(count: f64) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and twice what is refused"
    )]
    let count = count.clamp(0.0, MOST) as usize;
    count
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
    fn lines_have_the_columns_of_the_contact() {
        let grid = TrackGrid::of_line(0.5, 20, LENGTH_OF_LINE).unwrap();
        assert_eq!((grid.n_columns(), grid.window().len(), grid.n_cells()), (640, 65, 640));
        assert!(grid.x(grid.window().start + 32).abs() < 1e-15);
        assert!((grid.length() - 16.0).abs() < 1e-12);
        for (half_width, resolution, length) in [
            (0.5, 0, 32.0),
            (0.5, 20, 3.0),
            (0.5, 20, f64::NAN),
            (0.5, 20, f64::INFINITY),
            (0.5, usize::MAX, 32.0),
            (0.0, 20, 32.0),
            (f64::NAN, 20, 32.0),
            (f64::INFINITY, 20, 32.0),
        ] {
            let grid = TrackGrid::of_line(half_width, resolution, length);
            assert!(grid.is_err(), "{half_width} {resolution} {length}");
        }
    }

    #[test]
    fn ellipses_have_the_cells_of_the_contact() {
        let grid = TrackGrid::of_ellipse([0.5, 0.8], 10, LENGTH_OF_ELLIPSE).unwrap();
        assert_eq!((grid.n_columns(), grid.n_rows(), grid.window().len()), (120, 16, 33));
        assert!(grid.x(60).abs() < 1e-15 && (grid.y(0) - 0.04).abs() < 1e-15);
        let surface = grid.surface().unwrap();
        assert!((surface.x(0) - grid.x(grid.window().start)).abs() < 1e-12);
        assert!((surface.y(16) - grid.y(0)).abs() < 1e-12);
        assert_eq!(TrackGrid::of_ellipse([0.5, 0.8], 7, 12.0).unwrap().n_columns(), 88);
        for (axes, resolution, length) in [
            ([0.5, 0.5], 0, 12.0),
            ([0.5, 0.5], 10, 3.0),
            ([0.5, 0.5], 10, f64::NAN),
            ([0.5, 0.5], 10, f64::INFINITY),
            ([0.5, 0.5], usize::MAX, 12.0),
            ([0.0, 0.5], 10, 12.0),
            ([0.5, f64::NAN], 10, 12.0),
        ] {
            let grid = TrackGrid::of_ellipse(axes, resolution, length);
            assert!(grid.is_err(), "{axes:?} {resolution} {length}");
        }
    }
}
