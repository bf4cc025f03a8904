//! What a job in three dimensions will cost.

use crate::job::{Job, Load};
use crate::report::JobEstimate;
use crate::report::contact_stiffness::{of_small_mesh, small_solves};
use crate::solver::SolveError;
use crate::solver::half_spaces::{self, HalfSpaceProblem};

/// Bytes that solving takes whatever the job.
const SOLVER_BYTES: u64 = 56 << 20;
/// Bytes of the report of a step: of each cell of the surface where maps are asked for, of each
/// row and layer, of each row along a roller, and of the rest.
const MAP_BYTES: u64 = 24;
/// Bytes of the layers of a body, of each cell: 14 numbers. Copies of them while a step is
/// written, encoded and stored.
const LAYER_BYTES: u64 = 8 * 14;
const LAYER_COPIES: u64 = 4;
const ROW_BYTES: u64 = 220;
const ROLLER_ROW_BYTES: u64 = 90;
const STEP_BYTES: u64 = 6 << 10;
/// Cells of the layers that are a unit of work.
const WORK_UNIT: u64 = 1000;
/// Solves of a load that is sought, those on coarser grids by what they take.
const SEARCH_SOLVES: u64 = 4;

/// The estimate of a job.
///
/// # Errors
/// [`SolveError`] of a grid that cannot be laid out.
pub(super) fn estimate(job: &Job, problem: &HalfSpaceProblem) -> Result<JobEstimate, SolveError> {
    let grid = half_spaces::estimate(problem)?;
    let [columns, rows] = grid.cells.map(|count| count as u64);
    let layers = grid.layers as u64;
    let (surface, volume) = (columns * rows, columns * rows * layers);
    let are_equal = problem.materials[0] == problem.materials[1];
    let materials = problem.materials.iter().flatten();
    let yielding = materials.filter(|material| material.plasticity().is_some()).count() as u64;
    let yielding = if are_equal { yielding.min(1) } else { yielding };
    let steps = match &job.load {
        Load::Forces(sweep) | Load::Approaches(sweep) => sweep.iter().count(),
        Load::History(history) => history.iter().count(),
        Load::Onset => 1,
        Load::Target(target) => 1 + usize::from(target.figure.is_permanent()),
    } as u64;
    let solves = if matches!(job.load, Load::Onset | Load::Target(_)) { SEARCH_SOLVES } else { 1 };
    let bodies = problem.materials.iter().flatten().count() as u64;
    let (maps, fields) = if job.output.fields {
        (MAP_BYTES * surface, LAYER_BYTES * volume * bodies)
    } else {
        (0, 0)
    };
    let along = if problem.rollers.is_empty() { 0 } else { ROLLER_ROW_BYTES * rows };
    let step = STEP_BYTES + along + ROW_BYTES * (columns + rows + layers) + maps;
    let work = (volume / WORK_UNIT).max(1);
    Ok(JobEstimate {
        equations: usize::try_from(surface + 5 * yielding * volume).unwrap_or(usize::MAX),
        bytes: SOLVER_BYTES
            + grid.bytes
            + of_small_mesh(job, grid.bytes)
            + LAYER_COPIES * fields
            + step * steps,
        result_bytes: (step + fields) * steps,
        work: work * steps * solves + of_small_mesh(job, work) * small_solves(job, steps),
    })
}
