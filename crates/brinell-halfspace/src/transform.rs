//! Fourier transforms of fields on a surface grid, padded with zeros.
//!
//! A field of `nx × ny` reals becomes `mx × (my/2 + 1)` complex numbers. Rows along y are transformed first, and only those that
//! hold a number other than zero; then columns along x. A *stack* holds the spectra of several fields, wave number along
//! y outermost: `stack[((iy n_fields) + field) mx + ix]`. All fields of one wave number q_y are thus one contiguous *block*,
//! which a recursion over layers finds in the cache.
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

/// What a transform writes on.
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

    /// Numbers of a stack of `n_fields`.
    pub const fn stack_len(&self, n_fields: usize) -> usize {
        self.n_rows() * n_fields * self.mx
    }

    pub fn scratch(&self) -> Scratch {
        let zero = Complex64::ZERO;
        let y = self.forward_y.get_scratch_len().max(self.inverse_y.get_scratch_len());
        let x = self.forward_x.get_inplace_scratch_len().max(self.inverse_x.get_inplace_scratch_len());
        Scratch {
            row: vec![0.0; self.my],
            rows: vec![zero; self.nx * self.n_rows()],
            y: vec![zero; y],
            x: vec![zero; x],
        }
    }

    /// Rows along y of a field into the first `nx` numbers of each row of the stack; the rest of a row becomes zero.
    /// Whether the field holds a number other than zero.
    pub fn rows_forward(
        &self,
        field: &[f64],
        stack: &mut [Complex64],
        n_fields: usize,
        index: usize,
        scratch: &mut Scratch,
    ) -> bool {
        let n_rows = self.n_rows();
        let mut any = false;
        for (values, row) in field.chunks_exact(self.ny).zip(scratch.rows.chunks_exact_mut(n_rows)) {
            if values.iter().all(|value| *value == 0.0) {
                row.fill(Complex64::ZERO);
                continue;
            }
            any = true;
            scratch.row[..self.ny].copy_from_slice(values);
            scratch.row[self.ny..].fill(0.0);
            let done = self.forward_y.process_with_scratch(&mut scratch.row, row, &mut scratch.y);
            debug_assert!(done.is_ok(), "the plan's own lengths");
        }
        let rows = &scratch.rows;
        for (iy, block) in stack.chunks_exact_mut(n_fields * self.mx).enumerate() {
            let (head, tail) = block[index * self.mx..][..self.mx].split_at_mut(self.nx);
            if any {
                for (to, row) in head.iter_mut().zip(rows.chunks_exact(n_rows)) {
                    *to = row[iy];
                }
            } else {
                head.fill(Complex64::ZERO);
            }
            tail.fill(Complex64::ZERO);
        }
        any
    }

    /// Columns along x of whole rows of a stack, in place.
    pub fn columns_forward(&self, rows: &mut [Complex64], scratch: &mut Scratch) {
        self.forward_x.process_with_scratch(rows, &mut scratch.x);
    }

    /// Columns along x of whole rows of a stack, back, in place.
    pub fn columns_inverse(&self, rows: &mut [Complex64], scratch: &mut Scratch) {
        self.inverse_x.process_with_scratch(rows, &mut scratch.x);
    }

    /// Rows along y back into a field, from a stack whose columns are back.
    pub fn rows_inverse(
        &self,
        stack: &[Complex64],
        n_fields: usize,
        index: usize,
        field: &mut [f64],
        scratch: &mut Scratch,
    ) {
        let n_rows = self.n_rows();
        for (iy, block) in stack.chunks_exact(n_fields * self.mx).enumerate() {
            let from = &block[index * self.mx..][..self.nx];
            // The spectrum of a real row is real where its wave number is its own negative.
            let own_negative = iy == 0 || 2 * iy == self.my;
            for (row, value) in scratch.rows.chunks_exact_mut(n_rows).zip(from) {
                row[iy] = if own_negative { Complex64::new(value.re, 0.0) } else { *value };
            }
        }
        let scale = 1.0 / (self.mx * self.my) as f64;
        for (values, row) in field.chunks_exact_mut(self.ny).zip(scratch.rows.chunks_exact_mut(n_rows)) {
            let done = self.inverse_y.process_with_scratch(row, &mut scratch.row, &mut scratch.y);
            debug_assert!(done.is_ok(), "the plan's own lengths, real ends");
            for (value, from) in values.iter_mut().zip(&scratch.row) {
                *value = scale * from;
            }
        }
    }

    /// One field into a stack of one.
    pub fn forward(&self, field: &[f64], spectrum: &mut [Complex64], scratch: &mut Scratch) {
        self.rows_forward(field, spectrum, 1, 0, scratch);
        self.columns_forward(spectrum, scratch);
    }

    /// A stack of one back into a field.
    pub fn inverse(&self, spectrum: &mut [Complex64], field: &mut [f64], scratch: &mut Scratch) {
        self.columns_inverse(spectrum, scratch);
        self.rows_inverse(spectrum, 1, 0, field, scratch);
    }
}
