//! Sparse and dense linear algebra; nothing in here knows mechanics.
//!
//! The one heavy operation of a job is the sparse Cholesky factorization `K = L Lᵀ` of each body's stiffness. This
//! crate makes it possible to stop it, and arranges the equations so that everything after it is cheap:
//!
//! - [`EliminationOrder`] numbers the nodes by nested dissection, the *trailing* ones (in contact) after all others;
//! - [`Cholesky::refactor`] factorizes in place and asks now and then whether to go on;
//! - [`Cholesky::solve_restricted`] and its parts run over the supernodes of a *window* (the equations an iteration
//!   loads or reads) and their ancestors, its [`Reach`];
//! - [`Cholesky::trailing_inverse`] reads the flexibility of the trailing equations off the last block of `L`.
//!
//! This is the only crate that names the library for symbolic analysis and dense kernels.

mod cholesky;
mod cores;
pub mod dense;
mod elimination;
mod factorization;
mod graph;
mod nested_dissection;
mod panel;
mod pattern;
mod subtrees;
mod wide;

pub use cholesky::{Cholesky, FactorizationError, Reach, SymbolicCholesky};
pub use cores::share;
pub use cores::{Cores, OccupiedCore};
pub use elimination::EliminationOrder;
pub use graph::Graph;
pub use nested_dissection::LatticePoint;
pub use pattern::SymmetricPattern;
pub use wide::{dot, wide};
