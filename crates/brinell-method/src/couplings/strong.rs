//! Strong coupling, with Anderson acceleration or without.

use super::Coupling;
use super::anderson::Anderson;
use super::iteration::{Iteration, Outcome, State};
use crate::Error;
use crate::phases::Phase;

/// Strong coupling as in the paper: the next loads are the image of the present loads under the
/// plastic law.
pub struct Strong;

/// Strong coupling with tangent moduli and Anderson acceleration.
pub struct Accelerated;

impl Coupling for Strong {
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, Error> {
        run(iteration, None)
    }
}

impl Coupling for Accelerated {
    fn iterate(&self, iteration: Iteration<'_>) -> Result<Outcome, Error> {
        run(iteration, Some(Anderson::default()))
    }

    fn uses_tangent_moduli(&self) -> bool {
        true
    }
}

/// Strong coupling: one contact solve, one initial-stress update, repeat.
///
/// Each iteration maps loads `P_e` to their image under the plastic law. The paper continues with
/// the image itself; the accelerated coupling continues with a combination of past images by
/// Anderson's method. The map contains the contact solve, so that the contact conditions hold in
/// every iteration. The residual of the map, `P_e' - P_e`, is the true out-of-balance force:
/// Anderson's method combines it, and it decides convergence.
fn run(mut iteration: Iteration<'_>, mut anderson: Option<Anderson>) -> Result<Outcome, Error> {
    let system = iteration.system;
    let (mut start, mut loads) = iteration.initial_state();
    loop {
        let response = iteration.solve_equilibrium(&loads)?;
        iteration.count_update();
        let mut image = system.zeros();
        let plastic_points = iteration.initial_stress(&response.displacement, &mut image);
        let residual_norm =
            iteration.run.time(Phase::Plasticity, || system.distance(&image, &loads));
        let status = iteration.record(&start, &response, plastic_points, residual_norm);
        if status.is_some() || iteration.has_stalled() {
            return iteration.finish(State { response, loads, is_complete: false }, status);
        }
        start = response.displacement;
        match &mut anderson {
            None => loads = image,
            Some(anderson) => iteration.run.time(Phase::Plasticity, || {
                let next = anderson.next(&system.pack(&loads), system.pack(&image));
                system.unpack(&next, &mut loads);
            }),
        }
    }
}
