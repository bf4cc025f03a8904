//! Solves a problem: each load first on a grid of half the cells, then on the grid of all cells.

use super::engine::{Answer, GridDesign, HalfSpaceEngine};
use super::history::OnTwoGrids;
use super::problem::HalfSpaceProblem;
use super::search;
use super::step::HalfSpaceStep;
use crate::contact::ContactLoad;
use crate::job::Theory;
use crate::solver::loads::{Loads, loads};
use crate::solver::method::couplings::iteration::Controls;
use crate::solver::method::final_check::LeastScales;
use crate::solver::method::history;
use crate::solver::method::observer::{Interrupt, Observer};
use crate::solver::method::phases::PhaseTimes;
use crate::solver::method::run::Run;
use crate::solver::method::solve::solve;
use crate::solver::method::steps::{StepReceiver, each_load};
use crate::solver::{SolveError, SolveStatus};

/// Cells over a semi-axis, and tolerance, of the solve that determines the contact size.
const SIZING_CELLS: f64 = 4.0;
const SIZING_TOLERANCE: f64 = 1e-3;

/// Times, counts and the end of a run, beside its steps.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct HalfSpaceRun {
    /// Wall time by phase.
    pub phases: PhaseTimes,
    /// Number of grids built.
    pub grids: usize,
    /// Why the run ended before the last load.
    pub interrupted: Option<Interrupt>,
    /// Relative change of the sought figure over the relative change of the force; `None` where
    /// the loads are given.
    pub sensitivity: Option<f64>,
}

/// Solves the loads of a problem, or searches for the force of a sought figure. By flow theory
/// each load starts from the state after the load before.
///
/// # Errors
/// [`SolveError`]. An iteration that does not converge is no error: its step has the
/// [`SolveStatus`].
pub fn run_each(
    problem: &HalfSpaceProblem,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<HalfSpaceStep>,
) -> Result<HalfSpaceRun, SolveError> {
    let mut done = HalfSpaceRun::default();
    let mut run = Run { phases: &mut done.phases, passes: &mut done.grids, observer };
    match loads(&problem.load) {
        Loads::Given(loads) => done.interrupted = given(problem, &loads, &mut run, receiver)?,
        Loads::Sought(sought) => {
            let (steps, sensitivity) = search::run(problem, sought, &mut run)?;
            for step in steps {
                receiver.step(step, run.observer);
            }
            done.sensitivity = Some(sensitivity);
        }
    }
    Ok(done)
}

/// Solves given loads in their order.
pub(super) fn given(
    problem: &HalfSpaceProblem,
    loads: &[ContactLoad],
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<HalfSpaceStep>,
) -> Result<Option<Interrupt>, SolveError> {
    if problem.solver.theory == Theory::Flow {
        let bodies = OnTwoGrids { problem, loads };
        return history::run(&bodies, loads, problem.solver.increments, run, receiver);
    }
    each_load(loads, receiver, run, |load, _, run| step(problem, load, run))
}

/// Solves one load by deformation theory and estimates the errors of its figures.
fn step(
    problem: &HalfSpaceProblem,
    load: ContactLoad,
    run: &mut Run<'_>,
) -> Result<HalfSpaceStep, SolveError> {
    let engine =
        HalfSpaceEngine::auxiliary(problem, Theory::Deformation, problem.solver.tolerance.get());
    let design = size(problem, load, run)?;
    let (coarse, design) = run.preliminarily(|run| {
        under(&engine, load, design.with_cells(0.5 * problem.cells()), run)
    })?;
    interrupted(coarse.status)?;
    let engine = HalfSpaceEngine::new(problem, Theory::Deformation);
    let (mut fine, _) = under(&engine, load, design.with_cells(problem.cells()), run)?;
    if coarse.status == SolveStatus::Converged {
        fine.errors = fine.errors_beside(&coarse.figures);
    }
    Ok(fine)
}

/// Returns a first grid. Its size follows from the contact size of elastic bodies or, if a body
/// can yield, from a solve on few cells.
pub(super) fn size(
    problem: &HalfSpaceProblem,
    load: ContactLoad,
    run: &mut Run<'_>,
) -> Result<GridDesign, SolveError> {
    let design = GridDesign::new(
        problem.expected(load).ok_or(SolveError::NoLoad)?.bearable()?,
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
fn under(
    engine: &HalfSpaceEngine<'_>,
    load: ContactLoad,
    design: GridDesign,
    run: &mut Run<'_>,
) -> Result<(HalfSpaceStep, GridDesign), SolveError> {
    let answer: Answer = solve(engine, design, None, run, |grid, system, start, run| {
        grid.solve(system, start, engine.coupling, Controls { load, ..engine.controls() }, run)
    })?;
    let fitted =
        answer.system.design.fitted(&answer.system, &answer.outcome.state.response.contact.force);
    Ok((answer.step(engine, load, [0.0; 2], LeastScales::default(), run), fitted))
}

/// Returns an error if the observer stopped an auxiliary solve, which has no step to report.
fn interrupted(status: SolveStatus) -> Result<(), SolveError> {
    status.interrupt().map_or(Ok(()), |interrupt| Err(SolveError::Interrupted(interrupt)))
}
