//! The couplings of contact and plasticity, as algorithms.
//!
//! Initial-stress couplings iterate on the load `P_e` that plastic flow puts on the elastic bodies. One step is
//!
//! ```text
//! contact:     u_p = K⁻¹ P_e,  R from the gap δ0 + u_p
//! equilibrium: u = K⁻¹ (P_e + R)
//! plasticity:  P_e' = Σ ∫ Bᵀ (D_e - D_s(u)) B dV u
//! ```
//!
//! and `P_e' - P_e` is the true out-of-balance force of the state `(u, R)`.

//!
//! A coupling is one file with a type that implements [`Coupling`], and a line in [`of`].

mod anderson;
pub(crate) mod iteration;
pub(crate) mod newton;
mod secant;
mod strong;
mod weak;

use iteration::{Iteration, Outcome};

use crate::job;
use crate::solver::SolveError;

/// A way to alternate contact and plasticity.
pub(crate) trait Coupling {
    /// Iterates until the state is in equilibrium, or the iteration says that it ends.
    ///
    /// # Errors
    /// Those of a contact solve or a factorization.
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, SolveError>;

    /// Whether the stiffness takes the tangent moduli of a known state, and takes them anew where the iteration stalls.
    fn uses_tangent_moduli(&self) -> bool {
        false
    }

    /// Whether plastic flow has to be evaluated in the whole body, because the iteration cannot go on from a state that
    /// missed some of it.
    fn needs_whole_body(&self) -> bool {
        false
    }
}

/// The coupling that a job names.
pub(crate) fn of(name: job::Coupling) -> &'static dyn Coupling {
    match name {
        job::Coupling::Strong => &strong::Strong,
        job::Coupling::Accelerated => &strong::Accelerated,
        job::Coupling::Weak => &weak::Weak,
        job::Coupling::SecantStiffness => &secant::SecantStiffness,
    }
}
