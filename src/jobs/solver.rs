//! The seam between the job queue and the mechanics.

use crate::model::{FieldError, Job};
use crate::results::{self, JobEstimate, Report, RunError};
use crate::solve::Observer;

/// Solves jobs. The service uses [`CoreSolver`]; tests put slow, failing and panicking ones in its place.
pub trait JobSolver: Send + Sync + 'static {
    /// What the job will cost, without solving it.
    ///
    /// # Errors
    /// Every field that makes the job impossible.
    fn estimate(&self, job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
        results::preflight(job)
    }

    /// Solves the job; runs on a thread of its own and may take its time, but asks `observer` between phases.
    ///
    /// # Errors
    /// [`RunError`] when there is nothing to report. Not converging is a status of the report, not an error.
    fn solve(&self, job: &Job, observer: &mut dyn Observer) -> Result<Report, RunError>;
}

/// The solver of this crate.
#[derive(Debug, Clone, Copy, Default)]
pub struct CoreSolver;

impl JobSolver for CoreSolver {
    fn solve(&self, job: &Job, observer: &mut dyn Observer) -> Result<Report, RunError> {
        results::run(job, observer)
    }
}
