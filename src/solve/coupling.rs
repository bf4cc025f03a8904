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
use crate::model::Coupling;

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
/// Each iteration maps displacements `u` to `g(u)`. The paper goes on from `g(u)` itself; with acceleration the
/// next start is the combination of past images that Anderson's method chooses. The contact is solved inside the
/// map, so that it is exact in every iteration.
fn strong(mut iteration: Iteration<'_>, mut anderson: Option<Anderson>) -> Result<Outcome, SolveError> {
    let system = iteration.system;
    let (mut start, mut loads) = iteration.initial_state();
    loop {
        let response = iteration.respond(&loads)?;
        iteration.count_update();
        let mut image = system.zeros();
        let plastic_points = iteration.initial_stress(&response.displacement, &mut image);
        let imbalance = system.distance(&image, &loads);
        if let Some(status) = iteration.record(&start, &response, plastic_points, imbalance) {
            return Ok(iteration.finish(State { response, loads, factors: None }, status));
        }
        match &mut anderson {
            None => {
                start = response.displacement;
                loads = image;
            }
            Some(anderson) => {
                let next = anderson.next(&system.pack(&start), system.pack(&response.displacement));
                system.unpack(&next, &mut start);
                iteration.initial_stress(&start, &mut loads);
            }
        }
    }
}
