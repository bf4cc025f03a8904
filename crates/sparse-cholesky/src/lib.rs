//! Sparse Cholesky factorization `A = L Lᵀ` that can be stopped and renewed in part, with solves
//! over parts of the factor.
//!
//! - [`EliminationOrder`] numbers the nodes of a mesh by nested dissection, chosen *trailing* ones
//!   after all others;
//! - [`SymbolicCholesky`] is the structure of the factor for a [`SymmetricPattern`];
//! - [`Cholesky::refactor`] computes only the supernodes that a change of the matrix reaches, and
//!   asks now and then whether to go on;
//! - [`Cholesky::solve_restricted`] and its two halves run over the supernodes of the equations
//!   that are loaded or read and their ancestors, their [`Reach`];
//! - [`Cholesky::trailing_inverse`] takes the last rows and columns of `A⁻¹` from the last
//!   diagonal block of `L`.
//!
//! The README has an example. Of the workspace this crate and `dense-cholesky` use faer.

mod cholesky;
mod elimination;
mod error;
mod factorization;
mod graph;
mod nested_dissection;
mod panel;
mod pattern;
mod symbolic;

pub use cholesky::Cholesky;
pub use elimination::EliminationOrder;
pub use error::FactorizationError;
pub use graph::Graph;
pub use nested_dissection::LatticePoint;
pub use pattern::SymmetricPattern;
pub use symbolic::{Reach, SymbolicCholesky};

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
