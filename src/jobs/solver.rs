//! The seam between the job queue and the mechanics.

use std::sync::Arc;

use super::metrics;
use brinell_solver::job::{FieldError, Job, Load, Theory};
use brinell_solver::report::{self, JobEstimate, Report, RunError, StepReport};
use brinell_solver::solver::{FactorCache, Observer, Options};

/// Solves jobs. The service uses [`CoreSolver`]; tests put slow, failing and panicking ones in its place.
pub trait JobSolver: Send + Sync + 'static {
    /// What the job will cost, without solving it.
    ///
    /// # Errors
    /// Every field that makes the job impossible.
    fn estimate(&self, job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
        estimate(job)
    }

    /// Solves the job and hands over each step as soon as it is finished; the report that is returned has no steps. Runs on
    /// a thread of its own and may take its time, but asks `observer` between phases.
    ///
    /// # Errors
    /// [`RunError`] when there is nothing to report. Not converging is a status of the report, not an error.
    fn solve(
        &self,
        job: &Job,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(StepReport),
    ) -> Result<Report, RunError>;
}

/// Bytes that flow theory holds of an increment for each node: two displacements of the nodes of the
/// coarse mesh, which has a quarter of them, of this division and of one that is twice as fine.
const INCREMENT_BYTES: u64 = 16 * (1 + 2) / 4;

/// Bytes of an increment and its iterations in the report, in memory and as they are stored.
const REPORTED_INCREMENT_BYTES: u64 = 1024;
const STORED_INCREMENT_BYTES: u64 = 256;

/// Increments that the solver chooses itself: so many up to the largest load, and of each load.
const CHOSEN_INCREMENTS: u64 = 32;
const CHOSEN_INCREMENTS_OF_LOAD: u64 = 2;

/// What a job will cost. Beside what the solver counts, flow theory holds to the end of the job the
/// reports of all steps, because it may begin anew, and the increments on the coarse mesh.
///
/// # Errors
/// Every field that makes the job impossible.
pub fn estimate(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    let counted = report::preflight(job)?;
    if job.solver.theory != Theory::Flow {
        return Ok(counted);
    }
    let loads = match &job.load {
        Load::Forces(sweep) | Load::Approaches(sweep) => sweep.iter().count() as u64,
        Load::History(history) => history.iter().count() as u64,
        // A force, and its removal.
        Load::Onset | Load::Target(_) => 2,
    };
    let increments = match job.solver.increments {
        Some(of_load) => loads * u64::from(of_load),
        None => CHOSEN_INCREMENTS + loads * CHOSEN_INCREMENTS_OF_LOAD,
    };
    let nodes = counted.equations as u64 / 2;
    let held = increments * (nodes * INCREMENT_BYTES + REPORTED_INCREMENT_BYTES);
    Ok(JobEstimate {
        bytes: counted.bytes + held + counted.result_bytes,
        result_bytes: counted.result_bytes + increments * STORED_INCREMENT_BYTES,
        ..counted
    })
}

/// The solver of this crate.
#[derive(Debug, Default)]
pub struct CoreSolver {
    cache: Option<Arc<FactorCache>>,
}

impl CoreSolver {
    /// A solver that keeps up to so many bytes of bodies and factors from one job to the next.
    pub fn with_cache(bytes: usize) -> Self {
        Self { cache: (bytes > 0).then(|| Arc::new(FactorCache::new(bytes))) }
    }
}

impl JobSolver for CoreSolver {
    fn solve(
        &self,
        job: &Job,
        observer: &mut dyn Observer,
        on_step: &mut dyn FnMut(StepReport),
    ) -> Result<Report, RunError> {
        let options = Options { cache: self.cache.as_ref(), ..Options::default() };
        let report = report::run_each(job, options, observer, on_step);
        if let Some(cache) = &self.cache {
            metrics::factor_cache(cache.stats());
        }
        report
    }
}
