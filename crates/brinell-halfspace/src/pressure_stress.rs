//! Stress below pressures, the operator S, and what its transpose is: the displacement by plastic
//! strain.
//!
//! With `V = ∫∫ dA/ρ` and `χ = ∫∫ ln(z + ρ) dA` over a cell under unit pressure, ρ the distance to
//! a point at depth z,
//! ```text
//! σxx = (1/2π) [2ν V_z - (1-2ν) χ_xx - z V_xx]     σxy = -(1/2π) [(1-2ν) χ_xy + z V_xy]
//! σyy = (1/2π) [2ν V_z - (1-2ν) χ_yy - z V_yy]     σxz = -(z/2π) V_xz
//! σzz = (1/2π) [V_z - z V_zz]                      σyz = -(z/2π) V_yz
//! ```
//! The derivatives are sums over the corners `X = x ± hx/2, Y = y ± hy/2` with the sign of the
//! product, ρ² = X² + Y² + z²:
//! ```text
//! V_z  = -atan2(XY, zρ)     V_xx = X/(ρ(Y+ρ))    V_yy = Y/(ρ(X+ρ))    V_zz = -V_xx - V_yy
//! V_xy = 1/ρ                V_xz = z/(ρ(Y+ρ))    V_yz = z/(ρ(X+ρ))
//! χ_xx = 2 atan((ρ+Y+z)/X)  χ_yy = 2 atan((ρ+X+z)/Y)                  χ_xy = ln(z+ρ)
//! ```
//! where `ρ + Y = (X² + z²)/(ρ - Y)` for Y < 0. A layer's stress is the mean of two Gauss points
//! over its thickness.
//!
//! **Reciprocity.** A unit normal load at x works on a plastic strain as much as the displacement
//! that the strain causes at x: `u_p(x) = ∫ σ(load at x) : ε_p dV`, so that
//! ```text
//! û_p = Σ_l h_l Σ_k W_k conj(Ŝ_lk) ε̂_lk,   W = (1, 1, 1, 2, 2, 2)
//! ```
//! u_p is positive where the surface sinks, which opens the gap. Both are sums over the cells
//! themselves, without images.
//!
//! Each component is even or odd in x and in y. Its spectrum is real or imaginary, and a quadrant
//! says all.
//!
//! # Reference
//! A. E. H. Love (1929), see [`SurfaceFlexibility`](crate::SurfaceFlexibility); K. L. Johnson,
//! *Contact Mechanics* (1985), sections 3.2 and 3.4, for the potentials.

use std::f64::consts::PI;

use crate::offsets::Offsets;
use crate::stop::{Stop, Stopped, ask};
use crate::tensors::{COMPONENTS, WEIGHTS};
use crate::transform::Transform;
use crate::waves::{PARITIES, Parity, WIDTH};
use crate::{Layers, SurfaceGrid};

/// Spectra of the stresses of a cell under unit pressure.
pub(crate) struct PressureStress {
    /// `mx/2 + 1`.
    half: usize,
    n_layers: usize,
    /// Quadrants: wave number q_y, layer, component, wave number q_x.
    spectra: Vec<f64>,
}

impl PressureStress {
    pub fn new(
        transform: &Transform,
        grid: &SurfaceGrid,
        layers: &Layers,
        poisson: f64,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let of_corner = |x: f64, y: f64, z: f64| corner(x, y, z, poisson);
        Self::of_kernels(transform, (grid, layers), PARITIES, of_corner, stop)
    }

    /// Spectra of the stresses whose corner function, over 2π, is given.
    pub fn of_kernels(
        transform: &Transform,
        (grid, layers): (&SurfaceGrid, &Layers),
        parities: [Parity; COMPONENTS],
        corner: impl Fn(f64, f64, f64) -> [f64; COMPONENTS],
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let (half, n_layers) = (transform.mx / 2 + 1, layers.len());
        let block = n_layers * COMPONENTS * half;
        let mut spectra = vec![0.0; transform.n_rows() * block];
        let mut offsets = Offsets::new(transform, grid);
        let mut kernels: [Vec<f64>; COMPONENTS] =
            std::array::from_fn(|_| vec![0.0; grid.n_cells()]);
        for layer in 0..n_layers {
            ask(stop)?;
            let (middle, reach) =
                (layers.middle(layer), 0.5 * layers.thickness(layer) / 3.0_f64.sqrt());
            for kernel in &mut kernels {
                kernel.fill(0.0);
            }
            for z in [middle - reach, middle + reach] {
                offsets.add_corners(&mut kernels, 0.25 / PI, |x, y| corner(x, y, z));
            }
            for (component, (parity, kernel)) in parities.into_iter().zip(&kernels).enumerate() {
                let place = (layer * COMPONENTS + component) * half;
                for (row, to) in
                    offsets.spectrum(parity, kernel).zip(spectra.chunks_exact_mut(block))
                {
                    to[place..place + half].copy_from_slice(row);
                }
            }
        }
        Ok(Self { half, n_layers, spectra })
    }

    /// Multiplies the spectra of each component by a factor.
    pub fn scale(&mut self, factors: [f64; COMPONENTS]) {
        for (n, row) in self.spectra.chunks_exact_mut(self.half).enumerate() {
            for value in row {
                *value *= factors[n % COMPONENTS];
            }
        }
    }

    fn block(&self, iy: usize) -> &[f64] {
        let len = self.n_layers * COMPONENTS * self.half;
        &self.spectra[iy * len..][..len]
    }

    /// `σ̂ += Ŝ p̂` for one wave number q_y.
    #[inline(always)]
    pub fn add_stress(&self, iy: usize, pressure: &[f64], block: &mut [f64]) {
        let filled = self.half.next_multiple_of(WIDTH);
        let rows =
            block.chunks_exact_mut(pressure.len()).zip(self.block(iy).chunks_exact(self.half));
        for (n, (row, kernel)) in rows.enumerate() {
            let parity = PARITIES[n % COMPONENTS];
            let planes = row.chunks_exact_mut(filled).zip(pressure.chunks_exact(filled));
            for (plane, (stress, pressure)) in planes.enumerate() {
                let sign = parity.sign_in(plane);
                for ((s, p), k) in stress.iter_mut().zip(pressure).zip(kernel) {
                    *s += sign * p * k;
                }
            }
        }
    }

    /// `û_p = Σ_l h_l Σ_k W_k conj(Ŝ) ε̂` for one wave number q_y.
    #[inline(always)]
    pub fn opening(&self, iy: usize, strain: &[f64], layers: &Layers, opening: &mut [f64]) {
        let filled = self.half.next_multiple_of(WIDTH);
        opening.fill(0.0);
        let rows = strain.chunks_exact(opening.len()).zip(self.block(iy).chunks_exact(self.half));
        for (n, (row, kernel)) in rows.enumerate() {
            let (layer, component) = (n / COMPONENTS, n % COMPONENTS);
            let weight = layers.thickness(layer) * WEIGHTS[component];
            let planes = opening.chunks_exact_mut(filled).zip(row.chunks_exact(filled));
            for (plane, (opening, strain)) in planes.enumerate() {
                let factor = weight * PARITIES[component].sign_in(plane);
                for ((u, e), k) in opening.iter_mut().zip(strain).zip(kernel) {
                    *u += factor * e * k;
                }
            }
        }
    }
}

/// `ρ + y` without cancellation, where `rest = ρ² - y²`.
pub(crate) fn sum_with(rho: f64, y: f64, rest: f64) -> f64 {
    if y >= 0.0 { rho + y } else { rest / (rho - y) }
}

/// 2π times the stresses of one corner of a cell under unit pressure.
pub(crate) fn corner(x: f64, y: f64, z: f64, poisson: f64) -> [f64; COMPONENTS] {
    let rho = (x * x + y * y + z * z).sqrt();
    let (rho_y, rho_x) = (sum_with(rho, y, x * x + z * z), sum_with(rho, x, y * y + z * z));
    let (compressible, v_z) = (1.0 - 2.0 * poisson, -(x * y).atan2(z * rho));
    let (v_xx, v_yy) = (x / (rho * rho_y), y / (rho * rho_x));
    [
        2.0 * poisson * v_z - compressible * 2.0 * ((rho_y + z) / x).atan() - z * v_xx,
        2.0 * poisson * v_z - compressible * 2.0 * ((rho_x + z) / y).atan() - z * v_yy,
        v_z + z * (v_xx + v_yy),
        -(compressible * (z + rho).ln() + z / rho),
        -z * z / (rho * rho_y),
        -z * z / (rho * rho_x),
    ]
}
