//! The columns of a track.

use std::f64::consts::PI;

use brinell_contact::Flexibility;

use crate::transform::fast_length;
use crate::{GridError, Layers};

/// Length of the track over the half-width of the contact.
///
/// The material is a ring of this period. With 16, 32 and 64 half-widths the groove of a first pass
/// is 1.075, 1.034 and 1.021e-3 a; with friction every pass adds to this error.
pub const TRACK_LENGTH: f64 = 32.0;
/// Columns on each side of the load that may flow, in tenths of the ring.
///
/// Columns 0 and N-1 are neighbours, and the whole plastic change of a pass jumps between them, which
/// it does on no real track. Material that flowed there would take its stress for that of the
/// load. This far from the load the strain of a sound pass has long ended.
const LIVE: usize = 3;

/// Width of the window in which bodies may touch, over the half-width.
const WINDOW: f64 = 3.2;
/// Depth of the layers over the half-width.
const DEPTH: f64 = 3.0;
/// Friction from which the first layers may decide: with a backstress well below the 0.37 of perfect
/// plasticity.
const FRICTION_OF_SURFACE: f64 = 0.25;

/// A hundred times the columns of a fine track.
const MOST_COLUMNS: usize = 1 << 18;

/// Columns of one width h along a ring, with the load in the middle.
///
/// Column i has its middle at `x = (i - N/2) h`. The load moves in +x: material enters at column
/// N-1 and leaves at column 0. Bodies touch in a window of columns round the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackGrid {
    pub(super) n: usize,
    pub(super) h: f64,
    first: usize,
    window: usize,
}

impl TrackGrid {
    /// A ring of at least `n` columns of width `h` \[mm\] with a window of at least `window`
    /// columns, an odd number. n is rounded up to an even number without large factors.
    ///
    /// # Errors
    /// [`GridError`]: too few or too many columns, a window longer than the ring, or a width that
    /// is not positive.
    pub fn new(n: usize, h: f64, window: usize) -> Result<Self, GridError> {
        if n > MOST_COLUMNS {
            return Err(GridError::TooManyColumns(n));
        }
        let (n, window) = (fast_length(n), window | 1);
        if n < 4 || window < 3 || window >= n {
            return Err(GridError::TooFewCells(n, window));
        }
        if !(h > 0.0 && h.is_finite()) {
            return Err(GridError::CellSize(h, h));
        }
        Ok(Self { n, h, first: n / 2 - window / 2, window })
    }

    /// The track of a contact of half-width a \[mm\] with so many columns a half-width: a ring of
    /// [`TRACK_LENGTH`], or of another length over a.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_contact(half_width: f64, resolution: usize, length: f64) -> Result<Self, GridError> {
        let count = |length: f64| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "saturates, and long rings are refused"
            )]
            let count = (length * resolution as f64).max(0.0) as usize;
            count
        };
        Self::new(count(length), half_width / resolution as f64, count(WINDOW))
    }

    /// Layers for this track and friction: thin at the surface where friction decides.
    ///
    /// # Errors
    /// [`GridError::Faces`].
    pub fn layers(&self, half_width: f64, friction: f64) -> Result<Layers, GridError> {
        let (first, growth) =
            if friction.abs() >= FRICTION_OF_SURFACE { (0.25, 1.08) } else { (0.75, 1.06) };
        Layers::graded(first * self.h, growth, DEPTH * half_width)
    }

    /// Number of columns N.
    pub const fn n_columns(&self) -> usize {
        self.n
    }

    /// Width of a column \[mm\].
    pub const fn h(&self) -> f64 {
        self.h
    }

    /// Columns in which bodies may touch.
    pub const fn window(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.window
    }

    /// Length of the ring \[mm\].
    pub fn length(&self) -> f64 {
        self.n as f64 * self.h
    }

    /// x of the middle of a column \[mm\].
    pub fn x(&self, i: usize) -> f64 {
        (i as f64 - (self.n / 2) as f64) * self.h
    }

    /// A value at the middle of each column of the window.
    pub fn sample(&self, value: impl Fn(f64) -> f64) -> Vec<f64> {
        self.window().map(|i| value(self.x(i))).collect()
    }
}

/// Columns of a ring that may flow, with the load in the middle. Material enters at the last one.
pub(crate) const fn live_columns(n: usize) -> std::ops::Range<usize> {
    let half = LIVE * n / 10;
    n / 2 - half..n / 2 + half
}

/// The flexibility of the columns of the window: force per length \[N/mm\] to displacement along
/// the normal \[mm\].
///
/// ```text
/// A = -2/(πE*) [F(x+h/2) - F(x-h/2)],   F(x) = x ln(|x|/ℓ) - x
/// ```
/// A line load presses a half-plane in by any amount: the datum ℓ, the width of the window, makes
/// the flexibility positive definite. It adds the same displacement everywhere, and so the
/// approach of a line contact means nothing.
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), section 2.5.
#[derive(Debug, Clone)]
pub struct LineFlexibility {
    n: usize,
    entries: Vec<f64>,
}

impl LineFlexibility {
    /// The flexibility of two bodies with `1/E* = effective_modulus⁻¹` \[MPa\].
    pub fn new(grid: &TrackGrid, effective_modulus: f64) -> Self {
        let (n, h) = (grid.window, grid.h);
        let datum = n as f64 * h;
        let f = |x: f64| x * (x.abs() / datum).ln() - x;
        let of_offset = |offset: usize| {
            let x = offset as f64 * h;
            -2.0 / (PI * effective_modulus) * (f(x + 0.5 * h) - f(x - 0.5 * h)) / h
        };
        let column: Vec<f64> = (0..n).map(of_offset).collect();
        let entries = (0..n * n).map(|k| column[(k / n).abs_diff(k % n)]).collect();
        Self { n, entries }
    }
}

impl Flexibility for LineFlexibility {
    fn len(&self) -> usize {
        self.n
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        for (u, row) in displacement.iter_mut().zip(self.entries.chunks_exact(self.n)) {
            *u = row.iter().zip(force).map(|(a, r)| a * r).sum();
        }
    }

    fn dense(&self) -> Option<&[f64]> {
        Some(&self.entries)
    }
}

#[cfg(test)]
mod tests {
    use brinell_contact::{
        ActiveSetSolver, ContactLoad, ContactProblem, ContactSolver, SimplexSolver, never,
    };

    use super::*;

    #[test]
    fn grids_that_cannot_be_are_refused() {
        let of = |half_width: f64, resolution: usize, length: f64| {
            TrackGrid::of_contact(half_width, resolution, length)
        };
        let grid = of(0.5, 20, TRACK_LENGTH).unwrap();
        assert_eq!((grid.n_columns(), grid.window().len()), (640, 65));
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
            assert!(
                of(half_width, resolution, length).is_err(),
                "{half_width} {resolution} {length}"
            );
        }
    }

    /// Positive definite up to the whole window, as both solvers ask; the peak is that of Hertz.
    #[test]
    fn both_contact_solvers_take_the_flexibility() {
        let grid = TrackGrid::of_contact(1.0, 20, TRACK_LENGTH).unwrap();
        let (modulus, peak) = (230_000.0, 1000.0);
        let flexibility = LineFlexibility::new(&grid, modulus);
        let solve = |solver: &dyn ContactSolver, gap: &[f64]| {
            let closing = vec![1.0; gap.len()];
            let load = ContactLoad::Force(0.5 * PI * peak);
            let problem = ContactProblem {
                flexibility: &flexibility,
                initial_gap: gap,
                closing: &closing,
                load,
            };
            solver.solve(&problem, None, &mut never).unwrap()
        };
        let gap = grid.sample(|x| x * x * peak / modulus);
        let (one, other) = (solve(&ActiveSetSolver, &gap), solve(&SimplexSolver, &gap));
        for (a, b) in one.force.iter().zip(&other.force) {
            assert!((a - b).abs() < 1e-9 * peak, "{a} {b}");
        }
        let found = one.force.iter().fold(0.0, |a: f64, b| a.max(*b)) / grid.h();
        assert!((found / peak - 1.0).abs() < 1.2e-4, "{found}");
        assert!(one.pivots < 12, "{}", one.pivots);
        // A flat punch touches everywhere.
        assert_eq!(solve(&ActiveSetSolver, &vec![0.0; gap.len()]).active_set.len(), gap.len());
    }
}
