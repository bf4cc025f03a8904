//! The engine that solves a job, chosen once.

use super::error::SolveError;
use super::half_spaces::half_spaces_with_reference;
use super::plane::meshed_contact;
use super::rolling::{RollingInput, rolling};
use crate::job::{Analysis, Job, Load};
use crate::solver::MeshedContact;
use crate::solver::half_spaces::{EllipticReference, HalfSpaceProblem};

/// What an engine solves.
pub(crate) enum Input {
    /// Bodies that are meshed.
    Meshed(Box<MeshedContact>),
    /// Half-spaces, and their elastic contact.
    HalfSpaces(Box<(HalfSpaceProblem, EllipticReference)>),
    /// A load that rolls.
    Rolling(Box<RollingInput>),
}

/// Returns the contact of a job for its engine.
///
/// # Errors
/// [`SolveError::Track`] of a load that cannot roll, [`SolveError::NoHalfSpaces`].
pub(crate) fn of(job: &Job) -> Result<Input, SolveError> {
    Ok(match (&job.load, job.analysis) {
        (Load::Rolling(_), _) => Input::Rolling(Box::new(rolling(job)?)),
        (_, Analysis::ThreeDimensional) => {
            let contact = half_spaces_with_reference(job).ok_or(SolveError::NoHalfSpaces)?;
            Input::HalfSpaces(Box::new(contact))
        }
        _ => Input::Meshed(Box::new(meshed_contact(job))),
    })
}
