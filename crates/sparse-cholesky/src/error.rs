//! Why a matrix has no factor.

use thiserror::Error;

/// Why a matrix has no Cholesky factor.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum FactorizationError {
    /// An entry is NaN or infinite.
    #[error("the matrix has an entry that is not finite")]
    NotFinite,
    /// A pivot is not positive: the matrix is singular or indefinite.
    #[error("the matrix is not positive definite at equation {equation}")]
    NotPositiveDefinite {
        /// Position in elimination order.
        equation: usize,
    },
    /// The caller stopped the factorization.
    #[error("the factorization was stopped")]
    Stopped,
    /// The factor has more entries than can be indexed, or memory is short.
    #[error("the factor is too large")]
    TooLarge,
}
