//! The interface between the job queue and the mechanics.

use std::sync::Arc;

use super::metrics;
use brinell_solver::job::{FieldError, Job};
use brinell_solver::report::{self, JobEstimate, Report, RunError, StepReport};
use brinell_solver::solver::{FactorCache, Observer, Options};

/// Solves jobs. The service uses [`CoreSolver`]; tests use slow, failing and panicking solvers.
pub trait JobSolver: Send + Sync + 'static {
    /// Estimates the cost of a job without solving it.
    ///
    /// # Errors
    /// Every field that makes the job impossible.
    fn estimate(&self, job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
        report::preflight(job)
    }

    /// Solves the job and passes each step with its number to the caller as [`report::run_each`]
    /// does; the returned report has no steps. The caller provides a thread; between phases, the
    /// solve asks `observer` whether to stop.
    ///
    /// # Errors
    /// [`RunError`] when there is nothing to report. Not converging is a status of the report, not
    /// an error.
    fn solve(
        &self,
        job: &Job,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(usize, StepReport),
    ) -> Result<Report, RunError>;
}

/// The solver of this program, [`brinell_solver`].
#[derive(Debug, Default)]
pub struct CoreSolver {
    cache: Option<Arc<FactorCache>>,
}

impl CoreSolver {
    /// Makes a solver that caches up to `bytes` of bodies and factors between jobs.
    pub fn with_cache(bytes: usize) -> Self {
        Self { cache: (bytes > 0).then(|| Arc::new(FactorCache::new(bytes))) }
    }
}

impl JobSolver for CoreSolver {
    fn solve(
        &self,
        job: &Job,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(usize, StepReport),
    ) -> Result<Report, RunError> {
        let options = Options { cache: self.cache.as_ref(), ..Options::default() };
        let report = report::run_each(job, options, observer, on_step);
        if let Some(cache) = &self.cache {
            metrics::factor_cache(cache.stats());
        }
        report
    }
}
