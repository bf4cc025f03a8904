//! One attempt at one job, on a solver thread.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use tokio::sync::mpsc::Sender;

use super::observer::JobObserver;
use crate::jobs::{EncodeError, JobFailure, JobId, JobSolver, Outcome, StepResult, encode};
use brinell_solver::job::{Job, JobError};
use brinell_solver::report::{RunError, StepReport};

/// Solves a job and catches its errors and panics.
///
/// Each finished step goes into the channel `steps`. The channel is short: the solve waits until
/// the supervisor has written the steps, so that memory does not grow with their number.
pub(super) fn attempt(
    id: JobId,
    solver: &dyn JobSolver,
    request: &[u8],
    observer: &mut JobObserver,
    steps: &Sender<StepResult>,
) -> Outcome {
    // After a panic, all data that the closure touched are dropped except the plain fields of the
    // observer.
    let solved = catch_unwind(AssertUnwindSafe(|| solve(solver, request, observer, steps)));
    solved.unwrap_or_else(|panic| {
        tracing::error!(job = %id, panic = panic_message(panic.as_ref()), "the solver panicked");
        Outcome::Failed(JobFailure::internal(
            "the solver failed unexpectedly; the fault has been logged",
        ))
    })
}

fn solve(
    solver: &dyn JobSolver,
    request: &[u8],
    observer: &mut JobObserver,
    steps: &Sender<StepResult>,
) -> Outcome {
    if request.is_empty() {
        return Outcome::Failed(JobFailure::internal("what is stored of this job is damaged"));
    }
    let job = match Job::from_json(request) {
        Ok(job) => job,
        Err(JobError::Fields(errors)) => return Outcome::Failed(JobFailure::input(errors)),
        Err(error @ JobError::Syntax { .. }) => {
            return Outcome::Failed(JobFailure::internal(error.to_string()));
        }
    };
    let mut unusable: Option<EncodeError> = None;
    let mut on_step = |number, report: StepReport| {
        // A history that starts again discards its earlier steps.
        unusable = unusable.take().filter(|_| number > 0);
        match StepResult::encode(number, report) {
            // Without a supervisor, the step is lost, and so is the outcome of the attempt.
            Ok(step) if unusable.is_none() => drop(steps.blocking_send(step)),
            Ok(_) => {}
            Err(error) => unusable = unusable.take().or(Some(error)),
        }
    };
    let solved = solver.solve(&job, observer, &mut on_step);
    let encoded =
        solved.map(|report| (report.status, unusable.map_or_else(|| encode(&report), Err)));
    if let Some(reason) = observer.out_of_memory() {
        return Outcome::Failed(JobFailure::solver(reason));
    }
    match encoded {
        Ok((status, Ok(report))) => Outcome::Reported { status, report },
        Ok((_, Err(error))) => {
            Outcome::Failed(JobFailure::solver(format!("the result is not usable: {error}")))
        }
        Err(RunError::Input(errors)) => Outcome::Failed(JobFailure::input(errors)),
        Err(error) => match observer.interrupt() {
            Some(interrupt) => Outcome::Interrupted(interrupt),
            None => Outcome::Failed(JobFailure::solver(error.to_string())),
        },
    }
}

fn panic_message(panic: &(dyn Any + Send)) -> &str {
    panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("(no message)")
}
