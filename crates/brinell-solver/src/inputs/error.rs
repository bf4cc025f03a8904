//! Why a job has no solution to report.

use crate::solver::MeshedError;
use crate::solver::half_spaces::HalfSpaceError;
use crate::solver::method::Error;
use crate::solver::rolling::TrackError;

/// Why a job has no solution to report: the error of one of the engines.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// Of meshed bodies.
    #[error(transparent)]
    Meshed(#[from] MeshedError),
    /// Of half-spaces.
    #[error(transparent)]
    HalfSpaces(#[from] HalfSpaceError),
    /// A job in three dimensions between shapes that are no half-spaces.
    #[error("the shapes are no half-spaces")]
    NoHalfSpaces,
    /// Of a contact that rolls.
    #[error(transparent)]
    Track(#[from] TrackError),
}

impl SolveError {
    /// Returns the error of the alternation, which all engines have.
    pub const fn method(&self) -> Option<&Error> {
        match self {
            Self::Meshed(MeshedError::Method(error))
            | Self::HalfSpaces(HalfSpaceError::Method(error))
            | Self::Track(TrackError::Method(error)) => Some(error),
            _ => None,
        }
    }
}
