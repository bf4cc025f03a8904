//! Jobs between bodies that are meshed: plane ones, and bodies of revolution.

use super::error::SolveError;
use super::outline::outlines_of;
use super::settings::{loads, settings};
use super::slopes::of_slopes;
use crate::fem::assembly;
use crate::fem::element::StressState;
use crate::fem::mesh::Outline;
use crate::job::{Analysis, Body, FarSupport, Job, Shape};
use crate::material::Solid;
use crate::solver::{
    Asked, ElasticReference, GivenBody, MeshedContact, Observer, Options, Problem, Solution,
    run_each,
};

/// Returns the bodies of a job, their loads, and how they are solved.
pub(crate) fn meshed_contact(job: &Job) -> MeshedContact {
    MeshedContact {
        problem: problem(job),
        loads: loads(&job.load),
        asked: Asked { elements: job.mesh.elements_per_half_width, solver: settings(job) },
        elements_of_slopes: of_slopes(job),
    }
}

/// Returns both bodies of a job.
pub(super) fn problem(job: &Job) -> Problem {
    let stress_state = match job.analysis {
        Analysis::PlaneStrain => StressState::PlaneStrain,
        Analysis::PlaneStress => StressState::PlaneStress,
        // Half-spaces have no stress state of their own.
        Analysis::Axisymmetric | Analysis::ThreeDimensional => StressState::Axisymmetric,
    };
    let [upper, lower] = outlines_of([&job.upper.shape, &job.lower.shape]);
    Problem::new(stress_state, [given(&job.upper, upper), given(&job.lower, lower)])
}

/// Returns the support of a body.
pub const fn support(of_body: FarSupport) -> assembly::Support {
    match of_body {
        FarSupport::Clamped => assembly::Support::Clamped,
        FarSupport::Roller => assembly::Support::Roller,
    }
}

fn given(body: &Body, outline: Outline) -> GivenBody {
    GivenBody {
        outline,
        material: body.deformable().map(Solid::from),
        support: support(body.support),
        interpolation_is_open: matches!(
            &body.shape,
            Shape::Profile(profile) if profile.interpolation.is_none()
        ),
    }
}

/// Returns the elastic contact of a job in closed form under a force \[N/mm, or N in
/// axisymmetry\]; `None` where Hertz's theory does not apply, and for half-spaces.
pub fn elastic_reference(job: &Job, force: f64) -> Option<ElasticReference> {
    if job.analysis == Analysis::ThreeDimensional {
        return None;
    }
    ElasticReference::of(&problem(job), force)
}

/// Solves a job.
///
/// # Errors
/// [`SolveError`]. An iteration that does not converge is no error: see
/// [`SolveStatus`](crate::solver::SolveStatus).
pub fn run(job: &Job, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    run_with(job, Options::default(), observer)
}

/// Solves a job with options.
///
/// # Errors
/// As [`run`].
pub fn run_with(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
) -> Result<Solution, SolveError> {
    let mut steps = Vec::new();
    let solution = run_each(&meshed_contact(job), options, observer, &mut steps)?;
    Ok(Solution { steps, ..solution })
}
