//! Where the steps of a history go.
//!
//! A job may be stopped at any time. Loads that are finished at the density that was asked for are
//! answers, whatever comes of the rest. For the others there is what the coarse system has found,
//! which is less: no stresses, no error bars.

use super::observer::{Interrupt, Observer};
use super::run::Run;
use super::steps::{CoarseFigures, Step, StepReceiver};
use crate::Error;

/// What the coarse system says of the errors of each step.
pub(super) struct Estimates<'a> {
    pub coarse: &'a [Option<CoarseFigures>],
    pub increments: &'a [Option<CoarseFigures>],
}

/// Takes the end of each load of a history on one system.
pub(super) enum HistorySteps<'a, S> {
    /// Of the coarse system, by their number; each takes the place of the one that larger
    /// increments have found.
    Preliminary(&'a mut Vec<S>),
    /// Of the density that was asked for.
    Final {
        estimates: Estimates<'a>,
        receiver: &'a mut dyn StepReceiver<S>,
        /// How many it has received.
        done: usize,
    },
}

impl<'a, S: Step> HistorySteps<'a, S> {
    /// Of the density that was asked for.
    pub fn new(estimates: Estimates<'a>, receiver: &'a mut dyn StepReceiver<S>) -> Self {
        Self::Final { estimates, receiver, done: 0 }
    }

    /// How many steps of the density that was asked for have been handed over.
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
    pub fn take(&mut self, number: usize, mut step: S, observer: &mut dyn Observer) {
        match self {
            Self::Preliminary(steps) => {
                step.make_preliminary();
                if let Some(before) = steps.get_mut(number) {
                    *before = step;
                } else {
                    steps.push(step);
                }
            }
            Self::Final { estimates, receiver, done } => {
                let of =
                    |figures: &[Option<CoarseFigures>]| figures.get(number).copied().flatten();
                step.estimate(of(estimates.coarse), of(estimates.increments));
                receiver.step(step, observer);
                *done += 1;
            }
        }
    }

    /// A body has collapsed under the load of this number: there are no answers from there on.
    pub fn end_before(&mut self, number: usize) {
        if let Self::Preliminary(steps) = self {
            steps.truncate(number);
        }
    }

    /// The history begins anew on a wider system.
    pub fn begin_anew(&mut self) {
        if let Self::Final { receiver, done, .. } = self {
            receiver.begin_anew();
            *done = 0;
        }
    }
}

/// Of a job that is stopped: hands over what the coarse system has found of the loads from the
/// number `done` on.
///
/// # Errors
/// [`Error::Interrupted`] where there is nothing to keep at all.
pub(super) fn keep_preliminary<S: Step>(
    steps: Vec<S>,
    done: usize,
    interrupt: Interrupt,
    receiver: &mut dyn StepReceiver<S>,
    run: &mut Run<'_>,
) -> Result<Interrupt, Error> {
    if steps.len().max(done) == 0 {
        return Err(Error::Interrupted(interrupt));
    }
    for mut step in steps.into_iter().skip(done) {
        step.set_status(interrupt.into());
        receiver.step(step, run.observer);
    }
    Ok(interrupt)
}
