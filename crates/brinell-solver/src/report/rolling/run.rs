//! Entry points of jobs whose load rolls: they estimate, solve and report a job.

use super::step::StepWriter;
use crate::job::{FieldError, Job, Named as _};
use crate::report::build::timings;
use crate::report::run::{RunError, SOLVER_BYTES, STEP_BYTES};
use crate::report::{JobEstimate, MeshReport, Report, StepReport};
use crate::solver::Observer;
use crate::solver::rolling::{RollingProblem, RollingSolution, TrackEstimate, estimate, run};
use crate::units::UnitConverter;

/// Bytes of the report of a pass, and of a column of the window or a layer.
const PASS_BYTES: u64 = 900;
const ROW_BYTES: u64 = 120;
/// Cells of a track whose pass counts as one unit of work.
const WORK_UNIT: u64 = 10_000;

/// Estimates the cost of a job.
///
/// # Errors
/// The fields of the job that describe a track without an answer.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    let problem = RollingProblem::of(job).and_then(|problem| Ok((estimate(&problem)?, problem)));
    match problem.map_err(|error| RunError::of(job, &error)) {
        Ok((track, problem)) => Ok(cost(&problem, track)),
        Err(RunError::Input(faults)) => Err(faults),
        Err(other) => Err(vec![FieldError::not_solvable("/load/rolling", other.to_string())]),
    }
}

fn cost(problem: &RollingProblem, track: TrackEstimate) -> JobEstimate {
    let TrackEstimate { columns, window, layers, bytes } = track;
    let bodies = problem.yielding().count();
    let cells = (columns * layers * bodies) as u64;
    let passes = u64::from(problem.load.passes);
    let report = STEP_BYTES + PASS_BYTES * passes + ROW_BYTES * (window + 2 * layers) as u64;
    JobEstimate {
        equations: window + 3 * columns * layers * bodies,
        bytes: SOLVER_BYTES + bytes + 8 * report,
        result_bytes: report,
        work: (cells / WORK_UNIT).max(1) * passes,
    }
}

/// Solves a job and passes the report of its step to `on_step`. The returned report has no steps.
pub fn run_each(
    job: &Job,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    let problem = RollingProblem::of(job).map_err(|error| RunError::of(job, &error))?;
    let solution = run(&problem, observer).map_err(|error| RunError::of(job, &error))?;
    let start = observer.elapsed();
    let write = UnitConverter::new(job.units, job.analysis);
    let RollingSolution { phases, tracks, enlargements, .. } = &solution;
    let mesh = MeshReport {
        spacing: write.length(solution.column),
        contact_pairs: solution.x.len(),
        nodes: solution.grid[0],
        elements: solution.grid[0] * solution.grid[1] * problem.yielding().count(),
        equations: solution.x.len() + 3 * solution.grid[0] * solution.grid[1],
        passes: *tracks,
        enlargements: *enlargements,
        ..MeshReport::NONE
    };
    let report = StepWriter { job, write, problem: &problem, solution: &solution }.report();
    let reporting = observer.elapsed().saturating_sub(start);
    let status = report.status;
    on_step(0, report);
    Ok(Report {
        units: job.units.name().to_owned(),
        analysis: job.analysis.name().to_owned(),
        status,
        steps: Vec::new(),
        load_approach: None,
        target: None,
        hardness: None,
        mesh,
        timings_ms: timings(phases, observer.elapsed(), reporting),
        tags: job.tags.clone(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
    })
}
