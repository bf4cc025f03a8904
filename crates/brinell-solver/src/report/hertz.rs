//! Closed forms of elastic contacts along a line.

use super::ShakedownMap;
use super::known::Hertz;
use crate::analytical::DepthLimit;
use crate::solver::ElasticReference;
use crate::units::UnitConverter;

/// Returns the elastic contact in closed form.
pub(super) fn line(reference: &ElasticReference) -> Hertz {
    let first_yield = reference.yield_onset_force.zip(reference.yield_onset_depth);
    Hertz {
        half_width: reference.half_width,
        longer: None,
        peak_pressure: reference.peak_pressure,
        approach: None,
        first_yield: first_yield.map(|(force, depth)| [force, depth]),
        shakedown: reference.rolling_limit.map(|limit| [limit.peak_pressure, limit.depth]),
    }
}

/// Returns the limits of shakedown over friction of a job; empty without any.
pub(super) fn over_friction(limits: &[(f64, DepthLimit)], write: UnitConverter) -> ShakedownMap {
    let of = |limit: &DepthLimit| Some(write.stress(limit.peak_pressure));
    ShakedownMap {
        friction: limits.iter().map(|(friction, _)| *friction).collect(),
        perfect: limits.iter().map(|(_, limit)| of(limit)).collect(),
        perfect_depth: limits.iter().map(|(_, limit)| write.length(limit.depth)).collect(),
        ..ShakedownMap::default()
    }
}
