//! From two bodies and their loads to the solution.

use std::sync::Arc;

use super::force_search;
use super::load_sequence::LoadSequence;
use crate::element::StressState;
use crate::engine::body_system::factor_cache::FactorCache;
use crate::engine::error::MeshedError;
use crate::engine::meshed_contact::{Asked, MeshedContact};
use crate::engine::problem::{ModelOf, Problem, flow_theory};
use crate::engine::solution::{SectionField, Solution, StepSolution};
use brinell_contact::{ContactLoad, ContactSolver};
use brinell_method::observer::Observer;
use brinell_method::observer::SolveStatus;
use brinell_method::run::Run;
use brinell_method::settings::Theory;
use brinell_method::slope::Slopes;
use brinell_method::slope::reached;
use brinell_method::sought::{Loads, history_of};
use brinell_method::steps::StepReceiver;

/// Options beyond the wire format: for the service, for verification, and for trying out methods.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// Whether a symmetric problem is solved on one half. Default true.
    pub use_symmetry: bool,
    /// Contact method of the final mesh in place of the one that is asked for.
    pub contact_solver: Option<&'a dyn ContactSolver>,
    /// Bodies and factors that other jobs have left and this one leaves. Default none.
    pub cache: Option<&'a Arc<FactorCache>>,
    /// Makes the constitutive model of a material in place of the theory that is asked for.
    /// Default none.
    pub model: Option<ModelOf>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { use_symmetry: true, contact_solver: None, cache: None, model: None }
    }
}

/// Solves a contact and hands over each step as soon as it is finished, so that a long sweep need
/// not be kept in memory. The solution that is returned has none.
///
/// Small meshes find out how wide the contact is: four for the default job. One of half the
/// requested density follows, for error estimates, and then the one that was asked for. Only the last
/// is shown to the observer iteration by iteration; the others can be stopped. The loads of a
/// sweep share meshes and factors while the contact fits on them, and each starts from the state
/// of the one before.
///
/// # Errors
/// [`MeshedError`]. An iteration that does not converge is no error: see
/// [`brinell_method::observer::SolveStatus`].
pub fn run_each(
    contact: &MeshedContact,
    options: Options<'_>,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<SectionField>,
) -> Result<Solution, MeshedError> {
    let MeshedContact { problem, loads, asked, elements_of_slopes } = contact;
    let Some(elements) = *elements_of_slopes else {
        return solve(problem, loads, *asked, options, observer, receiver);
    };
    let mut under = |loads: &[ContactLoad], observer: &mut dyn Observer| {
        let Some(loads) = history_of(loads) else { return Ok(None) };
        let small = Asked { elements, ..*asked };
        let mut steps: Vec<StepSolution> = Vec::new();
        let solution = solve(problem, &loads, small, options, observer, &mut steps);
        let interrupt = solution.map(|solution| solution.interrupted);
        reached(&interrupt, &steps)
    };
    let is_history = asked.solver.theory == Theory::Flow && !matches!(loads, Loads::Each(_));
    let mut slopes = Slopes::new(receiver, lacks_slope, is_history, &mut under);
    solve(problem, loads, *asked, options, observer, &mut slopes)
}

/// Returns whether a step has a slope that is not known yet.
fn lacks_slope(step: &StepSolution) -> bool {
    let flows_freely = step.field.stress_state == StressState::PlaneStress
        && step.field.bodies.iter().flatten().any(|body| body.bounded_plastic_strain().is_none());
    step.status == SolveStatus::Converged && step.contact_stiffness.is_none() && !flows_freely
}

/// Solves a contact.
fn solve(
    problem: &Problem,
    loads: &Loads,
    asked: Asked,
    options: Options<'_>,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<SectionField>,
) -> Result<Solution, MeshedError> {
    let whole = (!options.use_symmetry).then(|| problem.as_whole());
    let problem = whole.as_ref().unwrap_or(problem);
    let contact = options.contact_solver.unwrap_or(asked.solver.contact);
    let model = options.model.or((asked.solver.theory == Theory::Flow).then_some(flow_theory));
    let with_memory = model.map(|model| problem.with_models(model));
    let (with_memory, cache) = (with_memory.as_ref(), options.cache);
    let sequence = LoadSequence { problem, with_memory, asked, contact, cache };
    let mut solution = Solution::default();
    let mut run = Run::new(&mut solution.phases, &mut solution.passes, observer);
    match loads {
        Loads::Each(loads) => {
            solution.interrupted = sequence.solve_each(loads, &mut run, receiver)?;
        }
        Loads::History(loads) => {
            solution.interrupted = sequence.solve(loads, &mut run, receiver)?;
        }
        Loads::Sought(sought) => {
            let (steps, sensitivity) = force_search::run(*sought, &sequence, &mut run)?;
            for step in steps {
                receiver.step(step, run.observer);
            }
            solution.sensitivity = Some(sensitivity);
        }
    }
    Ok(solution)
}
