//! Entry points of jobs whose load rolls: they estimate, solve and report a job.

use super::step::StepWriter;
use crate::inputs::{RollingInput, rolling};
use crate::job::{FieldError, Job, Named as _};
use crate::report::build::timings;
use crate::report::run::{RunError, SOLVER_BYTES, STEP_BYTES};
use crate::report::{JobEstimate, MeshReport, Report, StepReport};
use crate::solver::Observer;
use crate::solver::rolling::{
    Hardening, RollingProblem, RollingSolution, TrackEstimate, estimate, run,
};
use crate::units::UnitConverter;

/// Bytes of the report of a pass, and of a column of the window or a layer.
const PASS_BYTES: u64 = 900;
const ROW_BYTES: u64 = 120;
/// Numbers of a cell of the section of a track.
const SECTION_NUMBERS: u64 = 14;
/// Cells of a track whose pass counts as one unit of work.
const WORK_UNIT: u64 = 10_000;

/// Estimates the cost of a job.
///
/// # Errors
/// The fields of the job that describe a track without an answer.
pub fn preflight(job: &Job) -> Result<JobEstimate, Vec<FieldError>> {
    let problem = rolling(job).map(|input| input.problem);
    let problem = problem.and_then(|problem| Ok((estimate(&problem)?, problem)));
    match problem.map_err(|error| RunError::of(job, error)) {
        Ok((track, problem)) => Ok(cost(job, &problem, track)),
        Err(RunError::Input(faults)) => Err(faults),
        Err(other) => Err(vec![FieldError::not_solvable("/load/rolling", other.to_string())]),
    }
}

fn cost(job: &Job, problem: &RollingProblem, track: TrackEstimate) -> JobEstimate {
    let TrackEstimate { columns, window, layers, rows, bytes } = track;
    let bodies = problem.yielding().count();
    let cells = (columns * rows * layers * bodies) as u64;
    let components = if rows > 1 { 5 } else { 3 };
    let passes = u64::from(problem.load.passes);
    let is_twice =
        problem.load.hardening == Hardening::Both && problem.hardening_kinematically().is_some();
    let rules = if is_twice { 2 } else { 1 };
    let section = if job.output.fields && rows > 1 { 2 * (2 * rows * layers) as u64 } else { 0 };
    let report = STEP_BYTES
        + PASS_BYTES * passes
        + ROW_BYTES * (window + 2 * layers) as u64
        + 8 * SECTION_NUMBERS * section;
    JobEstimate {
        equations: window * rows + components * columns * rows * layers * bodies,
        bytes: SOLVER_BYTES + bytes + 8 * report,
        result_bytes: report,
        work: (cells / WORK_UNIT).max(1) * passes * rules,
    }
}

/// Solves a job and passes the report of its step to `on_step`. The returned report has no steps.
pub fn run_each(
    job: &Job,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError> {
    let input = rolling(job).map_err(|error| RunError::of(job, error))?;
    let RollingInput { problem, .. } = &input;
    let solution = run(problem, observer).map_err(|error| RunError::of(job, error))?;
    let start = observer.elapsed();
    let write = UnitConverter::new(job.units, job.analysis);
    let RollingSolution { phases, tracks, enlargements, .. } = &solution;
    let [columns, layers, rows] = solution.grid;
    let components = if rows > 1 { 5 } else { 3 };
    let mesh = MeshReport {
        spacing: write.length(solution.column),
        contact_pairs: solution.x.len() * rows,
        nodes: columns * rows,
        elements: columns * layers * rows * problem.yielding().count(),
        equations: solution.x.len() * rows + components * columns * layers * rows,
        passes: *tracks,
        enlargements: *enlargements,
        ..MeshReport::NONE
    };
    let report = StepWriter { job, write, input: &input, problem, solution: &solution }.report();
    let reporting = observer.elapsed().saturating_sub(start);
    let status = report.status;
    on_step(0, report);
    Ok(Report {
        units: job.units.name().to_owned(),
        analysis: job.analysis.name().to_owned(),
        theory: job.theory().map(|theory| theory.name().to_owned()),
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
