//! One attempt at one job, on a solver thread.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::observer::JobObserver;
use crate::jobs::{JobFailure, JobId, JobSolver, Outcome, encode};
use brinell_solver::job::{Job, JobError};
use brinell_solver::report::RunError;

/// Solves a job and catches whatever goes wrong. Never panics.
pub(super) fn attempt(
    id: JobId,
    solver: &dyn JobSolver,
    request: &[u8],
    observer: &mut JobObserver,
) -> Outcome {
    // Everything the closure touches is thrown away after a panic, save the observer's plain fields.
    let solved = catch_unwind(AssertUnwindSafe(|| solve(solver, request, observer)));
    solved.unwrap_or_else(|panic| {
        tracing::error!(job = %id, panic = panic_message(panic.as_ref()), "the solver panicked");
        Outcome::Failed(JobFailure::internal("the solver failed unexpectedly; the fault has been logged"))
    })
}

fn solve(solver: &dyn JobSolver, request: &[u8], observer: &mut JobObserver) -> Outcome {
    let job = match Job::from_json(request) {
        Ok(job) => job,
        Err(JobError::Fields(errors)) => return Outcome::Failed(JobFailure::input(errors)),
        Err(error @ JobError::Syntax { .. }) => {
            return Outcome::Failed(JobFailure::internal(error.to_string()));
        }
    };
    match solver.solve(&job, observer) {
        Ok(report) => match encode(&report) {
            Ok(json) => Outcome::Reported { status: report.status, report: json },
            Err(error) => Outcome::Failed(JobFailure::solver(format!("the result is not usable: {error}"))),
        },
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
