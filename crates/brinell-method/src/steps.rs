//! What a solve hands over, load by load.

use super::couplings::iteration::Outcome;
use super::increments::LastIncrement;
use super::observer::{Interrupt, Observer, SolveStatus};
use super::run::Run;
use crate::Interrupted;
use brinell_contact::ContactLoad;

/// Headline figures of a contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CoarseFigures {
    /// Largest contact pressure \[MPa\].
    pub peak_pressure: f64,
    /// Half-width \[mm\].
    pub half_width: f64,
    /// Approach \[mm\].
    pub approach: f64,
    /// Contact force of both sides of the axis \[N/mm\].
    pub force: f64,
}

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
    /// How its iteration ended.
    pub status: SolveStatus,
}

impl IncrementRecord {
    /// The record of an increment.
    pub fn of(figures: CoarseFigures, outcome: &Outcome) -> Self {
        let CoarseFigures { force, approach, peak_pressure, half_width } = figures;
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
    /// What was asked for. Less of it was applied where a body has collapsed.
    pub load: ContactLoad,
    /// The increment that reached it.
    pub last_increment: LastIncrement,
    /// All increments of the load.
    pub increments: Vec<IncrementRecord>,
    /// Largest approach and half-width of the history so far \[mm\].
    pub reached: [f64; 2],
}

/// What an engine reports of a load.
pub trait Step {
    /// How it ended.
    fn status(&self) -> SolveStatus;
    /// Changes how it ended.
    fn set_status(&mut self, status: SolveStatus);
    /// Whether the contact is wider than what can be solved.
    fn reaches_edge(&self) -> bool;
    /// Takes over how a history came to this load.
    fn end_load(&mut self, end: LoadEnd);
    /// Takes over what the coarse history says of the errors.
    fn estimate(&mut self, coarse: Option<CoarseFigures>, increments: Option<CoarseFigures>);
    /// Marks it as what the coarse history has found.
    fn make_preliminary(&mut self);
    /// Marks it as one whose figure, over its wanted value, no force brings to 1.
    fn miss(&mut self, ratio: f64);
}

/// Takes the steps of a solution, each as soon as it is finished.
pub trait StepReceiver<S> {
    /// Takes the next step.
    fn step(&mut self, step: S, observer: &mut dyn Observer);

    /// Gives up the steps so far: a history begins anew, because its contact has grown beyond the system. Loads that do not
    /// depend on those before never do.
    fn begin_anew(&mut self);
}

/// Keeps them.
impl<S> StepReceiver<S> for Vec<S> {
    fn step(&mut self, step: S, _: &mut dyn Observer) {
        self.push(step);
    }

    fn begin_anew(&mut self) {
        self.clear();
    }
}

/// Solves loads that do not depend on each other, in order; `solve` takes a load and the one after it.
///
/// Where the observer stops it, the steps that are done are kept, and the interrupt says why the others are missing.
///
/// # Errors
/// Those of `solve`, which may be that it was stopped before the first step is done.
pub fn each_load<S: Step, E: Interrupted>(
    loads: &[ContactLoad],
    receiver: &mut dyn StepReceiver<S>,
    run: &mut Run<'_>,
    mut solve: impl FnMut(ContactLoad, Option<ContactLoad>, &mut Run<'_>) -> Result<S, E>,
) -> Result<Option<Interrupt>, E> {
    for (k, &load) in loads.iter().enumerate() {
        match solve(load, loads.get(k + 1).copied(), run) {
            Ok(step) => {
                let status = step.status();
                receiver.step(step, run.observer);
                if status.is_stopped() {
                    break;
                }
            }
            // The steps that are done are worth keeping.
            Err(error) if k > 0 => return error.interrupt().ok_or(error).map(Some),
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}
