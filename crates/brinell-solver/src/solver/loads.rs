//! The loads of a job.

use crate::contact::ContactLoad;
use crate::job::{HistoryLoad, Load};

/// How much finer than asked a mesh is made where the loads that follow are smaller.
const FALLING_RESERVE: f64 = 1.2;

/// The loads of a job in order; `None` where the load itself is sought.
pub(crate) fn loads(load: &Load) -> Option<Vec<ContactLoad>> {
    match load {
        Load::Forces(forces) => Some(forces.iter().map(|force| ContactLoad::Force(force.get())).collect()),
        Load::Approaches(approaches) => {
            Some(approaches.iter().map(|approach| ContactLoad::Approach(approach.get())).collect())
        }
        Load::History(loads) => {
            let load = |load: &HistoryLoad| match load {
                HistoryLoad::Force(force) => ContactLoad::Force(force.get()),
                HistoryLoad::Approach(approach) => ContactLoad::Approach(approach.get()),
            };
            Some(loads.iter().map(load).collect())
        }
        Load::Onset => None,
    }
}

/// How much finer than asked a mesh is made, so that it serves for the next load too. A larger contact finds room
/// enough as it is, in the zone that is made wider than the contact anyway.
pub(crate) fn resolution_reserve(load: ContactLoad, next: Option<ContactLoad>) -> f64 {
    match next {
        Some(next) if next.magnitude() < load.magnitude() => FALLING_RESERVE,
        _ => 1.0,
    }
}
