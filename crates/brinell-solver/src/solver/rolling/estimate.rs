//! What a load that rolls will take, before it is solved.

use brinell_halfspace::raceway::{RacewayGrid, RacewaySpace};
use brinell_halfspace::track::TrackGrid;

use super::course::Course;
use super::engine::TrackDesign;
use super::problem::RollingProblem;
use crate::solver::SolveError;

/// Numbers that a body keeps of each cell: spectra of pressure and traction, spectra of the three
/// components and of their sweep, increments, trials and their images.
const NUMBERS_OF_CELL: usize = 40;
/// Numbers of each cell that flows, in the differences of the acceleration.
const NUMBERS_OF_FLOW: usize = 3 * 2 * 9;
/// Part of the cells that flows.
const FLOWING: usize = 4;

/// The track of a problem, as long as contact and plastic strain stay on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TrackEstimate {
    /// Columns of the track.
    pub columns: usize,
    /// Columns in which the bodies may touch.
    pub window: usize,
    /// Layers of each body.
    pub layers: usize,
    /// Rows of cells in a layer, on one side of the axis; one of a line.
    pub rows: usize,
    /// Largest memory \[bytes\].
    pub bytes: u64,
}

/// Estimates the track that a problem asks for, and its memory.
///
/// # Errors
/// Those of a grid, and [`SolveError::Track`] where the surfaces do not bear the friction.
pub fn estimate(problem: &RollingProblem) -> Result<TrackEstimate, SolveError> {
    problem.bears()?;
    if problem.is_line() { of::<TrackGrid>(problem) } else { of::<RacewayGrid>(problem) }
}

fn of<C: Course>(problem: &RollingProblem) -> Result<TrackEstimate, SolveError> {
    let (grid, layers) = C::lay(&TrackDesign::new(problem, problem.columns))?;
    Ok(TrackEstimate {
        columns: grid.n_columns(),
        window: grid.x().len(),
        layers: layers.len(),
        rows: grid.n_rows(),
        bytes: grid.bytes(problem, layers.len()) as u64,
    })
}

/// Bytes that a solve on a line holds.
pub(super) fn bytes_of_line(problem: &RollingProblem, grid: &TrackGrid, layers: usize) -> usize {
    let cells = grid.n_columns() * layers * problem.yielding().count();
    let contact = 3 * grid.window().len().pow(2);
    size_of::<f64>() * (cells * (NUMBERS_OF_CELL + NUMBERS_OF_FLOW / FLOWING) + contact)
}

/// Numbers that a body keeps of each cell and component on a track of finite width: increments,
/// trials and their images.
const FIELDS: usize = 8;

/// Bytes that a solve on a track of finite width holds.
pub(super) fn bytes_of_ellipse(
    problem: &RollingProblem,
    grid: &RacewayGrid,
    layers: usize,
) -> usize {
    let field = 5 * grid.n_cells() * layers;
    let vectors = field * (FIELDS + NUMBERS_OF_FLOW / 3 / FLOWING);
    let operators = RacewaySpace::bytes(grid, layers);
    // Spectra of the flexibility and its padded fields.
    let surface = 32 * grid.window().len() * 2 * grid.n_rows();
    problem.yielding().count() * (operators + size_of::<f64>() * vectors)
        + size_of::<f64>() * surface
}
