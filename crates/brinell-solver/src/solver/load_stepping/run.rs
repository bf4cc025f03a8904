//! From a job to its solution.

use std::sync::Arc;

use super::force_search;
use super::load_sequence::LoadSequence;
use crate::contact::{ActiveSetSolver, ContactLoad, ContactSolver, SimplexSolver};
use crate::fem::element::StressState;
use crate::job::{ContactMethod, Job, Theory};
use crate::solver::body_system::factor_cache::FactorCache;
use crate::solver::loads::{Loads, loads};
use crate::solver::method::observer::Observer;
use crate::solver::method::run::Run;
use crate::solver::method::slope::Slopes;
use crate::solver::method::steps::StepReceiver;
use crate::solver::problem::{ModelOf, Problem, flow_theory};
use crate::solver::slopes::{reached, small_job};
use crate::solver::solution::{SectionField, Solution, StepSolution};
use crate::solver::{SolveError, SolveStatus};

/// What the wire format does not offer: for the service, for verification, and for trying out
/// methods.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// Whether a symmetric problem is solved on one half. Default true.
    pub use_symmetry: bool,
    /// Contact method of the final mesh in place of the one that the job names.
    pub contact_solver: Option<&'a dyn ContactSolver>,
    /// Bodies and factors that other jobs have left and this one leaves. Default none.
    pub cache: Option<&'a Arc<FactorCache>>,
    /// Makes the constitutive model of a material in place of the theory that the job names.
    /// Default none.
    pub model: Option<ModelOf>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { use_symmetry: true, contact_solver: None, cache: None, model: None }
    }
}

/// Solves a job.
///
/// Three meshes: a small one that finds out how wide the contact is, one of half the requested
/// density for error estimates, and the one that was asked for. Only the last is shown to the
/// observer iteration by iteration; the others can be stopped. The loads of a sweep share meshes
/// and factors while the contact fits on them, and each starts from the state of the one before.
///
/// # Errors
/// [`SolveError`]. An iteration that does not converge is no error: see
/// [`crate::solver::SolveStatus`].
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    run_with(job, Options::default(), observer)
}

/// [`run`] with options.
///
/// # Errors
/// As [`run`].
pub fn run_with(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
) -> Result<Solution, SolveError> {
    let mut steps = Vec::new();
    let solution = run_each(job, options, observer, &mut steps)?;
    Ok(Solution { steps, ..solution })
}

/// [`run_with`] that hands over each step as soon as it is finished, so that a long sweep need not
/// be kept in memory. The solution that is returned has none.
///
/// # Errors
/// As [`run`].
pub fn run_each(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<SectionField>,
) -> Result<Solution, SolveError> {
    if !job.output.contact_stiffness {
        return solve(job, options, true, observer, receiver);
    }
    let mut under = |loads: &[ContactLoad], observer: &mut dyn Observer| {
        let Some(job) = small_job(job, loads) else { return Ok(None) };
        let mut steps: Vec<StepSolution> = Vec::new();
        let solution = solve(&job, options, false, observer, &mut steps);
        let interrupt = solution.map(|solution| solution.interrupted);
        reached(&interrupt, &steps)
    };
    let is_history = job.solver.theory == Theory::Flow;
    let slopes = &mut Slopes::new(receiver, lacks_slope, is_history, &mut under);
    solve(job, options, true, observer, slopes)
}

/// Returns whether a step has a slope that is not known yet.
fn lacks_slope(step: &StepSolution) -> bool {
    let flows_freely = step.field.stress_state == StressState::PlaneStress
        && step.field.bodies.iter().flatten().any(|body| body.bounded_plastic_strain().is_none());
    step.status == SolveStatus::Converged && step.contact_stiffness.is_none() && !flows_freely
}

/// Solves a job. `tells_bias` compares deformation theory with flow theory.
fn solve(
    job: &Job,
    options: Options<'_>,
    tells_bias: bool,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<SectionField>,
) -> Result<Solution, SolveError> {
    let mut problem = Problem::of(job);
    problem.use_symmetry = options.use_symmetry;
    let contact = options.contact_solver.unwrap_or(match job.solver.contact {
        ContactMethod::ActiveSet => &ActiveSetSolver,
        ContactMethod::Simplex => &SimplexSolver,
    });
    let model = options.model.or((job.solver.theory == Theory::Flow).then_some(flow_theory));
    let with_memory = model.map(|model| {
        let mut bodies = Problem::with_models(job, model);
        bodies.use_symmetry = options.use_symmetry;
        bodies
    });
    let (with_memory, cache) = (with_memory.as_ref(), options.cache);
    let tells_bias = tells_bias && options.model.is_none();
    let sequence =
        LoadSequence { problem: &problem, with_memory, job, contact, cache, tells_bias };
    let mut solution = Solution::default();
    let mut run = Run::new(&mut solution.phases, &mut solution.passes, observer);
    match loads(&job.load) {
        Loads::Given(loads) => {
            solution.interrupted = sequence.solve(&loads, &mut run, receiver)?;
        }
        Loads::Sought(sought) => {
            let (steps, sensitivity) = force_search::run(sought, &sequence, &mut run)?;
            for step in steps {
                receiver.step(step, run.observer);
            }
            solution.sensitivity = Some(sensitivity);
        }
    }
    Ok(solution)
}
