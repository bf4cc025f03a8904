//! What a problem will take, before it is solved.

use brinell_halfspace::{DEVIATOR_COMPONENTS, HalfSpace};

use super::engine::GridDesign;
use super::problem::HalfSpaceProblem;
use crate::solver::SolveError;
use crate::solver::method::couplings::anderson::DEPTH;

/// Part of the cells that flows.
const FLOWING: f64 = 0.25;
/// Vectors of all cells that a solve holds beside those of a body: initial stress, its image, trials, accepted state.
const VECTORS: usize = 6;

/// The grid of a problem, as long as contact and plastic strain stay on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HalfSpaceEstimate {
    /// Cells along x and y.
    pub cells: [usize; 2],
    /// Layers of each body.
    pub layers: usize,
    /// Largest memory \[bytes\].
    pub bytes: u64,
}

/// Estimates the grid that a problem asks for, and its memory.
///
/// # Errors
/// Those of a grid.
pub fn estimate(problem: &HalfSpaceProblem) -> Result<HalfSpaceEstimate, SolveError> {
    let contact = problem.hertz(1.0);
    let design =
        GridDesign::new([contact.semi_axis_x, contact.semi_axis_y], f64::from(problem.cells_per_semi_axis));
    let (grid, layers) = design.grid()?;
    let field = layers.len() * grid.n_cells() * DEVIATOR_COMPONENTS * size_of::<f64>();
    let operators = HalfSpace::bytes(&grid, layers.len());
    let are_equal = problem.materials[0] == problem.materials[1];
    let bodies = if are_equal { 1 } else { problem.materials.iter().flatten().count() };
    let yielding =
        problem.materials.iter().flatten().filter(|material| material.plasticity().is_some()).count();
    let yielding = if are_equal { yielding.min(1) } else { yielding };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bytes of a field")]
    let anderson = (2.0 * (DEPTH + 2) as f64 * FLOWING * field as f64) as usize;
    // Strain, stress before, total and stress of the body, and fields of the answer.
    let of_yielding = (VECTORS + 4) * field + anderson;
    let bytes = bodies * (operators + 3 * field) + yielding * of_yielding;
    Ok(HalfSpaceEstimate { cells: [grid.nx(), grid.ny()], layers: layers.len(), bytes: bytes as u64 })
}
