//! Solves a problem: its given loads, or the force of a sought figure.

use super::error::HalfSpaceError;
use super::given::{each, given};
use super::problem::HalfSpaceProblem;
use super::search;
use super::step::{HalfSpaceField, HalfSpaceStep};
use brinell_contact::ContactLoad;
use brinell_method::observer::SolveStatus;
use brinell_method::observer::{Interrupt, Observer};
use brinell_method::phases::PhaseTimes;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::slope::Slopes;
use brinell_method::slope::reached;
use brinell_method::sought::{Loads, history_of};
use brinell_method::steps::StepReceiver;

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
/// each load of a history starts from the state after the load before.
///
/// # Errors
/// [`HalfSpaceError`]. An iteration that does not converge is no error: its step has the
/// [`SolveStatus`].
pub fn run_each(
    problem: &HalfSpaceProblem,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<HalfSpaceField>,
) -> Result<HalfSpaceRun, HalfSpaceError> {
    let Some(cells_per_semi_axis) = problem.cells_of_slopes else {
        return solve(problem, observer, receiver);
    };
    let mut under = |loads: &[ContactLoad], observer: &mut dyn Observer| {
        let Some(loads) = history_of(loads) else { return Ok(None) };
        let problem = HalfSpaceProblem { loads, cells_per_semi_axis, ..problem.clone() };
        let mut steps: Vec<HalfSpaceStep> = Vec::new();
        let interrupt = solve(&problem, observer, &mut steps).map(|done| done.interrupted);
        reached(&interrupt, &steps)
    };
    let is_history =
        problem.solver.theory == Theory::Flow && !matches!(problem.loads, Loads::Each(_));
    solve(problem, observer, &mut Slopes::new(receiver, lacks_slope, is_history, &mut under))
}

/// Returns whether a step has a slope that is not known yet. Bodies that do not flow have one in
/// closed form.
fn lacks_slope(step: &HalfSpaceStep) -> bool {
    step.status == SolveStatus::Converged && step.path.flows
}

fn solve(
    problem: &HalfSpaceProblem,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<HalfSpaceField>,
) -> Result<HalfSpaceRun, HalfSpaceError> {
    let mut done = HalfSpaceRun::default();
    let mut run = Run { phases: &mut done.phases, passes: &mut done.grids, observer };
    match &problem.loads {
        Loads::Each(loads) => done.interrupted = each(problem, loads, &mut run, receiver)?,
        Loads::History(loads) => done.interrupted = given(problem, loads, &mut run, receiver)?,
        Loads::Sought(sought) => {
            let (steps, sensitivity) = search::run(problem, *sought, &mut run)?;
            for step in steps {
                receiver.step(step, run.observer);
            }
            done.sensitivity = Some(sensitivity);
        }
    }
    Ok(done)
}
