//! The steps of a solution: one for each load.

use super::couplings::iteration::Outcome;
use super::figures::{FigureSet, Figures, Values};
use super::increments::LastIncrement;
use super::observer::{IterationRecord, Observer, SolveStatus};
use brinell_contact::{ContactLoad, KktReport};

/// One increment of a load history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IncrementRecord {
    /// Contact force, both sides of the axis.
    pub force: f64,
    /// Approach \[mm\].
    pub approach: f64,
    /// Largest contact pressure \[MPa\].
    pub peak_pressure: f64,
    /// Contact pressure in the middle of the contact, where it is measured \[MPa\].
    pub middle_pressure: Option<f64>,
    /// Half-width \[mm\].
    pub half_width: f64,
    /// Iterations made.
    pub iterations: usize,
    /// Points that have yielded so far.
    pub plastic_points: usize,
    /// How the iteration ended.
    pub status: SolveStatus,
}

impl IncrementRecord {
    /// The record of an increment.
    pub fn of(figures: Figures, outcome: &Outcome) -> Self {
        let Figures { force, approach, peak_pressure, middle_pressure, half_width, .. } = figures;
        Self {
            force,
            approach,
            peak_pressure,
            middle_pressure,
            half_width,
            iterations: outcome.history.len(),
            plastic_points: outcome.history.last().map_or(0, |record| record.plastic_points),
            status: outcome.status,
        }
    }
}

/// Where the work of the force has gone \[N mm/mm, or N mm\].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Energy {
    /// Elastic energy of both bodies.
    pub elastic: f64,
    /// `∫σ:dε_p`.
    pub plastic_work: f64,
    /// The part of it that the backstress stores.
    pub backstress: f64,
}

impl Energy {
    /// Returns the work of the contact force, stored and dissipated energy together.
    pub fn work(&self) -> f64 {
        self.elastic + self.plastic_work
    }

    /// Returns the dissipated energy: plastic work less the energy stored by backstress.
    pub fn dissipated(&self) -> f64 {
        self.plastic_work - self.backstress
    }
}

/// The result for one load: what the bodies of every engine have, and the fields `F` of one engine.
///
/// Lengths in mm, stresses in MPa, forces in N/mm or N.
#[derive(Debug, Clone)]
pub struct Step<F> {
    /// How the iteration ended, the final check included.
    pub status: SolveStatus,
    /// The prescribed force or approach.
    pub load: ContactLoad,
    /// The scalar figures of contact and bodies.
    pub figures: Figures,
    /// The same figures on a system of half the density, for error bars; `None` without one.
    pub coarse: Option<Figures>,
    /// Relative changes of the figures by half as many increments; histories only.
    pub increment_error: Option<Values>,
    /// What the final check has found.
    pub checks: Checks,
    /// Records of all iterations.
    pub history: Vec<IterationRecord>,
    /// How a history came to this load.
    pub path: Path,
    /// How the force was found.
    pub search: Search,
    /// Slope dP/dα of the load-approach curve at this load; `None` where it is not known.
    pub contact_stiffness: Option<f64>,
    /// Times that the system was enlarged.
    pub enlargements: usize,
    /// Whether it is a step of the coarse history, which was stopped before the fine one came to
    /// this load.
    pub is_preliminary: bool,
    /// The fields of the engine.
    pub field: F,
}

/// Residuals and limits of a step.
#[derive(Debug, Clone, Copy, Default)]
pub struct Checks {
    /// The contact conditions, computed afresh.
    pub contact: KktReport,
    /// Residual of equilibrium or of the plastic law over the contact force, computed afresh.
    pub residual: f64,
    /// Whether contact or plastic region reach the edge of the widest system.
    pub reaches_edge: bool,
    /// Whether strains have outgrown the theory of small strains.
    pub has_collapsed: bool,
}

/// How a history came to a load. The default is that of a load without a history.
#[derive(Debug, Clone, Default)]
pub struct Path {
    /// The increments of this load.
    pub increments: Vec<IncrementRecord>,
    /// Those of the coarse system.
    pub coarse_increments: Vec<IncrementRecord>,
    /// The last of the increments.
    pub last_increment: LastIncrement,
    /// Largest approach and half-width of the history so far \[mm\].
    pub reached: [f64; 2],
    /// Least relative errors of the figures: the strays of this load and, at the requested density,
    /// the differences to the coarse system that the loads so far have shown.
    pub shown: Values,
    /// Whether a point flowed in the last increment.
    pub flows: bool,
    /// Energies, of bodies with a memory.
    pub energy: Option<Energy>,
    /// Figures of the bodies that earlier loads of the history have left unknown.
    pub unknown_before: FigureSet,
}

/// How a force was found. The default is that of a load that was given.
#[derive(Debug, Clone, Copy, Default)]
pub struct Search {
    /// The figure over its wanted value, where no force gave it.
    pub missed: Option<f64>,
    /// Relative error of the force.
    pub force_error: Option<f64>,
    /// Number of systems on which the force was sought.
    pub systems: usize,
}

impl<F> Step<F> {
    /// Marks the step as one that misses the wanted value of its figure under every force. `ratio`
    /// is the figure over that value.
    pub fn miss(&mut self, ratio: f64) {
        (self.status, self.search.missed) = (SolveStatus::NotConverged, Some(ratio));
    }
}

/// Receives each step of a solution as soon as it is finished.
pub trait StepReceiver<F> {
    /// Receives the next step.
    fn step(&mut self, step: Step<F>, observer: &mut dyn Observer);

    /// Discards the steps so far, because a history begins again: its contact has outgrown the
    /// system. Independent loads never begin again.
    fn begin_anew(&mut self);
}

/// Collects the steps.
impl<F> StepReceiver<F> for Vec<Step<F>> {
    fn step(&mut self, step: Step<F>, _: &mut dyn Observer) {
        self.push(step);
    }

    fn begin_anew(&mut self) {
        self.clear();
    }
}
