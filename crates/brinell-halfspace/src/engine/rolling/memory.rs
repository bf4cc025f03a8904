//! Bytes that a solve on a track holds.

use crate::engine::FLOWING;
use crate::raceway::RacewaySpace;
use crate::track::TrackGrid;

use super::problem::RollingProblem;

/// Numbers that a body keeps of each cell: spectra of pressure and traction, spectra of the three
/// components and of their sweep, increments, trials and their images.
const NUMBERS_OF_CELL: usize = 40;
/// Numbers of each cell that flows, in the differences of the acceleration.
const NUMBERS_OF_FLOW: usize = 3 * 2 * 9;

/// Numbers that a body keeps of each cell and component on a track of finite width: increments,
/// trials and their images.
const FIELDS: usize = 8;

/// Bytes that a solve on a track holds.
pub(super) fn bytes(problem: &RollingProblem, grid: &TrackGrid, layers: usize) -> usize {
    let bodies = problem.yielding().count();
    if grid.is_line() {
        let cells = grid.n_columns() * layers * bodies;
        let contact = 3 * grid.window().len().pow(2);
        return size_of::<f64>()
            * (cells * (NUMBERS_OF_CELL + NUMBERS_OF_FLOW / FLOWING) + contact);
    }
    let field = 5 * grid.n_cells() * layers;
    let vectors = field * (FIELDS + NUMBERS_OF_FLOW / 3 / FLOWING);
    let operators = RacewaySpace::bytes(grid, layers);
    // Spectra of the flexibility and its padded fields.
    let surface = 32 * grid.window().len() * 2 * grid.n_rows();
    bodies * (operators + size_of::<f64>() * vectors) + size_of::<f64>() * surface
}
