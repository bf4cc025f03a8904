//! The frictionless unilateral contact of two elastic bodies, reduced to their candidate node pairs.
//!
//! With n pairs, the flexibility `F = flexibility [mm/N]`, the equivalent initial gap
//! `g = initial_gap [mm]` along each pair's normal (geometry plus plastic displacement), the contact forces `R = force [N]`, the gap
//! after loading `δ = gap [mm]` and the `α = approach [mm]`, a solution satisfies
//! ```text
//! -F R + α e + δ = g        continuity; e_k, the cosine of the pair's normal to the approach
//! eᵀR = P   or   α given    the load
//! R >= 0,  δ >= 0,  R_k δ_k = 0
//! ```
//! For F symmetric positive definite these are the optimality conditions of
//! `min ½ RᵀF R + gᵀR` over `R >= 0, eᵀR = P` (or of `min ½ RᵀF R + (g - α e)ᵀR` over `R >= 0`): a solution
//! exists and is unique.
//!
//! F is a [`Flexibility`]; both solvers here need its entries.
//!
//! Two solvers, one independent check:
//! - [`SimplexSolver`], the simplex with restricted basis entry: finite, needs no start, O(n²) a pivot;
//! - [`ActiveSetSolver`], Newton's method on the same conditions: a few steps, warm-started in one or two;
//! - [`kkt::check`] recomputes every condition from the data and shares no code with either.
//!
//! Forces are per unit thickness in plane problems. Nothing here knows a mesh.

mod active_set;
mod bordered;
mod entries;
mod error;
pub mod kkt;
mod pairs;
mod problem;
mod simplex;
mod tableau;

pub use active_set::ActiveSetSolver;
pub use brinell_contact::{ContactLoad, Flexibility};
pub use error::ContactError;
pub use kkt::KktReport;
pub use pairs::ActiveSet;
pub use problem::{ContactProblem, ContactSolution};
pub use simplex::SimplexSolver;

/// A method that solves a [`ContactProblem`].
pub trait ContactSolver {
    /// Finds forces, gaps and approach.
    ///
    /// `warm` is where to start, usually the active set of the previous iteration. It may be any set, even one
    /// from another mesh: it changes the number of steps, never the answer.
    ///
    /// # Errors
    /// [`ContactError`]: data that are no contact problem, or a flexibility that is not positive definite.
    fn solve(
        &self,
        problem: &ContactProblem,
        warm: Option<&ActiveSet>,
    ) -> Result<ContactSolution, ContactError>;
}
