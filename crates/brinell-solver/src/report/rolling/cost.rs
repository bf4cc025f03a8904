//! Estimate of the memory of a load that rolls.

use crate::job::Job;
use crate::report::cost::{JobEstimate, SOLVER_BYTES, STEP_BYTES};
use crate::solver::rolling::{RollingProblem, TrackError, TrackEstimate, estimate};

/// Bytes of the report of a pass, and of a column of the window or a layer.
const PASS_BYTES: u64 = 900;
const ROW_BYTES: u64 = 120;
/// Numbers of a cell of the section of a track.
const SECTION_NUMBERS: u64 = 14;

/// Returns the estimate of a job.
///
/// # Errors
/// [`TrackError`] of a track without an answer.
pub(super) fn cost(job: &Job, problem: &RollingProblem) -> Result<JobEstimate, TrackError> {
    let TrackEstimate { columns, window, layers, rows, bytes } = estimate(problem)?;
    let bodies = problem.yielding().count();
    let components = if rows > 1 { 5 } else { 3 };
    let passes = u64::from(problem.load.passes);
    let section = if job.output.fields && rows > 1 { 2 * (2 * rows * layers) as u64 } else { 0 };
    let report = STEP_BYTES
        + PASS_BYTES * passes
        + ROW_BYTES * (window + 2 * layers) as u64
        + 8 * SECTION_NUMBERS * section;
    Ok(JobEstimate {
        equations: window * rows + components * columns * rows * layers * bodies,
        bytes: SOLVER_BYTES + bytes + 8 * report,
        result_bytes: report,
    })
}
