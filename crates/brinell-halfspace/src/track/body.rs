//! A body that yields under a load that rolls over it: one pass is one fixed-point problem.
//!
//! In the frame of the load a steady pass is stationary. Plastic strain `ε_p,in` enters at the
//! front, and each column adds its Δε. With `c_i = 2μ Σ_{j>=i} Δε_j`, what the columns from the
//! front to column i have added in a row of constant y and z,
//! ```text
//! u_p = u_in(y) + Sᵀ c/2μ                               opening
//! T_i = dev(S p + μ S_t p + G c/2μ + σ_in) + c_i        trial
//! 2μ Δε_i: flow along T_{i+1} -> T_i                    stream
//! ```
//! Only the live columns of the grid flow. The last of them is far behind the load:
//! its T is that of the uniform state of its own c beside σ_in, so that the state that leaves is
//! within its yield surface by the plastic law itself.
//!
//! σ_in is the residual stress of the inlet, uniform along the track, with the stress σ0 that the
//! unloaded body has. The groove u_in is that of an endless track; under a line, where how deep the
//! surface sinks has no meaning, it is left out of the gap.
//!
//! Increments and trials have the same length: `2μ Δε` \[MPa\] of each column of each row.

use std::sync::Arc;

use brinell_material::{Deviators as _, StreamLaw};

use super::fault::{FlowOfPass, NOTHING, TrackFault, excess};
use super::figures::{Outlet, work_along};
use super::grid::TrackGrid;
use super::operators::{Direction, Frame, Ground, Operators, Settled};
use crate::stop::{Stop, Stopped};
use crate::tensors::COMPONENTS;

/// Plastic strains, memory and work space of one body on a track, whose deviators have D
/// components, R of them given.
///
/// A pass is the fixed point of `increment -> open -> (contact) -> trial -> flow`.
pub struct TrackBody<O: Operators<D, R>, const D: usize, const R: usize> {
    space: Arc<O>,
    law: Box<dyn StreamLaw<D, R>>,
    /// Number of bodies for which this one stands.
    count: f64,
    /// Traction in the direction of travel over pressure.
    friction: f64,
    /// σ0xx, σ0yy of each layer.
    initial: Vec<[f64; 2]>,
    /// `2μ ε_p` of each row at the front, what it leaves, and the deviator of its residual stress.
    inlet: Vec<[f64; R]>,
    settled: Settled,
    deviator: Vec<[f64; R]>,
    /// c.
    gained: Vec<f64>,
    /// Rows of each layer, from the axis outwards, in which c is not zero.
    reach: Vec<usize>,
    /// Accumulated plastic strain that each column adds.
    strain: Vec<f64>,
    work: O::Work,
    /// u_p of c, and pressure, in the window at y > 0.
    displacement: Vec<f64>,
    pressure: Vec<f64>,
    /// Cells that have flowed in this pass, in the order in which their flow began.
    flowed: Vec<usize>,
    has_flowed: Vec<bool>,
    /// The largest flow of a pass so far.
    most_flow: f64,
}

impl<O: Operators<D, R>, const D: usize, const R: usize> TrackBody<O, D, R> {
    /// A body at rest; two equal bodies that roll freely are one that stands for `count = 2`.
    ///
    /// The law has the rows of all layers, those of the first layer first. `initial` is the stress
    /// σxx, σyy of each layer before any load \[MPa\].
    pub fn new(
        space: Arc<O>,
        law: Box<dyn StreamLaw<D, R>>,
        count: u8,
        friction: f64,
        initial: Vec<[f64; 2]>,
    ) -> Self {
        let Ground { grid, layers, .. } = space.ground();
        let (n_rows, n_cells) = (layers.len() * grid.n_rows(), layers.len() * grid.n_cells());
        debug_assert_eq!((law.n_rows(), initial.len()), (n_rows, layers.len()));
        let (inlet, window) = (vec![[0.0; R]; n_rows], grid.n_rows() * grid.window().len());
        let mut work = space.work();
        let settled = space.settle(&inlet, &initial, &mut work);
        Self {
            law,
            count: f64::from(count),
            friction,
            deviator: settled.residual.iter().map(deviator::<O::Frame, D, R>).collect(),
            settled,
            initial,
            inlet,
            gained: vec![0.0; R * n_cells],
            reach: vec![0; layers.len()],
            strain: vec![0.0; n_cells],
            work,
            displacement: vec![0.0; window],
            pressure: vec![0.0; window],
            flowed: Vec::new(),
            has_flowed: vec![false; n_cells],
            most_flow: 0.0,
            space,
        }
    }

    /// Operators of the body.
    pub fn space(&self) -> &O {
        &self.space
    }

    fn grid(&self) -> &TrackGrid {
        &self.space.ground().grid
    }

    fn thickness(&self, row: usize) -> f64 {
        self.space.ground().layers.thickness(row / self.grid().n_rows())
    }

    /// The plastic law, with what the rows remember.
    pub fn law(&self) -> &dyn StreamLaw<D, R> {
        &*self.law
    }

    /// Returns the number of bodies for which this one stands.
    pub const fn count(&self) -> f64 {
        self.count
    }

    /// Traction on this body in the direction of travel over pressure.
    pub const fn friction(&self) -> f64 {
        self.friction
    }

    /// Numbers of an increment.
    pub const fn n_numbers(&self) -> usize {
        self.gained.len()
    }

    /// Accumulated plastic strain that the columns of each row have added in the last stream.
    pub fn strains(&self) -> &[f64] {
        &self.strain
    }

    /// Number of cells that may change.
    pub const fn n_flowed(&self) -> usize {
        self.flowed.len()
    }

    /// Turns the track round: the next pass goes the other way. x is again the direction of
    /// travel.
    pub fn turn(&mut self) {
        for inlet in &mut self.inlet {
            let mut whole: [f64; D] = O::Frame::whole(*inlet);
            for odd in O::Frame::ODD {
                whole[*odd] = -whole[*odd];
            }
            *inlet = O::Frame::given(whole);
        }
        self.law.mirror();
        self.settle();
    }

    /// Residual stress and groove of the inlet.
    fn settle(&mut self) {
        self.settled = self.space.settle(&self.inlet, &self.initial, &mut self.work);
        self.deviator = self.settled.residual.iter().map(deviator::<O::Frame, D, R>).collect();
    }

    /// Begins a pass from an increment: the cells that may change are those that flow in it.
    pub fn begin(&mut self, increment: &[f64]) {
        let n_cells = self.grid().n_cells();
        self.flowed.clear();
        for (cell, has_flowed) in self.has_flowed.iter_mut().enumerate() {
            let from = place::<R>(cell, n_cells);
            *has_flowed = (0..R).any(|k| increment[from + k * n_cells] != 0.0);
            if *has_flowed {
                self.flowed.push(cell);
            }
        }
    }

    /// Adds u_p of all the bodies that this one stands for to the surface field `opening` \[mm\],
    /// positive where it opens the gap.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn open(
        &mut self,
        increment: &[f64],
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.gain(increment);
        let (direction, displacement) = (Direction::Normal, &mut self.displacement);
        let (gained, reach) = (&self.gained, &self.reach);
        self.space.opening(direction, gained, reach, &mut self.work, displacement, stop)?;
        let (grid, width) = (self.grid(), self.grid().window().len());
        let groove = |row: usize| if grid.is_line() { 0.0 } else { self.settled.groove[row] };
        grid.add_to(opening, |row, column| {
            self.count * (groove(row) + self.displacement[row * width + column])
        });
        Ok(())
    }

    /// c of an increment: its sum from the front.
    fn gain(&mut self, increment: &[f64]) {
        let [nx, _, n_cells] = self.size();
        let layers = self.gained.chunks_exact_mut(R * n_cells);
        let layers = layers.zip(increment.chunks_exact(R * n_cells));
        for ((gained, increment), reach) in layers.zip(&mut self.reach) {
            *reach = 0;
            for component in increment.chunks_exact(n_cells) {
                let mut rows = component.chunks_exact(nx);
                let last = rows.rposition(|row| row.iter().any(|value| *value != 0.0));
                *reach = last.map_or(*reach, |last| (last + 1).max(*reach));
            }
            let components = gained.chunks_exact_mut(n_cells).zip(increment.chunks_exact(n_cells));
            for (gained, increment) in components {
                let (strained, rest) = gained.split_at_mut(*reach * nx);
                rest.fill(0.0);
                let rows = strained.chunks_exact_mut(nx).zip(increment.chunks_exact(nx));
                for (gained, increment) in rows {
                    let mut sum = 0.0;
                    for (gained, value) in gained.iter_mut().zip(increment).rev() {
                        sum += value;
                        *gained = sum;
                    }
                }
            }
        }
    }

    /// Columns, rows and cells of a layer.
    fn size(&self) -> [usize; 3] {
        let grid = self.grid();
        [grid.n_columns(), grid.n_rows(), grid.n_cells()]
    }

    /// T under the pressures of a surface field \[MPa\], with the increment of the last
    /// [`open`](Self::open), which it uses up.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn trial(
        &mut self,
        pressure: &[f64],
        into: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.space.ground().grid.halved(pressure, &mut self.pressure);
        self.space.stress(&self.pressure, self.friction, &mut self.work, into, stop)?;
        let [nx, rows, _] = self.size();
        for (n, (row, gained)) in
            into.chunks_exact_mut(nx).zip(self.gained.chunks_exact(nx)).enumerate()
        {
            let (layer, k, j) = (n / rows / R, n / rows % R, n % rows);
            let inlet = self.deviator[layer * rows + j][k];
            if j < self.reach[layer] {
                for (trial, gained) in row.iter_mut().zip(gained) {
                    *trial += inlet + gained;
                }
            } else if inlet != 0.0 {
                for trial in row {
                    *trial += inlet;
                }
            }
        }
        self.leave(into);
        Ok(())
    }

    /// The trial of the last live column.
    fn leave(&mut self, trial: &mut [f64]) {
        // G of an ellipse takes two transforms, and far behind the load S p is next to nothing.
        if !self.grid().is_line() && self.reach.iter().all(|rows| *rows == 0) {
            return;
        }
        let [nx, rows, n_cells] = self.size();
        let last = self.grid().live().start;
        let at = |row: usize, k: usize| (row / rows * R + k) * n_cells + row % rows * nx + last;
        let c = |row: usize| std::array::from_fn(|k| self.gained[at(row, k)]);
        let c: Vec<[f64; R]> = (0..self.inlet.len()).map(c).collect();
        for (row, left) in self.space.leave(&self.deviator, &c, &mut self.work).iter().enumerate()
        {
            for (k, value) in left.iter().enumerate() {
                trial[at(row, k)] = *value;
            }
        }
    }

    /// Answers T with `2μ Δε` of the plastic law.
    ///
    /// The stream of a row begins where its path leaves the elastic domain with which it enters:
    /// the path is a polygon and the domain a ball, so that nothing flows ahead of that column.
    pub fn flow(&mut self, trial: &[f64], into: &mut [f64]) {
        let [nx, rows, n_cells] = self.size();
        self.law.rest();
        self.strain.fill(0.0);
        into.fill(0.0);
        let live = self.grid().live();
        for row in 0..self.law.n_rows() {
            let (layer, j) = (row / rows, row % rows);
            let from = layer * R * n_cells + j * nx;
            let of_row: [&[f64]; R] =
                std::array::from_fn(|k| &trial[from + k * n_cells..][live.clone()]);
            let Some(first) = self.leaves_elastic_domain(row, of_row) else { continue };
            let inlet = if first + 1 < live.len() {
                O::Frame::whole(of_row.map(|row| row[first + 1]))
            } else {
                O::Frame::at_front(all_of_deviator(&self.settled.residual[row]))
            };
            let mut components = into[layer * R * n_cells..]
                .chunks_exact_mut(n_cells)
                .map(|component| &mut component[j * nx + live.start..][..=first]);
            let into = std::array::from_fn(|_| components.next().unwrap_or_default());
            let strain = &mut self.strain[row * nx + live.start..][..=first];
            let trial = of_row.map(|row| &row[..=first]);
            if self.law.follow(row, inlet, trial, into, strain) {
                for (i, _) in strain.iter().enumerate().filter(|(_, dp)| **dp > 0.0) {
                    let cell = row * nx + live.start + i;
                    if !std::mem::replace(&mut self.has_flowed[cell], true) {
                        self.flowed.push(cell);
                    }
                }
            }
        }
    }

    /// The first column from the front at which the path of a row leaves the elastic domain with
    /// which it enters.
    fn leaves_elastic_domain(&self, row: usize, trial: [&[f64]; R]) -> Option<usize> {
        let limit = self.law.yield_stress(row).powi(2);
        let centre = O::Frame::given(self.law.backstress(row));
        let is_outside = |s: [f64; R]| 3.0 * half_square(minus(s, centre)) > limit;
        let n = trial[0].len();
        if is_outside(self.deviator[row]) {
            return n.checked_sub(1);
        }
        let trial = trial.map(|row| &row[..n]);
        (0..n).rev().find(|i| is_outside(trial.map(|row| row[*i])))
    }

    /// By how much the residual stress at the front exceeds the yield stress, over the largest
    /// yield stress.
    fn excess(&self) -> f64 {
        let of_row = |(row, s): (usize, &[f64; R])| {
            let centre = O::Frame::given(self.law.backstress(row));
            [(3.0 * half_square(minus(*s, centre))).sqrt(), self.law.yield_stress(row)]
        };
        excess(self.deviator.iter().enumerate().map(of_row))
    }

    /// Plastic flow of the last stream, and the part of it far from the load.
    fn flow_of_pass(&self) -> FlowOfPass {
        let grid = self.grid();
        let live = (grid.n_columns(), grid.live());
        FlowOfPass::of(&self.strain, live, |row| self.thickness(row))
    }

    /// `∫∫σ:dε_p` of the last stream, per length of travel \[N\].
    fn work_of_pass(&self) -> f64 {
        let of_row = |row: usize| self.thickness(row) * self.law.work_of_pass(row);
        self.grid().row_width() * (0..self.law.n_rows()).map(of_row).sum::<f64>()
    }

    /// Accepts an increment that the law has just answered its trial with. The state at the back
    /// enters the next pass, and the trial becomes that of the same path behind the residual stress
    /// that this pass leaves.
    pub fn accept(&mut self, increment: &[f64], trial: &mut [f64]) -> Outlet {
        let [nx, rows, _] = self.size();
        let compliance = 0.5 / self.space.ground().elastic.shear();
        let (stored, work) = (self.settled.stored_energy, self.work_of_pass());
        let before = self.deviator.clone();
        let place_of = |n: usize| (n / rows / R * rows + n % rows, n / rows % R);
        let mut change = vec![[0.0; R]; self.inlet.len()];
        for (n, row) in increment.chunks_exact(nx).enumerate() {
            let (of, k) = place_of(n);
            let sum: f64 = row.iter().sum();
            self.inlet[of][k] += sum;
            change[of][k] = compliance * sum;
        }
        let accumulated = self.strain.chunks_exact(nx).map(|row| row.iter().sum()).collect();
        self.law.accept();
        self.most_flow = self.most_flow.max(self.flow_of_pass().whole);
        self.settle();
        for (n, row) in trial.chunks_exact_mut(nx).enumerate() {
            let (of, k) = place_of(n);
            let shift = self.deviator[of][k] - before[of][k];
            for value in row {
                *value += shift;
            }
        }
        let change: Vec<_> = change.into_iter().map(O::Frame::all_of).collect();
        let strain = |tau: &[f64; R]| O::Frame::all_of(tau.map(|value| compliance * value));
        let (grid, layers) = (self.grid(), &self.space.ground().layers);
        let groove = &self.settled.groove;
        Outlet {
            depths: (0..layers.len()).map(|layer| layers.middle(layer)).collect(),
            faces: layers.faces().to_vec(),
            across: (0..rows).map(|j| grid.y(j)).collect(),
            forward: self.space.forward(&change),
            change,
            strain: self.inlet.iter().map(strain).collect(),
            accumulated,
            groove_depth: groove.first().copied().unwrap_or(0.0),
            pile_up: if grid.is_line() {
                0.0
            } else {
                groove.iter().fold(0.0, |most, u| f64::max(most, -u))
            },
            residual: self.settled.residual.clone(),
            plastic_work: work,
            stored_energy: self.settled.stored_energy - stored,
            excess: self.excess(),
        }
    }

    /// Work of the traction μ p on the plastic displacement of the surface of one body, `-Σ μ p
    /// ∂u_px/∂x hx hy` per length of travel \[N\], with the increment of the last
    /// [`open`](Self::open).
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn work_of_traction(
        &mut self,
        pressure: &[f64],
        stop: &mut Stop<'_>,
    ) -> Result<f64, Stopped> {
        if self.friction == 0.0 || self.reach.iter().all(|rows| *rows == 0) {
            return Ok(0.0);
        }
        self.space.ground().grid.halved(pressure, &mut self.pressure);
        let mut along = vec![0.0; self.pressure.len()];
        let (direction, gained, reach) = (Direction::Tangential, &self.gained, &self.reach);
        self.space.opening(direction, gained, reach, &mut self.work, &mut along, stop)?;
        let width = self.grid().window().len();
        let rows = self.pressure.chunks_exact(width).zip(along.chunks_exact(width));
        let sum: f64 = rows.map(|(p, u)| work_along(p, u)).sum();
        Ok(-self.friction * self.grid().row_width() * sum)
    }

    /// Appends the cells that have flowed, in the order in which their flow began, to one vector
    /// whose square is `Σ h_l a:a`, over all cells on both sides of an axis \[MPa √mm\]. A vector
    /// packed earlier is the beginning of one packed later.
    pub fn pack(&self, increment: &[f64], into: &mut Vec<f64>) {
        let n_cells = self.grid().n_cells();
        for cell in &self.flowed {
            let from = place::<R>(*cell, n_cells);
            let values = std::array::from_fn(|k| increment[from + k * n_cells]);
            into.extend(O::Frame::packed(values, self.weight(cell / n_cells)));
        }
    }

    /// Writes the cells back to where [`pack`](Self::pack) took them from.
    pub fn unpack(&self, packed: &[f64], increment: &mut [f64]) {
        let n_cells = self.grid().n_cells();
        for (cell, values) in self.flowed.iter().zip(packed.chunks_exact(R)) {
            let (from, weight) = (place::<R>(*cell, n_cells), self.weight(cell / n_cells));
            let values = O::Frame::unpacked(std::array::from_fn(|k| values[k]), weight);
            for (k, value) in values.into_iter().enumerate() {
                increment[from + k * n_cells] = value;
            }
        }
    }

    /// Root of the thickness of a layer, over all sides for which a cell stands.
    fn weight(&self, layer: usize) -> f64 {
        (self.grid().n_sides() * self.space.ground().layers.thickness(layer)).sqrt()
    }

    /// Why the plastic zone of the last stream is cut off, if it is.
    ///
    /// # Errors
    /// [`TrackFault::Far`], [`TrackFault::Depth`], [`TrackFault::Edge`].
    pub fn holds(&self) -> Result<(), TrackFault> {
        self.flow_of_pass().holds(self.most_flow, self.grid().length())?;
        let [nx, rows, _] = self.size();
        let of_row: Vec<f64> = self.strain.chunks_exact(nx).map(|row| row.iter().sum()).collect();
        let largest = |rows: &mut dyn Iterator<Item = &f64>| rows.fold(0.0, |a: f64, b| a.max(*b));
        let limit = NOTHING * largest(&mut of_row.iter());
        if largest(&mut of_row[of_row.len() - rows..].iter()) > limit {
            let depth = self.space.ground().layers.faces().last().copied().unwrap_or(0.0);
            return Err(TrackFault::Depth { depth });
        }
        let at_edge = || largest(&mut of_row.iter().skip(rows - 1).step_by(rows));
        if !self.grid().is_line() && at_edge() > limit {
            return Err(TrackFault::Edge { half_width: self.grid().half_width() });
        }
        Ok(())
    }
}

/// The deviator of a stress `xx yy zz xy xz yz`.
fn all_of_deviator([xx, yy, zz, xy, xz, yz]: &[f64; COMPONENTS]) -> [f64; COMPONENTS] {
    let mean = (xx + yy + zz) / 3.0;
    [xx - mean, yy - mean, zz - mean, *xy, *xz, *yz]
}

/// The components that are given of the deviator of a stress.
fn deviator<F: Frame<D, R>, const D: usize, const R: usize>(
    stress: &[f64; COMPONENTS],
) -> [f64; R] {
    F::of_all(all_of_deviator(stress))
}

/// Half of `a:a` of a deviator, of which two normal components come first.
fn half_square<const R: usize>(a: [f64; R]) -> f64 {
    let normal = a[0] * a[0] + a[1] * a[1] + a[0] * a[1];
    a[2..].iter().fold(normal, |sum, shear| sum + shear * shear)
}

fn minus<const R: usize>(a: [f64; R], b: [f64; R]) -> [f64; R] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// Returns the index of the first component of a cell in an increment.
const fn place<const R: usize>(cell: usize, n_cells: usize) -> usize {
    cell / n_cells * R * n_cells + cell % n_cells
}
