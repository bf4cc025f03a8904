//! The growth of a contact with its load.

use crate::element::StressState;
use crate::engine::problem::Problem;
use crate::engine::reference::ElasticReference;
use brinell_contact::ContactLoad;
use brinell_method::increments::Growth;

/// Returns the growth of the contact on the way to a load.
pub(super) fn growth(problem: &Problem, load: ContactLoad) -> Growth {
    let onset = match load {
        _ if problem.bodies.iter().all(|body| body.hardening().is_none()) => Some(f64::INFINITY),
        ContactLoad::Force(force) => ElasticReference::of(problem, force.max(f64::MIN_POSITIVE))
            .and_then(|reference| reference.yield_onset_force),
        ContactLoad::Approach(_) => None,
    };
    // Between the elastic and the fully plastic contact.
    let exponent = match (problem.stress_state, load) {
        (StressState::Axisymmetric, ContactLoad::Force(_)) => 2.4,
        (_, ContactLoad::Force(_)) => 1.6,
        (_, ContactLoad::Approach(_)) => 2.0,
    };
    Growth { onset, exponent }
}
