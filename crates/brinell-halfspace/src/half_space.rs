//! One elastic half-space: stresses and displacements of pressures on it and plastic strains in it.

use realfft::num_complex::Complex64;

use crate::eigenstrain_stress::{EigenstrainStress, SweepWork};
use crate::images::{FarField, FarFieldWork};
use crate::pressure_stress::PressureStress;
use crate::stop::{Stop, Stopped, ask};
use crate::tensors::{COMPONENTS, TensorField};
use crate::transform::{Scratch, Transform, fast_length};
use crate::{Elasticity, Layers, SurfaceGrid};

/// The operators S (pressure to stress), Sᵀ (plastic strain to displacement) and G (plastic strain to stress) of a body.
///
/// Nothing in it changes; bodies of one material on one grid share it. What changes is in [`HalfSpaceWork`].
pub struct HalfSpace {
    grid: SurfaceGrid,
    layers: Layers,
    elastic: Elasticity,
    transform: Transform,
    pressure_stress: PressureStress,
    eigenstrain_stress: EigenstrainStress,
    far_field: Option<FarField>,
    arch: pulp::Arch,
}

/// What an evaluation writes on, and the spectra that it carries from strain to stress.
pub struct HalfSpaceWork {
    n_components: usize,
    stack: Vec<Complex64>,
    scratch: Scratch,
    sweep: SweepWork,
    surface: Vec<Complex64>,
    far_field: Option<FarFieldWork>,
    /// Layers with strain.
    strained: Vec<bool>,
}

impl HalfSpace {
    /// The operators of a body. The images of plastic strain are removed.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn new(
        grid: SurfaceGrid,
        layers: Layers,
        elastic: Elasticity,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let mut body = Self::periodic(grid, layers, elastic, stop)?;
        body.far_field = Some(FarField::new(&body.transform, &body.grid, &body.layers, elastic));
        Ok(body)
    }

    /// The same with a G of period two grid sides.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn periodic(
        grid: SurfaceGrid,
        layers: Layers,
        elastic: Elasticity,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let (nx, ny) = (grid.nx(), grid.ny());
        let transform = Transform::new(nx, ny, fast_length(2 * nx), fast_length(2 * ny));
        let pressure_stress = PressureStress::new(&transform, &grid, &layers, elastic.poisson(), stop)?;
        let sides = [grid.hx(), grid.hy()];
        let eigenstrain_stress = EigenstrainStress::new(&transform, sides, &layers, elastic);
        let arch = pulp::Arch::new();
        Ok(Self {
            grid,
            layers,
            elastic,
            transform,
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
            stack: vec![Complex64::ZERO; self.transform.stack_len(n_fields)],
            scratch: self.transform.scratch(),
            sweep: self.eigenstrain_stress.work(),
            surface: vec![Complex64::ZERO; self.transform.stack_len(1)],
            far_field: self.far_field.as_ref().map(|far_field| far_field.work(n_components)),
            strained: vec![false; self.layers.len()],
        }
    }

    /// `u_p = Sᵀ ε_p`, positive into the body \[mm\]. Keeps the spectra of `G ε_p` for [`stress`](Self::stress).
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
        let mx = self.transform.mx;
        for (layer, strained) in work.strained.iter_mut().enumerate() {
            *strained = strain.layer(layer).iter().any(|value| *value != 0.0);
        }
        if !work.strained.contains(&true) {
            work.stack.fill(Complex64::ZERO);
            opening.fill(0.0);
            return Ok(());
        }
        for (layer, _) in work.strained.iter().enumerate().filter(|(_, strained)| **strained) {
            ask(stop)?;
            for (component, row) in strain.rows().iter().enumerate() {
                let field = strain.component(layer, component);
                let index = layer * COMPONENTS + row;
                self.transform.rows_forward(field, &mut work.stack, n_fields, index, &mut work.scratch);
            }
        }
        let deviator = work.n_components < COMPONENTS;
        let blocks = work.stack.chunks_exact_mut(n_fields * mx).zip(work.surface.chunks_exact_mut(mx));
        for (iy, (block, surface)) in blocks.enumerate() {
            ask(stop)?;
            for (rows, strained) in block.chunks_exact_mut(COMPONENTS * mx).zip(&work.strained) {
                if !strained {
                    rows.fill(Complex64::ZERO);
                } else if deviator {
                    let (in_plane, rest) = rows.split_at_mut(2 * mx);
                    let (normal, shear) = rest.split_at_mut(mx);
                    self.transform.columns_forward(in_plane, &mut work.scratch);
                    self.transform.columns_forward(shear, &mut work.scratch);
                    // tr ε_p = 0.
                    let (xx, yy) = in_plane.split_at(mx);
                    for ((zz, xx), yy) in normal.iter_mut().zip(xx).zip(yy) {
                        *zz = -*xx - *yy;
                    }
                } else {
                    self.transform.columns_forward(rows, &mut work.scratch);
                }
            }
            self.arch.dispatch(
                #[inline(always)]
                || {
                    self.pressure_stress.opening(iy, block, &self.layers, surface);
                    self.eigenstrain_stress.apply(iy, block, &mut work.sweep);
                },
            );
        }
        self.transform.inverse(&mut work.surface, opening, &mut work.scratch);
        if let (Some(far_field), Some(far_work)) = (&self.far_field, &mut work.far_field) {
            far_field.evaluate(self.arch, strain, far_work);
        }
        Ok(())
    }

    /// `σ = S p + G ε_p` \[MPa\] with the strain of the last [`opening`](Self::opening), as tensors or as deviators. Uses up the
    /// spectra kept.
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
        let mx = self.transform.mx;
        self.transform.forward(pressure, &mut work.surface, &mut work.scratch);
        let deviator = stress.n_components() < COMPONENTS;
        let blocks = work.stack.chunks_exact_mut(n_fields * mx).zip(work.surface.chunks_exact(mx));
        for (iy, (block, surface)) in blocks.enumerate() {
            ask(stop)?;
            self.arch.dispatch(
                #[inline(always)]
                || {
                    self.pressure_stress.add_stress(iy, surface, block);
                    if deviator {
                        subtract_mean(block, mx);
                    }
                },
            );
            for rows in block.chunks_exact_mut(COMPONENTS * mx) {
                if deviator {
                    let (in_plane, rest) = rows.split_at_mut(2 * mx);
                    self.transform.columns_inverse(in_plane, &mut work.scratch);
                    self.transform.columns_inverse(&mut rest[mx..], &mut work.scratch);
                } else {
                    self.transform.columns_inverse(rows, &mut work.scratch);
                }
            }
        }
        let rows = stress.rows();
        for layer in 0..self.layers.len() {
            ask(stop)?;
            for (component, row) in rows.iter().enumerate() {
                let index = layer * COMPONENTS + row;
                let field = stress.component_mut(layer, component);
                self.transform.rows_inverse(&work.stack, n_fields, index, field, &mut work.scratch);
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
    pub fn bytes(grid: &SurfaceGrid, n_layers: usize) -> usize {
        let [mx, my] = [grid.nx(), grid.ny()].map(|n| fast_length(2 * n));
        let (n_rows, half) = (my / 2 + 1, mx / 2 + 1);
        let kernels = n_rows * half * n_layers * (COMPONENTS + 5) * size_of::<f64>();
        let stack = n_rows * mx * n_layers * COMPONENTS * size_of::<Complex64>();
        kernels + stack
    }
}

/// Deviators of the normal stresses xx and yy in place of them.
#[inline(always)]
fn subtract_mean(block: &mut [Complex64], mx: usize) {
    for rows in block.chunks_exact_mut(COMPONENTS * mx) {
        let (xx, rest) = rows.split_at_mut(mx);
        let (yy, rest) = rest.split_at_mut(mx);
        for ((xx, yy), zz) in xx.iter_mut().zip(yy).zip(&rest[..mx]) {
            let mean = (*xx + *yy + *zz) * (1.0 / 3.0);
            *xx -= mean;
            *yy -= mean;
        }
    }
}
