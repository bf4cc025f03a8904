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

pub(crate) mod anderson;
pub(crate) mod iteration;
mod secant;
mod strong;
mod weak;

use anderson::Anderson;
use iteration::{Iteration, Outcome};

use crate::job::Coupling;
use crate::solver::SolveError;

/// Runs the coupling that the job asks for.
pub(crate) fn run(iteration: Iteration<'_>, coupling: Coupling) -> Result<Outcome, SolveError> {
    match coupling {
        Coupling::Strong => strong::run(iteration, None),
        Coupling::Accelerated => strong::run(iteration, Some(Anderson::default())),
        Coupling::Weak => weak::run(iteration),
        Coupling::SecantStiffness => secant::run(iteration),
    }
}
