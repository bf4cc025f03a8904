//! The steps of a solution: one for each load.

use super::couplings::iteration::Outcome;
use super::figures::Figures;
use super::increments::LastIncrement;
use super::observer::{Observer, SolveStatus};
use brinell_contact::ContactLoad;

/// One increment of a load history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IncrementRecord {
    /// Contact force, both sides of the axis.
    pub force: f64,
    /// Approach \[mm\].
    pub approach: f64,
    /// Largest contact pressure \[MPa\].
    pub peak_pressure: f64,
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
        let Figures { force, approach, peak_pressure, half_width, .. } = figures;
        Self {
            force,
            approach,
            peak_pressure,
            half_width,
            iterations: outcome.history.len(),
            plastic_points: outcome.history.last().map_or(0, |record| record.plastic_points),
            status: outcome.status,
        }
    }
}

/// The end of a load of a history.
pub struct LoadEnd {
    /// The requested load. The applied load is smaller where a body has collapsed.
    pub load: ContactLoad,
    /// The increment that reached it.
    pub last_increment: LastIncrement,
    /// All increments of the load.
    pub increments: Vec<IncrementRecord>,
    /// Largest approach and half-width of the history so far \[mm\].
    pub reached: [f64; 2],
}

/// The result of an engine for one load.
pub trait Step {
    /// Returns the status.
    fn status(&self) -> SolveStatus;
    /// Sets the status.
    fn set_status(&mut self, status: SolveStatus);
    /// Whether the contact reaches the edge of the widest system.
    fn reaches_edge(&self) -> bool;
    /// Whether strains have outgrown the theory of small strains.
    fn has_collapsed(&self) -> bool;
    /// Stores the increments of a history that led to this load.
    fn end_load(&mut self, end: LoadEnd);
    /// Stores the figures of the coarse history, from which the errors are estimated.
    fn estimate(&mut self, coarse: Option<Figures>, increments: Option<Figures>);
    /// Marks the step as a preliminary one of the coarse history.
    fn make_preliminary(&mut self);
    /// Marks the step as one that misses the wanted value of its figure under every force. `ratio`
    /// is the figure over that value.
    fn miss(&mut self, ratio: f64);
}

/// Receives each step of a solution as soon as it is finished.
pub trait StepReceiver<S> {
    /// Receives the next step.
    fn step(&mut self, step: S, observer: &mut dyn Observer);

    /// Discards the steps so far, because a history begins again: its contact has outgrown the
    /// system. Independent loads never begin again.
    fn begin_anew(&mut self);
}

/// Collects the steps.
impl<S> StepReceiver<S> for Vec<S> {
    fn step(&mut self, step: S, _: &mut dyn Observer) {
        self.push(step);
    }

    fn begin_anew(&mut self) {
        self.clear();
    }
}
