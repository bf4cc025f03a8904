//! Given loads: each first on a grid of half the cells, then on the grid of all cells.

use super::engine::HalfSpaceEngine;
use super::error::HalfSpaceError;
use super::history::coarse;
use super::problem::HalfSpaceProblem;
use super::sizing::{interrupted, size, under};
use super::step::{HalfSpaceField, HalfSpaceStep};
use brinell_contact::ContactLoad;
use brinell_method::history;
use brinell_method::loads::each_load;
use brinell_method::observer::Interrupt;
use brinell_method::observer::SolveStatus;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::steps::StepReceiver;

/// Solves given loads in their order.
pub(super) fn given(
    problem: &HalfSpaceProblem,
    loads: &[ContactLoad],
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<HalfSpaceField>,
) -> Result<Option<Interrupt>, HalfSpaceError> {
    if problem.solver.theory == Theory::Flow {
        let coarse = coarse(problem, loads, run)?;
        return history::run(coarse, loads, problem.solver.increments, run, receiver);
    }
    each_load(loads, receiver, run, |load, _, run| step(problem, load, run))
}

/// Solves one load by deformation theory and estimates the errors of its figures.
fn step(
    problem: &HalfSpaceProblem,
    load: ContactLoad,
    run: &mut Run<'_>,
) -> Result<HalfSpaceStep, HalfSpaceError> {
    let engine =
        HalfSpaceEngine::auxiliary(problem, Theory::Deformation, problem.solver.tolerance);
    let design = size(problem, load, run)?;
    let (coarse, design) = run.preliminarily(|run| {
        under(&engine, load, design.with_cells(0.5 * problem.cells()), run)
    })?;
    interrupted(coarse.status)?;
    let engine = HalfSpaceEngine::new(problem, Theory::Deformation);
    let (mut fine, _) = under(&engine, load, design.with_cells(problem.cells()), run)?;
    if coarse.status == SolveStatus::Converged {
        fine.coarse = Some(coarse.figures);
    }
    Ok(fine)
}
