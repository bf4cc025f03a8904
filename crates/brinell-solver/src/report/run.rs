//! Entry points of the service and the command line: they estimate, solve and report a job.

use std::ops::ControlFlow;
use std::time::Duration;

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
use crate::solver::{Held, Interrupt, IterationRecord, Observer, Options};
use crate::units::UnitConverter;

/// An engine of any kind, with the job that it solves.
trait Reported {
    fn cost(&self) -> Result<JobEstimate, SolveError>;

    fn run_each(
        &self,
        options: Options<'_>,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(usize, StepReport),
    ) -> Result<Report, SolveError>;
}

impl<E: Shown> Reported for E {
    fn cost(&self) -> Result<JobEstimate, SolveError> {
        Shown::cost(self)
    }

    fn run_each(
        &self,
        options: Options<'_>,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(usize, StepReport),
    ) -> Result<Report, SolveError> {
        write_each(self, options, observer, on_step)
    }
}

/// Returns the engine of a job.
fn engine(job: &Job) -> Result<Box<dyn Reported + '_>, SolveError> {
    Ok(match inputs::of(job)? {
        Input::Meshed(contact) => Box::new(Meshed::new(job, *contact)),
        Input::HalfSpaces(contact) => Box::new(HalfSpaces::new(job, *contact)),
        Input::Rolling(contact) => Box::new(Track::new(job, *contact)),
    })
}

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
    engine(job).and_then(|engine| engine.cost()).map_err(|error| {
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

/// Converts each iteration to the units of the job and passes it to another observer.
struct InUnits<'a> {
    observer: &'a mut dyn Observer,
    write: UnitConverter,
}

impl Observer for InUnits<'_> {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.observer.on_iteration(&in_units(record, self.write))
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.observer.on_preliminary_iteration(&in_units(record, self.write))
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.observer.on_checkpoint()
    }

    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        self.observer.on_held(part, bytes)
    }

    fn elapsed(&self) -> Duration {
        self.observer.elapsed()
    }
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
    let observer = &mut InUnits { observer, write: UnitConverter::new(job.units, job.analysis) };
    let engine = engine(job).map_err(|error| RunError::of(job, &error))?;
    engine.run_each(options, observer, on_step).map_err(|error| RunError::of(job, &error))
}
