//! Hands the steps of a history to the receiver.
//!
//! The observer may stop a job at any time. Loads that are finished at the requested density keep
//! their answers. The other loads get preliminary steps from the coarse system, without stresses
//! and error bars.

use super::figures::{Figures, Values};
use super::observer::{Interrupt, Observer};
use super::run::Run;
use super::steps::{Step, StepReceiver};
use super::strays::Shown;
use crate::Error;

/// What the coarse system has found, from which the errors of each step are estimated.
pub(super) struct Estimates<'a, F> {
    pub coarse: &'a [Option<Figures>],
    pub increments: &'a [Option<Values>],
    pub steps: &'a [Step<F>],
}

/// Takes the end of each load of a history on one system.
pub(super) enum HistorySteps<'a, F> {
    /// Steps of the coarse system by the number of their load; a step replaces its predecessor
    /// with larger increments.
    Preliminary(&'a mut Vec<Step<F>>),
    /// Steps of the requested density.
    Final {
        estimates: Estimates<'a, F>,
        receiver: &'a mut dyn StepReceiver<F>,
        /// Errors that the loads so far have shown.
        shown: Box<Shown>,
        /// Number of steps received.
        done: usize,
    },
}

impl<'a, F> HistorySteps<'a, F> {
    /// Makes the receiver for steps of the requested density.
    pub fn new(estimates: Estimates<'a, F>, receiver: &'a mut dyn StepReceiver<F>) -> Self {
        Self::Final { estimates, receiver, shown: Box::default(), done: 0 }
    }

    /// Returns the number of steps of the requested density that were handed over.
    pub fn done(&self) -> usize {
        match self {
            Self::Preliminary(_) => 0,
            Self::Final { done, .. } => *done,
        }
    }

    pub fn are_final(&self) -> bool {
        matches!(self, Self::Final { .. })
    }

    /// Takes the end of a load.
    pub fn take(&mut self, number: usize, mut step: Step<F>, observer: &mut dyn Observer) {
        match self {
            Self::Preliminary(steps) => {
                step.is_preliminary = true;
                if let Some(before) = steps.get_mut(number) {
                    *before = step;
                } else {
                    steps.push(step);
                }
            }
            Self::Final { estimates, receiver, shown, done } => {
                step.coarse = estimates.coarse.get(number).copied().flatten();
                step.increment_error = estimates.increments.get(number).copied().flatten();
                if let Some(coarse) = estimates.steps.get(number) {
                    step.path.coarse_increments.clone_from(&coarse.path.increments);
                }
                step.path.shown = shown.by(&step);
                receiver.step(step, observer);
                *done += 1;
            }
        }
    }

    /// Drops the steps from this load on, under which a body has collapsed.
    pub fn end_before(&mut self, number: usize) {
        if let Self::Preliminary(steps) = self {
            steps.truncate(number);
        }
    }

    /// Drops all steps, because the history begins again on a wider system.
    pub fn begin_anew(&mut self) {
        if let Self::Final { receiver, shown, done, .. } = self {
            receiver.begin_anew();
            (**shown, *done) = (Shown::default(), 0);
        }
    }
}

/// Hands over the preliminary steps of a stopped job, from load `done` on.
///
/// # Errors
/// [`Error::Interrupted`] where there is no step at all.
pub(super) fn keep_preliminary<F>(
    steps: Vec<Step<F>>,
    done: usize,
    interrupt: Interrupt,
    receiver: &mut dyn StepReceiver<F>,
    run: &mut Run<'_>,
) -> Result<Interrupt, Error> {
    if steps.len().max(done) == 0 {
        return Err(Error::Interrupted(interrupt));
    }
    for mut step in steps.into_iter().skip(done) {
        step.status = interrupt.into();
        receiver.step(step, run.observer);
    }
    Ok(interrupt)
}
