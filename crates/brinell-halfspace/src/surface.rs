//! Normal displacement of the surface under pressures: the operator A.
//!
//! The pressure `p = R / (hx hy)` is constant in each cell. The surfaces of both bodies approach
//! each other at the centre of a cell by
//! ```text
//! u = A p = 1/(π E*) Σ p_cell F(x - x_cell, y - y_cell),    1/E* = Σ_bodies (1 - ν²)/E
//! F(x, y) = Σ±± [X asinh(Y/|X|) + Y asinh(X/|Y|)],   X = x ± hx/2,  Y = y ± hy/2,  sign = product of the two
//! ```
//! which is ∫∫ dA/r over a rectangle. The sum is a convolution, done by Fourier transforms of
//! twice the size: with the kernel at every offset between two cells it is the sum itself, without
//! images. F is even in x and in y, so its spectrum is real and a quadrant says all.
//!
//! The preconditioner is the inverse for a periodic surface, `p̂ = E*/2 |q| û`, on the cells
//! without padding. At q = 0, where it would vanish, it has half the value of the longest wave.
//!
//! # Reference
//! A. E. H. Love, *The stress produced in a semi-infinite solid by pressure on part of the
//! boundary*, Phil. Trans. R. Soc. A 228 (1929) 377–420; S. Liu, Q. Wang, G. Liu, *A versatile
//! method of discrete convolution and FFT (DC-FFT) for contact analyses*, Wear 243 (2000) 101–111.

use std::cell::RefCell;
use std::f64::consts::{FRAC_PI_2, PI};

use brinell_contact::Flexibility;
use realfft::num_complex::Complex64;

use crate::SurfaceGrid;
use crate::offsets::Offsets;
use crate::transform::{Scratch, Transform, fast_length};
use crate::waves::Parity;

/// The flexibility of two half-spaces on a surface grid. Holds plans, kernel and work space.
pub struct SurfaceFlexibility {
    grid: SurfaceGrid,
    padded: Transform,
    /// Real spectrum of the kernel \[mm/N\], quadrant by rows of q_y.
    kernel: Vec<f64>,
    periodic: Transform,
    /// `E*/2 |q| hx hy` \[N/mm\], quadrant by rows of q_y.
    stiffness: Vec<f64>,
    work: RefCell<Work>,
}

struct Work {
    spectrum: Vec<Complex64>,
    padded: Scratch,
    periodic: Scratch,
}

impl SurfaceFlexibility {
    /// The surface of two bodies with the modulus `1/E* = Σ (1 - ν²)/E` \[MPa\].
    pub fn new(grid: SurfaceGrid, effective_modulus: f64) -> Self {
        Self::inclined(grid, effective_modulus, [0.0; 2])
    }

    /// The surface of two bodies that bend round each other, one convex and one concave. The
    /// normal turns by `ψ_k = κ_k s_k` over an arc s_k along x and y, with the κ_k of both bodies
    /// in `curvature` \[1/mm\]. Forces and displacements are along the normals:
    /// ```text
    /// F -> F cos ψ r/c,    ψ² = ψ_x² + ψ_y²,    c² = Σ (2/κ_k sin ψ_k/2)²
    /// ```
    /// with the arc r and the chord c between two cells; 0 from a right angle on.
    ///
    /// In the plane this is the displacement `cos ψ ln c` of a disc and a hole of equal materials,
    /// but for an even part: A. Persson, *On the stress distribution of cylindrical elastic bodies
    /// in contact*, dissertation, Chalmers (1964).
    pub fn inclined(grid: SurfaceGrid, effective_modulus: f64, curvature: [f64; 2]) -> Self {
        let (nx, ny) = (grid.nx(), grid.ny());
        let padded = Transform::new(nx, ny, fast_length(2 * nx), fast_length(2 * ny));
        let mut offsets = Offsets::new(&padded, &grid);
        let mut kernel = [vec![0.0; grid.n_cells()]];
        let factor = 1.0 / (PI * effective_modulus * grid.cell_area());
        offsets.add_corners(&mut kernel, factor, |x, y| [potential(x, y)]);
        if curvature.iter().any(|curvature| *curvature > 0.0) {
            for (k, value) in kernel[0].iter_mut().enumerate() {
                let arc = [(k / ny) as f64 * grid.hx(), (k % ny) as f64 * grid.hy()];
                *value *= inclination(arc, curvature);
            }
        }
        let kernel = offsets.spectrum(Parity::Even, &kernel[0]).flatten().copied().collect();
        let periodic = Transform::new(nx, ny, nx, ny);
        let (dx, dy) = (2.0 * PI / (nx as f64 * grid.hx()), 2.0 * PI / (ny as f64 * grid.hy()));
        let scale = 0.5 * effective_modulus * grid.cell_area();
        let stiffness = (0..=ny / 2)
            .flat_map(|j| {
                (0..=nx / 2).map(move |i| {
                    let q = f64::hypot(i as f64 * dx, j as f64 * dy);
                    scale * if i + j == 0 { 0.5 * dx.min(dy) } else { q }
                })
            })
            .collect();
        let work = Work {
            spectrum: vec![Complex64::ZERO; padded.spectrum_len()],
            padded: padded.scratch(),
            periodic: periodic.scratch(),
        };
        Self { grid, padded, kernel, periodic, stiffness, work: RefCell::new(work) }
    }

    /// The cells.
    pub const fn grid(&self) -> &SurfaceGrid {
        &self.grid
    }
}

/// Multiplies a spectrum by a real quadrant.
fn multiply(transform: &Transform, quadrant: &[f64], spectrum: &mut [Complex64]) {
    let half = transform.mx / 2 + 1;
    for (row, factors) in spectrum.chunks_exact_mut(transform.mx).zip(quadrant.chunks_exact(half))
    {
        let (positive, negative) = row.split_at_mut(half);
        for (value, factor) in positive.iter_mut().zip(factors) {
            *value *= *factor;
        }
        for (value, factor) in negative.iter_mut().rev().zip(&factors[1..]) {
            *value *= *factor;
        }
    }
}

impl Flexibility for SurfaceFlexibility {
    fn len(&self) -> usize {
        self.grid.n_cells()
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        let work = &mut *self.work.borrow_mut();
        self.padded.forward(force, &mut work.spectrum, &mut work.padded);
        multiply(&self.padded, &self.kernel, &mut work.spectrum);
        self.padded.inverse(&mut work.spectrum, displacement, &mut work.padded);
    }

    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        let work = &mut *self.work.borrow_mut();
        let spectrum = &mut work.spectrum[..self.periodic.spectrum_len()];
        self.periodic.forward(displacement, spectrum, &mut work.periodic);
        multiply(&self.periodic, &self.stiffness, spectrum);
        self.periodic.inverse(spectrum, force, &mut work.periodic);
    }
}

/// `cos ψ r/c` of two places that are an arc apart along x and y.
fn inclination(arc: [f64; 2], curvature: [f64; 2]) -> f64 {
    let turn = [0, 1].map(|k| curvature[k] * arc[k]);
    let angle = f64::hypot(turn[0], turn[1]);
    if angle >= FRAC_PI_2 {
        return 0.0;
    }
    let chord = [0, 1].map(|k| {
        let half = 0.5 * turn[k];
        if half > 0.0 { arc[k] * half.sin() / half } else { arc[k] }
    });
    let [long, short] = [arc, chord].map(|[x, y]| f64::hypot(x, y));
    angle.cos() * if short > 0.0 { long / short } else { 1.0 }
}

/// `X asinh(Y/|X|) + Y asinh(X/|Y|)`: ∫∫ dA/r from the origin to the corner `(X, Y)`.
fn potential(x: f64, y: f64) -> f64 {
    x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh()
}
