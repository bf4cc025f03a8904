//! Why a contact problem has no answer.

use thiserror::Error;

/// Why a contact problem was refused or could not be solved.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ContactError {
    /// There are no candidate cells.
    #[error("the contact has no candidate cells")]
    NoCells,
    /// Flexibility and initial gaps describe different numbers of cells.
    #[error("the flexibility is of {expected} cells, but there are {found} initial gaps")]
    DimensionMismatch {
        /// Cells of the flexibility.
        expected: usize,
        /// Initial gaps.
        found: usize,
    },
    /// A NaN or an infinity in the data.
    #[error("the {0} holds a number that is not finite")]
    NotFinite(&'static str),
    /// The bodies cannot be pulled together: frictionless contact transmits no tension.
    #[error("the contact force must not be negative, got {0}")]
    NegativeForce(f64),
    /// A direction along which the elastic energy does not grow.
    #[error("the flexibility is not positive definite: the energy of a direction is {energy:e}")]
    NotPositiveDefinite {
        /// `tᵀF t` \[N mm\].
        energy: f64,
    },
}
