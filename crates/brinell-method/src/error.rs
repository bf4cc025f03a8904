//! Why the alternation has no answer.

use brinell_contact::ContactError;
use sparse_cholesky::FactorizationError;

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

/// Why the search has failed: no force gives the figure its wanted value.
#[derive(Debug, Clone, PartialEq)]
pub struct Unreachable {
    /// The nearest figure over its wanted value; for the onset of yield, the highest von Mises
    /// stress over the yield stress. Not a number where no force was solved.
    pub nearest: f64,
    /// The force of this nearest figure \[N/mm or N\].
    pub force: f64,
    /// The largest force that was solved \[N/mm or N\].
    pub largest_force: f64,
    /// The reason.
    pub reason: UnreachableReason,
}

/// Why no force gives the figure its wanted value.
#[derive(Debug, Clone, PartialEq)]
pub enum UnreachableReason {
    /// Larger forces cannot be solved.
    Limit(Limit),
    /// The figure is too small under the largest force.
    LargestForce,
    /// The figure is too large under the smallest force.
    SmallestForce,
    /// The figure is the same under all forces nearby.
    Insensitive,
}

/// Why larger forces cannot be solved.
#[derive(Debug, Clone, PartialEq)]
pub enum Limit {
    /// The contact has no room on the surfaces.
    NoRoom {
        /// Half-width of the contact zone \[mm\].
        half_width: f64,
        /// Half-span of the narrower surface \[mm\].
        available: f64,
    },
    /// A surface is too steep for a mesh.
    TooSteep {
        /// Where \[mm\].
        x: f64,
        /// Slope there.
        slope: f64,
    },
    /// Another reason, as the end of a sentence without a figure that has a unit.
    Other(String),
}

impl From<&str> for Limit {
    fn from(reason: &str) -> Self {
        Self::Other(reason.to_owned())
    }
}
