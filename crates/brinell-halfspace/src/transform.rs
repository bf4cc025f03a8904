//! Fourier transforms of fields on a surface grid, padded with zeros.
//!
//! A field of `nx × ny` reals becomes `mx × (my/2 + 1)` complex numbers, wave number along y
//! outermost. Rows along y are transformed first, and only those that hold a number other than
//! zero; then columns along x.
//!
//! Nothing is scaled on the way in; on the way out by `1/(mx my)`.

use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::Fft;

/// Plans for one size.
#[derive(Clone)]
pub(crate) struct Transform {
    pub nx: usize,
    pub ny: usize,
    /// Length along x with padding.
    pub mx: usize,
    /// Length along y with padding.
    pub my: usize,
    forward_y: Arc<dyn RealToComplex<f64>>,
    inverse_y: Arc<dyn ComplexToReal<f64>>,
    forward_x: Arc<dyn Fft<f64>>,
    inverse_x: Arc<dyn Fft<f64>>,
}

/// Work space of a transform.
#[derive(Clone)]
pub(crate) struct Scratch {
    row: Vec<f64>,
    /// `nx` rows of `my/2 + 1`.
    rows: Vec<Complex64>,
    y: Vec<Complex64>,
    x: Vec<Complex64>,
}

/// The smallest even number from `least` on without a prime factor above 5.
pub(crate) fn fast_length(least: usize) -> usize {
    let smooth = |mut n: usize| {
        for factor in [2, 3, 5] {
            while n.is_multiple_of(factor) {
                n /= factor;
            }
        }
        n == 1
    };
    let mut n = least.max(2).next_multiple_of(2);
    while !smooth(n) {
        n += 2;
    }
    n
}

impl Transform {
    /// Transforms of fields of `nx × ny` in a box of `mx × my`.
    pub fn new(nx: usize, ny: usize, mx: usize, my: usize) -> Self {
        let mut real = RealFftPlanner::new();
        let mut complex = rustfft::FftPlanner::new();
        Self {
            nx,
            ny,
            mx,
            my,
            forward_y: real.plan_fft_forward(my),
            inverse_y: real.plan_fft_inverse(my),
            forward_x: complex.plan_fft_forward(mx),
            inverse_x: complex.plan_fft_inverse(mx),
        }
    }

    /// Wave numbers along y that are kept, `my/2 + 1`.
    pub const fn n_rows(&self) -> usize {
        self.my / 2 + 1
    }

    /// Numbers of a spectrum.
    pub const fn spectrum_len(&self) -> usize {
        self.n_rows() * self.mx
    }

    pub fn scratch(&self) -> Scratch {
        let zero = Complex64::ZERO;
        let y = self.forward_y.get_scratch_len().max(self.inverse_y.get_scratch_len());
        let x =
            self.forward_x.get_inplace_scratch_len().max(self.inverse_x.get_inplace_scratch_len());
        Scratch {
            row: vec![0.0; self.my],
            rows: vec![zero; self.nx * self.n_rows()],
            y: vec![zero; y],
            x: vec![zero; x],
        }
    }

    /// Spectra along y of the `nx` rows of a field.
    pub fn rows_forward<'a>(&self, field: &[f64], scratch: &'a mut Scratch) -> &'a [Complex64] {
        let n_rows = self.n_rows();
        for (values, row) in field.chunks_exact(self.ny).zip(scratch.rows.chunks_exact_mut(n_rows))
        {
            if values.iter().all(|value| *value == 0.0) {
                row.fill(Complex64::ZERO);
                continue;
            }
            scratch.row[..self.ny].copy_from_slice(values);
            scratch.row[self.ny..].fill(0.0);
            let done = self.forward_y.process_with_scratch(&mut scratch.row, row, &mut scratch.y);
            debug_assert!(done.is_ok(), "the plan's own lengths");
        }
        &scratch.rows
    }

    /// Columns along x of whole rows, in place.
    pub fn columns_forward(&self, rows: &mut [Complex64], scratch: &mut Scratch) {
        self.forward_x.process_with_scratch(rows, &mut scratch.x);
    }

    /// Columns along x of whole rows, back, in place.
    pub fn columns_inverse(&self, rows: &mut [Complex64], scratch: &mut Scratch) {
        self.inverse_x.process_with_scratch(rows, &mut scratch.x);
    }

    /// The field whose spectra along y are in [`rows_mut`](Scratch::rows_mut).
    pub fn rows_inverse(&self, field: &mut [f64], scratch: &mut Scratch) {
        let scale = 1.0 / (self.mx * self.my) as f64;
        let rows = scratch.rows.chunks_exact_mut(self.n_rows());
        for (values, row) in field.chunks_exact_mut(self.ny).zip(rows) {
            // The spectrum of a real row is real where its wave number is its own negative.
            row[0].im = 0.0;
            if self.my.is_multiple_of(2) {
                row[self.my / 2].im = 0.0;
            }
            let done = self.inverse_y.process_with_scratch(row, &mut scratch.row, &mut scratch.y);
            debug_assert!(done.is_ok(), "the plan's own lengths, real ends");
            for (value, from) in values.iter_mut().zip(&scratch.row) {
                *value = scale * from;
            }
        }
    }

    /// A field into its spectrum.
    pub fn forward(&self, field: &[f64], spectrum: &mut [Complex64], scratch: &mut Scratch) {
        let (rows, n_rows) = (self.rows_forward(field, scratch), self.n_rows());
        for (iy, line) in spectrum.chunks_exact_mut(self.mx).enumerate() {
            for (to, row) in line.iter_mut().zip(rows.chunks_exact(n_rows)) {
                *to = row[iy];
            }
            line[self.nx..].fill(Complex64::ZERO);
        }
        self.columns_forward(spectrum, scratch);
    }

    /// The reverse; uses up the spectrum.
    pub fn inverse(&self, spectrum: &mut [Complex64], field: &mut [f64], scratch: &mut Scratch) {
        self.columns_inverse(spectrum, scratch);
        let n_rows = self.n_rows();
        for (iy, line) in spectrum.chunks_exact(self.mx).enumerate() {
            for (row, value) in scratch.rows.chunks_exact_mut(n_rows).zip(line) {
                row[iy] = *value;
            }
        }
        self.rows_inverse(field, scratch);
    }
}

impl Scratch {
    /// Spectra along y of the rows of a field.
    pub fn rows_mut(&mut self) -> &mut [Complex64] {
        &mut self.rows
    }
}
