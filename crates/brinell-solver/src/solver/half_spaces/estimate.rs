//! What a problem will take, before it is solved.

use brinell_halfspace::{DEVIATOR_COMPONENTS, HalfSpace, Layers, SurfaceGrid};

use super::engine::{GridDesign, is_symmetric};
use super::problem::{Expected, HalfSpaceProblem};
use super::search::first_force;
use crate::contact::ContactLoad;
use crate::solver::SolveError;
use crate::solver::loads::{Loads, Sought, largest_loads, loads};
use crate::solver::method::couplings::anderson::DEPTH;

/// Part of the cells that flows.
const FLOWING: f64 = 0.25;
/// Vectors of all cells that a solve holds beside those of a body: initial stress, its image,
/// trials, accepted state.
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

/// Overload for which a search for a force is prepared.
const SEARCHED_OVERLOAD: f64 = 12.0;

/// Estimates the grid that a problem asks for, and its memory.
///
/// # Errors
/// Those of a grid.
pub fn estimate(problem: &HalfSpaceProblem) -> Result<HalfSpaceEstimate, SolveError> {
    let mut design: Option<GridDesign> = None;
    for expected in of_loads(problem)? {
        let next = GridDesign::new(expected.bearable()?, problem.cells(), problem.cells());
        design = Some(design.map_or(next, |design| design.union(next)));
    }
    let design = design.ok_or(SolveError::NoLoad)?;
    let (grid, layers) = design.grid()?;
    let bytes = bytes(problem, &grid, &layers) as u64;
    Ok(HalfSpaceEstimate { cells: [grid.nx(), grid.ny()], layers: layers.len(), bytes })
}

/// What is expected under the largest loads.
fn of_loads(problem: &HalfSpaceProblem) -> Result<Vec<Expected>, SolveError> {
    Ok(match loads(&problem.load) {
        Loads::Given(loads) => {
            largest_loads(&loads).into_iter().filter_map(|load| problem.expected(load)).collect()
        }
        Loads::Sought(sought) => {
            let first = problem.expected(ContactLoad::Force(first_force(problem, sought)?));
            let overload = |first: f64| match sought {
                Sought::Onset => 0.0,
                Sought::Target(_) => first.max(SEARCHED_OVERLOAD),
            };
            let expected =
                |first: Expected| Expected { overload: overload(first.overload), ..first };
            first.map(expected).into_iter().collect()
        }
    })
}

/// Bytes that a solve on a grid holds.
pub(super) fn bytes(problem: &HalfSpaceProblem, grid: &SurfaceGrid, layers: &Layers) -> usize {
    let field = layers.len() * grid.n_cells() * DEVIATOR_COMPONENTS * size_of::<f64>();
    let is_symmetric = is_symmetric(problem, grid, layers, &problem.gap(grid));
    let operators = HalfSpace::bytes(grid, layers.len(), is_symmetric);
    let are_equal = problem.materials[0] == problem.materials[1];
    let bodies = if are_equal { 1 } else { problem.materials.iter().flatten().count() };
    let yielding = problem
        .materials
        .iter()
        .flatten()
        .filter(|material| material.plasticity().is_some())
        .count();
    let yielding = if are_equal { yielding.min(1) } else { yielding };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "bytes of a field"
    )]
    let anderson = (2.0 * (DEPTH + 2) as f64 * FLOWING * field as f64) as usize;
    // Strain, stress before, total and stress of the body, and fields of the answer.
    let of_yielding = (VECTORS + 4) * field + anderson;
    bodies * (operators + 3 * field) + yielding * of_yielding
}
