//! Why a job has no solution to report.

use std::ops::ControlFlow;

use thiserror::Error;

use crate::contact::ContactError;
use crate::fem::mesh::MeshError;
use crate::solver::observer::{Interrupt, Observer};
use sparse_cholesky::FactorizationError;

/// Why a job has no solution to report.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SolveError {
    /// No mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// No factor.
    #[error(transparent)]
    Factorization(#[from] FactorizationError),
    /// No contact solution.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The load would spread the contact over too much of the bodies.
    #[error(
        "the contact would reach about {half_width:.4} mm to each side on a surface that spans {available:.4} mm; \
         small-displacement contact theory does not carry that far: reduce the load"
    )]
    TooWide {
        /// Expected half-width \[mm\].
        half_width: f64,
        /// Half-span of the narrower surface \[mm\].
        available: f64,
    },
    /// The surfaces do not open away from the contact.
    #[error("the surfaces do not open away from where they first touch; conforming contacts are not solved")]
    Conforming,
    /// The onset of yield is sought of bodies that do not yield, or do from the first load on.
    #[error("neither body has a yield stress, so there is no onset of yield to find")]
    NoYieldPoint,
    /// A history without a load.
    #[error("none of the loads is above zero")]
    NoLoad,
    /// Stopped before there was anything to report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
}

/// Asks the observer whether to stop.
pub(crate) fn checkpoint(observer: &mut dyn Observer) -> Result<(), SolveError> {
    match observer.on_checkpoint() {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(interrupt) => Err(SolveError::Interrupted(interrupt)),
    }
}
