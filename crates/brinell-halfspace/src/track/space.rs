//! The operators of a half-space under a line load on a ring.

use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::grid::TrackGrid;
use super::strip;
use super::sweep::{PLANES, ROWS, Sweep, SweepWork};
use crate::stop::{Stop, Stopped, ask};
use crate::waves::Wide;
use crate::{Elasticity, Layers};

/// S and S_t (pressure and traction to stress), Sᵀ and S_tᵀ (plastic strain to displacement) and G
/// (plastic strain to stress) of a body, of states that do not depend on y.
///
/// The material is a ring: G and the offsets of S have the period of the grid, and the pressure
/// acts once. Fields have three components xx, zz, xz of a deviator in each cell, in rows `layer,
/// component` of N columns. Plastic strains are given as polarization `τ = 2μ ε_p` \[MPa\].
pub struct TrackSpace {
    grid: TrackGrid,
    layers: Layers,
    elastic: Elasticity,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
    /// Spectra of deviators of stress under pressure: layer, row, wave number.
    normal: Vec<f64>,
    /// Spectra of deviators of stress under traction, multiplied by ±i.
    tangential: Vec<f64>,
    sweep: Sweep,
    arch: pulp::Arch,
}

/// Work space of an evaluation, with the spectra that it carries from strain to stress.
pub struct TrackWork {
    stack: Vec<f64>,
    row: Vec<f64>,
    spectrum: Vec<Complex64>,
    scratch: Vec<Complex64>,
    /// Real and imaginary part of a field on the surface.
    surface: [Vec<f64>; 2],
    sweep: SweepWork,
}

/// The direction of a surface load or displacement.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    Normal,
    Tangential,
}

impl TrackSpace {
    /// The operators of a body.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    pub fn new(
        grid: TrackGrid,
        layers: Layers,
        elastic: Elasticity,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let n = grid.n_columns();
        let mut planner = RealFftPlanner::new();
        let (forward, inverse) = (planner.plan_fft_forward(n), planner.plan_fft_inverse(n));
        let sweep = Sweep::new(&grid, &layers, elastic);
        let mut space = Self {
            grid,
            layers,
            elastic,
            forward,
            inverse,
            normal: Vec::new(),
            tangential: Vec::new(),
            sweep,
            arch: pulp::Arch::new(),
        };
        let mut work = space.work();
        for layer in 0..space.layers.len() {
            ask(stop)?;
            space.append_kernels(layer, &mut work);
        }
        Ok(space)
    }

    /// Transforms the stresses of a layer under loads on the column in the middle.
    ///
    /// Components that are even in x have real spectra, the others imaginary ones. An odd
    /// component has no value at the offset N/2, which is its own negative.
    fn append_kernels(&mut self, layer: usize, work: &mut TrackWork) {
        let (n, h, nu) = (self.grid.n, self.grid.h, self.elastic.poisson());
        let faces = [self.layers.faces()[layer], self.layers.faces()[layer + 1]];
        let stresses: Vec<[[f64; 3]; 2]> =
            (0..=n / 2).map(|k| strip::average(k as f64 * h, faces, h)).collect();
        for (load, into) in [&mut self.normal, &mut self.tangential].into_iter().enumerate() {
            for row in 0..ROWS {
                let is_even = (load == 0) == (row < 2);
                let value = |k: usize| {
                    let [xx, zz, xz] = stresses[k][load];
                    let mean = (1.0 + nu) * (xx + zz) / 3.0;
                    [xx - mean, zz - mean, xz][row]
                };
                for k in 0..=n / 2 {
                    work.row[k] = if 2 * k == n && !is_even { 0.0 } else { value(k) };
                    if k > 0 && 2 * k < n {
                        work.row[n - k] = if is_even { work.row[k] } else { -work.row[k] };
                    }
                }
                transform(&*self.forward, work);
                // i β P of a component that is odd adds -β Im P to the plane with Im, and so on:
                // in the planes, every component of a traction has the same rule.
                let sign = if load == 1 && row < 2 { -1.0 } else { 1.0 };
                let part = work.spectrum.iter();
                let from = into.len();
                into.extend(part.map(|z| if is_even { z.re } else { sign * z.im }));
                into.resize(from + self.sweep.filled, 0.0);
            }
        }
    }

    /// Columns of the surface.
    pub const fn grid(&self) -> &TrackGrid {
        &self.grid
    }

    /// Layers below it.
    pub const fn layers(&self) -> &Layers {
        &self.layers
    }

    /// Elastic constants.
    pub const fn elastic(&self) -> Elasticity {
        self.elastic
    }

    /// Numbers of a field: three for each column of each layer.
    pub const fn field_len(&self) -> usize {
        self.layers.len() * ROWS * self.grid.n
    }

    /// Work space.
    pub fn work(&self) -> TrackWork {
        let zero = Complex64::ZERO;
        let scratch = self.forward.get_scratch_len().max(self.inverse.get_scratch_len());
        TrackWork {
            stack: vec![0.0; self.layers.len() * PLANES * ROWS * self.sweep.filled],
            row: vec![0.0; self.grid.n],
            spectrum: vec![zero; self.grid.n / 2 + 1],
            scratch: vec![zero; scratch],
            surface: [vec![0.0; self.sweep.filled], vec![0.0; self.sweep.filled]],
            sweep: self.sweep.work(),
        }
    }

    /// `u_p = Sᵀ ε_p` in the window, positive into the body \[mm\]. Keeps the spectra of `G ε_p`
    /// for [`stress`](Self::stress). Layers of which `strained` says no are not read.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    pub fn opening(
        &self,
        polarization: &[f64],
        strained: &[bool],
        work: &mut TrackWork,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.spectra(polarization, strained, work, stop)?;
        if strained.contains(&true) {
            self.displacement(Direction::Normal, strained, work, opening);
            self.arch.dispatch(Wide(
                #[inline(always)]
                || self.sweep.apply(&mut work.stack, &mut work.sweep),
            ));
        } else {
            opening.fill(0.0);
        }
        Ok(())
    }

    /// `u_px = S_tᵀ ε_p` in the window, positive in +x \[mm\].
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    pub fn tangential_opening(
        &self,
        polarization: &[f64],
        strained: &[bool],
        work: &mut TrackWork,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.spectra(polarization, strained, work, stop)?;
        self.displacement(Direction::Tangential, strained, work, opening);
        Ok(())
    }

    /// The deviators `S p + μ S_t p + G ε_p` \[MPa\] of a pressure in the window, with a traction
    /// μ p in +x and the strain of the last [`opening`](Self::opening), which it uses up.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer.
    pub fn stress(
        &self,
        pressure: &[f64],
        friction: f64,
        work: &mut TrackWork,
        stress: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        work.row.fill(0.0);
        work.row[self.grid.window()].copy_from_slice(pressure);
        transform(&*self.forward, work);
        let [re, im] = &mut work.surface;
        for (z, (re, im)) in work.spectrum.iter().zip(re.iter_mut().zip(im)) {
            (*re, *im) = (z.re, z.im);
        }
        let filled = self.sweep.filled;
        let [re, im] = &work.surface;
        self.arch.dispatch(Wide(
            #[inline(always)]
            || {
                let kernels = self.normal.chunks_exact(ROWS * filled);
                let blocks = work.stack.chunks_exact_mut(PLANES * ROWS * filled);
                for (block, kernel) in blocks.zip(kernels) {
                    let (first, second) = block.split_at_mut(ROWS * filled);
                    add_products(first, kernel, re, 1.0);
                    add_products(second, kernel, im, 1.0);
                }
                if friction != 0.0 {
                    let kernels = self.tangential.chunks_exact(ROWS * filled);
                    let blocks = work.stack.chunks_exact_mut(PLANES * ROWS * filled);
                    for (block, kernel) in blocks.zip(kernels) {
                        let (first, second) = block.split_at_mut(ROWS * filled);
                        add_products(first, kernel, im, friction);
                        add_products(second, kernel, re, -friction);
                    }
                }
            },
        ));
        let n = self.grid.n;
        for (layer, rows) in stress.chunks_exact_mut(ROWS * n).enumerate() {
            ask(stop)?;
            for (k, row) in rows.chunks_exact_mut(n).enumerate() {
                let from = (layer * PLANES * ROWS + k) * filled;
                let planes = [&work.stack[from..], &work.stack[from + ROWS * filled..]];
                let both = planes[0].iter().zip(planes[1]);
                for (z, (first, second)) in work.spectrum.iter_mut().zip(both) {
                    *z = if k < 2 {
                        Complex64::new(*first, *second)
                    } else {
                        Complex64::new(-second, *first)
                    };
                }
                transform_back(&*self.inverse, &mut work.spectrum, row, &mut work.scratch);
            }
        }
        work.stack.fill(0.0);
        Ok(())
    }

    /// Spectra of a polarization in planes.
    fn spectra(
        &self,
        polarization: &[f64],
        strained: &[bool],
        work: &mut TrackWork,
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        let (n, filled) = (self.grid.n, self.sweep.filled);
        for (layer, is_strained) in strained.iter().enumerate() {
            ask(stop)?;
            let block = layer * PLANES * ROWS * filled;
            if !is_strained {
                work.stack[block..block + PLANES * ROWS * filled].fill(0.0);
                continue;
            }
            for k in 0..ROWS {
                work.row.copy_from_slice(&polarization[(layer * ROWS + k) * n..][..n]);
                transform(&*self.forward, work);
                let (first, second) = work.stack[block..].split_at_mut(ROWS * filled);
                let planes = first[k * filled..].iter_mut().zip(&mut second[k * filled..]);
                for (z, (first, second)) in work.spectrum.iter().zip(planes) {
                    (*first, *second) = if k < 2 { (z.re, z.im) } else { (z.im, -z.re) };
                }
            }
        }
        Ok(())
    }

    /// `Σ h_l W conj(S) ε` of the spectra of a polarization, in the window.
    ///
    /// Of deviators, `S:ε = (2 S'xx + S'zz) εxx + (2 S'zz + S'xx) εzz + 2 S'xz εxz`.
    fn displacement(
        &self,
        direction: Direction,
        strained: &[bool],
        work: &mut TrackWork,
        opening: &mut [f64],
    ) {
        let filled = self.sweep.filled;
        let compliance = 0.5 / self.elastic.shear();
        for part in &mut work.surface {
            part.fill(0.0);
        }
        let kernels = match direction {
            Direction::Normal => &self.normal,
            Direction::Tangential => &self.tangential,
        };
        let blocks = work.stack.chunks_exact(PLANES * ROWS * filled);
        let layers = blocks.zip(kernels.chunks_exact(ROWS * filled)).zip(strained).enumerate();
        for (layer, ((block, kernel), _)) in layers.filter(|(_, (_, strained))| **strained) {
            let factor = compliance * self.layers.thickness(layer);
            for (plane, rows) in block.chunks_exact(ROWS * filled).enumerate() {
                let (part, factor) = match (direction, plane) {
                    (Direction::Normal, plane) => (plane, factor),
                    (Direction::Tangential, 0) => (1, factor),
                    (Direction::Tangential, _) => (0, -factor),
                };
                let into = &mut work.surface[part];
                self.arch.dispatch(Wide(
                    #[inline(always)]
                    || add_works(into, rows, kernel, factor),
                ));
            }
        }
        let [re, im] = &work.surface;
        for (z, (re, im)) in work.spectrum.iter_mut().zip(re.iter().zip(im)) {
            *z = Complex64::new(*re, *im);
        }
        transform_back(&*self.inverse, &mut work.spectrum, &mut work.row, &mut work.scratch);
        opening.copy_from_slice(&work.row[self.grid.window()]);
    }
}

/// The spectrum of the row.
fn transform(plan: &dyn RealToComplex<f64>, work: &mut TrackWork) {
    let done = plan.process_with_scratch(&mut work.row, &mut work.spectrum, &mut work.scratch);
    debug_assert!(done.is_ok(), "the plan's own lengths");
}

/// The row of a spectrum, real where a wave number is its own negative.
fn transform_back(
    plan: &dyn ComplexToReal<f64>,
    spectrum: &mut [Complex64],
    row: &mut [f64],
    scratch: &mut [Complex64],
) {
    let last = spectrum.len() - 1;
    (spectrum[0].im, spectrum[last].im) = (0.0, 0.0);
    let done = plan.process_with_scratch(spectrum, row, scratch);
    debug_assert!(done.is_ok(), "the plan's own lengths, real ends");
    let scale = 1.0 / row.len() as f64;
    for value in row {
        *value *= scale;
    }
}

/// Adds the products of the rows of a kernel with a spectrum.
#[inline(always)]
fn add_products(rows: &mut [f64], kernel: &[f64], spectrum: &[f64], factor: f64) {
    let n = spectrum.len();
    for (row, kernel) in rows.chunks_exact_mut(n).zip(kernel.chunks_exact(n)) {
        for (value, (k, p)) in row.iter_mut().zip(kernel.iter().zip(spectrum)) {
            *value += factor * k * p;
        }
    }
}

/// Adds the work of the rows of a kernel on the rows of a strain.
#[inline(always)]
fn add_works(into: &mut [f64], rows: &[f64], kernel: &[f64], factor: f64) {
    let n = into.len();
    let ((exx, rest), (kxx, others)) = (rows.split_at(n), kernel.split_at(n));
    let ((ezz, exz), (kzz, kxz)) = (rest.split_at(n), others.split_at(n));
    for i in 0..n {
        let normal = (2.0 * kxx[i] + kzz[i]) * exx[i] + (2.0 * kzz[i] + kxx[i]) * ezz[i];
        into[i] += factor * (normal + 2.0 * kxz[i] * exz[i]);
    }
}
