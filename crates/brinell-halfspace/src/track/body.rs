//! A body that yields under a load that rolls over it: one pass is one fixed-point problem.
//!
//! In the frame of the load a steady pass is stationary. Plastic strain `ε_p,in` enters at the
//! front, and each column adds its Δε. With `c_i = 2μ Σ_{j>=i} Δε_j`, what the columns from the
//! front to column i have added,
//! ```text
//! u_p = Sᵀ c/2μ                                        opening
//! T_i = dev(S p + μ S_t p + G c + σ_in) + c_i          trial
//! 2μ Δε_i: flow along T_{i+1} -> T_i                   stream
//! ```
//! Only the [live](super::grid::live_columns) columns flow. The last of them is far behind the load:
//! its T is that of the uniform state of its own c, `dev(λ'c_zz - c_xx, λ'c_zz - c_yy) + c` beside
//! σ_in, so that the state that leaves is within its yield surface by the plastic law itself.
//!
//! σ_in is the residual stress of the inlet, uniform along the track: `σxx = λ'τzz - τxx`, `σyy =
//! λ'τzz - τyy` with `τ = 2μ ε_p,in`, and the stress σ0 that the unloaded body has. Δε enters and
//! leaves as `2μ Δε` \[MPa\], rows xx, zz, xz of N columns for each layer.

use std::ops::Range;
use std::sync::Arc;

use brinell_material::{Rows, StreamLaw};

use super::fault::{FlowOfPass, NOTHING, TrackFault, excess};
use super::figures::Outlet;
use super::grid::live_columns;
use super::space::{TrackSpace, TrackWork};
use super::sweep::ROWS;
use crate::stop::{Stop, Stopped};

/// Plastic strains, memory and work space of one body on a track.
pub struct RollingBody {
    space: Arc<TrackSpace>,
    law: Box<dyn StreamLaw>,
    /// Number of bodies for which this one stands.
    count: f64,
    /// Traction in the direction of travel over pressure.
    friction: f64,
    /// σ0xx, σ0yy of each layer.
    initial: Vec<[f64; 2]>,
    /// `2μ ε_p` xx, zz, xz of each layer at the front.
    inlet: Vec<[f64; 3]>,
    /// c.
    gained: Vec<f64>,
    strained: Vec<bool>,
    /// Accumulated plastic strain that each column adds.
    strain: Vec<f64>,
    work: TrackWork,
    /// u_p of one body.
    displacement: Vec<f64>,
    /// Cells that have flowed in this pass, in the order in which their flow began.
    flowed: Vec<usize>,
    has_flowed: Vec<bool>,
    /// The largest flow of a pass so far.
    most_flow: f64,
}

impl RollingBody {
    /// A body at rest; two equal bodies that roll freely are one that stands for `count = 2`.
    ///
    /// `initial` is the stress σxx, σyy of each layer before any load \[MPa\].
    pub fn new(
        space: Arc<TrackSpace>,
        law: Box<dyn StreamLaw>,
        count: u8,
        friction: f64,
        initial: Vec<[f64; 2]>,
    ) -> Self {
        let (n_layers, n) = (space.layers().len(), space.grid().n);
        debug_assert_eq!((law.n_rows(), initial.len()), (n_layers, n_layers));
        let work = space.work();
        Self {
            law,
            count: f64::from(count),
            friction,
            initial,
            inlet: vec![[0.0; 3]; n_layers],
            gained: vec![0.0; space.field_len()],
            strained: vec![false; n_layers],
            strain: vec![0.0; n_layers * n],
            work,
            displacement: vec![0.0; space.grid().window().len()],
            flowed: Vec::new(),
            has_flowed: vec![false; n_layers * n],
            most_flow: 0.0,
            space,
        }
    }

    /// Operators of the body.
    pub fn space(&self) -> &TrackSpace {
        &self.space
    }

    /// The plastic law, with what the layers remember.
    pub fn law(&self) -> &dyn StreamLaw {
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
    pub fn len(&self) -> usize {
        self.gained.len()
    }

    /// Always false: there is at least one layer.
    pub const fn is_empty(&self) -> bool {
        false
    }

    /// Turns the track round: the next pass goes the other way. x is again the direction of
    /// travel.
    pub fn turn(&mut self) {
        for [.., xz] in &mut self.inlet {
            *xz = -*xz;
        }
        self.law.mirror();
    }

    /// Begins a pass from an increment: the cells that may change are those that flow in it.
    pub fn begin(&mut self, increment: &[f64]) {
        let n = self.space.grid().n;
        self.flowed.clear();
        for (cell, has_flowed) in self.has_flowed.iter_mut().enumerate() {
            let from = cell / n * ROWS * n + cell % n;
            *has_flowed = (0..ROWS).any(|k| increment[from + k * n] != 0.0);
            if *has_flowed {
                self.flowed.push(cell);
            }
        }
    }

    /// Adds u_p of all the bodies that this one stands for to `opening` \[mm\], positive where it
    /// opens the gap.
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
        self.space.opening(
            &self.gained,
            &self.strained,
            &mut self.work,
            &mut self.displacement,
            stop,
        )?;
        for (u, part) in opening.iter_mut().zip(&self.displacement) {
            *u += self.count * part;
        }
        Ok(())
    }

    /// c of an increment: its sum from the front.
    fn gain(&mut self, increment: &[f64]) {
        let n = self.space.grid().n;
        let layers = self.gained.chunks_exact_mut(ROWS * n).zip(increment.chunks_exact(ROWS * n));
        for ((gained, increment), strained) in layers.zip(&mut self.strained) {
            *strained = increment.iter().any(|value| *value != 0.0);
            if !*strained {
                gained.fill(0.0);
                continue;
            }
            for (gained, increment) in gained.chunks_exact_mut(n).zip(increment.chunks_exact(n)) {
                let mut sum = 0.0;
                for (gained, value) in gained.iter_mut().zip(increment).rev() {
                    sum += value;
                    *gained = sum;
                }
            }
        }
    }

    /// T under pressures \[MPa\], with the increment of the last [`open`](Self::open), which it
    /// uses up.
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn trial(
        &mut self,
        pressure: &[f64],
        into: &mut [f64],
        stop: &mut Stop<'_>,
    ) -> Result<(), Stopped> {
        self.space.stress(pressure, self.friction, &mut self.work, into, stop)?;
        let n = self.space.grid().n;
        for layer in 0..self.inlet.len() {
            let [xx, _, zz, xz] = self.inlet_deviator(layer);
            for (k, inlet) in [xx, zz, xz].into_iter().enumerate() {
                let from = (layer * ROWS + k) * n;
                let gained = &self.gained[from..][..n];
                let row = &mut into[from..][..n];
                if self.strained[layer] {
                    for (trial, gained) in row.iter_mut().zip(gained) {
                        *trial += inlet + gained;
                    }
                } else if inlet != 0.0 {
                    for trial in row {
                        *trial += inlet;
                    }
                }
            }
            let last = self.live().start;
            let at = |k: usize| (layer * ROWS + k) * n + last;
            let c = std::array::from_fn(|k| self.gained[at(k)]);
            let [uniform_xx, uniform_yy] = self.uniform_stress(c);
            let mean = (uniform_xx + uniform_yy) / 3.0;
            into[at(0)] = xx + uniform_xx - mean + c[0];
            into[at(1)] = zz - mean + c[1];
            into[at(2)] = xz + c[2];
        }
        Ok(())
    }

    /// Columns that may flow.
    fn live(&self) -> Range<usize> {
        live_columns(self.space.grid().n)
    }

    /// Stress σxx, σyy of a polarization `2μ ε_p` xx, zz, xz that is uniform along the track.
    fn uniform_stress(&self, [xx, zz, _]: [f64; 3]) -> [f64; 2] {
        let nu = self.space.elastic().poisson();
        let local = nu / (1.0 - nu);
        [local * zz - xx, local * zz + xx + zz]
    }

    /// Answers T with `2μ Δε` of the plastic law.
    ///
    /// The stream of a layer begins where its path leaves the elastic domain with which it enters:
    /// the path is a polygon and the domain a ball, so that nothing flows ahead of that column.
    pub fn flow(&mut self, trial: &[f64], into: &mut [f64]) {
        let n = self.space.grid().n;
        self.law.rest();
        self.strain.fill(0.0);
        into.fill(0.0);
        let live = self.live();
        for layer in 0..self.inlet.len() {
            let from = layer * ROWS * n;
            let (xx, rest) = trial[from..][..ROWS * n].split_at(n);
            let rows = [xx, &rest[..n], &rest[n..]].map(|row| &row[live.clone()]);
            let inlet = self.inlet_deviator(layer);
            let Some(first) = self.leaves_elastic_domain(layer, inlet, rows) else { continue };
            let inlet = match first + 1 {
                ahead if ahead < live.len() => {
                    let [xx, zz, xz] = rows.map(|row| row[ahead]);
                    [xx, -xx - zz, zz, xz]
                }
                _ => inlet,
            };
            let (into_xx, rest) = into[from..][..ROWS * n].split_at_mut(n);
            let (into_zz, into_xz) = rest.split_at_mut(n);
            let into = [into_xx, into_zz, into_xz].map(|row| &mut row[live.start..][..=first]);
            let strain = &mut self.strain[layer * n + live.start..][..=first];
            if self.law.follow(layer, inlet, rows.map(|row| &row[..=first]), into, strain) {
                for (i, _) in strain.iter().enumerate().filter(|(_, dp)| **dp > 0.0) {
                    let cell = layer * n + live.start + i;
                    if !std::mem::replace(&mut self.has_flowed[cell], true) {
                        self.flowed.push(cell);
                    }
                }
            }
        }
    }

    /// The first column from the front at which the path of a layer leaves the elastic domain with
    /// which it enters.
    fn leaves_elastic_domain(
        &self,
        layer: usize,
        [inlet_xx, _, inlet_zz, inlet_xz]: [f64; 4],
        [row_xx, row_zz, row_xz]: Rows<'_>,
    ) -> Option<usize> {
        let limit = self.law.yield_stress(layer).powi(2);
        let [x, _, z, t] = self.law.backstress(layer);
        let is_outside = |xx: f64, zz: f64, xz: f64| {
            let (xx, zz, xz) = (xx - x, zz - z, xz - t);
            3.0 * (xx * xx + zz * zz + xx * zz + xz * xz) > limit
        };
        if is_outside(inlet_xx, inlet_zz, inlet_xz) {
            return row_xx.len().checked_sub(1);
        }
        let mut columns = row_xx.iter().zip(row_zz).zip(row_xz);
        columns.rposition(|((xx, zz), xz)| is_outside(*xx, *zz, *xz))
    }

    /// Residual stress σxx, σyy of a layer at the front, σ0 included \[MPa\].
    pub fn residual(&self, layer: usize) -> [f64; 2] {
        let [xx, yy] = self.uniform_stress(self.inlet[layer]);
        let [initial_xx, initial_yy] = self.initial[layer];
        [initial_xx + xx, initial_yy + yy]
    }

    /// Its deviator `xx yy zz xz`.
    fn inlet_deviator(&self, layer: usize) -> [f64; 4] {
        let [xx, yy] = self.residual(layer);
        let mean = (xx + yy) / 3.0;
        [xx - mean, yy - mean, -mean, 0.0]
    }

    /// Accepts an increment that the law has just answered with. The state at the back enters the
    /// next pass.
    pub fn accept(&mut self, increment: &[f64]) -> Outlet {
        let n = self.space.grid().n;
        let stored = self.stored_energy();
        let work = self.work_of_pass();
        let compliance = 0.5 / self.space.elastic().shear();
        let mut change = vec![[0.0; 5]; self.inlet.len()];
        for (layer, rows) in increment.chunks_exact(ROWS * n).enumerate() {
            let mut sums = [0.0; ROWS];
            for (sum, row) in sums.iter_mut().zip(rows.chunks_exact(n)) {
                *sum = row.iter().sum();
            }
            for (inlet, sum) in self.inlet[layer].iter_mut().zip(sums) {
                *inlet += sum;
            }
            let [xx, zz, xz] = sums.map(|sum| compliance * sum);
            change[layer] = [xx, -xx - zz, 0.0, xz, 0.0];
        }
        let strain = self.inlet.iter().map(|inlet| {
            let [xx, zz, xz] = inlet.map(|tau| compliance * tau);
            [xx, -xx - zz, 0.0, xz, 0.0]
        });
        let strain = strain.collect();
        let accumulated = self.strain.chunks_exact(n).map(|row| row.iter().sum()).collect();
        self.law.accept();
        self.most_flow = self.most_flow.max(self.flow_of_pass().whole);
        let layers = self.space.layers();
        let depths = (0..layers.len()).map(|layer| layers.middle(layer)).collect();
        let forward =
            change.iter().enumerate().map(|(l, of)| -2.0 * of[3] * layers.thickness(l)).sum();
        Outlet {
            depths,
            faces: layers.faces().to_vec(),
            across: vec![0.0],
            change,
            strain,
            accumulated,
            forward,
            groove_depth: self.groove_depth(),
            pile_up: 0.0,
            residual: (0..layers.len())
                .map(|layer| self.residual(layer))
                .map(|[xx, yy]| [xx, yy, 0.0, 0.0, 0.0, 0.0])
                .collect(),
            plastic_work: work,
            stored_energy: self.stored_energy() - stored,
            excess: self.excess(),
        }
    }

    /// By how much the residual stress at the front exceeds the yield stress, over the largest
    /// yield stress.
    fn excess(&self) -> f64 {
        let of_layer = |layer: usize| {
            let [s_xx, _, s_zz, s_xz] = self.inlet_deviator(layer);
            let [x, _, z, t] = self.law.backstress(layer);
            let (xx, zz, xz) = (s_xx - x, s_zz - z, s_xz - t);
            (3.0 * (xx * xx + zz * zz + xx * zz + xz * xz)).sqrt()
        };
        excess((0..self.inlet.len()).map(|l| [of_layer(l), self.law.yield_stress(l)]))
    }

    /// Plastic flow of the last stream, and the part of it far from the load.
    pub(super) fn flow_of_pass(&self) -> FlowOfPass {
        let layers = self.space.layers();
        let n = self.space.grid().n;
        FlowOfPass::of(&self.strain, n, |layer| layers.thickness(layer))
    }

    /// The largest flow of the passes that are accepted.
    pub(super) const fn most_flow(&self) -> f64 {
        self.most_flow
    }

    /// `∫σ:dε_p` of the last stream, per length of travel \[N\].
    fn work_of_pass(&self) -> f64 {
        let layers = self.space.layers();
        (0..layers.len()).map(|l| layers.thickness(l) * self.law.work_of_pass(l)).sum()
    }

    /// Returns the depth of the groove of the track, `(1-λ') ∫ε_zz dz` \[mm\].
    pub fn groove_depth(&self) -> f64 {
        let (elastic, layers) = (self.space.elastic(), self.space.layers());
        let local = elastic.poisson() / (1.0 - elastic.poisson());
        let sum: f64 =
            self.inlet.iter().enumerate().map(|(l, [_, zz, _])| layers.thickness(l) * zz).sum();
        // u_p is positive into the body: compression in z makes ε_zz negative and sinks it.
        -(1.0 - local) * 0.5 / elastic.shear() * sum
    }

    /// Elastic energy of the residual stress, per length of track \[N\].
    pub fn stored_energy(&self) -> f64 {
        let (elastic, layers) = (self.space.elastic(), self.space.layers());
        let (young, nu) = (elastic.young(), elastic.poisson());
        let of_layer = |layer: usize| {
            let [xx, yy] = self.residual(layer);
            layers.thickness(layer) * (xx * xx + yy * yy - 2.0 * nu * xx * yy) * 0.5 / young
        };
        (0..layers.len()).map(of_layer).sum()
    }

    /// Work of the traction μ p on the plastic displacement of the surface, per length of travel
    /// \[N\]: `-Σ μ p ∂u_px/∂x h`, with the increment of the last [`open`](Self::open).
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn work_of_traction(
        &mut self,
        pressure: &[f64],
        stop: &mut Stop<'_>,
    ) -> Result<f64, Stopped> {
        if self.friction == 0.0 || !self.strained.contains(&true) {
            return Ok(0.0);
        }
        let mut along = vec![0.0; pressure.len()];
        self.space.tangential_opening(
            &self.gained,
            &self.strained,
            &mut self.work,
            &mut along,
            stop,
        )?;
        Ok(-self.friction * super::figures::work_along(pressure, &along))
    }

    /// Equivalent plastic strain that the cells have added in the last stream: layer, column.
    pub fn strains(&self) -> &[f64] {
        &self.strain
    }

    /// Number of cells that may change.
    pub const fn n_flowed(&self) -> usize {
        self.flowed.len()
    }

    /// Appends the cells that have flowed, in the order in which their flow began, to one vector
    /// whose square is `Σ h_l a:a` \[MPa √mm\]. A vector packed earlier is the beginning of one
    /// packed later.
    pub fn pack(&self, increment: &[f64], into: &mut Vec<f64>) {
        let n = self.space.grid().n;
        for cell in &self.flowed {
            let (layer, from) = (cell / n, cell / n * ROWS * n + cell % n);
            let weight = self.space.layers().thickness(layer).sqrt();
            let [xx, zz, xz] = std::array::from_fn(|k| weight * increment[from + k * n]);
            into.extend([ISOMETRIC[0] * (xx + zz), ISOMETRIC[1] * (xx - zz), ISOMETRIC[2] * xz]);
        }
    }

    /// Writes the cells back to where [`pack`](Self::pack) took them from. Returns what follows.
    pub fn unpack<'a>(&self, packed: &'a [f64], increment: &mut [f64]) -> &'a [f64] {
        let n = self.space.grid().n;
        let (mine, rest) = packed.split_at((ROWS * self.flowed.len()).min(packed.len()));
        for (cell, values) in self.flowed.iter().zip(mine.chunks_exact(ROWS)) {
            let (layer, from) = (cell / n, cell / n * ROWS * n + cell % n);
            let weight = self.space.layers().thickness(layer).sqrt().recip();
            let sum = weight * values[0] / ISOMETRIC[0];
            let difference = weight * values[1] / ISOMETRIC[1];
            increment[from] = 0.5 * (sum + difference);
            increment[from + n] = 0.5 * (sum - difference);
            increment[from + 2 * n] = weight * values[2] / ISOMETRIC[2];
        }
        rest
    }
}

/// √(3/2), √(1/2), √2: `a:a = 3/2 (xx+zz)² + 1/2 (xx-zz)² + 2 xz²` of a deviator.
pub(super) const ISOMETRIC: [f64; 3] =
    [1.224_744_871_391_589, std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::SQRT_2];

impl RollingBody {
    /// Why the body cannot bear the traction of a peak pressure \[MPa\], if it cannot. A pressure
    /// is known before the first pass as that of Hertz.
    ///
    /// # Errors
    /// [`TrackFault::Traction`].
    pub fn bears(&self, peak_pressure: f64) -> Result<(), TrackFault> {
        let traction = self.friction().abs() * peak_pressure;
        let strength = self.law().largest_stress(0) / 3f64.sqrt();
        if traction > strength {
            return Err(TrackFault::Traction { traction, strength });
        }
        Ok(())
    }

    /// Why the plastic zone of the last stream is cut off, if it is.
    ///
    /// # Errors
    /// [`TrackFault::Depth`], [`TrackFault::Far`].
    pub fn holds(&self) -> Result<(), TrackFault> {
        self.flow_of_pass().holds(self.most_flow(), self.space().grid().length())?;
        let of_layer = |row: &[f64]| row.iter().sum::<f64>();
        let rows = self.strains().chunks_exact(self.space().grid().n_columns());
        let largest = rows.clone().map(of_layer).fold(0.0, f64::max);
        if rows.last().map_or(0.0, of_layer) > NOTHING * largest {
            let depth = self.space().layers().faces().last().copied().unwrap_or(0.0);
            return Err(TrackFault::Depth { depth });
        }
        Ok(())
    }
}
