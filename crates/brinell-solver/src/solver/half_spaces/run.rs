//! Solves a problem: its given loads, or the force of a sought figure.

use super::given::given;
use super::problem::HalfSpaceProblem;
use super::search;
use super::step::HalfSpaceStep;
use crate::contact::ContactLoad;
use crate::job::Theory;
use crate::solver::loads::{Loads, history_of, loads};
use crate::solver::method::observer::{Interrupt, Observer};
use crate::solver::method::phases::PhaseTimes;
use crate::solver::method::run::Run;
use crate::solver::method::slope::{Loaded, OfStep, Slopes};
use crate::solver::method::steps::StepReceiver;
use crate::solver::slopes::reached;
use crate::solver::{SolveError, SolveStatus};

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
    let Some(cells_per_semi_axis) = problem.cells_of_slopes else {
        return solve(problem, observer, receiver);
    };
    let mut under = |loads: &[ContactLoad], observer: &mut dyn Observer| {
        let Some(load) = history_of(loads) else { return Ok(None) };
        let problem = HalfSpaceProblem { load, cells_per_semi_axis, ..problem.clone() };
        let mut steps: Vec<HalfSpaceStep> = Vec::new();
        let interrupt = solve(&problem, observer, &mut steps).map(|done| done.interrupted);
        reached(&interrupt, &steps, |step| [step.figures.force, step.figures.approach])
    };
    let of_step: OfStep<_> = (loaded, give_slope);
    let is_history = problem.solver.theory == Theory::Flow;
    solve(problem, observer, &mut Slopes::new(receiver, of_step, is_history, &mut under))
}

/// What has to be known of a step for its slope. Bodies that do not flow have one in closed form.
fn loaded(step: &HalfSpaceStep) -> Loaded {
    Loaded {
        load: step.load,
        reached: [step.figures.force, step.figures.approach],
        is_sought: step.status == SolveStatus::Converged && step.flows,
    }
}

fn give_slope(step: &mut HalfSpaceStep, slope: f64) {
    step.contact_stiffness = Some(slope);
}

fn solve(
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
