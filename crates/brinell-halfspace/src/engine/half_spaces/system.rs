//! Two half-spaces as a contact system of the method.
//!
//! An initial stress is `2μ Δε` in the cells that can yield \[MPa\]. The "displacements" of the
//! method are the trial deviators of the plastic law, `dev(S p + G(ε_p + Δε) + σ0) + 2μ Δε`
//! \[MPa\]. Their norm is
//! ```text
//! ‖a‖ = hx hy √(Σ h_l/ℓ a:a)      ℓ: shorter semi-axis
//! ```
//! The sum runs over the cells that have flowed in this increment. The norm is a force comparable
//! to the force of the cells in contact, with which the method compares it.

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use crate::{
    DEVIATOR_COMPONENTS, HalfSpace, Stop, Stopped, SurfaceFlexibility, SurfaceGrid, YieldingBody,
    from_isometric, isometric,
};

use super::design::GridDesign;
use super::moment::PrescribedMoment;
use crate::engine::watch::{never, watched};
use brinell_contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use brinell_material::{body_flows, flows};
use brinell_method::contact_system::{BlockVector, ContactFigures, ContactSystem, Response};
use brinell_method::phases::Phase;
use brinell_method::run::Run;

/// An elastic body: its operators, its initial stress, and its index among the bodies that can
/// yield.
#[derive(Clone)]
pub(super) struct ElasticBody {
    pub space: Arc<HalfSpace>,
    /// Initial stress `xx yy xy` of each layer \[MPa\].
    pub initial: Vec<[f64; 3]>,
    pub yielding: Option<usize>,
}

/// Two bodies and the cells of the surface between them.
pub(super) struct HalfSpaces {
    pub design: GridDesign,
    pub surface: SurfaceFlexibility,
    /// Initial gap δ0 \[mm\].
    pub initial_gap: Vec<f64>,
    /// Components of the normals along the approach: 1 but for bodies that conform.
    pub closing: Vec<f64>,
    /// Moment under which a roller tilts; `None` if the tilts are given.
    pub moment: Option<PrescribedMoment>,
    /// Tilt of the last contact under a moment; 0 before the first one.
    pub last_tilt: Cell<f64>,
    /// Upper and lower body; `None` for a rigid body. Two equal bodies share one that yields.
    pub elastic: [Option<ElasticBody>; 2],
    pub yielding: RefCell<Yielding>,
    /// `hx hy √(h_l/ℓ)` of the layers of each body that can yield.
    pub weights: Vec<Vec<f64>>,
    /// Deviators of the last accepted state.
    pub accepted: BlockVector,
    /// Whether the peak pressure is taken after a binomial mean: over 3 × 3 cells, of a roller over 3
    /// across its axis, because its pressure may rise towards an end as much as it falls beyond.
    pub is_smoothed: bool,
}

/// The state that an evaluation changes.
pub(super) struct Yielding {
    pub bodies: Vec<YieldingBody>,
    /// Body and cell of the cells that have flowed in this increment, in the order in which their
    /// flow began.
    flowed: Vec<(usize, usize)>,
    has_flowed: Vec<Vec<bool>>,
    pressure: Vec<f64>,
}

impl Yielding {
    pub fn new(bodies: Vec<YieldingBody>) -> Self {
        let has_flowed =
            bodies.iter().map(|body| vec![false; body.len() / DEVIATOR_COMPONENTS]).collect();
        Self { bodies, flowed: Vec::new(), has_flowed, pressure: Vec::new() }
    }

    /// Adds the surface displacement by plastic strain, `u_p`, of all bodies to `opening`.
    fn open(
        &mut self,
        increment: &BlockVector,
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.bodies
            .iter_mut()
            .zip(increment)
            .try_for_each(|(body, part)| body.open(part, opening, stop))
    }

    /// Returns the trial deviators of all bodies for the increment of the last [`Self::open`].
    fn trial(
        &mut self,
        increment: &BlockVector,
        pressure: impl Iterator<Item = f64>,
        stop: &mut Stop<'_>,
    ) -> Result<BlockVector, Stopped> {
        self.pressure.clear();
        self.pressure.extend(pressure);
        let of_body = |(body, increment): (&mut YieldingBody, &Vec<f64>)| {
            let mut trial = vec![0.0; increment.len()];
            body.trial(&self.pressure, increment, &mut trial, stop)?;
            Ok(trial)
        };
        self.bodies.iter_mut().zip(increment).map(of_body).collect()
    }
}

impl HalfSpaces {
    pub const fn grid(&self) -> &SurfaceGrid {
        self.surface.grid()
    }

    /// Whether both bodies are equal and share one.
    pub fn is_shared(&self) -> bool {
        let [upper, lower] = &self.elastic;
        matches!((upper, lower), (Some(a), Some(b)) if Arc::ptr_eq(&a.space, &b.space))
    }

    /// Returns the pressures of contact forces \[MPa\].
    pub fn pressure<'a>(&self, force: &'a [f64]) -> impl Iterator<Item = f64> + use<'a> {
        let area = self.grid().cell_area();
        force.iter().map(move |force| force / area)
    }

    /// Returns the approach α \[mm\], zero at the first touch of the undeformed surfaces. The
    /// vertices do not lie in the middle of a cell, so that cells first touch at the least gap.
    /// Bodies that are apart are at the approach that was given.
    pub fn approach(&self, contact: &ContactSolution) -> f64 {
        let least_of = |gap: &[f64]| gap.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = contact.gap.iter().copied().fold(0.0, f64::max);
        if contact.total_force > 0.0 || least_of(&contact.gap) > f64::EPSILON * largest {
            return contact.approach;
        }
        let least = least_of(&self.tilted(&self.initial_gap, contact.tilt));
        let approach = contact.approach - least;
        if approach.abs() <= f64::EPSILON * least.abs() { 0.0 } else { approach }
    }

    /// Returns the peak pressure \[MPa\] and its cell. Where nothing has yielded it is the top of the
    /// parabolas through the squared pressures of this cell and its neighbours, which under ellipses
    /// is exact. A mean over cells beyond the end of a roller would be no pressure of the roller.
    pub fn peak(&self, force: &[f64]) -> (f64, usize) {
        let (grid, area) = (self.grid(), self.grid().cell_area());
        let is_at_end = |cell: usize| {
            let beyond = grid.y(cell % grid.ny()).abs() + grid.hy();
            self.design.half_length.is_some_and(|half_length| beyond > half_length)
        };
        let is_elastic = self.is_elastic();
        let along = if self.design.half_length.is_some() { [0.0, 1.0, 0.0] } else { BINOMIAL };
        let pressure = |cell: usize| {
            let is_mean = self.is_smoothed && !is_elastic && !is_at_end(cell);
            if is_mean { smoothed(grid, force, cell, along) / area } else { force[cell] / area }
        };
        let (most, cell) = (0..force.len())
            .map(|cell| (pressure(cell), cell))
            .fold((0.0, force.len() / 2), |most, next| if next.0 > most.0 { next } else { most });
        if !is_elastic || is_at_rim(grid, cell) {
            return (most, cell);
        }
        let between = |step: usize| {
            above(pressure(cell - step).powi(2), most * most, pressure(cell + step).powi(2))
        };
        ((most * most + between(1) + between(grid.ny())).sqrt(), cell)
    }

    /// Whether smooth bodies have not yielded.
    pub fn is_elastic(&self) -> bool {
        !self.design.is_patch()
            && self.yielding.borrow().bodies.iter().all(|body| yielded_cells(body) == 0)
    }

    /// Returns whether a body flows in an increment of the initial stress `2G Δε_p`.
    pub fn flows(&self, increment: &BlockVector) -> bool {
        let (yielding, n_cells) = (self.yielding.borrow(), self.grid().n_cells());
        let cell_flows = |body: usize, cell: usize| {
            let (layer, start) = place(cell, n_cells);
            let flow = isometric(std::array::from_fn(|k| increment[body][start + k * n_cells]));
            // 3G times the equivalent of Δε_p.
            let gained = (1.5 * flow.iter().map(|x| x * x).sum::<f64>()).sqrt();
            flows(gained, yielding.bodies[body].law().yield_stress(layer, cell), 1.0)
        };
        yielding.bodies.iter().enumerate().any(|(n, body)| {
            let thickness = |cell: usize| body.space().layers().thickness(cell / n_cells);
            let flowing =
                yielding.flowed.iter().filter(|(k, cell)| *k == n && cell_flows(n, *cell));
            let flowing: f64 = flowing.map(|(_, cell)| thickness(*cell)).sum();
            let cells = 0..body.len() / DEVIATOR_COMPONENTS;
            let plastic = cells.filter(|cell| body.law().equivalent_plastic_strain(*cell) > 0.0);
            body_flows(flowing, plastic.map(thickness).sum())
        })
    }

    /// Returns `Σ (hx hy)² h_l/ℓ a:a` over the cells that have flowed. In other cells, the initial
    /// stress is zero and the trial deviators have no effect.
    fn sum_of_squares(&self, value: impl Fn(usize, usize) -> f64) -> f64 {
        let n_cells = self.grid().n_cells();
        let of_cell = |(body, cell): &(usize, usize)| {
            let (layer, start) = place(*cell, n_cells);
            let scaled = isometric(std::array::from_fn(|k| value(*body, start + k * n_cells)));
            self.weights[*body][layer].powi(2) * scaled.iter().map(|x| x * x).sum::<f64>()
        };
        self.yielding.borrow().flowed.iter().map(of_cell).sum()
    }
}

/// Weights of a binomial mean.
const BINOMIAL: [f64; 3] = [0.25, 0.5, 0.25];

/// Returns the mean of a field over 3 × 3 cells, binomial along x and with weights along y; at the
/// rim, the value of the cell itself.
fn smoothed(grid: &SurfaceGrid, field: &[f64], cell: usize, along: [f64; 3]) -> f64 {
    if is_at_rim(grid, cell) {
        return field[cell];
    }
    let (i, j) = (cell / grid.ny(), cell % grid.ny());
    let part = |n: usize| {
        BINOMIAL[n / 3] * along[n % 3] * field[(i + n / 3 - 1) * grid.ny() + j + n % 3 - 1]
    };
    (0..9).map(part).sum()
}

fn is_at_rim(grid: &SurfaceGrid, cell: usize) -> bool {
    let (i, j) = (cell / grid.ny(), cell % grid.ny());
    i == 0 || j == 0 || i + 1 == grid.nx() || j + 1 == grid.ny()
}

/// Returns how far the top of the parabola through the largest of three values and its neighbours
/// lies above it; 0 beside the end of a contact.
pub(super) fn above(before: f64, most: f64, after: f64) -> f64 {
    let falls = 2.0 * most - before - after;
    let is_top = before.min(after) > 0.0 && before.max(after) <= most && falls > 0.0;
    if is_top { (after - before).powi(2) / (8.0 * falls) } else { 0.0 }
}

impl ContactSystem for HalfSpaces {
    fn zeros(&self) -> BlockVector {
        self.yielding.borrow().bodies.iter().map(|body| vec![0.0; body.len()]).collect()
    }

    fn initial_gap(&self) -> &[f64] {
        &self.initial_gap
    }

    fn contact_problem<'a>(
        &'a self,
        initial_gap: &'a [f64],
        load: ContactLoad,
    ) -> ContactProblem<'a> {
        ContactProblem { flexibility: &self.surface, initial_gap, closing: &self.closing, load }
    }

    fn gap_opening(&self, initial_stress: &BlockVector) -> Vec<f64> {
        let mut opening = vec![0.0; self.initial_gap.len()];
        let done = self.yielding.borrow_mut().open(initial_stress, &mut opening, &mut never);
        debug_assert!(done.is_ok(), "nobody stops it");
        opening
    }

    fn contact(
        &self,
        gap_opening: &[f64],
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<ContactSolution, brinell_method::Error> {
        let gaps = self.initial_gap.iter().zip(gap_opening);
        let gap: Vec<f64> = gaps.map(|(gap, opening)| gap + opening).collect();
        match self.moment {
            Some(moment) => self.balanced(moment, &gap, solver, load, start, run),
            None => Ok(run.solve_contact(solver, &self.contact_problem(&gap, load), start)?),
        }
    }

    fn displacement(&self, initial_stress: &BlockVector, force: &[f64]) -> BlockVector {
        self.gap_opening(initial_stress);
        let trial =
            self.yielding.borrow_mut().trial(initial_stress, self.pressure(force), &mut never);
        trial.unwrap_or_else(|Stopped| self.zeros())
    }

    /// Gap and stress share one transform of the plastic strain.
    fn equilibrium(
        &self,
        initial_stress: &BlockVector,
        solver: &dyn ContactSolver,
        load: ContactLoad,
        start: Option<&ContactSolution>,
        run: &mut Run<'_>,
    ) -> Result<Response, brinell_method::Error> {
        let mut opening = vec![0.0; self.initial_gap.len()];
        watched(run, Phase::Solves, |stop| {
            self.yielding.borrow_mut().open(initial_stress, &mut opening, stop)
        })?;
        let contact = self.contact(&opening, solver, load, start, run)?;
        let displacement = watched(run, Phase::Solves, |stop| {
            self.yielding.borrow_mut().trial(initial_stress, self.pressure(&contact.force), stop)
        })?;
        Ok(Response { displacement, contact })
    }

    fn initial_stress(&self, displacement: &BlockVector, into: &mut BlockVector) -> usize {
        let mut yielding = self.yielding.borrow_mut();
        let Yielding { bodies, flowed, has_flowed, .. } = &mut *yielding;
        for (n, (body, (trial, into))) in
            bodies.iter_mut().zip(displacement.iter().zip(into)).enumerate()
        {
            body.flow(trial, into, |cell| {
                if !std::mem::replace(&mut has_flowed[n][cell], true) {
                    flowed.push((n, cell));
                }
            });
        }
        bodies.iter().map(yielded_cells).sum()
    }

    fn norm(&self, v: &BlockVector) -> f64 {
        self.sum_of_squares(|body, k| v[body][k]).sqrt()
    }

    fn distance(&self, v: &BlockVector, w: &BlockVector) -> f64 {
        self.sum_of_squares(|body, k| v[body][k] - w[body][k]).sqrt()
    }

    /// Returns the weighted components of the cells that have flowed, in the order in which their
    /// flow began: a vector packed earlier is the beginning of one packed later.
    fn pack(&self, vectors: &BlockVector) -> Vec<f64> {
        let (yielding, n_cells) = (self.yielding.borrow(), self.grid().n_cells());
        let mut packed = Vec::with_capacity(DEVIATOR_COMPONENTS * yielding.flowed.len());
        for (body, cell) in &yielding.flowed {
            let (layer, start) = place(*cell, n_cells);
            let values = isometric(std::array::from_fn(|k| vectors[*body][start + k * n_cells]));
            packed.extend(values.map(|value| self.weights[*body][layer] * value));
        }
        packed
    }

    fn unpack(&self, packed: &[f64], vectors: &mut BlockVector) {
        let (yielding, n_cells) = (self.yielding.borrow(), self.grid().n_cells());
        for ((body, cell), scaled) in
            yielding.flowed.iter().zip(packed.chunks_exact(DEVIATOR_COMPONENTS))
        {
            let (layer, start) = place(*cell, n_cells);
            let weight = self.weights[*body][layer].recip();
            let values = from_isometric(std::array::from_fn(|k| weight * scaled[k]));
            for (k, value) in values.into_iter().enumerate() {
                vectors[*body][start + k * n_cells] = value;
            }
        }
    }

    fn accepted(&self) -> &BlockVector {
        &self.accepted
    }

    /// Accepts the state with these trial deviators. The next increment starts from the stresses
    /// to which the law returns them.
    fn commit(&mut self, displacement: BlockVector) {
        let mut increment = self.zeros();
        self.initial_stress(&displacement, &mut increment);
        let yielding = self.yielding.get_mut();
        self.accepted = displacement;
        for ((body, increment), trial) in
            yielding.bodies.iter_mut().zip(&increment).zip(&mut self.accepted)
        {
            body.accept(increment, trial);
            for (stress, flowed) in trial.iter_mut().zip(increment) {
                *stress -= flowed;
            }
        }
        for (body, cell) in yielding.flowed.drain(..) {
            yielding.has_flowed[body][cell] = false;
        }
    }

    fn figures(&self, contact: &ContactSolution) -> ContactFigures {
        ContactFigures {
            force: contact.total_force,
            approach: self.approach(contact),
            peak_pressure: self.peak(&contact.force).0,
            pairs: contact.active_set.len(),
        }
    }
}

/// Returns the number of cells that count as yielded after the last paths.
fn yielded_cells(body: &YieldingBody) -> usize {
    let n_cells = body.space().grid().n_cells();
    (0..body.len() / DEVIATOR_COMPONENTS)
        .filter(|cell| body.law().has_yielded(cell / n_cells, *cell))
        .count()
}

/// Returns the layer of a cell and the index of its first component in the vector of a body.
const fn place(cell: usize, n_cells: usize) -> (usize, usize) {
    let layer = cell / n_cells;
    (layer, layer * DEVIATOR_COMPONENTS * n_cells + cell % n_cells)
}
