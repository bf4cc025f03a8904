//! The operators of a half-space under a line load on a ring.

use std::sync::Arc;

use brinell_material::TrackFrame;
use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::strip;
use super::sweep::{PLANES, ROWS, Sweep, SweepWork};
use crate::stop::{Stop, Stopped, ask};
use crate::tensors::{COMPONENTS, DEVIATOR_COMPONENTS};
use crate::track::{Direction, Ground, Operators, Settled};
use crate::waves::Wide;

/// The operators of a body under a line load, of states that do not depend on y.
///
/// The material is a ring: G and the offsets of S have the period of the grid, and the pressure
/// acts once. Fields have three components xx, zz, xz of a deviator in each cell.
pub struct LineSpace {
    ground: Ground,
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
pub struct LineWork {
    stack: Vec<f64>,
    row: Vec<f64>,
    spectrum: Vec<Complex64>,
    scratch: Vec<Complex64>,
    /// Real and imaginary part of a field on the surface.
    surface: [Vec<f64>; 2],
    sweep: SweepWork,
}

impl LineSpace {
    /// Transforms the stresses of a layer under loads on the column in the middle.
    ///
    /// Components that are even in x have real spectra, the others imaginary ones. An odd
    /// component has no value at the offset N/2, which is its own negative.
    fn append_kernels(&mut self, layer: usize, work: &mut LineWork) {
        let (n, h, nu) = (
            self.ground.grid.n_columns(),
            self.ground.grid.column(),
            self.ground.elastic.poisson(),
        );
        let faces = [self.ground.layers.faces()[layer], self.ground.layers.faces()[layer + 1]];
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

    /// Spectra of a polarization in planes.
    fn spectra(
        &self,
        polarization: &[f64],
        reach: &[usize],
        work: &mut LineWork,
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        let (n, filled) = (self.ground.grid.n_columns(), self.sweep.filled);
        for (layer, reach) in reach.iter().enumerate() {
            ask(stop)?;
            let block = layer * PLANES * ROWS * filled;
            if *reach == 0 {
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
        reach: &[usize],
        work: &mut LineWork,
        opening: &mut [f64],
    ) {
        let filled = self.sweep.filled;
        let compliance = 0.5 / self.ground.elastic.shear();
        for part in &mut work.surface {
            part.fill(0.0);
        }
        let kernels = match direction {
            Direction::Normal => &self.normal,
            Direction::Tangential => &self.tangential,
        };
        let blocks = work.stack.chunks_exact(PLANES * ROWS * filled);
        let layers = blocks.zip(kernels.chunks_exact(ROWS * filled)).zip(reach).enumerate();
        for (layer, ((block, kernel), _)) in layers.filter(|(_, (_, reach))| **reach > 0) {
            let factor = compliance * self.ground.layers.thickness(layer);
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
        opening.copy_from_slice(&work.row[self.ground.grid.window()]);
    }
}

/// Stress σxx, σyy of a polarization `2μ ε_p` xx, zz, xz that is uniform along the track.
fn uniform_stress(poisson: f64, [xx, zz, _]: [f64; 3]) -> [f64; 2] {
    let local = poisson / (1.0 - poisson);
    [local * zz - xx, local * zz + xx + zz]
}

impl Operators<4, ROWS> for LineSpace {
    type Frame = TrackFrame;
    type Work = LineWork;

    fn new(ground: Ground, _: bool, stop: &mut Stop<'_>) -> Result<Self, Stopped> {
        debug_assert!(ground.grid.is_line(), "the track of a line");
        let n = ground.grid.n_columns();
        let mut planner = RealFftPlanner::new();
        let (forward, inverse) = (planner.plan_fft_forward(n), planner.plan_fft_inverse(n));
        let sweep = Sweep::new(&ground);
        let mut space = Self {
            ground,
            forward,
            inverse,
            normal: Vec::new(),
            tangential: Vec::new(),
            sweep,
            arch: pulp::Arch::new(),
        };
        let mut work = space.work();
        for layer in 0..space.ground.layers.len() {
            ask(stop)?;
            space.append_kernels(layer, &mut work);
        }
        Ok(space)
    }

    fn ground(&self) -> &Ground {
        &self.ground
    }

    fn work(&self) -> LineWork {
        let (zero, n) = (Complex64::ZERO, self.ground.grid.n_columns());
        let scratch = self.forward.get_scratch_len().max(self.inverse.get_scratch_len());
        LineWork {
            stack: vec![0.0; self.ground.layers.len() * PLANES * ROWS * self.sweep.filled],
            row: vec![0.0; n],
            spectrum: vec![zero; n / 2 + 1],
            scratch: vec![zero; scratch],
            surface: [vec![0.0; self.sweep.filled], vec![0.0; self.sweep.filled]],
            sweep: self.sweep.work(),
        }
    }

    fn opening(
        &self,
        direction: Direction,
        polarization: &[f64],
        reach: &[usize],
        work: &mut LineWork,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.spectra(polarization, reach, work, stop)?;
        if reach.iter().all(|rows| *rows == 0) {
            opening.fill(0.0);
            return Ok(());
        }
        self.displacement(direction, reach, work, opening);
        if direction == Direction::Normal {
            self.arch.dispatch(Wide(
                #[inline(always)]
                || self.sweep.apply(&mut work.stack, &mut work.sweep),
            ));
        }
        Ok(())
    }

    fn stress(
        &self,
        pressure: &[f64],
        friction: f64,
        work: &mut LineWork,
        stress: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        work.row.fill(0.0);
        work.row[self.ground.grid.window()].copy_from_slice(pressure);
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
        let n = self.ground.grid.n_columns();
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

    /// Residual stress is `σxx = λ'τzz - τxx`, `σyy = λ'τzz - τyy`, the groove `(1-λ') ∫ε_zz dz`.
    fn settle(&self, inlet: &[[f64; ROWS]], initial: &[[f64; 2]], _: &mut LineWork) -> Settled {
        let Ground { layers, elastic, .. } = &self.ground;
        let (young, nu) = (elastic.young(), elastic.poisson());
        let of_layer = |(tau, initial): (&[f64; ROWS], &[f64; 2])| {
            let [xx, yy] = uniform_stress(nu, *tau);
            [initial[0] + xx, initial[1] + yy, 0.0, 0.0, 0.0, 0.0]
        };
        let residual: Vec<[f64; COMPONENTS]> = inlet.iter().zip(initial).map(of_layer).collect();
        let energy = |(layer, [xx, yy, ..]): (usize, &[f64; COMPONENTS])| {
            layers.thickness(layer) * (xx * xx + yy * yy - 2.0 * nu * xx * yy) * 0.5 / young
        };
        let sum: f64 =
            inlet.iter().enumerate().map(|(l, [_, zz, _])| layers.thickness(l) * zz).sum();
        // u_p is positive into the body: compression in z makes ε_zz negative and sinks it.
        let groove = -(1.0 - nu / (1.0 - nu)) * 0.5 / elastic.shear() * sum;
        let stored_energy = residual.iter().enumerate().map(energy).sum();
        Settled { residual, groove: vec![groove], stored_energy }
    }

    fn leave(
        &self,
        inlet: &[[f64; ROWS]],
        c: &[[f64; ROWS]],
        _: &mut LineWork,
    ) -> Vec<[f64; ROWS]> {
        let nu = self.ground.elastic.poisson();
        let of_layer = |([xx, zz, xz], c): (&[f64; ROWS], &[f64; ROWS])| {
            let [uniform_xx, uniform_yy] = uniform_stress(nu, *c);
            let mean = (uniform_xx + uniform_yy) / 3.0;
            [xx + uniform_xx - mean + c[0], zz - mean + c[1], xz + c[2]]
        };
        inlet.iter().zip(c).map(of_layer).collect()
    }

    fn forward(&self, strain: &[[f64; DEVIATOR_COMPONENTS]]) -> f64 {
        let layers = &self.ground.layers;
        strain.iter().enumerate().map(|(l, of)| -2.0 * of[3] * layers.thickness(l)).sum()
    }
}

/// The spectrum of the row.
fn transform(plan: &dyn RealToComplex<f64>, work: &mut LineWork) {
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
