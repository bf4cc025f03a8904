//! Dense symmetric matrices with their Cholesky factorization, and plain loops for the vector
//! units of the machine.
//!
//! The arithmetic of factorizations is faer's. Sums run in a fixed order: results are the same on
//! every processor.

mod simd;
mod symmetric;

pub use simd::{dot, simd_dispatch};
pub use symmetric::{
    DenseCholesky, NotPositiveDefinite, SizeMismatch, SymmetricMatrix, factorization_memory,
    factorize_in_place, inverse_of_factor,
};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
