//! Grid and memory of a problem, estimated before it is solved.

use crate::EllipticContact;

use super::design::GridDesign;
use super::error::HalfSpaceError;
use super::operators::bytes;
use super::problem::{Expected, HalfSpaceProblem};
use brinell_contact::ContactLoad;
use brinell_method::sought::{Loads, Sought, Target, TargetFigure, largest_loads};

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
/// Peak over mean pressure of Hertz's ellipse.
const PEAK_OF_MEAN: f64 = 1.5;

/// Estimates the grid that a problem asks for, and its memory.
///
/// # Errors
/// Those of a grid.
pub fn estimate(problem: &HalfSpaceProblem) -> Result<HalfSpaceEstimate, HalfSpaceError> {
    let mut design: Option<GridDesign> = None;
    for expected in of_loads(problem)? {
        let next = GridDesign::new(expected.bearable()?, problem.cells(), problem.cells());
        design = Some(design.map_or(next, |design| design.union(next)));
    }
    let design = design.ok_or(HalfSpaceError::Method(brinell_method::Error::NoLoad))?;
    let (grid, layers) = design.grid()?;
    let bytes = bytes(problem, &grid, &layers) as u64;
    Ok(HalfSpaceEstimate { cells: [grid.nx(), grid.ny()], layers: layers.len(), bytes })
}

/// Returns the expected contacts under the largest loads.
fn of_loads(problem: &HalfSpaceProblem) -> Result<Vec<Expected>, HalfSpaceError> {
    Ok(match &problem.loads {
        Loads::Each(loads) | Loads::History(loads) => {
            largest_loads(loads).into_iter().filter_map(|load| problem.expected(load)).collect()
        }
        Loads::Sought(sought) => {
            let first = problem.expected(ContactLoad::Force(first_force(problem, *sought)?));
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

/// Returns the force of the first trial \[N\].
///
/// # Errors
/// [`HalfSpaceError::NoYieldPoint`].
pub(super) fn first_force(
    problem: &HalfSpaceProblem,
    sought: Sought,
) -> Result<f64, HalfSpaceError> {
    let no_yield = HalfSpaceError::NoYieldPoint;
    match sought {
        Sought::Onset => problem.yield_force().ok_or(no_yield),
        Sought::Target(Target { figure: TargetFigure::HalfWidth, value }) => {
            let shorter = |hertz: &EllipticContact| hertz.semi_axis_x.min(hertz.semi_axis_y);
            Ok(problem.force_where(shorter, value, 3.0))
        }
        Sought::Target(_) => {
            let mean = sought.first_mean_pressure(problem.weakest()).ok_or(no_yield)?;
            Ok(problem.force_where(|hertz| hertz.peak_pressure, PEAK_OF_MEAN * mean, 3.0))
        }
    }
}
