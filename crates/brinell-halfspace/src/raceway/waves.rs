//! Spectra of fields on half a track, in real numbers.
//!
//! Each component is even or odd in y, so that its transform along y is a sum of cosines or sines
//! over the rows at y > 0; along x it is that of a ring. With the spectra of components whose
//! kernel is odd in one coordinate multiplied by -i, as in [`waves`](crate::waves), all operators
//! are real. With the transform R + iI along x of a sum 2 Σ f cos(q_y y) or 2 Σ f sin(q_y y), the
//! two *planes* of a row of `filled` numbers each over `q_x >= 0` are
//! ```text
//! xx yy zz     R    I
//! xz           I   -R
//! xy           I   -R     of the sum of sines
//! yz          -R   -I     of the sum of sines
//! ```
//! A track ends across the travel, and its box is padded there: images of a plastic zone lie one
//! period away. Those of short waves along x do not reach it, because a wave q_x decays as
//! exp(-q_x y). The `low` longest waves are therefore transformed in a *wide* box too, four times
//! as wide, where G acts on them.

use std::f64::consts::PI;
use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use crate::track::TrackGrid;
use crate::transform::{Transform, fast_length};
use crate::waves::{WIDTH, Wide, combine, wave};

/// Width of the wide box over that of the narrow one.
const WIDE_BOX: usize = 4;
/// Decay of the first wave that is not low, over the width of the track: exp(-10) is 5e-5.
const DECAY: f64 = 10.0;

/// Layout of a component in planes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Planes {
    /// xx, yy, zz, and fields on the surface.
    Even,
    /// xy, xz.
    Turned,
    /// yz.
    Reversed,
}

/// Planes of a component of a tensor, and whether it is odd in y.
pub(super) const fn planes_of(component: usize) -> (Planes, bool) {
    match component {
        3 => (Planes::Turned, true),
        4 => (Planes::Turned, false),
        5 => (Planes::Reversed, true),
        _ => (Planes::Even, false),
    }
}

/// Sums of cosines (0) and of sines (1) over the rows, and back.
struct Across {
    /// Period of the box over a row.
    period: usize,
    /// Wave number, row.
    to: [Vec<f64>; 2],
    /// Row, wave number.
    from: [Vec<f64>; 2],
}

impl Across {
    fn new(rows: usize, period: usize) -> Self {
        let n_waves = period / 2 + 1;
        let weight = |k: usize| {
            let both = if k == 0 || 2 * k == period { 1.0 } else { 2.0 };
            both / period as f64
        };
        let to = |is_odd: bool| {
            let of_wave = move |k: usize| (0..rows).map(move |j| 2.0 * wave(k, j, period, is_odd));
            (0..n_waves).flat_map(of_wave).collect()
        };
        let from = |is_odd: bool| {
            let of_row =
                |j: usize| (0..n_waves).map(move |k| weight(k) * wave(k, j, period, is_odd));
            (0..rows).flat_map(of_row).collect()
        };
        Self { period, to: [to(false), to(true)], from: [from(false), from(true)] }
    }

    const fn n_waves(&self) -> usize {
        self.period / 2 + 1
    }
}

/// The wave vectors of a track.
pub(super) struct RingWaves {
    pub rows: usize,
    pub nx: usize,
    /// `nx/2 + 1` filled up.
    pub filled: usize,
    /// Waves along x that have the wide box, a multiple of [`WIDTH`].
    pub low: usize,
    narrow: Across,
    wide: Across,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    arch: pulp::Arch,
}

/// Which box.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Span {
    Narrow,
    Wide,
}

/// Work space of the transforms.
pub(super) struct RingScratch {
    /// Rows of planes of one field.
    pub rows: Vec<f64>,
    low_rows: Vec<f64>,
    table: Vec<f64>,
    row: Vec<f64>,
    spectrum: Vec<Complex64>,
    complex: Vec<Complex64>,
}

impl RingWaves {
    pub fn new(grid: &TrackGrid, arch: pulp::Arch) -> Self {
        let (nx, rows) = (grid.n_columns(), grid.n_rows());
        let filled = (nx / 2 + 1).next_multiple_of(WIDTH);
        let period = fast_length(4 * rows);
        let apart = (period - 2 * rows) as f64 * grid.sides()[1];
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a positive number, bounded by that of all waves"
        )]
        let low = (DECAY * grid.length() / (2.0 * PI * apart)).ceil() as usize;
        let mut planner = RealFftPlanner::new();
        Self {
            rows,
            nx,
            filled,
            low: low.next_multiple_of(WIDTH).clamp(WIDTH, filled),
            narrow: Across::new(rows, period),
            wide: Across::new(rows, WIDE_BOX * period),
            forward: planner.plan_fft_forward(nx),
            inverse: planner.plan_fft_inverse(nx),
            arch,
        }
    }

    /// Numbers of a row of both planes.
    pub const fn row_len(&self, of: Span) -> usize {
        match of {
            Span::Narrow => 2 * self.filled,
            Span::Wide => 2 * self.low,
        }
    }

    /// Wave numbers along y.
    pub const fn n_waves(&self, of: Span) -> usize {
        self.across(of).n_waves()
    }

    const fn across(&self, of: Span) -> &Across {
        match of {
            Span::Narrow => &self.narrow,
            Span::Wide => &self.wide,
        }
    }

    /// The box as operators ask for it.
    pub fn transform(&self, of: Span) -> Transform {
        let mx = match of {
            Span::Narrow => self.nx,
            Span::Wide => self.ring_of_low(),
        };
        Transform::new(mx, 2 * self.rows, mx, self.across(of).period)
    }

    /// Columns of a ring that has the low waves only.
    pub const fn ring_of_low(&self) -> usize {
        2 * (self.low - 1)
    }

    pub fn scratch(&self) -> RingScratch {
        let n_waves = self.narrow.n_waves().max(self.wide.n_waves());
        let complex = self.forward.get_scratch_len().max(self.inverse.get_scratch_len());
        RingScratch {
            rows: vec![0.0; self.rows * 2 * self.filled],
            low_rows: vec![0.0; self.rows * 2 * self.low],
            table: vec![0.0; n_waves * 2 * self.filled],
            row: vec![0.0; self.nx],
            spectrum: vec![Complex64::ZERO; self.nx / 2 + 1],
            complex: vec![Complex64::ZERO; complex],
        }
    }

    /// Transforms the first rows of a field along x into planes, times a factor.
    pub fn along_x<'a>(
        &self,
        field: impl Iterator<Item = &'a [f64]>,
        start: usize,
        (planes, factor): (Planes, f64),
        scratch: &mut RingScratch,
    ) {
        let half = self.nx / 2 + 1;
        for (values, row) in field.zip(scratch.rows.chunks_exact_mut(2 * self.filled)) {
            scratch.row.fill(0.0);
            scratch.row[start..start + values.len()].copy_from_slice(values);
            let done = self.forward.process_with_scratch(
                &mut scratch.row,
                &mut scratch.spectrum,
                &mut scratch.complex,
            );
            debug_assert!(done.is_ok(), "the plan's own lengths");
            let (first, second) = row.split_at_mut(self.filled);
            for ((first, second), z) in first.iter_mut().zip(&mut *second).zip(&scratch.spectrum) {
                let (re, im) = (factor * z.re, factor * z.im);
                (*first, *second) = match planes {
                    Planes::Even => (re, im),
                    Planes::Turned => (im, -re),
                    Planes::Reversed => (-re, -im),
                };
            }
            first[half..].fill(0.0);
            second[half..].fill(0.0);
        }
    }

    /// Transforms the first `reach` rows that [`along_x`](Self::along_x) has left along y. `row_of`
    /// is where a wave number of a stack has the field.
    pub fn along_y<'s>(
        &self,
        of: Span,
        (is_odd, reach): (bool, usize),
        stack: impl Iterator<Item = &'s mut [f64]>,
        scratch: &mut RingScratch,
    ) {
        if of == Span::Wide {
            let wide = scratch.low_rows.chunks_exact_mut(2 * self.low);
            for (low, row) in wide.zip(scratch.rows.chunks_exact(2 * self.filled)).take(reach) {
                low[..self.low].copy_from_slice(&row[..self.low]);
                low[self.low..].copy_from_slice(&row[self.filled..][..self.low]);
            }
        }
        let row_len = self.row_len(of);
        let rows = if of == Span::Wide { &scratch.low_rows } else { &scratch.rows };
        let table = &rows[..reach * row_len];
        let mut waves = stack.zip(self.across(of).to[usize::from(is_odd)].chunks_exact(self.rows));
        self.arch.dispatch(Wide(
            #[inline(always)]
            || {
                for (row, waves) in waves.by_ref() {
                    combine(&waves[..reach], table, row);
                }
            },
        ));
    }

    /// The rows of a field whose spectra are given: those of the narrow box replace what is in the
    /// scratch, those of the wide one are added.
    pub fn back_along_y<'s>(
        &self,
        of: Span,
        is_odd: bool,
        stack: impl Iterator<Item = &'s [f64]>,
        scratch: &mut RingScratch,
    ) {
        let row_len = self.row_len(of);
        let RingScratch { rows, low_rows, table, .. } = scratch;
        for (to, from) in table.chunks_exact_mut(row_len).zip(stack) {
            to.copy_from_slice(from);
        }
        let n_waves = self.n_waves(of);
        let table = &table[..n_waves * row_len];
        let mut factors = self.across(of).from[usize::from(is_odd)].chunks_exact(n_waves);
        let into = if of == Span::Wide { &mut *low_rows } else { &mut *rows };
        let mut into = into.chunks_exact_mut(row_len);
        self.arch.dispatch(Wide(
            #[inline(always)]
            || {
                for (row, factors) in into.by_ref().zip(factors.by_ref()) {
                    combine(factors, table, row);
                }
            },
        ));
        if of == Span::Wide {
            let low_rows = low_rows.chunks_exact(2 * self.low);
            for (row, low) in rows.chunks_exact_mut(2 * self.filled).zip(low_rows) {
                for (plane, part) in low.chunks_exact(self.low).enumerate() {
                    for (to, from) in row[plane * self.filled..].iter_mut().zip(part) {
                        *to += from;
                    }
                }
            }
        }
    }

    /// The field of the rows that are in the scratch. Columns from `start` on, as many as `field`
    /// has in a row.
    pub fn back_along_x(
        &self,
        planes: Planes,
        (start, width): (usize, usize),
        field: &mut [f64],
        scratch: &mut RingScratch,
    ) {
        let scale = 1.0 / self.nx as f64;
        let last = self.nx / 2;
        let rows = scratch.rows.chunks_exact(2 * self.filled);
        for (values, row) in field.chunks_exact_mut(width).zip(rows) {
            let (first, second) = row.split_at(self.filled);
            for ((first, second), z) in first.iter().zip(second).zip(&mut scratch.spectrum) {
                let (first, second) = (scale * first, scale * second);
                *z = match planes {
                    Planes::Even => Complex64::new(first, second),
                    Planes::Turned => Complex64::new(-second, first),
                    Planes::Reversed => Complex64::new(-first, -second),
                };
            }
            // Real where a wave number is its own negative.
            (scratch.spectrum[0].im, scratch.spectrum[last].im) = (0.0, 0.0);
            let done = self.inverse.process_with_scratch(
                &mut scratch.spectrum,
                &mut scratch.row,
                &mut scratch.complex,
            );
            debug_assert!(done.is_ok(), "the plan's own lengths, real ends");
            values.copy_from_slice(&scratch.row[start..][..width]);
        }
    }

    /// Sums over the rows of a field that does not depend on x, and back.
    pub fn of_uniform(&self, is_odd: bool, rows: impl Iterator<Item = f64>) -> Vec<f64> {
        let rows: Vec<f64> = rows.collect();
        let waves = self.wide.to[usize::from(is_odd)].chunks_exact(self.rows);
        waves.map(|waves| waves.iter().zip(&rows).map(|(w, value)| w * value).sum()).collect()
    }

    /// The reverse.
    pub fn to_uniform(&self, is_odd: bool, spectrum: impl Iterator<Item = f64>) -> Vec<f64> {
        let spectrum: Vec<f64> = spectrum.collect();
        let rows = self.wide.from[usize::from(is_odd)].chunks_exact(self.wide.n_waves());
        rows.map(|waves| waves.iter().zip(&spectrum).map(|(w, value)| w * value).sum()).collect()
    }
}
