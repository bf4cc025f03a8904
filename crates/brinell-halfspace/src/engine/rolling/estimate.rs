//! Track and memory of a load that rolls, estimated before it is solved.

use super::design::TrackDesign;
use super::error::TrackError;
use super::memory::bytes;
use super::problem::RollingProblem;

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
/// Those of a grid, and [`TrackError::Track`] where the surfaces do not bear the friction.
pub fn estimate(problem: &RollingProblem) -> Result<TrackEstimate, TrackError> {
    problem.bears()?;
    let (grid, layers) = TrackDesign::new(problem, problem.columns).lay()?;
    Ok(TrackEstimate {
        columns: grid.n_columns(),
        window: grid.window().len(),
        layers: layers.len(),
        rows: grid.n_rows(),
        bytes: bytes(problem, &grid, layers.len()) as u64,
    })
}
