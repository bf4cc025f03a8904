//! The loads of a job.

use crate::contact::ContactLoad;
use crate::job::{History, HistoryLoad, Load, NonNegativeF64, Target};

/// Factor by which a mesh is finer than requested if a smaller load follows.
const FALLING_RESERVE: f64 = 1.2;

/// The loads of a job.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Loads {
    /// The loads in order.
    Given(Vec<ContactLoad>),
    /// A force that is sought for its effect.
    Sought(Sought),
}

/// The effect that defines a force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Sought {
    /// The elastic bodies just reach the yield stress at one point.
    Onset,
    /// A figure of the contact has a value.
    Target(Target),
}

impl Sought {
    /// Whether the effect is that of a force that is taken away.
    pub fn is_permanent(self) -> bool {
        matches!(self, Self::Target(target) if target.figure.is_permanent())
    }
}

/// Returns the loads of a job.
pub(crate) fn loads(load: &Load) -> Loads {
    match load {
        Load::Forces(forces) => {
            Loads::Given(forces.iter().map(|force| ContactLoad::Force(force.get())).collect())
        }
        Load::Approaches(approaches) => Loads::Given(
            approaches.iter().map(|approach| ContactLoad::Approach(approach.get())).collect(),
        ),
        Load::History(loads) => {
            let load = |load: &HistoryLoad| match load {
                HistoryLoad::Force(force) => ContactLoad::Force(force.get()),
                HistoryLoad::Approach(approach) => ContactLoad::Approach(approach.get()),
            };
            Loads::Given(loads.iter().map(load).collect())
        }
        Load::Rolling(rolling) => Loads::Given(vec![ContactLoad::Force(rolling.force.get())]),
        Load::Onset => Loads::Sought(Sought::Onset),
        Load::Target(target) => Loads::Sought(Sought::Target(*target)),
    }
}

/// Returns loads one after the other as the load of a job; `None` without a load above zero.
pub(crate) fn history_of(loads: &[ContactLoad]) -> Option<Load> {
    let load = |load: &ContactLoad| match *load {
        ContactLoad::Force(force) => NonNegativeF64::new(force).map(HistoryLoad::Force),
        ContactLoad::Approach(by) => NonNegativeF64::new(by).map(HistoryLoad::Approach),
    };
    let loads: Result<_, _> = loads.iter().map(load).collect();
    Some(Load::History(History::new(loads.ok()?).ok()?))
}

/// Returns the largest force and the largest approach, if they are above zero.
pub(crate) fn largest_loads(loads: &[ContactLoad]) -> Vec<ContactLoad> {
    let largest =
        |of: fn(&ContactLoad) -> Option<f64>| loads.iter().filter_map(of).fold(0.0, f64::max);
    let force =
        largest(|load| if let ContactLoad::Force(force) = load { Some(*force) } else { None });
    let approach =
        largest(|load| if let ContactLoad::Approach(a) = load { Some(*a) } else { None });
    let mut found = Vec::new();
    if force > 0.0 {
        found.push(ContactLoad::Force(force));
    }
    if approach > 0.0 {
        found.push(ContactLoad::Approach(approach));
    }
    found
}

/// Returns the factor by which a mesh is finer than requested, so that it serves for a smaller
/// next load. A larger contact fits into the margin of the zone.
pub(crate) fn resolution_reserve(load: ContactLoad, next: Option<ContactLoad>) -> f64 {
    match next {
        Some(next) if next.magnitude() < load.magnitude() => FALLING_RESERVE,
        _ => 1.0,
    }
}
