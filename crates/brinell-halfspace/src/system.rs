//! Two bodies in contact, of which one or both yield: all that an iteration on plastic strain asks of them.
//!
//! With the plastic strains `ε_p` that are accepted and the increment Δε of this load, an evaluation is
//! ```text
//! e = ε_p + Δε,  u_p = Σ_bodies Sᵀe          gap_opening
//! p, α = contact(δ0 + u_p)                   equilibrium
//! σ = S p + G e,  s_tr = dev σ + 2μ Δε,  Δε_new = flow(s_old → s_tr)      initial_stress
//! ```
//! and Δε is the answer where `Δε_new = Δε`. How to get there is the caller's affair. Deformation theory is one increment from
//! rest.
//!
//! [`pack`](HalfSpaceSystem::pack) writes the cells that have flowed in this increment, in the order in which they began
//! to, so that a vector packed earlier is a part of one packed later; all entries left out are zero. Its numbers are
//! scaled: the product of two packed vectors is `Σ h_l Δε:Δε` over cells.

use std::sync::Arc;

use brinell_contact::{
    ConjugateGradientSolver, ContactError, ContactLoad, ContactProblem, ContactSolution, ContactSolver,
    Flexibility, StopHook,
};

use crate::half_space::{HalfSpace, HalfSpaceWork};
use crate::plasticity::{Deviator, Hardening, flow};
use crate::tensors::{DEVIATOR_COMPONENTS, TensorField, from_isometric, isometric};
use crate::{SurfaceFlexibility, SurfaceGrid};

/// A body that may yield.
pub struct PlasticBody<H> {
    space: Arc<HalfSpace>,
    hardening: H,
    /// How many bodies this one stands for.
    count: f64,
    strain: TensorField,
    accumulated: Vec<f64>,
    old_stress: TensorField,
    work: HalfSpaceWork,
    total: TensorField,
    stress: TensorField,
    /// Δp of each cell in the last evaluation.
    growth: Vec<f64>,
    /// Whether a cell has flowed in this increment.
    has_flowed: Vec<bool>,
}

impl<H: Hardening> PlasticBody<H> {
    /// A body at rest. Where both bodies are equal, one stands for `count = 2`.
    pub fn new(space: Arc<HalfSpace>, hardening: H, count: u8) -> Self {
        let (n_layers, n_cells) = (space.layers().len(), space.grid().n_cells());
        let deviators = || TensorField::deviators(n_layers, n_cells);
        let work = space.work();
        Self {
            space,
            hardening,
            count: f64::from(count),
            strain: deviators(),
            accumulated: vec![0.0; n_layers * n_cells],
            old_stress: deviators(),
            work,
            total: deviators(),
            stress: deviators(),
            growth: vec![0.0; n_layers * n_cells],
            has_flowed: vec![false; n_layers * n_cells],
        }
    }

    /// Operators of the body.
    pub fn space(&self) -> &HalfSpace {
        &self.space
    }

    /// Plastic strain of the accepted increments.
    pub const fn plastic_strain(&self) -> &TensorField {
        &self.strain
    }

    /// Equivalent plastic strain of the accepted increments and of the last evaluation, layer by layer.
    pub fn equivalent_plastic_strain(&self) -> Vec<f64> {
        self.accumulated.iter().zip(&self.growth).map(|(p, dp)| p + dp).collect()
    }

    /// The return mapping in every cell. Calls `begins` where a cell flows for the first time in this increment. The number
    /// of cells that flow.
    fn update(
        &mut self,
        increment: &TensorField,
        into: &mut TensorField,
        mut begins: impl FnMut(usize),
    ) -> usize {
        let (n_cells, shear) = (increment.n_cells(), self.space.elastic().shear());
        let double = 2.0 * shear;
        let mut flowing = 0;
        into.values_mut().fill(0.0);
        self.growth.fill(0.0);
        for layer in 0..increment.n_layers() {
            let (sigma, delta) = (self.stress.layer(layer), increment.layer(layer));
            let old = self.old_stress.layer(layer);
            let new = into.layer_mut(layer);
            let accumulated = &self.accumulated[layer * n_cells..][..n_cells];
            let fresh = self.hardening.stress(layer, 0.0);
            for (cell, p) in accumulated.iter().enumerate() {
                let at = |k: usize| sigma[k * n_cells + cell] + double * delta[k * n_cells + cell];
                let trial = whole(std::array::from_fn(at));
                // Hardening never softens: below the first yield stress nothing has to be asked.
                let size = trial[0] * trial[0]
                    + trial[1] * trial[1]
                    + trial[2] * trial[2]
                    + 2.0 * (trial[3] * trial[3] + trial[4] * trial[4] + trial[5] * trial[5]);
                if 1.5 * size <= fresh * fresh {
                    continue;
                }
                let from = whole(std::array::from_fn(|k| old[k * n_cells + cell]));
                let Some((strain, dp)) = flow(&self.hardening, layer, shear, *p, &from, &trial) else {
                    continue;
                };
                flowing += 1;
                let index = layer * n_cells + cell;
                self.growth[index] = dp;
                if !self.has_flowed[index] {
                    self.has_flowed[index] = true;
                    begins(index);
                }
                for (k, value) in
                    [strain[0], strain[1], strain[3], strain[4], strain[5]].into_iter().enumerate()
                {
                    new[k * n_cells + cell] = value;
                }
            }
        }
        flowing
    }
}

/// A deviator of six components.
#[inline(always)]
fn whole([xx, yy, xy, xz, yz]: [f64; DEVIATOR_COMPONENTS]) -> Deviator {
    [xx, yy, -xx - yy, xy, xz, yz]
}

/// Plastic strain increments of each body.
pub type Increment = Vec<TensorField>;

/// Contact, elastic surface and plastic bodies.
pub struct HalfSpaceSystem<H> {
    surface: SurfaceFlexibility,
    bodies: Vec<PlasticBody<H>>,
    initial_gap: Vec<f64>,
    solver: ConjugateGradientSolver,
    contact: ContactSolution,
    opening: Vec<f64>,
    gap: Vec<f64>,
    /// All normals are along the approach.
    closing: Vec<f64>,
    /// Of one body.
    part: Vec<f64>,
    pressure: Vec<f64>,
    /// Body and cell of what has flowed in this increment, in the order in which it began to.
    flowed: Vec<(usize, usize)>,
}

impl<H: Hardening> HalfSpaceSystem<H> {
    /// Bodies that touch over the cells of `surface` with the gap δ0 \[mm\] of their shapes. All plastic bodies lie on the
    /// grid of the surface; bodies that do not yield are in its modulus alone.
    pub fn new(
        surface: SurfaceFlexibility,
        bodies: Vec<PlasticBody<H>>,
        initial_gap: Vec<f64>,
        contact_tolerance: f64,
    ) -> Self {
        let n = initial_gap.len();
        Self {
            surface,
            bodies,
            initial_gap,
            solver: ConjugateGradientSolver::new(contact_tolerance),
            contact: ContactSolution::default(),
            opening: vec![0.0; n],
            gap: vec![0.0; n],
            closing: vec![1.0; n],
            part: vec![0.0; n],
            pressure: vec![0.0; n],
            flowed: Vec::new(),
        }
    }

    /// Cells of the surface.
    pub const fn grid(&self) -> &SurfaceGrid {
        self.surface.grid()
    }

    /// The plastic bodies.
    pub fn bodies(&self) -> &[PlasticBody<H>] {
        &self.bodies
    }

    /// Forces, gaps and approach of the last equilibrium.
    pub const fn contact(&self) -> &ContactSolution {
        &self.contact
    }

    /// u_p of the last evaluation, of all bodies together \[mm\].
    pub fn opening(&self) -> &[f64] {
        &self.opening
    }

    /// No plastic strain.
    pub fn zeros(&self) -> Increment {
        let field =
            |body: &PlasticBody<H>| TensorField::deviators(body.strain.n_layers(), body.strain.n_cells());
        self.bodies.iter().map(field).collect()
    }

    /// `u_p = Σ Sᵀ(ε_p + Δε)` \[mm\], positive where it opens the gap.
    pub fn gap_opening(&mut self, increment: &Increment) -> &[f64] {
        self.opening.fill(0.0);
        for (body, delta) in self.bodies.iter_mut().zip(increment) {
            let total = body.total.values_mut().iter_mut();
            for ((e, accepted), delta) in total.zip(body.strain.values()).zip(delta.values()) {
                *e = accepted + delta;
            }
            body.space.opening(&body.total, &mut body.work, &mut self.part);
            for (u, part) in self.opening.iter_mut().zip(&self.part) {
                *u += body.count * part;
            }
        }
        &self.opening
    }

    /// Contact forces and approach with the gap of these plastic strains.
    ///
    /// # Errors
    /// [`ContactError`].
    pub fn equilibrium(
        &mut self,
        increment: &Increment,
        load: ContactLoad,
        stop: &mut StopHook<'_>,
    ) -> Result<&ContactSolution, ContactError> {
        self.gap_opening(increment);
        for ((gap, initial), opening) in self.gap.iter_mut().zip(&self.initial_gap).zip(&self.opening) {
            *gap = initial + opening;
        }
        let (flexibility, closing) = (&self.surface, self.closing.as_slice());
        let problem = ContactProblem { flexibility, initial_gap: &self.gap, closing, load };
        self.contact = self.solver.solve(&problem, Some(&self.contact), stop)?;
        Ok(&self.contact)
    }

    /// Plastic strains that the stresses of the last [`equilibrium`](Self::equilibrium) make of `increment`. The number of cells
    /// that flow.
    pub fn initial_stress(&mut self, increment: &Increment, into: &mut Increment) -> usize {
        self.take_pressure();
        let flowed = &mut self.flowed;
        let mut flowing = 0;
        for (n, ((body, delta), new)) in self.bodies.iter_mut().zip(increment).zip(into).enumerate() {
            body.space.stress(&self.pressure, &mut body.work, &mut body.stress);
            flowing += body.update(delta, new, |index| flowed.push((n, index)));
        }
        flowing
    }

    fn take_pressure(&mut self) {
        let area = self.surface.grid().cell_area();
        for (p, force) in self.pressure.iter_mut().zip(&self.contact.force) {
            *p = force / area;
        }
    }

    /// `F R + u_p`: displacement of both surfaces away from each other under contact forces \[mm\].
    pub fn displacement(&mut self, increment: &Increment, force: &[f64]) -> Vec<f64> {
        self.gap_opening(increment);
        let mut displacement = vec![0.0; force.len()];
        self.surface.apply(force, &mut displacement);
        for (u, opening) in displacement.iter_mut().zip(&self.opening) {
            *u += opening;
        }
        displacement
    }

    /// All six stresses of a body \[MPa\] in the state of the last equilibrium.
    pub fn stresses(&mut self, body: usize, increment: &Increment) -> TensorField {
        self.gap_opening(increment);
        self.take_pressure();
        let body = &mut self.bodies[body];
        let mut stress = TensorField::tensors(body.strain.n_layers(), body.strain.n_cells());
        body.space.stress(&self.pressure, &mut body.work, &mut stress);
        stress
    }

    /// `√Σ h_l |a - b|²` over cells.
    pub fn distance(&self, a: &Increment, b: &Increment) -> f64 {
        self.size(a, |body, layer, k, cell| {
            a[body].component(layer, k)[cell] - b[body].component(layer, k)[cell]
        })
    }

    /// `√Σ h_l |a|²` over cells.
    pub fn norm(&self, a: &Increment) -> f64 {
        self.size(a, |body, layer, k, cell| a[body].component(layer, k)[cell])
    }

    fn size(&self, like: &Increment, value: impl Fn(usize, usize, usize, usize) -> f64) -> f64 {
        let mut sum = 0.0;
        for (n, (body, field)) in self.bodies.iter().zip(like).enumerate() {
            for layer in 0..field.n_layers() {
                let mut of_layer = 0.0;
                for cell in 0..field.n_cells() {
                    let scaled = isometric(std::array::from_fn(|k| value(n, layer, k, cell)));
                    of_layer += scaled.iter().map(|x| x * x).sum::<f64>();
                }
                sum += body.space.layers().thickness(layer) * of_layer;
            }
        }
        sum.sqrt()
    }

    /// Scaled numbers of the cells that have flowed.
    pub fn pack(&self, increment: &Increment) -> Vec<f64> {
        let mut packed = Vec::with_capacity(DEVIATOR_COMPONENTS * self.flowed.len());
        for (body, index) in &self.flowed {
            let field = &increment[*body];
            let (layer, cell) = (index / field.n_cells(), index % field.n_cells());
            let root = self.bodies[*body].space.layers().thickness(layer).sqrt();
            let values = isometric(std::array::from_fn(|k| field.component(layer, k)[cell]));
            packed.extend(values.map(|x| root * x));
        }
        packed
    }

    /// The reverse of [`pack`](Self::pack); cells beyond a shorter vector are zero.
    pub fn unpack(&self, packed: &[f64], into: &mut Increment) {
        for field in into.iter_mut() {
            field.values_mut().fill(0.0);
        }
        for ((body, index), scaled) in self.flowed.iter().zip(packed.chunks_exact(DEVIATOR_COMPONENTS)) {
            let field = &mut into[*body];
            let (layer, cell) = (index / field.n_cells(), index % field.n_cells());
            let root = 1.0 / self.bodies[*body].space.layers().thickness(layer).sqrt();
            let values = from_isometric(std::array::from_fn(|k| root * scaled[k]));
            for (k, value) in values.into_iter().enumerate() {
                field.component_mut(layer, k)[cell] = value;
            }
        }
    }

    /// Accepts an increment: the state of the last [`initial_stress`](Self::initial_stress) is where the next increment starts from.
    pub fn commit(&mut self, increment: &Increment) {
        for (body, delta) in self.bodies.iter_mut().zip(increment) {
            for (strain, delta) in body.strain.values_mut().iter_mut().zip(delta.values()) {
                *strain += delta;
            }
            for (p, dp) in body.accumulated.iter_mut().zip(&mut body.growth) {
                *p += *dp;
                *dp = 0.0;
            }
            body.old_stress.values_mut().copy_from_slice(body.stress.values());
        }
        for (body, index) in self.flowed.drain(..) {
            self.bodies[body].has_flowed[index] = false;
        }
    }
}
