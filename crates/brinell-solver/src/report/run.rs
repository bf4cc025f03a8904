//! The one entry that the service and the command line use.

use serde::Serialize;
use thiserror::Error;

use super::build::ReportBuilder;
use super::{Report, StepReport};
use crate::fem::mesh::MeshError;
use crate::job::{FieldError, Job};
use crate::solver::{self, Interrupt, Observer, Options, SolveError, StepSolution};

/// Why a job gave no report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RunError {
    /// The job is well formed but describes a contact that the theory does not cover.
    #[error("{}", summary(.0))]
    Input(Vec<FieldError>),
    /// The observer stopped it before there was anything to report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
    /// The solver failed.
    #[error("{0}")]
    Failed(String),
}

fn summary(errors: &[FieldError]) -> String {
    errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

impl From<SolveError> for RunError {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::TooWide { .. } | SolveError::Mesh(MeshError::ZoneBeyondBody { .. }) => {
                Self::Input(vec![FieldError::not_solvable("/load", error.to_string())])
            }
            SolveError::NoYieldPoint => {
                Self::Input(vec![FieldError::not_solvable("/load/onset", error.to_string())])
            }
            SolveError::Conforming => {
                let detail = error.to_string();
                Self::Input(vec![
                    FieldError::not_solvable("/upper/shape", detail.clone()),
                    FieldError::not_solvable("/lower/shape", detail),
                ])
            }
            SolveError::Interrupted(interrupt) => Self::Interrupted(interrupt),
            other => Self::Failed(other.to_string()),
        }
    }
}

/// What a job will cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct JobEstimate {
    /// Equations of both bodies.
    pub equations: usize,
    /// Peak memory \[bytes\].
    pub bytes: u64,
}

/// Estimates the cost of a job without meshing it.
///
/// # Errors
/// The fields that describe a contact which is not solved.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    match solver::estimate(job).map_err(RunError::from) {
        Ok(estimate) => Ok(JobEstimate { equations: estimate.equations, bytes: estimate.bytes }),
        Err(RunError::Input(errors)) => Err(errors),
        Err(other) => Err(vec![FieldError::not_solvable("", other.to_string())]),
    }
}

/// Solves a job and reports on it.
///
/// # Errors
/// [`RunError`]. An iteration that does not converge is a report with that status, not an error.
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Report, RunError> {
    run_with(job, Options::default(), observer)
}

/// [`run`] with options.
///
/// # Errors
/// As [`run`].
pub fn run_with(job: &Job, options: Options<'_>, observer: &mut dyn Observer) -> Result<Report, RunError> {
    let mut steps = Vec::new();
    let report = run_each(job, options, observer, &mut |step| steps.push(step))?;
    Ok(Report { steps, ..report })
}

/// [`run_with`] that hands over the report of each step as soon as the step is finished. The report that is returned has
/// no steps.
///
/// # Errors
/// As [`run`].
pub fn run_each(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(StepReport),
) -> Result<Report, RunError> {
    let mut builder = ReportBuilder::new(job);
    let mut report_step = |step: StepSolution, observer: &mut dyn Observer| {
        on_step(builder.step(&step, observer));
    };
    let solution = solver::run_each(job, options, observer, &mut report_step)?;
    Ok(builder.finish(&solution, observer))
}
