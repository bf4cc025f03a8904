//! The frictionless unilateral contact of two elastic bodies that are known by their flexibility
//! alone.
//!
//! With n candidate pairs of nodes or cells, the flexibility `F = flexibility [mm/N]`, the initial
//! gap `g = initial_gap [mm]` along each pair's normal (geometry plus plastic displacement), the
//! contact forces `R = force [N]`, the gap after loading `δ = gap [mm]` and the approach `α =
//! approach [mm]`, a solution satisfies
//! ```text
//! g + F R - α e = δ         continuity; e_k, the cosine of the pair's normal to the approach
//! eᵀR = P   or   α given    the load
//! R >= 0,  δ >= 0,  R_k δ_k = 0
//! ```
//! For F symmetric positive definite these are the optimality conditions of `min ½ RᵀF R + gᵀR`
//! over `R >= 0, eᵀR = P` (or of `min ½ RᵀF R + (g - α e)ᵀR` over `R >= 0`): a solution exists and
//! is unique.
//!
//! F is a [`Flexibility`]. Two solvers need its entries, one applies it:
//! - [`ActiveSetSolver`], Newton's method on the conditions: a few steps, or one or two from the
//!   pairs of a similar answer;
//! - [`SimplexSolver`], the simplex with restricted basis entry: finite, needs no start, O(n²) a
//!   pivot;
//! - [`ConjugateGradientSolver`], the active set outside, preconditioned conjugate gradients
//!   inside.
//!
//! [`kkt::check`] recomputes every condition from the data and shares no code with any of them.
//!
//! A solve that does not converge returns an answer with that [`ContactStatus`], not an error.
//! Forces are per unit thickness in plane problems. Nothing here knows a mesh.

mod active_set;
mod bordered;
mod conjugate_gradient;
mod entries;
mod error;
mod flexibility;
pub mod kkt;
mod operator;
mod pairs;
mod problem;
mod simplex;
mod start;
mod tableau;
mod vectors;

use std::ops::ControlFlow;

pub use active_set::ActiveSetSolver;
pub use conjugate_gradient::ConjugateGradientSolver;
pub use error::ContactError;
pub use flexibility::Flexibility;
pub use kkt::KktReport;
pub use pairs::ActiveSet;
pub use problem::{ContactLoad, ContactProblem, ContactSolution, ContactStatus};
pub use simplex::SimplexSolver;

/// A hook that runs once per iteration of conjugate gradients; `Break` ends the solve with
/// [`ContactStatus::Stopped`]. Direct solvers are too short for it.
pub type StopHook<'a> = dyn FnMut() -> ControlFlow<()> + 'a;

/// A hook that never stops.
pub fn never() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A method that solves a [`ContactProblem`].
pub trait ContactSolver {
    /// Finds forces, gaps and approach.
    ///
    /// `start` is an initial guess, usually the answer of the iteration before: active sets start
    /// from its pairs, conjugate gradients from its forces. Any answer is allowed, even with other
    /// pairs: it changes the number of steps, not the result.
    ///
    /// # Errors
    /// [`ContactError`]: data that are no contact problem, or a flexibility that is not positive
    /// definite.
    fn solve(
        &self,
        problem: &ContactProblem<'_>,
        start: Option<&ContactSolution>,
        stop: &mut StopHook<'_>,
    ) -> Result<ContactSolution, ContactError>;
}
