//! Loads one after the other: independent ones, and those of a trial in the search of a force.

use super::observer::{Interrupt, SolveStatus};
use super::run::Run;
use super::steps::{Step, StepReceiver};
use crate::{Error, Interrupted, Limit};
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

/// A figure that is sought.
pub struct Wanted<'a, F, E> {
    /// Whether the contact has it after the force is taken away.
    pub is_permanent: bool,
    /// The figure at the end of the loads over its wanted value.
    pub ratio: &'a dyn Fn(&Step<F>) -> f64,
    /// Why the force of an error is too large to be solved; other errors come back.
    pub too_large: &'a dyn Fn(E) -> Result<Limit, E>,
}

impl<F, E: From<Error>> Wanted<'_, F, E> {
    /// Solves under one force by `solve`, which takes loads in order.
    ///
    /// # Errors
    /// Errors of `solve` that do not come from too large a force.
    pub fn trial(
        &self,
        force: f64,
        solve: impl FnOnce(&[ContactLoad], &mut Vec<Step<F>>) -> Result<Option<Interrupt>, E>,
    ) -> Result<Tried<F>, E> {
        let loads = [ContactLoad::Force(force), ContactLoad::Force(0.0)];
        let mut steps = Vec::new();
        let interrupt = match solve(&loads[..=usize::from(self.is_permanent)], &mut steps) {
            Ok(interrupt) => interrupt,
            Err(error) => return (self.too_large)(error).map(Err),
        };
        let interrupt = interrupt.or_else(|| steps.iter().find_map(|s| s.status.interrupt()));
        if let Some(interrupt) = interrupt {
            return Err(Error::Interrupted(interrupt).into());
        }
        if steps.iter().any(|step| step.checks.has_collapsed) {
            return Ok(Err("a body collapses: its plastic strain is above 100 %".into()));
        }
        let ratio = steps.last().map_or(0.0, |step| (self.ratio)(step));
        Ok(Ok(Trial { ratio, steps }))
    }
}

/// The result under one force.
pub struct Trial<F> {
    /// The figure over its wanted value.
    pub ratio: f64,
    /// Steps of the force and of the loads after it.
    pub steps: Vec<Step<F>>,
}

/// A trial, or the reason why its force is too large to be solved.
pub type Tried<F> = Result<Trial<F>, Limit>;

impl<F> Trial<F> {
    /// Whether all steps have converged.
    pub fn is_converged(&self) -> bool {
        self.steps.iter().all(|step| step.status == SolveStatus::Converged)
    }

    pub(super) fn why_not_converged(&self) -> &'static str {
        if self.steps.iter().any(|step| step.checks.reaches_edge) {
            "the contact is wider than what can be meshed"
        } else {
            "the iteration does not converge"
        }
    }

    pub(super) fn deviation(&self) -> f64 {
        (self.ratio - 1.0).abs()
    }
}
