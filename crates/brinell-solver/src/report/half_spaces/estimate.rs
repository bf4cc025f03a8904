//! What a job in three dimensions will cost.

use brinell_halfspace::Layers;

use crate::job::{Job, Load, Material};
use crate::report::JobEstimate;

/// Half a side of the grid over the semi-axis, thickness of the first layer over the side of a cell, growth of the layers times
/// cells along a side, depth over the semi-axis: as the engine lays grids out.
const REACH: f64 = 1.6;
const FIRST_LAYER: f64 = 0.75;
const GROWTH: f64 = 1.92;
const DEPTH: f64 = 2.6;

/// Bytes that solving takes whatever the job.
const SOLVER_BYTES: u64 = 56 << 20;
/// Bytes of a cell of the layers of a body, with the transforms over twice the sides and their spectra.
const BYTES_PER_CELL: u64 = 2000;
/// Bytes of the report of a step for each cell of the surface where maps are asked for, and for each row and layer.
const MAP_BYTES: u64 = 24;
const ROW_BYTES: u64 = 220;
const STEP_BYTES: u64 = 6 << 10;

/// The estimate of a job.
pub fn estimate(job: &Job) -> JobEstimate {
    let cells = f64::from(job.mesh.elements_per_half_width);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 60 cells")]
    let side = 2 * (REACH * cells).ceil() as u64;
    let growth = 1.0 + GROWTH / (2.0 * REACH * cells);
    let layers = Layers::graded(FIRST_LAYER / cells, growth, DEPTH).map_or(0, |layers| layers.len() as u64);
    let materials = [&job.upper.material, &job.lower.material];
    let yields =
        |material: &&&Material| matches!(material, Material::Deformable(of) if of.plasticity().is_some());
    let equal = materials[0] == materials[1];
    let bodies =
        if equal { 1 } else { materials.iter().filter(|of| ***of != Material::Rigid).count() as u64 };
    let yielding = if equal { 1 } else { 2 }.min(materials.iter().filter(yields).count() as u64);
    let volume = side * side * layers;
    let steps = match &job.load {
        Load::Forces(sweep) | Load::Approaches(sweep) => sweep.iter().count(),
        Load::History(history) => history.iter().count(),
        Load::Onset | Load::Target(_) => 1,
    } as u64;
    let maps = if job.output.fields { MAP_BYTES * side * side } else { 0 };
    let step = STEP_BYTES + ROW_BYTES * (side + layers) + maps;
    JobEstimate {
        equations: usize::try_from(side * side + 5 * yielding * volume).unwrap_or(usize::MAX),
        bytes: SOLVER_BYTES + BYTES_PER_CELL * bodies * volume + step * steps,
        result_bytes: step * steps,
        work: (volume / 1000).max(1) * steps,
    }
}
