//! Independent loads, one after the other.

use super::observer::{Interrupt, Observer};
use super::run::Run;
use super::steps::{Step, StepReceiver};
use crate::Interrupted;
use brinell_contact::ContactLoad;

/// Solves independent loads in order; `solve` takes a load and the next one.
///
/// If the observer stops the solve, finished steps are kept, and the returned interrupt is the
/// reason for the missing ones.
///
/// # Errors
/// Errors of `solve`, also the interrupt before the first step is finished.
pub fn each_load<F, E: Interrupted>(
    loads: &[ContactLoad],
    receiver: &mut dyn StepReceiver<F>,
    run: &mut Run<'_>,
    mut solve: impl FnMut(ContactLoad, Option<ContactLoad>, &mut Run<'_>) -> Result<Step<F>, E>,
) -> Result<Option<Interrupt>, E> {
    for (k, &load) in loads.iter().enumerate() {
        match solve(load, loads.get(k + 1).copied(), run) {
            Ok(step) => {
                let status = step.status;
                receiver.step(step, run.observer);
                if status.is_stopped() {
                    break;
                }
            }
            // Finished steps are kept.
            Err(error) if k > 0 => return error.interrupt().ok_or(error).map(Some),
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// Solves loads that are each applied to bodies at rest, where the bodies have a memory.
///
/// Loads that rise are one history: each is on the way from rest to the next one. It ends where a
/// load falls, where a body collapses, and before a load whose system would be too coarse for the
/// first load: `serves` takes that one and the larger one. The next load begins at rest again.
/// `history` solves one history and hands its steps over.
///
/// # Errors
/// Errors of `history`, also the interrupt before the first step is finished.
pub fn each_from_rest<F, E: Interrupted>(
    loads: &[ContactLoad],
    receiver: &mut dyn StepReceiver<F>,
    run: &mut Run<'_>,
    serves: impl Fn(ContactLoad, ContactLoad) -> bool,
    mut history: impl FnMut(
        Stretch<'_>,
        &mut Run<'_>,
        &mut dyn StepReceiver<F>,
    ) -> Result<Option<Interrupt>, E>,
) -> Result<Option<Interrupt>, E> {
    let mut before = 0;
    while let [first, ..] = loads[before..] {
        let pairs = loads[before..].windows(2);
        let rises = |pair: &&[ContactLoad]| {
            pair[0].magnitude() <= pair[1].magnitude() && serves(first, pair[1])
        };
        let count = 1 + pairs.take_while(rises).count();
        let stretch = Stretch { loads: &loads[before..before + count], before, all: loads.len() };
        let mut steps = StepsFromRest { receiver: &mut *receiver, done: 0, skipped: 0 };
        let end = history(stretch, run, &mut steps);
        let done = steps.done;
        match end {
            Ok(None) => before += done.max(1),
            Ok(Some(interrupt)) => return Ok(Some(interrupt)),
            // Finished steps are kept.
            Err(error) if before + done > 0 => return error.interrupt().ok_or(error).map(Some),
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// Loads of one history among all loads of a solve.
#[derive(Debug, Clone, Copy)]
pub struct Stretch<'a> {
    /// The loads in order.
    pub loads: &'a [ContactLoad],
    /// Number of loads before them.
    pub before: usize,
    /// Number of all loads.
    pub all: usize,
}

impl<'a> Stretch<'a> {
    /// All loads of a solve.
    pub fn whole(loads: &'a [ContactLoad]) -> Self {
        Self { loads, before: 0, all: loads.len() }
    }
}

/// Hands over the steps of loads from rest. Where a history begins again on a wider system, steps
/// that were handed over stay: each has the answer to its load.
struct StepsFromRest<'a, F> {
    receiver: &'a mut dyn StepReceiver<F>,
    /// Steps that were handed over.
    done: usize,
    /// Steps to come that were handed over before.
    skipped: usize,
}

impl<F> StepReceiver<F> for StepsFromRest<'_, F> {
    fn step(&mut self, step: Step<F>, observer: &mut dyn Observer) {
        if self.skipped > 0 {
            self.skipped -= 1;
            return;
        }
        self.receiver.step(step, observer);
        self.done += 1;
    }

    fn begin_anew(&mut self) {
        self.skipped = self.done;
    }
}
