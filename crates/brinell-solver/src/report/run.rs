//! Entry points of the service and the command line: they estimate, solve and report a job.

use super::accuracy;
use super::cost::JobEstimate;
use super::find;
use super::half_spaces::HalfSpaces;
use super::meshed::Meshed;
use super::rolling::Track;
use super::run_error::RunError;
use super::shown::Shown;
use super::step::{in_units, run_each as write_each};
use super::{Report, StepReport};
use crate::inputs::{self, Input, SolveError};
use crate::job::{FieldError, Job};
use crate::solver::method::observer::Retold;
use crate::solver::{Observer, Options};
use crate::units::UnitConverter;

/// Estimates the cost of a job without meshing it.
///
/// # Errors
/// The fields of the job that describe a contact outside the theory.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    if find::is_asked(job) { find::estimate(job, estimate) } else { estimate(job) }
}

/// Estimates the cost of a job without a search.
fn estimate(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    accuracy::estimate(job, cost)
}

/// Estimates the cost of one solve.
fn cost(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    let cost = inputs::of(job).and_then(|input| match input {
        Input::Meshed(contact) => Meshed::new(job, *contact).cost(),
        Input::HalfSpaces(contact) => HalfSpaces::new(job, *contact).cost(),
        Input::Rolling(contact) => Track::new(job, *contact).cost(),
    });
    cost.map_err(|error| {
        let whole = match &error {
            SolveError::Meshed(_) => "",
            SolveError::HalfSpaces(_) | SolveError::NoHalfSpaces => "/mesh",
            SolveError::Track(_) => "/load/rolling",
        };
        match RunError::of(job, &error) {
            RunError::Input(faults) => faults,
            other => vec![FieldError::not_solvable(whole, other.to_string())],
        }
    })
}

/// Solves a job and returns its report. The observer sees iterations in the units of the job.
///
/// # Errors
/// [`RunError`]. A job that does not converge returns a report with that status, not an error.
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Report, RunError> {
    run_with(job, Options::default(), observer)
}

/// Solves a job with options, as [`run`].
///
/// # Errors
/// As [`run`].
pub fn run_with(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    let mut steps = Vec::new();
    let mut on_step = |number, step| {
        steps.truncate(number);
        steps.push(step);
    };
    let report = run_each(job, options, observer, &mut on_step)?;
    Ok(Report { steps, ..report })
}

/// Solves a job as [`run_with`] and passes the report of each load step to `on_step` when the step
/// ends. Steps are numbered from 0. A history that restarts on a wider mesh numbers its steps from
/// 0 again: a step then replaces the earlier step of its number, and all later ones are void. The
/// returned report has no steps.
///
/// # Errors
/// As [`run`].
pub fn run_each(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    if find::is_asked(job) {
        return find::run_each(job, options, observer, on_step, solve);
    }
    solve(job, options, observer, on_step)
}

/// Solves a job without a search.
fn solve(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    accuracy::solve(job, options, observer, on_step, solve_once)
}

/// Solves a job once.
fn solve_once(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    let write = UnitConverter::new(job.units, job.analysis);
    let observer = &mut Retold::new(observer, |record| in_units(record, write));
    let report = inputs::of(job).and_then(|input| match input {
        Input::Meshed(contact) => {
            write_each(&Meshed::new(job, *contact), options, observer, on_step)
        }
        Input::HalfSpaces(contact) => {
            write_each(&HalfSpaces::new(job, *contact), options, observer, on_step)
        }
        Input::Rolling(contact) => {
            write_each(&Track::new(job, *contact), options, observer, on_step)
        }
    });
    report.map_err(|error| RunError::of(job, &error))
}
