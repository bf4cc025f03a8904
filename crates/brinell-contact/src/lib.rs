//! The frictionless unilateral contact of two elastic bodies that are known by their flexibility alone.
//!
//! With n candidate cells, the flexibility `F = flexibility [mm/N]`, the initial gap `g = initial_gap [mm]` (geometry
//! plus plastic displacement), the contact forces `R = force [N]`, the gap after loading `δ = gap [mm]` and the
//! approach `α = approach [mm]`, a solution satisfies
//! ```text
//! g + F R - α = δ           continuity
//! Σ R = P   or   α given    the load
//! R >= 0,  δ >= 0,  R_k δ_k = 0
//! ```
//! For F symmetric positive definite these are the optimality conditions of `min ½ RᵀF R + gᵀR` over
//! `R >= 0, Σ R = P` (or of `min ½ RᵀF R + (g - α)ᵀR` over `R >= 0`): a solution exists and is unique.
//!
//! F is a [`Flexibility`]: it is applied to forces and has no entries to look at.
//!
//! Two solvers, one independent check:
//! - [`ConjugateGradientSolver`], a primal-dual active set outside, preconditioned conjugate gradients inside, with
//!   the second solver to fall back on;
//! - [`PolonskyKeerSolver`], projected conjugate gradients without a preconditioner;
//! - [`kkt::check`] recomputes every condition from the data and shares no code with either. Both solvers report its
//!   verdict on the answer that they return.
//!
//! An answer that has not converged is an answer with that [`ContactStatus`], not an error.

mod conjugate_gradient;
mod error;
mod flexibility;
pub mod kkt;
mod polonsky_keer;
mod problem;
mod start;
mod vectors;

use std::ops::ControlFlow;

pub use conjugate_gradient::ConjugateGradientSolver;
pub use error::ContactError;
pub use flexibility::Flexibility;
pub use kkt::KktReport;
pub use polonsky_keer::PolonskyKeerSolver;
pub use problem::{ContactLoad, ContactProblem, ContactSolution, ContactStatus};

/// Asked once per iteration; `Break` ends the solve with [`ContactStatus::Stopped`].
pub type StopHook<'a> = dyn FnMut() -> ControlFlow<()> + 'a;

/// A hook that never stops.
pub fn never() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A method that solves a [`ContactProblem`].
pub trait ContactSolver {
    /// Finds forces, gaps and approach.
    ///
    /// The forces that `solution` holds are where the solver starts, usually those of the iteration before. They
    /// change the number of steps, never the answer. [`ContactSolution::default`] is a start from nothing. The
    /// vectors of `solution` are reused.
    ///
    /// # Errors
    /// [`ContactError`]: data that are no contact problem, or a flexibility that is not positive definite.
    fn solve(
        &mut self,
        problem: &ContactProblem<'_>,
        solution: &mut ContactSolution,
        stop: &mut StopHook<'_>,
    ) -> Result<(), ContactError>;
}
