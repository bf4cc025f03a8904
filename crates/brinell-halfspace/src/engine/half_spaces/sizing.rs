//! The first grid of a load, and a load on a grid.

use super::design::GridDesign;
use super::engine::{Answer, HalfSpaceEngine};
use super::error::HalfSpaceError;
use super::problem::HalfSpaceProblem;
use super::step::HalfSpaceStep;
use brinell_contact::ContactLoad;
use brinell_method::couplings::iteration::Controls;
use brinell_method::final_check::LeastScales;
use brinell_method::observer::SolveStatus;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::solve::solve;

/// Cells over a semi-axis, and tolerance, of the solve that determines the contact size.
const SIZING_CELLS: f64 = 4.0;
const SIZING_TOLERANCE: f64 = 1e-3;

/// Returns a first grid. Its size follows from the contact size of elastic bodies or, if a body
/// can yield, from a solve on few cells.
pub(super) fn size(
    problem: &HalfSpaceProblem,
    load: ContactLoad,
    run: &mut Run<'_>,
) -> Result<GridDesign, HalfSpaceError> {
    let design = GridDesign::new(
        problem
            .expected(load)
            .ok_or(HalfSpaceError::Method(brinell_method::Error::NoLoad))?
            .bearable()?,
        SIZING_CELLS,
        problem.cells(),
    );
    if problem.heights.is_some() || !problem.can_yield() {
        return Ok(design);
    }
    let engine = HalfSpaceEngine::auxiliary(problem, Theory::Deformation, SIZING_TOLERANCE);
    let (found, design) = run.preliminarily(|run| under(&engine, load, design, run))?;
    interrupted(found.status)?;
    Ok(design)
}

/// Solves one load from the undeformed state. Returns the step, and a design that fits the
/// contact.
pub(super) fn under(
    engine: &HalfSpaceEngine<'_>,
    load: ContactLoad,
    design: GridDesign,
    run: &mut Run<'_>,
) -> Result<(HalfSpaceStep, GridDesign), HalfSpaceError> {
    let answer: Answer = solve(engine, design, None, run, |grid, system, start, run| {
        grid.solve(system, start, engine.coupling, Controls { load, ..engine.controls() }, run)
    })?;
    let fitted = answer.system.fitted(&answer.outcome.state.response.contact.force);
    Ok((answer.step(engine, load, [0.0; 2], LeastScales::default(), run), fitted))
}

/// Returns an error if the observer stopped an auxiliary solve, which has no step to report.
pub(super) fn interrupted(status: SolveStatus) -> Result<(), HalfSpaceError> {
    status.interrupt().map_or(Ok(()), |interrupt| {
        Err(HalfSpaceError::Method(brinell_method::Error::Interrupted(interrupt)))
    })
}
