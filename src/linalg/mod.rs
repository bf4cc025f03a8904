//! Sparse and dense linear algebra; nothing in here knows mechanics.
//!
//! The one heavy operation of a job is the sparse Cholesky factorization `K = L Lᵀ` of each body's elastic
//! stiffness. This module arranges the equations so that everything after it is cheap:
//!
//! - [`EliminationOrder`] numbers them by nested dissection, with a *window* (the equations an iteration loads
//!   or reads) after everything else and the *trailing* ones (contact normals) last of all;
//! - [`Cholesky::solve_restricted`] and its parts run over the columns of `L` that belong to the window;
//! - [`Cholesky::trailing_inverse`] reads the flexibility of the trailing equations off the last block of `L`.
//!
//! This is the only module that names the library that factorizes.

mod cholesky;
pub mod dense;
mod elimination;
mod factorization;
mod graph;
mod nested_dissection;
mod pattern;
mod wide;

pub use cholesky::{Cholesky, FactorizationError, Reach, SymbolicCholesky};
pub use elimination::EliminationOrder;
pub use graph::Graph;
pub use nested_dissection::LatticePoint;
pub use pattern::SymmetricPattern;
pub(crate) use wide::{dot, wide};
