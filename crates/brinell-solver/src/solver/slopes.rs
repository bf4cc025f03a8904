//! The contact stiffness of bodies that yield, from two loads on a small mesh.

use crate::solver::method::Interrupted;
use crate::solver::method::observer::{Interrupt, SolveStatus};
use crate::solver::method::slope::Reached;
use crate::solver::method::steps::Step;

/// Relative error of the slope; in plane stress, where plastic flow gathers in bands.
pub(crate) const SLOPE_ERROR: f64 = 0.02;
pub(crate) const SLOPE_ERROR_IN_PLANE_STRESS: f64 = 0.05;

/// What the last of the loads on a small mesh reaches; `None` where one of them has no answer.
pub(super) fn reached<F, E: Interrupted>(
    interrupt: &Result<Option<Interrupt>, E>,
    steps: &[Step<F>],
) -> Result<Option<Reached>, Interrupt> {
    let interrupt = match interrupt {
        Ok(interrupt) => *interrupt,
        Err(error) => return error.interrupt().map_or(Ok(None), Err),
    };
    let stopped = || steps.iter().find_map(|step| step.status.interrupt());
    interrupt.or_else(stopped).map_or(Ok(()), Err)?;
    let is_converged = steps.iter().all(|step| step.status == SolveStatus::Converged);
    let last = steps.last().filter(|_| is_converged);
    Ok(last.map(|step| [step.figures.force, step.figures.approach]))
}
