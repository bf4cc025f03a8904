//! Estimate of the memory of a job in three dimensions.

use crate::inputs::of_small_mesh;
use crate::job::Job;
use crate::report::LAYER_NAMES;
use crate::report::cost::{
    FIELD_COPIES, JobEstimate, REPORTED_INCREMENT_BYTES, SOLVER_BYTES, STEP_BYTES, increments_of,
    steps_of,
};
use crate::solver::half_spaces::{self, HalfSpaceError, HalfSpaceProblem};

/// Bytes of the report of a load step: for each cell of the maps, if the job asks for them, and
/// for each row and layer. A row along a roller counts twice.
const MAP_BYTES: u64 = 32;
const ROW_BYTES: u64 = 220;
/// Numbers in each cell of the layers of a preliminary step: stress, plastic strain, its
/// equivalent, yield stress. Its grid has half the cells along each axis.
const PRELIMINARY: u64 = 13;
/// Copies of the records of a load while its step is reported, encoded and stored.
const RECORD_COPIES: u64 = 4;

/// Returns the estimate of a job.
///
/// # Errors
/// [`HalfSpaceError`] if no grid fits the job.
pub(super) fn estimate(
    job: &Job,
    problem: &HalfSpaceProblem,
) -> Result<JobEstimate, HalfSpaceError> {
    let grid = half_spaces::estimate(problem)?;
    let [columns, rows] = grid.cells.map(|count| count as u64);
    let layers = grid.layers as u64;
    let (surface, volume) = (columns * rows, columns * rows * layers);
    let are_equal = problem.materials[0] == problem.materials[1];
    let materials = problem.materials.iter().flatten();
    let yielding = materials.filter(|material| material.can_yield()).count() as u64;
    let yielding = if are_equal { yielding.min(1) } else { yielding };
    let steps = steps_of(job);
    let bodies = problem.materials.iter().flatten().count() as u64;
    let (maps, fields) = if job.output.fields {
        (MAP_BYTES * surface, (size_of::<f64>() * LAYER_NAMES.len()) as u64 * volume * bodies)
    } else {
        (0, 0)
    };
    let along = if problem.rollers.is_empty() { 0 } else { rows };
    let step = STEP_BYTES + ROW_BYTES * (columns + rows + along + layers) + maps;
    let is_history = job.has_memory();
    let [of_load, increments] = if is_history { increments_of(job, steps) } else { [0; 2] };
    let preliminary = if is_history {
        size_of::<f64>() as u64 * steps * (PRELIMINARY * volume * bodies / 8 + 3 * surface / 4)
    } else {
        0
    };
    Ok(JobEstimate {
        equations: usize::try_from(surface + 5 * yielding * volume).unwrap_or(usize::MAX),
        bytes: SOLVER_BYTES
            + grid.bytes
            + of_small_mesh(job, grid.bytes)
            + FIELD_COPIES * fields
            + step * steps
            + preliminary
            + RECORD_COPIES * REPORTED_INCREMENT_BYTES * of_load,
        result_bytes: (step + fields) * steps + REPORTED_INCREMENT_BYTES * increments,
    })
}
