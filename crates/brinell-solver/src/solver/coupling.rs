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

use super::SolveError;
use super::anderson::Anderson;
use super::iteration::{Iteration, Outcome, State};
use super::phases::Phase;
use crate::job::Coupling;

/// Runs the coupling that the job asks for.
pub(super) fn run(iteration: Iteration<'_>, coupling: Coupling) -> Result<Outcome, SolveError> {
    match coupling {
        Coupling::Strong => strong(iteration, None),
        Coupling::Accelerated => strong(iteration, Some(Anderson::default())),
        Coupling::Weak => super::weak::run(iteration),
        Coupling::SecantStiffness => super::secant::run(iteration),
    }
}

/// Strong coupling: one contact solve, one initial-stress update, repeat.
///
/// Each iteration maps loads `P_e` to those that the plastic law answers with. The paper goes on from the answer
/// itself; with acceleration the next loads are the combination of past answers that Anderson's method chooses. The
/// contact is solved inside the map, so that it is exact in every iteration. What is combined is what is judged: the
/// residual of the map is the true out-of-balance force.
fn strong(mut iteration: Iteration<'_>, mut anderson: Option<Anderson>) -> Result<Outcome, SolveError> {
    let system = iteration.system;
    let (mut start, mut loads) = iteration.initial_state();
    loop {
        let response = iteration.respond(&loads)?;
        iteration.count_update();
        let mut image = system.zeros();
        let plastic_points = iteration.initial_stress(&response.displacement, &mut image);
        let imbalance =
            iteration.phases.time(Phase::Plasticity, iteration.observer, || system.distance(&image, &loads));
        let status = iteration.record(&start, &response, plastic_points, imbalance);
        if status.is_some() || iteration.has_stalled() {
            return Ok(iteration.finish(State { response, loads, factors: None }, status));
        }
        start = response.displacement;
        match &mut anderson {
            None => loads = image,
            Some(anderson) => iteration.phases.time(Phase::Plasticity, iteration.observer, || {
                let next = anderson.next(&system.pack(&loads), system.pack(&image));
                system.unpack(&next, &mut loads);
            }),
        }
    }
}
