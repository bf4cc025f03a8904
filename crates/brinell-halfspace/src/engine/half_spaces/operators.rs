//! The operators that a problem needs on a grid: whether they are symmetric, and their bytes.

use crate::engine::FLOWING;
use crate::{DEVIATOR_COMPONENTS, HalfSpace, Layers, SurfaceGrid};

use super::law::initial_stress;
use super::problem::HalfSpaceProblem;
use brinell_method::couplings::anderson::DEPTH;

/// Vectors of all cells that a solve holds beside those of a body: initial stress, its image,
/// trials, accepted state.
const VECTORS: usize = 6;

/// Whether gap and initial stress are symmetric about both axes of the fields, to the last digit.
pub(super) fn is_symmetric(
    problem: &HalfSpaceProblem,
    grid: &SurfaceGrid,
    layers: &Layers,
    gap: &[f64],
) -> bool {
    let mut rows = gap.chunks_exact(grid.ny());
    let mirrored = gap.chunks_exact(grid.ny()).rev();
    let is_even = rows.clone().zip(mirrored).all(|(row, mirror)| row == mirror)
        && rows.all(|row| row.iter().eq(row.iter().rev()));
    is_even
        && problem.moment().is_none()
        && problem.materials.iter().flatten().all(|material| {
            initial_stress(material, problem.orientation(), layers)
                .iter()
                .all(|[_, _, xy]| xy.abs() <= 0.0)
        })
}

/// Bytes that a solve on a grid holds.
pub(super) fn bytes(problem: &HalfSpaceProblem, grid: &SurfaceGrid, layers: &Layers) -> usize {
    let field = layers.len() * grid.n_cells() * DEVIATOR_COMPONENTS * size_of::<f64>();
    let is_symmetric = is_symmetric(problem, grid, layers, &problem.gap(grid));
    let operators = HalfSpace::bytes(grid, layers.len(), is_symmetric);
    let are_equal = problem.materials[0] == problem.materials[1];
    let bodies = if are_equal { 1 } else { problem.materials.iter().flatten().count() };
    let yielding =
        problem.materials.iter().flatten().filter(|material| material.can_yield()).count();
    let yielding = if are_equal { yielding.min(1) } else { yielding };
    let anderson = 2 * (DEPTH + 2) * field / FLOWING;
    // Strain, stress before, total and stress of the body, and fields of the answer.
    let of_yielding = (VECTORS + 4) * field + anderson;
    bodies * (operators + 3 * field) + yielding * of_yielding
}
