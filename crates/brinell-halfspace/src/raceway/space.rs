//! The operators of a half-space under a contact that rolls along a ring.

use brinell_material::TrackFrame;

use super::uniform::UniformTrack;
use super::waves::{Planes, RingScratch, RingWaves, Span, planes_of};
use crate::SurfaceGrid;
use crate::eigenstrain_stress::{EigenstrainStress, SweepWork};
use crate::half_space::subtract_mean;
use crate::pressure_stress::PressureStress;
use crate::stop::{Stop, Stopped, ask};
use crate::tensors::{COMPONENTS, DEVIATOR_COMPONENTS, DEVIATOR_ROWS};
use crate::track::{Direction, Ground, Operators, Settled, TrackGrid};
use crate::traction_stress::traction_stress;
use crate::waves::Wide;

/// The operators of a body under an ellipse, for states that are symmetric about y = 0.
///
/// The material is a ring along x: G has the period of the grid there, and a load acts once, on
/// offsets up to half of it. Across the travel the track has no images but for those of waves along
/// x that do not reach it, and the long waves those of a box eight times as wide as the grid.
///
/// Fields have deviators `xx yy xy xz yz` in the cells at y > 0.
pub struct RacewaySpace {
    ground: Ground,
    waves: RingWaves,
    pressure: PressureStress,
    /// Of bodies that slide.
    traction: Option<PressureStress>,
    narrow: EigenstrainStress,
    wide: EigenstrainStress,
    uniform: UniformTrack,
    arch: pulp::Arch,
}

/// Work space of an evaluation, with the spectra that it carries from strain to stress.
pub struct RacewayWork {
    stack: Vec<f64>,
    wide: Vec<f64>,
    /// A field on the surface, and the same turned by -i.
    surface: Vec<f64>,
    turned: Vec<f64>,
    scratch: RingScratch,
    sweeps: [SweepWork; 2],
    is_strained: bool,
}

type Deviator = [f64; DEVIATOR_COMPONENTS];

impl RacewaySpace {
    fn compliance(&self) -> f64 {
        0.5 / self.ground.elastic.shear()
    }

    /// Bytes of the operators and of one work space.
    pub fn bytes(grid: &TrackGrid, n_layers: usize) -> usize {
        let waves = RingWaves::new(grid, pulp::Arch::new());
        let of = |of: Span| waves.n_waves(of) * waves.row_len(of) * n_layers;
        // Spectra of pressure and traction, coefficients of G, and the stack.
        let narrow = of(Span::Narrow) * (COMPONENTS + 3 + COMPONENTS);
        size_of::<f64>() * (narrow + of(Span::Wide) * (3 + COMPONENTS))
    }

    /// G of a state that does not depend on x: residual stresses `xx yy zz xy xz yz` \[MPa\] of
    /// polarizations `xx yy xy xz yz` \[MPa\], in the rows of the layers.
    pub fn uniform_stress(
        &self,
        polarization: &[[f64; DEVIATOR_COMPONENTS]],
        work: &mut RacewayWork,
    ) -> Vec<[f64; COMPONENTS]> {
        let (waves, rows) = (&self.waves, self.ground.grid.n_rows());
        let fields = self.ground.layers.len() * COMPONENTS;
        let row_len = waves.row_len(Span::Wide);
        let compliance = self.compliance();
        work.wide.fill(0.0);
        // The transform along x of a constant is real: it is in the plane of R.
        let part = |component: usize| match planes_of(component).0 {
            Planes::Even => (0, 1.0),
            Planes::Turned => (waves.low, -1.0),
            Planes::Reversed => (0, -1.0),
        };
        for layer in 0..self.ground.layers.len() {
            let of_layer = &polarization[layer * rows..][..rows];
            for component in 0..COMPONENTS {
                let value = |tau: &[f64; DEVIATOR_COMPONENTS]| match component {
                    2 => -tau[0] - tau[1],
                    0 | 1 => tau[component],
                    _ => tau[component - 1],
                };
                let (start, sign) = part(component);
                let spectrum =
                    waves.of_uniform(planes_of(component).1, of_layer.iter().map(value));
                let place = (layer * COMPONENTS + component) * row_len + start;
                for (block, value) in work.wide.chunks_exact_mut(fields * row_len).zip(spectrum) {
                    block[place] = sign * compliance * value;
                }
            }
        }
        for (iy, block) in work.wide.chunks_exact_mut(fields * row_len).enumerate() {
            self.wide.apply(iy, block, &mut work.sweeps[1]);
        }
        let mut stress = vec![[0.0; COMPONENTS]; polarization.len()];
        for layer in 0..self.ground.layers.len() {
            for component in 0..COMPONENTS {
                let (start, sign) = part(component);
                let place = (layer * COMPONENTS + component) * row_len + start;
                let blocks = work.wide.chunks_exact(fields * row_len);
                let values = blocks.map(|block| sign * block[place]);
                let of_rows = waves.to_uniform(planes_of(component).1, values);
                for (to, value) in stress[layer * rows..].iter_mut().zip(of_rows) {
                    to[component] = value;
                }
            }
        }
        work.is_strained = false;
        stress
    }

    /// Spectra of a polarization in both boxes.
    fn spectra(
        &self,
        polarization: &[f64],
        reach: &[usize],
        work: &mut RacewayWork,
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        let (waves, n_cells, nx) =
            (&self.waves, self.ground.grid.n_cells(), self.ground.grid.n_columns());
        let fields = self.ground.layers.len() * COMPONENTS;
        let compliance = self.compliance();
        let RacewayWork { stack, wide, scratch, .. } = work;
        for (layer, reach) in reach.iter().enumerate() {
            ask(stop)?;
            for (stack, of) in [(&mut *stack, Span::Narrow), (&mut *wide, Span::Wide)] {
                let row_len = waves.row_len(of);
                let start = layer * COMPONENTS * row_len;
                for block in stack.chunks_exact_mut(fields * row_len).filter(|_| *reach == 0) {
                    block[start..start + COMPONENTS * row_len].fill(0.0);
                }
            }
            if *reach == 0 {
                continue;
            }
            for (k, component) in DEVIATOR_ROWS.into_iter().enumerate() {
                let from = (layer * DEVIATOR_COMPONENTS + k) * n_cells;
                let rows = polarization[from..][..reach * nx].chunks_exact(nx);
                let (planes, is_odd) = planes_of(component);
                waves.along_x(rows, 0, (planes, compliance), scratch);
                for (stack, of) in [(&mut *stack, Span::Narrow), (&mut *wide, Span::Wide)] {
                    let row_len = waves.row_len(of);
                    let place = (layer * COMPONENTS + component) * row_len;
                    let into = stack
                        .chunks_exact_mut(fields * row_len)
                        .map(|block| &mut block[place..place + row_len]);
                    waves.along_y(of, (is_odd, *reach), into, scratch);
                }
            }
            for (stack, of) in [(&mut *stack, Span::Narrow), (&mut *wide, Span::Wide)] {
                let row_len = waves.row_len(of);
                for block in stack.chunks_exact_mut(fields * row_len) {
                    let rows = &mut block[layer * COMPONENTS * row_len..][..3 * row_len];
                    let (in_plane, normal) = rows.split_at_mut(2 * row_len);
                    let (xx, yy) = in_plane.split_at(row_len);
                    for ((zz, xx), yy) in normal.iter_mut().zip(xx).zip(yy) {
                        *zz = -xx - yy;
                    }
                }
            }
        }
        Ok(())
    }

    /// `Σ h_l W conj(S) ε` of the spectra of a strain, in the window.
    fn displacement(&self, direction: Direction, work: &mut RacewayWork, opening: &mut [f64]) {
        let (waves, filled) = (&self.waves, self.waves.filled);
        let row_len = waves.row_len(Span::Narrow);
        let fields = self.ground.layers.len() * COMPONENTS;
        let kernels = match direction {
            Direction::Normal => Some(&self.pressure),
            Direction::Tangential => self.traction.as_ref(),
        };
        let Some(kernels) = kernels else { return opening.fill(0.0) };
        let surface = work.surface.chunks_exact_mut(row_len);
        for (iy, (surface, block)) in
            surface.zip(work.stack.chunks_exact(fields * row_len)).enumerate()
        {
            self.arch.dispatch(Wide(
                #[inline(always)]
                || kernels.opening(iy, block, &self.ground.layers, surface),
            ));
            if direction == Direction::Tangential {
                // The conjugate of a spectrum that is kept multiplied by i.
                let (re, im) = surface.split_at_mut(filled);
                for (re, im) in re.iter_mut().zip(im) {
                    (*re, *im) = (-*im, *re);
                }
            }
        }
        let window = self.ground.grid.window();
        let surface = work.surface.chunks_exact(row_len);
        waves.back_along_y(Span::Narrow, false, surface, &mut work.scratch);
        let columns = (window.start, window.len());
        waves.back_along_x(Planes::Even, columns, opening, &mut work.scratch);
    }
}

impl Operators<COMPONENTS, DEVIATOR_COMPONENTS> for RacewaySpace {
    type Frame = TrackFrame;
    type Work = RacewayWork;

    fn new(ground: Ground, slides: bool, stop: &mut Stop<'_>) -> Result<Self, Stopped> {
        debug_assert!(!ground.grid.is_line(), "the track of an ellipse");
        let arch = pulp::Arch::new();
        let Ground { grid, layers, elastic } = &ground;
        let waves = RingWaves::new(grid, arch);
        let (narrow, wide) = (waves.transform(Span::Narrow), waves.transform(Span::Wide));
        let nu = elastic.poisson();
        let [hx, hy] = grid.sides();
        // Offsets along x up to half the ring.
        let offsets = SurfaceGrid::new(grid.n_columns() / 2 + 1, 2 * grid.n_rows(), hx, hy);
        let offsets = offsets.map_err(|_| Stopped)?;
        let pressure = PressureStress::new(&narrow, &offsets, layers, nu, stop)?;
        let traction =
            slides.then(|| traction_stress(&narrow, (&offsets, layers), nu, stop)).transpose()?;
        let side_of_low = grid.length() / waves.ring_of_low() as f64;
        Ok(Self {
            narrow: EigenstrainStress::new(&narrow, [hx, hy], layers, *elastic),
            wide: EigenstrainStress::new(&wide, [side_of_low, hy], layers, *elastic),
            uniform: UniformTrack::new(grid, layers, nu),
            ground,
            waves,
            pressure,
            traction,
            arch,
        })
    }

    fn ground(&self) -> &Ground {
        &self.ground
    }

    fn work(&self) -> RacewayWork {
        let fields = self.ground.layers.len() * COMPONENTS;
        let len = |of: Span| self.waves.n_waves(of) * self.waves.row_len(of);
        RacewayWork {
            stack: vec![0.0; fields * len(Span::Narrow)],
            wide: vec![0.0; fields * len(Span::Wide)],
            surface: vec![0.0; len(Span::Narrow)],
            turned: vec![0.0; len(Span::Narrow)],
            scratch: self.waves.scratch(),
            sweeps: [self.narrow.work(), self.wide.work()],
            is_strained: false,
        }
    }

    fn opening(
        &self,
        direction: Direction,
        polarization: &[f64],
        reach: &[usize],
        work: &mut RacewayWork,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        if direction == Direction::Tangential {
            self.spectra(polarization, reach, work, stop)?;
            self.displacement(direction, work, opening);
            return Ok(());
        }
        work.is_strained = reach.iter().any(|rows| *rows > 0);
        if !work.is_strained {
            opening.fill(0.0);
            work.stack.fill(0.0);
            return Ok(());
        }
        self.spectra(polarization, reach, work, stop)?;
        self.displacement(Direction::Normal, work, opening);
        let (row_len, wide_len) =
            (self.waves.row_len(Span::Narrow), self.waves.row_len(Span::Wide));
        let fields = self.ground.layers.len() * COMPONENTS;
        let (low, filled) = (self.waves.low, self.waves.filled);
        for (iy, block) in work.stack.chunks_exact_mut(fields * row_len).enumerate() {
            ask(stop)?;
            self.arch.dispatch(Wide(
                #[inline(always)]
                || self.narrow.apply_from(low, iy, block, &mut work.sweeps[0]),
            ));
            for plane in block.chunks_exact_mut(filled) {
                plane[..low].fill(0.0);
            }
        }
        for (iy, block) in work.wide.chunks_exact_mut(fields * wide_len).enumerate() {
            ask(stop)?;
            self.arch.dispatch(Wide(
                #[inline(always)]
                || self.wide.apply(iy, block, &mut work.sweeps[1]),
            ));
        }
        Ok(())
    }

    fn stress(
        &self,
        pressure: &[f64],
        friction: f64,
        work: &mut RacewayWork,
        stress: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        let (waves, filled) = (&self.waves, self.waves.filled);
        let window = self.ground.grid.window();
        let row_len = waves.row_len(Span::Narrow);
        let fields = self.ground.layers.len() * COMPONENTS;
        let rows = pressure.chunks_exact(window.len());
        waves.along_x(rows, window.start, (Planes::Even, 1.0), &mut work.scratch);
        let surface = work.surface.chunks_exact_mut(row_len);
        waves.along_y(
            Span::Narrow,
            (false, self.ground.grid.n_rows()),
            surface,
            &mut work.scratch,
        );
        let traction = self.traction.as_ref().filter(|_| friction != 0.0);
        if traction.is_some() {
            let rows = work.turned.chunks_exact_mut(row_len);
            for (turned, surface) in rows.zip(work.surface.chunks_exact(row_len)) {
                for k in 0..filled {
                    turned[k] = friction * surface[filled + k];
                    turned[filled + k] = -friction * surface[k];
                }
            }
        }
        let surfaces = work.surface.chunks_exact(row_len).zip(work.turned.chunks_exact(row_len));
        let blocks = work.stack.chunks_exact_mut(fields * row_len);
        for (iy, (block, (surface, turned))) in blocks.zip(surfaces).enumerate() {
            ask(stop)?;
            self.arch.dispatch(Wide(
                #[inline(always)]
                || {
                    self.pressure.add_stress(iy, surface, block);
                    if let Some(traction) = traction {
                        traction.add_stress(iy, turned, block);
                    }
                    subtract_mean(block, row_len);
                },
            ));
        }
        if work.is_strained {
            let wide_len = waves.row_len(Span::Wide);
            for block in work.wide.chunks_exact_mut(fields * wide_len) {
                subtract_mean(block, wide_len);
            }
        }
        let n_cells = self.ground.grid.n_cells();
        for (n, field) in stress.chunks_exact_mut(n_cells).enumerate() {
            ask(stop)?;
            let component = DEVIATOR_ROWS[n % DEVIATOR_COMPONENTS];
            let place = n / DEVIATOR_COMPONENTS * COMPONENTS + component;
            let (planes, is_odd) = planes_of(component);
            let narrow = rows_of(&work.stack, fields, place, row_len);
            waves.back_along_y(Span::Narrow, is_odd, narrow, &mut work.scratch);
            if work.is_strained {
                let wide = rows_of(&work.wide, fields, place, waves.row_len(Span::Wide));
                waves.back_along_y(Span::Wide, is_odd, wide, &mut work.scratch);
            }
            waves.back_along_x(
                planes,
                (0, self.ground.grid.n_columns()),
                field,
                &mut work.scratch,
            );
        }
        Ok(())
    }

    /// The stored energy is `-½ ∫ε_p : (σ_in + σ0) dA`, without that of σ0.
    fn settle(&self, inlet: &[Deviator], initial: &[[f64; 2]], work: &mut RacewayWork) -> Settled {
        let (rows, compliance) = (self.ground.grid.n_rows(), self.compliance());
        let mut residual = self.uniform_stress(inlet, work);
        for (row, stress) in residual.iter_mut().enumerate() {
            let [xx, yy] = initial[row / rows];
            stress[0] += xx;
            stress[1] += yy;
        }
        let energy = |(row, (tau, stress)): (usize, (&Deviator, &[f64; COMPONENTS]))| {
            let [xx, yy, xy, xz, yz] = *tau;
            let [initial_xx, initial_yy] = initial[row / rows];
            let normal = xx * (stress[0] + initial_xx) + yy * (stress[1] + initial_yy)
                - (xx + yy) * stress[2];
            let shear = 2.0 * (xy * stress[3] + xz * stress[4] + yz * stress[5]);
            self.ground.layers.thickness(row / rows) * (normal + shear)
        };
        let sum: f64 = inlet.iter().zip(&residual).enumerate().map(energy).sum();
        let strain = |tau: &Deviator| tau.map(|value| compliance * value);
        let groove = self.uniform.groove(&inlet.iter().map(strain).collect::<Vec<_>>());
        let [_, hy] = self.ground.grid.sides();
        Settled { residual, groove, stored_energy: -compliance * hy * sum }
    }

    fn leave(&self, inlet: &[Deviator], c: &[Deviator], work: &mut RacewayWork) -> Vec<Deviator> {
        let uniform = self.uniform_stress(c, work);
        let of_row = |((inlet, c), stress): ((&Deviator, &Deviator), [f64; COMPONENTS])| {
            let [xx, yy, zz, xy, xz, yz] = stress;
            let mean = (xx + yy + zz) / 3.0;
            let stress = [xx - mean, yy - mean, xy, xz, yz];
            std::array::from_fn(|k| inlet[k] + stress[k] + c[k])
        };
        inlet.iter().zip(c).zip(uniform).map(of_row).collect()
    }

    fn forward(&self, strain: &[[f64; DEVIATOR_COMPONENTS]]) -> f64 {
        self.uniform.forward(strain).first().copied().unwrap_or(0.0)
    }
}

/// The rows of a field in a stack.
fn rows_of(
    stack: &[f64],
    fields: usize,
    place: usize,
    row_len: usize,
) -> impl Iterator<Item = &[f64]> {
    stack.chunks_exact(fields * row_len).map(move |block| &block[place * row_len..][..row_len])
}
