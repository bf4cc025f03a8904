//! The couplings of contact and plasticity, as algorithms.
//!
//! The load `P_e` is the initial-stress load of plastic flow on the elastic bodies. `Strong` and
//! `Accelerated` iterate on `P_e`, the inner loop of `Weak` on displacements. One step is
//!
//! ```text
//! contact:     u_p, by how much K⁻¹ P_e opens the pairs;  R from the gaps δ0 + u_p
//! equilibrium: u = K⁻¹ (P_e + R)
//! plasticity:  P_e' = Σ ∫ Bᵀ (D_e - D_s(u)) B dV u
//! ```
//!
//! and `P_e' - P_e` is the true out-of-balance force of the state `(u, R)`. The printed paper has
//! the opposite sign of `P_e` (docs/theory.md, section 4). `Accelerated` uses tangent moduli D as
//! reference: `P_e' = Σ ∫ Bᵀ (D ε - σ) dV`, and K is assembled from D. Where this iteration
//! stalls, `newton` takes over.
//!
//! A coupling is one file with a type that implements [`Coupling`], and a line in
//! `inputs/settings.rs` of `brinell-solver`.

pub mod anderson;
pub mod iteration;
pub mod newton;
mod secant;
mod strong;
mod weak;

use iteration::{Controls, InitialState, Iteration, Outcome};
pub use secant::SecantStiffness;
pub use strong::{Accelerated, Strong};
pub use weak::Weak;

use super::contact_system::ContactSystem;
use super::run::Run;
use crate::Error;
use brinell_material::ReferenceModuli;

/// A way to alternate contact and plasticity.
pub trait Coupling {
    /// Iterates until the state is in equilibrium or the iteration ends at a limit.
    ///
    /// # Errors
    /// Those of a contact solve or a factorization.
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, Error>;

    /// Whether the stiffness has the tangent moduli of a known state and is renewed where the
    /// iteration stalls.
    fn uses_tangent_moduli(&self) -> bool {
        false
    }

    /// Whether the plastic region has to be the whole body, because the iteration cannot continue
    /// after the region has grown.
    fn needs_whole_body(&self) -> bool {
        false
    }
}

/// Iterates under one load. Where a coupling with tangent moduli stalls, the stiffness is renewed
/// once; where it stalls again, Newton's method takes over.
///
/// # Errors
/// Those of a contact solve or a factorization.
pub fn iterate(
    system: &mut dyn ContactSystem,
    coupling: &dyn Coupling,
    mut controls: Controls<'_>,
    initial: InitialState,
    run: &mut Run<'_>,
) -> Result<Outcome, Error> {
    controls.renewable = coupling.uses_tangent_moduli() && system.linearizable().is_some();
    let first = coupling.iterate(Iteration::new(&*system, controls, initial, run.reborrow()))?;
    let Some(system) = system.linearizable().filter(|_| first.stalled) else { return Ok(first) };
    let at = (&first.state.response.displacement, ReferenceModuli::Tangent);
    match system.linearize(Some(at), run) {
        Ok(()) => {}
        // The iterations made so far are kept.
        Err(Error::Interrupted(interrupt)) => {
            return Ok(Outcome { status: interrupt.into(), ..first });
        }
        Err(Error::Factorization(_)) => return newton::run(system, controls, first, run),
        Err(error) => return Err(error),
    }
    let Outcome { state, history, .. } = first;
    let initial = InitialState {
        displacement: Some(state.response.displacement),
        history,
        factorizations: system.factorizations(),
        contact: Some(state.response.contact),
    };
    let second = coupling.iterate(Iteration::new(&*system, controls, initial, run.reborrow()))?;
    if second.stalled { newton::run(system, controls, second, run) } else { Ok(second) }
}
