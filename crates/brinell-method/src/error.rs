//! Why the alternation has no answer.

use brinell_contact::ContactError;
use sparse_cholesky::FactorizationError;

use crate::force_search::Unreachable;
use crate::observer::Interrupt;

/// Why the alternation has no answer. The error type of each engine converts from this one.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// The factorization has failed.
    #[error(transparent)]
    Factorization(#[from] FactorizationError),
    /// The contact solve has failed.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A history without a load.
    #[error("none of the loads is above zero")]
    NoLoad,
    /// No force gives the figure of the contact its wanted value.
    #[error("no force gives the contact what the job asks for")]
    Unreachable(Unreachable),
    /// The bodies have no stiffness that could take secant moduli.
    #[error("the coupling by secant stiffness needs bodies whose stiffness is assembled")]
    NoSecantStiffness,
    /// Stopped before there was anything to report.
    #[error("stopped before the first iteration")]
    Interrupted(Interrupt),
}

/// Errors of which an observer's request to stop may be the cause.
pub trait Interrupted {
    /// Why the observer stopped the solve, if it did.
    fn interrupt(&self) -> Option<Interrupt>;
}

impl Interrupted for Error {
    fn interrupt(&self) -> Option<Interrupt> {
        match self {
            Self::Interrupted(interrupt) => Some(*interrupt),
            _ => None,
        }
    }
}
