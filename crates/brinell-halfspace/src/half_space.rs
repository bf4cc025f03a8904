//! One elastic half-space: stresses and displacements of pressures on it and plastic strains in
//! it.

use crate::eigenstrain_stress::{EigenstrainStress, SweepWork};
use crate::images::{FarField, FarFieldWork};
use crate::pressure_stress::PressureStress;
use crate::stop::{Stop, Stopped, ask};
use crate::tensors::{COMPONENTS, TensorField};
use crate::transform::fast_length;
use crate::waves::{PARITIES, Waves, WavesScratch, Wide};
use crate::{Elasticity, Layers, SurfaceGrid};

/// The operators S (pressure to stress), Sᵀ (plastic strain to displacement) and G (plastic strain
/// to stress) of a body.
///
/// Nothing in it changes; bodies of one material on one grid share it. [`HalfSpaceWork`] holds the
/// fields that change.
pub struct HalfSpace {
    grid: SurfaceGrid,
    layers: Layers,
    elastic: Elasticity,
    waves: Waves,
    pressure_stress: PressureStress,
    eigenstrain_stress: EigenstrainStress,
    far_field: Option<FarField>,
    arch: pulp::Arch,
}

/// Work space of an evaluation, with the spectra that it carries from strain to stress.
pub struct HalfSpaceWork {
    n_components: usize,
    stack: Vec<f64>,
    scratch: WavesScratch,
    sweep: SweepWork,
    surface: Vec<f64>,
    far_field: Option<FarFieldWork>,
    /// Layers with strain.
    strained: Vec<bool>,
}

impl HalfSpace {
    /// The operators of a body. The images of plastic strain are removed.
    ///
    /// Where all strains and pressures are symmetric about both axes and there are even numbers of
    /// cells, a quarter of the wave vectors is enough; only the cells at x, y > 0 are read then.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn new(
        grid: SurfaceGrid,
        layers: Layers,
        elastic: Elasticity,
        is_symmetric: bool,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let mut body = Self::periodic(grid, layers, elastic, is_symmetric, stop)?;
        body.far_field =
            Some(FarField::new(&body.waves, &body.grid, &body.layers, elastic, body.arch));
        Ok(body)
    }

    /// Returns the operators of a body with a G of period two grid sides.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn periodic(
        grid: SurfaceGrid,
        layers: Layers,
        elastic: Elasticity,
        is_symmetric: bool,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let arch = pulp::Arch::new();
        let cells = [grid.nx(), grid.ny()];
        let waves = Waves::new(
            cells,
            cells.map(|n| fast_length(2 * n)),
            is_symmetric && is_even(cells),
            arch,
        );
        let pressure_stress =
            PressureStress::new(&waves.transform, &grid, &layers, elastic.poisson(), stop)?;
        let sides = [grid.hx(), grid.hy()];
        let eigenstrain_stress = EigenstrainStress::new(&waves.transform, sides, &layers, elastic);
        Ok(Self {
            grid,
            layers,
            elastic,
            waves,
            pressure_stress,
            eigenstrain_stress,
            far_field: None,
            arch,
        })
    }

    /// Cells of the surface.
    pub const fn grid(&self) -> &SurfaceGrid {
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

    /// Work space for plastic strains, which are deviators.
    pub fn work(&self) -> HalfSpaceWork {
        self.work_for(crate::DEVIATOR_COMPONENTS)
    }

    /// Work space for any initial strains.
    pub fn work_for_tensors(&self) -> HalfSpaceWork {
        self.work_for(COMPONENTS)
    }

    fn work_for(&self, n_components: usize) -> HalfSpaceWork {
        let n_fields = self.layers.len() * COMPONENTS;
        HalfSpaceWork {
            n_components,
            stack: vec![0.0; self.waves.stack_len(n_fields)],
            scratch: self.waves.scratch(),
            sweep: self.eigenstrain_stress.work(),
            surface: vec![0.0; self.waves.stack_len(1)],
            far_field: self.far_field.as_ref().map(|far_field| far_field.work(n_components)),
            strained: vec![false; self.layers.len()],
        }
    }

    /// `u_p = Sᵀ ε_p`, positive into the body \[mm\]. Keeps the spectra of `G ε_p` for
    /// [`stress`](Self::stress).
    ///
    /// `strain` has as many components as the work space is for.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer and each wave number.
    pub fn opening(
        &self,
        strain: &TensorField,
        work: &mut HalfSpaceWork,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        debug_assert_eq!(strain.n_components(), work.n_components);
        let n_fields = self.layers.len() * COMPONENTS;
        let row_len = self.waves.row_len();
        for (layer, strained) in work.strained.iter_mut().enumerate() {
            *strained = strain.layer(layer).iter().any(|value| *value != 0.0);
        }
        if !work.strained.contains(&true) {
            work.stack.fill(0.0);
            opening.fill(0.0);
            return Ok(());
        }
        for (layer, _) in work.strained.iter().enumerate().filter(|(_, strained)| **strained) {
            ask(stop)?;
            for (component, row) in strain.rows().iter().enumerate() {
                let (field, place) =
                    (strain.component(layer, component), (n_fields, layer * COMPONENTS + row));
                self.waves.rows_forward(
                    field,
                    PARITIES[*row],
                    &mut work.stack,
                    place,
                    &mut work.scratch,
                );
            }
        }
        let is_deviator = work.n_components < COMPONENTS;
        let surface = work.surface.chunks_exact_mut(row_len);
        for (iy, (block, surface)) in
            work.stack.chunks_exact_mut(n_fields * row_len).zip(surface).enumerate()
        {
            ask(stop)?;
            for (rows, strained) in
                block.chunks_exact_mut(COMPONENTS * row_len).zip(&work.strained)
            {
                if *strained {
                    self.waves.layer_forward(rows, is_deviator, &mut work.scratch);
                } else {
                    rows.fill(0.0);
                }
            }
            self.arch.dispatch(Wide(
                #[inline(always)]
                || {
                    self.pressure_stress.opening(iy, block, &self.layers, surface);
                    self.eigenstrain_stress.apply(iy, block, &mut work.sweep);
                },
            ));
        }
        self.waves.inverse(&mut work.surface, opening, &mut work.scratch);
        if let (Some(far_field), Some(far_work)) = (&self.far_field, &mut work.far_field) {
            far_field.evaluate(strain, far_work);
        }
        Ok(())
    }

    /// `σ = S p + G ε_p` \[MPa\] with the strain of the last [`opening`](Self::opening), as
    /// tensors or as deviators. Uses up the spectra kept.
    ///
    /// # Errors
    /// [`Stopped`]; `stop` is asked for each layer and each wave number.
    pub fn stress(
        &self,
        pressure: &[f64],
        work: &mut HalfSpaceWork,
        stress: &mut TensorField,
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        let n_fields = self.layers.len() * COMPONENTS;
        let row_len = self.waves.row_len();
        self.waves.forward(pressure, &mut work.surface, &mut work.scratch);
        let is_deviator = stress.n_components() < COMPONENTS;
        let surface = work.surface.chunks_exact(row_len);
        for (iy, (block, surface)) in
            work.stack.chunks_exact_mut(n_fields * row_len).zip(surface).enumerate()
        {
            ask(stop)?;
            self.arch.dispatch(Wide(
                #[inline(always)]
                || {
                    self.pressure_stress.add_stress(iy, surface, block);
                    if is_deviator {
                        subtract_mean(block, row_len);
                    }
                },
            ));
            for rows in block.chunks_exact_mut(COMPONENTS * row_len) {
                self.waves.layer_inverse(rows, is_deviator, &mut work.scratch);
            }
        }
        let rows = stress.rows();
        for layer in 0..self.layers.len() {
            ask(stop)?;
            for (component, row) in rows.iter().enumerate() {
                let (field, place) =
                    (stress.component_mut(layer, component), (n_fields, layer * COMPONENTS + row));
                self.waves.rows_inverse(
                    &work.stack,
                    place,
                    PARITIES[*row],
                    field,
                    &mut work.scratch,
                );
            }
        }
        if let (Some(far_field), Some(far_work)) = (&self.far_field, &mut work.far_field)
            && work.strained.contains(&true)
        {
            far_field.add(far_work, stress);
        }
        Ok(())
    }

    /// Bytes of the operators and of one work space.
    pub fn bytes(grid: &SurfaceGrid, n_layers: usize, is_symmetric: bool) -> usize {
        let cells = [grid.nx(), grid.ny()];
        let [half, n_rows] = cells.map(|n| fast_length(2 * n) / 2 + 1);
        let kernels = n_rows * half * n_layers * (COMPONENTS + 5);
        let stack =
            Waves::padded_stack_len(cells, n_layers * COMPONENTS, is_symmetric && is_even(cells));
        (kernels + stack) * size_of::<f64>()
    }
}

fn is_even(cells: [usize; 2]) -> bool {
    cells.iter().all(|n| n.is_multiple_of(2))
}

/// Deviators of the normal stresses xx and yy in place of them.
#[inline(always)]
pub(crate) fn subtract_mean(block: &mut [f64], row_len: usize) {
    for rows in block.chunks_exact_mut(COMPONENTS * row_len) {
        let (xx, rest) = rows.split_at_mut(row_len);
        let (yy, rest) = rest.split_at_mut(row_len);
        for ((xx, yy), zz) in xx.iter_mut().zip(yy).zip(&rest[..row_len]) {
            let mean = (*xx + *yy + *zz) * (1.0 / 3.0);
            *xx -= mean;
            *yy -= mean;
        }
    }
}
