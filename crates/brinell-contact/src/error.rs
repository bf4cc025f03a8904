//! Why a contact problem has no answer.

use thiserror::Error;

/// Why a contact problem was refused or could not be solved.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ContactError {
    /// There are no candidate pairs.
    #[error("the contact has no candidate pairs")]
    NoPairs,
    /// Flexibility, initial gaps and normals describe different numbers of pairs.
    #[error("flexibility is of {expected} pairs, but there are {found} initial gaps or normals")]
    DimensionMismatch {
        /// Rows of the flexibility.
        expected: usize,
        /// Entries of the other list.
        found: usize,
    },
    /// The solver needs the entries of the flexibility, which has none.
    #[error("this contact solver needs the entries of the flexibility")]
    NoEntries,
    /// An approach that does not close a pair.
    #[error("the approach has to close every pair: the cosine of a normal to it is in (0, 1]")]
    NotClosing,
    /// A NaN or an infinity in the data.
    #[error("the {0} holds a number that is not finite")]
    NotFinite(&'static str),
    /// The bodies cannot be pulled together: frictionless contact transmits no tension.
    #[error("the contact force must not be negative, got {0}")]
    NegativeForce(f64),
    /// A direction along which the elastic energy does not grow.
    #[error("the flexibility is not positive definite: the energy of a direction is {energy:e}")]
    NoEnergy {
        /// `tᵀF t` \[N mm\].
        energy: f64,
    },
    /// The flexibility is not positive definite on the pairs in contact.
    #[error("the flexibility is not positive definite (pair {pair})")]
    NotPositiveDefinite {
        /// Pair at which the elimination stopped.
        pair: usize,
    },
    /// Nothing blocks the entering variable: the load can grow without limit, so F is not positive
    /// definite.
    #[error(
        "the simplex ended on a ray after {pivots} pivots: the flexibility is not positive \
         definite"
    )]
    Ray {
        /// Pivots made.
        pivots: usize,
    },
    /// The pivots exceed a limit far above the need of any known contact.
    #[error("the simplex did not finish within {limit} pivots")]
    PivotLimit {
        /// The limit.
        limit: usize,
    },
    /// Rounding led to an active set that violates the conditions.
    #[error(
        "the flexibility is too ill-conditioned: gaps are violated by {violation:e} of their scale"
    )]
    IllConditioned {
        /// Largest penetration relative to the terms it is the sum of.
        violation: f64,
    },
}
