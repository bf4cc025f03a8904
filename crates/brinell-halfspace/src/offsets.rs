//! Spectra of kernels that depend on the offset between two cells.

use realfft::num_complex::Complex64;

use crate::SurfaceGrid;
use crate::transform::{Scratch, Transform};
use crate::waves::Parity;

/// The offsets between two cells of a grid, with what it takes to transform a kernel over them.
pub(crate) struct Offsets {
    grid: SurfaceGrid,
    whole: Transform,
    scratch: Scratch,
    field: Vec<f64>,
    spectrum: Vec<Complex64>,
}

impl Offsets {
    /// Offsets in the padded box of a transform, at least twice as long as the grid either way; on a
    /// ring along x the grid has the offsets up to half its length.
    pub fn new(transform: &Transform, grid: &SurfaceGrid) -> Self {
        let (mx, my) = (transform.mx, transform.my);
        let whole = Transform::new(mx, my, mx, my);
        let (scratch, len) = (whole.scratch(), whole.spectrum_len());
        Self {
            grid: *grid,
            whole,
            scratch,
            field: vec![0.0; mx * my],
            spectrum: vec![Complex64::ZERO; len],
        }
    }

    /// Differences `Σ±± sign function(x ± hx/2, y ± hy/2)` at offsets that are not negative, times
    /// `factor`, added to N kernels (row by row, `nx × ny`).
    pub fn add_corners<const N: usize>(
        &self,
        kernels: &mut [Vec<f64>; N],
        factor: f64,
        function: impl Fn(f64, f64) -> [f64; N],
    ) {
        let (nx, ny) = (self.grid.nx(), self.grid.ny());
        let corner = |i: usize, j: usize| {
            function((i as f64 - 0.5) * self.grid.hx(), (j as f64 - 0.5) * self.grid.hy())
        };
        let mut before: Vec<[f64; N]> = (0..=ny).map(|j| corner(0, j)).collect();
        let mut after = vec![[0.0; N]; ny + 1];
        for i in 0..nx {
            for (j, values) in after.iter_mut().enumerate() {
                *values = corner(i + 1, j);
            }
            for (k, kernel) in kernels.iter_mut().enumerate() {
                for (j, value) in kernel[i * ny..][..ny].iter_mut().enumerate() {
                    let (right, left) =
                        (after[j + 1][k] - before[j + 1][k], after[j][k] - before[j][k]);
                    *value += factor * (right - left);
                }
            }
            std::mem::swap(&mut before, &mut after);
        }
    }

    /// Quadrant of the spectrum of a kernel given at offsets that are not negative. It is real
    /// where the kernel is even or odd in both offsets; elsewhere it is imaginary, and its
    /// imaginary part is returned. Rows of q_y.
    pub fn spectrum(
        &mut self,
        parity: Parity,
        kernel: &[f64],
    ) -> impl Iterator<Item = &[f64]> + use<'_> {
        let (nx, ny, mx, my) = (self.grid.nx(), self.grid.ny(), self.whole.mx, self.whole.my);
        let sign_x = if parity.is_odd_in_x() { -1.0 } else { 1.0 };
        let sign_y = if parity.is_odd_in_y() { -1.0 } else { 1.0 };
        self.field.fill(0.0);
        for i in 0..nx {
            for (j, value) in kernel[i * ny..][..ny].iter().enumerate() {
                let (mirror_i, mirror_j) = ((mx - i) % mx, (my - j) % my);
                // Half a ring is its own mirror image.
                let value = &if 2 * i == mx && sign_x < 0.0 { 0.0 } else { *value };
                self.field[mirror_i * my + mirror_j] = sign_x * sign_y * value;
                self.field[mirror_i * my + j] = sign_x * value;
                self.field[i * my + mirror_j] = sign_y * value;
                self.field[i * my + j] = *value;
            }
        }
        self.whole.forward(&self.field, &mut self.spectrum, &mut self.scratch);
        for (to, from) in self.field.iter_mut().zip(&self.spectrum) {
            *to = if parity.is_imaginary() { from.im } else { from.re };
        }
        let half = mx / 2 + 1;
        self.field.chunks_exact(mx).take(my / 2 + 1).map(move |row| &row[..half])
    }
}
