//! A body that yields under an elliptic contact that rolls over it: one pass is one fixed-point
//! problem.
//!
//! As on a [line](crate::track), with `c_i = 2μ Σ_{j>=i} Δε_j` of each row of constant y and z and
//! the residual stress σ_in of the inlet,
//! ```text
//! u_p = u_in(y) + Sᵀ c/2μ                               opening
//! T_i = dev(S p + μ S_t p + G c/2μ + σ_in) + c_i        trial
//! 2μ Δε_i: flow along T_{i+1} -> T_i                    stream
//! ```
//! The plastic strain of the inlet does not depend on x. Its groove u_in and its residual stress
//! are those of an endless track: sums of line loads, and G at q_x = 0.

use std::ops::Range;
use std::sync::Arc;

use brinell_material::StreamLaw;

use super::grid::RacewayGrid;
use super::space::{RacewaySpace, RacewayWork};
use crate::stop::{Stop, Stopped};
use crate::tensors::{COMPONENTS, DEVIATOR_COMPONENTS, from_isometric, isometric};
use crate::track::{FlowOfPass, Outlet, Rolls, TrackFault, excess, live_columns};

/// The plastic law of the rows of a body.
pub type RowLaw = dyn StreamLaw<COMPONENTS, DEVIATOR_COMPONENTS>;

type Deviator = [f64; DEVIATOR_COMPONENTS];

/// Plastic strains, memory and work space of one body on a track of finite width.
pub struct RacewayBody {
    space: Arc<RacewaySpace>,
    law: Box<RowLaw>,
    /// Number of bodies for which this one stands.
    count: f64,
    /// Traction in the direction of travel over pressure.
    friction: f64,
    /// σ0xx, σ0yy of each layer.
    initial: Vec<[f64; 2]>,
    /// `2μ ε_p` of each row at the front, and what it makes: residual stress with σ0, its
    /// deviator, and the sinking of the rows of the surface of one body.
    inlet: Vec<Deviator>,
    residual: Vec<[f64; COMPONENTS]>,
    residual_deviator: Vec<Deviator>,
    groove: Vec<f64>,
    /// c.
    gained: Vec<f64>,
    /// Rows of each layer, from the axis outwards, in which c is not zero.
    reach: Vec<usize>,
    /// Accumulated plastic strain that each column adds.
    strain: Vec<f64>,
    work: RacewayWork,
    /// u_p of c, and pressure, in the window at y > 0.
    displacement: Vec<f64>,
    pressure: Vec<f64>,
    /// Cells that have flowed in this pass, in the order in which their flow began.
    flowed: Vec<usize>,
    has_flowed: Vec<bool>,
    /// The largest flow of a pass so far.
    most_flow: f64,
}

impl RacewayBody {
    /// A body at rest; two equal bodies that roll freely are one that stands for `count = 2`.
    ///
    /// The law has the rows of all layers, those of the first layer first. `initial` is the stress
    /// σxx, σyy of each layer before any load \[MPa\].
    pub fn new(
        space: Arc<RacewaySpace>,
        law: Box<RowLaw>,
        count: u8,
        friction: f64,
        initial: Vec<[f64; 2]>,
    ) -> Self {
        let (n_layers, grid) = (space.layers().len(), *space.grid());
        let n_rows = n_layers * grid.n_rows();
        debug_assert_eq!((law.n_rows(), initial.len()), (n_rows, n_layers));
        let (work, window) = (space.work(), grid.n_rows() * grid.window().len());
        let mut body = Self {
            law,
            count: f64::from(count),
            friction,
            initial,
            inlet: vec![[0.0; DEVIATOR_COMPONENTS]; n_rows],
            residual: vec![[0.0; COMPONENTS]; n_rows],
            residual_deviator: vec![[0.0; DEVIATOR_COMPONENTS]; n_rows],
            groove: vec![0.0; grid.n_rows()],
            gained: vec![0.0; space.field_len()],
            reach: vec![0; n_layers],
            strain: vec![0.0; n_layers * grid.n_cells()],
            work,
            displacement: vec![0.0; window],
            pressure: vec![0.0; window],
            flowed: Vec::new(),
            has_flowed: vec![false; n_layers * grid.n_cells()],
            most_flow: 0.0,
            space,
        };
        body.settle();
        body
    }

    /// Operators of the body.
    pub fn space(&self) -> &RacewaySpace {
        &self.space
    }

    fn grid(&self) -> &RacewayGrid {
        self.space.grid()
    }

    /// The plastic law, with what the rows remember.
    pub fn law(&self) -> &RowLaw {
        &*self.law
    }

    /// Traction on this body in the direction of travel over pressure.
    pub const fn friction(&self) -> f64 {
        self.friction
    }

    /// Residual stresses `xx yy zz xy xz yz` of the rows at the front, σ0 included \[MPa\].
    pub fn residual(&self) -> &[[f64; COMPONENTS]] {
        &self.residual
    }

    /// Returns the depth of the groove at the rows of the surface after all passes \[mm\].
    pub fn groove(&self) -> &[f64] {
        &self.groove
    }

    /// Plastic strains `xx yy xy xz yz` of the rows at the front.
    pub fn inlet(&self) -> Vec<[f64; DEVIATOR_COMPONENTS]> {
        let compliance = self.compliance();
        self.inlet.iter().map(|tau| tau.map(|value| compliance * value)).collect()
    }

    fn compliance(&self) -> f64 {
        0.5 / self.space.elastic().shear()
    }

    /// Residual stress and groove of the inlet.
    fn settle(&mut self) {
        let rows = self.grid().n_rows();
        self.residual = self.space.uniform_stress(&self.inlet, &mut self.work);
        for (row, stress) in self.residual.iter_mut().enumerate() {
            let [xx, yy] = self.initial[row / rows];
            stress[0] += xx;
            stress[1] += yy;
        }
        self.residual_deviator = self.residual.iter().map(deviator).collect();
        self.groove = self.space.uniform().groove(&self.inlet());
    }

    /// c of an increment: its sum from the front.
    fn gain(&mut self, increment: &[f64]) {
        let (nx, n_cells) = (self.grid().n_columns(), self.grid().n_cells());
        let len = DEVIATOR_COMPONENTS * n_cells;
        let layers = self.gained.chunks_exact_mut(len).zip(increment.chunks_exact(len));
        for ((gained, increment), reach) in layers.zip(&mut self.reach) {
            *reach = 0;
            for component in increment.chunks_exact(n_cells) {
                let mut rows = component.chunks_exact(nx);
                let last = rows.rposition(|row| row.iter().any(|value| *value != 0.0));
                *reach = last.map_or(*reach, |last| (last + 1).max(*reach));
            }
            let components = gained.chunks_exact_mut(n_cells).zip(increment.chunks_exact(n_cells));
            for (gained, increment) in components {
                let rows = gained.chunks_exact_mut(nx).zip(increment.chunks_exact(nx));
                for (gained, increment) in rows.take(*reach) {
                    let mut sum = 0.0;
                    for (gained, value) in gained.iter_mut().zip(increment).rev() {
                        sum += value;
                        *gained = sum;
                    }
                }
            }
        }
    }

    /// The first column from the front at which the path of a row leaves the elastic domain with
    /// which it enters.
    fn leaves_elastic_domain(
        &self,
        row: usize,
        trial: [&[f64]; DEVIATOR_COMPONENTS],
    ) -> Option<usize> {
        let limit = self.law.yield_stress(row).powi(2);
        let [x, y, _, xy, xz, yz] = self.law.backstress(row);
        let is_outside = |s: Deviator| {
            let [xx, yy, xy, xz, yz] = [s[0] - x, s[1] - y, s[2] - xy, s[3] - xz, s[4] - yz];
            3.0 * (xx * xx + yy * yy + xx * yy + xy * xy + xz * xz + yz * yz) > limit
        };
        let n = trial[0].len();
        if is_outside(self.residual_deviator[row]) {
            return n.checked_sub(1);
        }
        (0..n).rev().find(|i| is_outside(trial.map(|row| row[*i])))
    }

    /// Columns that may flow.
    fn live(&self) -> Range<usize> {
        live_columns(self.grid().n_columns())
    }

    /// The trial of the last live column, which is far behind the load: that of the uniform state
    /// of its own c.
    fn leave(&mut self, trial: &mut [f64]) {
        if self.reach.iter().all(|rows| *rows == 0) {
            return;
        }
        let (nx, rows, n_cells) =
            (self.grid().n_columns(), self.grid().n_rows(), self.grid().n_cells());
        let last = self.live().start;
        let at = |row: usize, k: usize| {
            (row / rows * DEVIATOR_COMPONENTS + k) * n_cells + row % rows * nx + last
        };
        let c: Vec<Deviator> = (0..self.inlet.len())
            .map(|row| std::array::from_fn(|k| self.gained[at(row, k)]))
            .collect();
        let uniform = self.space.uniform_stress(&c, &mut self.work);
        for (row, (c, stress)) in c.iter().zip(&uniform).enumerate() {
            let stress = deviator(stress);
            for (k, (c, stress)) in c.iter().zip(stress).enumerate() {
                trial[at(row, k)] = self.residual_deviator[row][k] + stress + c;
            }
        }
    }

    /// By how much the residual stress at the front exceeds the yield stress, over the largest
    /// yield stress.
    fn excess(&self) -> f64 {
        let of_row = |row: usize| {
            let [x, y, _, xy, xz, yz] = self.law.backstress(row);
            let s = self.residual_deviator[row];
            let [xx, yy, xy, xz, yz] = [s[0] - x, s[1] - y, s[2] - xy, s[3] - xz, s[4] - yz];
            let squares = xx * xx + yy * yy + xx * yy + xy * xy + xz * xz + yz * yz;
            [(3.0 * squares).sqrt(), self.law.yield_stress(row)]
        };
        excess((0..self.inlet.len()).map(of_row))
    }

    /// Plastic flow of the last stream, and the part of it far from the load.
    fn flow_of_pass(&self) -> FlowOfPass {
        let (rows, layers) = (self.grid().n_rows(), self.space.layers());
        FlowOfPass::of(&self.strain, self.grid().n_columns(), |row| layers.thickness(row / rows))
    }

    /// `∫∫σ:dε_p` of the last stream, per length of travel \[N\].
    fn work_of_pass(&self) -> f64 {
        let (rows, layers) = (self.grid().n_rows(), self.space.layers());
        let of_row = |row: usize| layers.thickness(row / rows) * self.law.work_of_pass(row);
        2.0 * self.grid().hy * (0..self.law.n_rows()).map(of_row).sum::<f64>()
    }

    /// Elastic energy of the residual stress less that of σ0, per length of track \[N\]: `-½ ∫ε_p :
    /// (σ_in + σ0) dA`.
    pub fn stored_energy(&self) -> f64 {
        let (rows, layers) = (self.grid().n_rows(), self.space.layers());
        let of_row = |(row, (tau, stress)): (usize, (&Deviator, &[f64; COMPONENTS]))| {
            let [xx, yy, xy, xz, yz] = *tau;
            let [initial_xx, initial_yy] = self.initial[row / rows];
            let normal = xx * (stress[0] + initial_xx) + yy * (stress[1] + initial_yy)
                - (xx + yy) * stress[2];
            let shear = 2.0 * (xy * stress[3] + xz * stress[4] + yz * stress[5]);
            layers.thickness(row / rows) * (normal + shear)
        };
        let sum: f64 = self.inlet.iter().zip(&self.residual).enumerate().map(of_row).sum();
        -self.compliance() * self.grid().hy * sum
    }

    /// Why the body cannot bear the traction of a peak pressure \[MPa\], if it cannot.
    ///
    /// # Errors
    /// [`TrackFault::Traction`].
    pub fn bears(&self, peak_pressure: f64) -> Result<(), TrackFault> {
        let traction = self.friction.abs() * peak_pressure;
        let strength = self.law.largest_stress(0) / 3f64.sqrt();
        if traction > strength {
            return Err(TrackFault::Traction { traction, strength });
        }
        Ok(())
    }
}

impl Rolls for RacewayBody {
    const PACKED: usize = DEVIATOR_COMPONENTS;

    fn n_numbers(&self) -> usize {
        self.gained.len()
    }

    fn count(&self) -> f64 {
        self.count
    }

    fn begin(&mut self, increment: &[f64]) {
        let n_cells = self.grid().n_cells();
        self.flowed.clear();
        for (cell, has_flowed) in self.has_flowed.iter_mut().enumerate() {
            let from = place(cell, n_cells);
            *has_flowed = (0..DEVIATOR_COMPONENTS).any(|k| increment[from + k * n_cells] != 0.0);
            if *has_flowed {
                self.flowed.push(cell);
            }
        }
    }

    fn open(
        &mut self,
        increment: &[f64],
        opening: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.gain(increment);
        self.space.opening(
            &self.gained,
            &self.reach,
            &mut self.work,
            &mut self.displacement,
            stop,
        )?;
        let (rows, window) = (self.grid().n_rows(), self.grid().window().len());
        for (i, cells) in opening.chunks_exact_mut(2 * rows).enumerate() {
            for j in 0..rows {
                let u = self.count * (self.groove[j] + self.displacement[j * window + i]);
                cells[rows + j] += u;
                cells[rows - 1 - j] += u;
            }
        }
        Ok(())
    }

    fn trial(
        &mut self,
        pressure: &[f64],
        into: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.space.grid().halved(pressure, &mut self.pressure);
        self.space.stress(&self.pressure, self.friction, &mut self.work, into, stop)?;
        let (nx, rows) = (self.grid().n_columns(), self.grid().n_rows());
        for (n, (row, gained)) in
            into.chunks_exact_mut(nx).zip(self.gained.chunks_exact(nx)).enumerate()
        {
            let (layer, k, j) =
                (n / rows / DEVIATOR_COMPONENTS, n / rows % DEVIATOR_COMPONENTS, n % rows);
            let inlet = self.residual_deviator[layer * rows + j][k];
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

    /// The stream of a row begins where its path leaves the elastic domain with which it enters.
    fn flow(&mut self, trial: &[f64], into: &mut [f64]) {
        let (nx, rows, n_cells) =
            (self.grid().n_columns(), self.grid().n_rows(), self.grid().n_cells());
        self.law.rest();
        self.strain.fill(0.0);
        into.fill(0.0);
        let live = self.live();
        for row in 0..self.law.n_rows() {
            let (layer, j) = (row / rows, row % rows);
            let from = layer * DEVIATOR_COMPONENTS * n_cells + j * nx;
            let of_row: [&[f64]; DEVIATOR_COMPONENTS] =
                std::array::from_fn(|k| &trial[from + k * n_cells..][live.clone()]);
            let Some(first) = self.leaves_elastic_domain(row, of_row) else { continue };
            let [xx, yy, xy, xz, yz] = if first + 1 < live.len() {
                of_row.map(|row| row[first + 1])
            } else {
                self.residual_deviator[row]
            };
            let inlet = [xx, yy, -xx - yy, xy, xz, yz];
            let mut components = into[layer * DEVIATOR_COMPONENTS * n_cells..]
                .chunks_exact_mut(n_cells)
                .map(|component| &mut component[j * nx + live.start..][..=first]);
            let into = std::array::from_fn(|_| components.next().unwrap_or_default());
            let strain = &mut self.strain[row * nx + live.start..][..=first];
            if self.law.follow(row, inlet, of_row.map(|row| &row[..=first]), into, strain) {
                for (i, _) in strain.iter().enumerate().filter(|(_, dp)| **dp > 0.0) {
                    let cell = row * nx + live.start + i;
                    if !std::mem::replace(&mut self.has_flowed[cell], true) {
                        self.flowed.push(cell);
                    }
                }
            }
        }
    }

    fn accept(&mut self, increment: &[f64], trial: &mut [f64]) -> Outlet {
        let (nx, rows) = (self.grid().n_columns(), self.grid().n_rows());
        let (stored, work, compliance) =
            (self.stored_energy(), self.work_of_pass(), self.compliance());
        let before = self.residual_deviator.clone();
        let mut change = vec![[0.0; DEVIATOR_COMPONENTS]; self.inlet.len()];
        let place_of = |n: usize| {
            let layer = n / rows / DEVIATOR_COMPONENTS;
            (layer * rows + n % rows, n / rows % DEVIATOR_COMPONENTS)
        };
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
            let shift = self.residual_deviator[of][k] - before[of][k];
            for value in row {
                *value += shift;
            }
        }
        let layers = self.space.layers();
        let forward = self.space.uniform().forward(&change).first().copied();
        Outlet {
            depths: (0..layers.len()).map(|layer| layers.middle(layer)).collect(),
            faces: layers.faces().to_vec(),
            across: (0..rows).map(|j| self.grid().y(j)).collect(),
            change,
            strain: self.inlet(),
            accumulated,
            forward: forward.unwrap_or(0.0),
            groove_depth: self.groove.first().copied().unwrap_or(0.0),
            pile_up: self.groove.iter().fold(0.0, |most, u| f64::max(most, -u)),
            residual: self.residual.clone(),
            plastic_work: work,
            stored_energy: self.stored_energy() - stored,
            excess: self.excess(),
        }
    }

    fn turn(&mut self) {
        for [_, _, xy, xz, _] in &mut self.inlet {
            (*xy, *xz) = (-*xy, -*xz);
        }
        self.law.mirror();
        self.settle();
    }

    /// `-Σ μ p ∂u_px/∂x hx hy` over both sides of the axis \[N\].
    fn work_of_traction(&mut self, pressure: &[f64], stop: &mut Stop<'_>) -> Result<f64, Stopped> {
        if self.friction == 0.0 || self.reach.iter().all(|rows| *rows == 0) {
            return Ok(0.0);
        }
        self.space.grid().halved(pressure, &mut self.pressure);
        let mut along = vec![0.0; self.pressure.len()];
        let (space, work) = (&self.space, &mut self.work);
        space.tangential_opening(&self.gained, &self.reach, work, &mut along, stop)?;
        let width = self.grid().window().len();
        let rows = self.pressure.chunks_exact(width).zip(along.chunks_exact(width));
        let sum: f64 = rows.map(|(p, u)| crate::track::work_along(p, u)).sum();
        Ok(-self.friction * 2.0 * self.grid().hy * sum)
    }

    fn strains(&self) -> &[f64] {
        &self.strain
    }

    fn n_columns(&self) -> usize {
        self.grid().n_columns()
    }

    fn n_layers(&self) -> usize {
        self.space.layers().len()
    }

    fn n_flowed(&self) -> usize {
        self.flowed.len()
    }

    fn pack(&self, increment: &[f64], into: &mut Vec<f64>) {
        let n_cells = self.grid().n_cells();
        for cell in &self.flowed {
            let from = place(*cell, n_cells);
            // A cell stands for both sides of the axis.
            let weight = (2.0 * self.space.layers().thickness(cell / n_cells)).sqrt();
            let values = isometric(std::array::from_fn(|k| increment[from + k * n_cells]));
            into.extend(values.map(|value| weight * value));
        }
    }

    fn unpack(&self, packed: &[f64], increment: &mut [f64]) {
        let n_cells = self.grid().n_cells();
        for (cell, values) in self.flowed.iter().zip(packed.chunks_exact(DEVIATOR_COMPONENTS)) {
            let from = place(*cell, n_cells);
            let weight = (2.0 * self.space.layers().thickness(cell / n_cells)).sqrt().recip();
            let values = from_isometric(std::array::from_fn(|k| weight * values[k]));
            for (k, value) in values.into_iter().enumerate() {
                increment[from + k * n_cells] = value;
            }
        }
    }

    fn holds(&self) -> Result<(), TrackFault> {
        self.flow_of_pass().holds(self.most_flow, self.grid().length())?;
        let (nx, rows) = (self.grid().n_columns(), self.grid().n_rows());
        let of_row: Vec<f64> = self.strain.chunks_exact(nx).map(|row| row.iter().sum()).collect();
        let largest = |rows: &mut dyn Iterator<Item = &f64>| rows.fold(0.0, |a: f64, b| a.max(*b));
        let limit = crate::track::NOTHING * largest(&mut of_row.iter());
        if largest(&mut of_row[of_row.len() - rows..].iter()) > limit {
            let depth = self.space.layers().faces().last().copied().unwrap_or(0.0);
            return Err(TrackFault::Depth { depth });
        }
        if largest(&mut of_row.iter().skip(rows - 1).step_by(rows)) > limit {
            return Err(TrackFault::Edge { half_width: self.grid().half_width() });
        }
        Ok(())
    }
}

impl RacewayGrid {
    /// Why pressures on the cells of the window are cut off, if they are.
    ///
    /// # Errors
    /// [`TrackFault::Window`], [`TrackFault::Edge`].
    pub fn holds(&self, pressure: &[f64]) -> Result<(), TrackFault> {
        let ny = 2 * self.n_rows();
        let touches = |cells: &[f64]| cells.iter().any(|p| *p > 0.0);
        if touches(&pressure[..ny]) || touches(&pressure[pressure.len() - ny..]) {
            return Err(TrackFault::Window { width: self.window().len() as f64 * self.hx });
        }
        if pressure.chunks_exact(ny).any(|cells| cells[0] > 0.0 || cells[ny - 1] > 0.0) {
            return Err(TrackFault::Edge { half_width: self.half_width() });
        }
        Ok(())
    }

    /// The force against which a contact is pushed, `F = Σ p ∂δ0/∂x hx hy` \[N\], of a pressure
    /// and the gap of the undeformed bodies on the cells of the window.
    pub fn rolling_force(&self, gap: &[f64], pressure: &[f64]) -> f64 {
        let ny = 2 * self.n_rows();
        let of_row = |j: usize| {
            let row = |field: &[f64]| -> Vec<f64> {
                field.iter().skip(j).step_by(ny).copied().collect()
            };
            crate::track::work_along(&row(pressure), &row(gap))
        };
        self.hy * (0..ny).map(of_row).sum::<f64>()
    }
}

/// The deviator of a stress `xx yy zz xy xz yz`.
fn deviator([xx, yy, zz, xy, xz, yz]: &[f64; COMPONENTS]) -> Deviator {
    let mean = (xx + yy + zz) / 3.0;
    [xx - mean, yy - mean, *xy, *xz, *yz]
}

/// Returns the index of the first component of a cell in an increment.
const fn place(cell: usize, n_cells: usize) -> usize {
    cell / n_cells * DEVIATOR_COMPONENTS * n_cells + cell % n_cells
}
