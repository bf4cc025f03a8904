//! The contact stiffness of bodies that yield: the small meshes of its two loads, and what they
//! take.

use crate::contact::ContactLoad;
use crate::job::{Analysis, Job, MeshSettings, OutputSettings, Theory};
use crate::solver::SolveError;
use crate::solver::loads::history_of;
use crate::solver::method::observer::{Interrupt, SolveStatus};
use crate::solver::method::slope::Reached;
use crate::solver::method::steps::Step;

/// Elements over the half-width of the small meshes, and cells over the semi-axes of small grids.
const ELEMENTS: u32 = 12;
const CELLS: u32 = 8;
/// Relative error of the slope; in plane stress, where plastic flow gathers in bands.
pub(crate) const SLOPE_ERROR: f64 = 0.02;
pub(crate) const SLOPE_ERROR_IN_PLANE_STRESS: f64 = 0.05;

/// Elements over the half-width of the small meshes of a job, or cells over the semi-axes.
pub(crate) fn small(job: &Job) -> u32 {
    let most = if job.analysis == Analysis::ThreeDimensional { CELLS } else { ELEMENTS };
    job.mesh.elements_per_half_width.min(most)
}

/// What small meshes take of what a mesh of the job's own takes, of memory or of the work of one
/// solve; nothing where they are not made.
pub(crate) fn of_small_mesh(job: &Job, own: u64) -> u64 {
    let dimensions = if job.analysis == Analysis::ThreeDimensional { 3 } else { 2 };
    let of = |elements: u32| u64::from(elements).pow(dimensions);
    if job.output.contact_stiffness {
        own * of(small(job)) / of(job.mesh.elements_per_half_width)
    } else {
        0
    }
}

/// Small meshes that are solved for so many steps: under flow theory each with the loads before.
pub(crate) fn small_solves(job: &Job, steps: u64) -> u64 {
    let is_history = job.solver.theory == Theory::Flow;
    if is_history { steps * (steps + 1) } else { 2 * steps }
}

/// The job of loads on a small mesh.
pub(super) fn small_job(job: &Job, loads: &[ContactLoad]) -> Option<Job> {
    Some(Job {
        load: history_of(loads)?,
        mesh: MeshSettings { elements_per_half_width: small(job) },
        output: OutputSettings { contact_stiffness: false, ..job.output },
        ..job.clone()
    })
}

/// What the last of the loads on a small mesh reaches; `None` where one of them has no answer.
pub(super) fn reached<F>(
    interrupt: &Result<Option<Interrupt>, SolveError>,
    steps: &[Step<F>],
) -> Result<Option<Reached>, Interrupt> {
    let interrupt = match interrupt {
        Ok(interrupt) => *interrupt,
        Err(SolveError::Interrupted(interrupt)) => return Err(*interrupt),
        Err(_) => return Ok(None),
    };
    let stopped = || steps.iter().find_map(|step| step.status.interrupt());
    interrupt.or_else(stopped).map_or(Ok(()), Err)?;
    let is_converged = steps.iter().all(|step| step.status == SolveStatus::Converged);
    let last = steps.last().filter(|_| is_converged);
    Ok(last.map(|step| [step.figures.force, step.figures.approach]))
}
