//! Given loads: each first on a grid of half the cells, then on the grid of all cells.

use super::engine::HalfSpaceEngine;
use super::error::HalfSpaceError;
use super::extrapolation::{Extrapolated, extrapolated};
use super::history::{coarse, contact_growth};
use super::problem::HalfSpaceProblem;
use super::sizing::{interrupted, size, under};
use super::step::{HalfSpaceField, HalfSpaceStep};
use brinell_contact::ContactLoad;
use brinell_method::history;
use brinell_method::loads::{Stretch, each_from_rest, each_load};
use brinell_method::observer::Interrupt;
use brinell_method::observer::SolveStatus;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::steps::StepReceiver;

/// Cells over the shorter semi-axis under the first load of a history, at least: from so many on a
/// grid is not called coarse. Where fewer are asked for, the contact may still grow by
/// `LEAST_GROWTH`.
const FEWEST_OF_FIRST: f64 = 5.5;
const LEAST_GROWTH: f64 = 1.25;

/// Solves loads that are each applied to bodies at rest.
pub(super) fn each(
    problem: &HalfSpaceProblem,
    loads: &[ContactLoad],
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<HalfSpaceField>,
) -> Result<Option<Interrupt>, HalfSpaceError> {
    if problem.solver.theory == Theory::Deformation {
        return given(problem, loads, run, receiver);
    }
    let most = (problem.cells() / FEWEST_OF_FIRST).max(LEAST_GROWTH);
    let serves = |first, load| contact_growth(first, load) <= most;
    each_from_rest(loads, receiver, run, serves, |stretch, run, receiver| {
        history(problem, stretch, run, receiver)
    })
}

/// Solves loads one after the other.
pub(super) fn given(
    problem: &HalfSpaceProblem,
    loads: &[ContactLoad],
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<HalfSpaceField>,
) -> Result<Option<Interrupt>, HalfSpaceError> {
    if problem.solver.theory == Theory::Flow {
        return history(problem, Stretch::whole(loads), run, receiver);
    }
    each_load(loads, receiver, run, |load, _, run| step(problem, load, run))
}

fn history(
    problem: &HalfSpaceProblem,
    stretch: Stretch<'_>,
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<HalfSpaceField>,
) -> Result<Option<Interrupt>, HalfSpaceError> {
    let coarse = coarse(problem, stretch.loads, run)?;
    let mut receiver = Extrapolated(receiver);
    history::run(coarse, stretch, problem.solver.increments, run, &mut receiver)
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
    Ok(extrapolated(fine))
}
