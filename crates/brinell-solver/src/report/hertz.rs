//! Closed forms of elastic contacts along a line.

use super::{HertzReport, ShakedownLimit};
use crate::analytical::DepthLimit;
use crate::solver::ElasticReference;
use crate::units::UnitConverter;

/// Returns the elastic contact in closed form.
pub(super) fn line(
    reference: &ElasticReference,
    over_friction: &[ShakedownLimit],
    write: UnitConverter,
) -> HertzReport {
    HertzReport {
        half_width: write.length(reference.half_width),
        peak_pressure: write.stress(reference.peak_pressure),
        yield_onset_force: reference.yield_onset_force.map(|force| write.force(force)),
        yield_onset_depth: reference.yield_onset_depth.map(|depth| write.length(depth)),
        shakedown_pressure: reference.rolling_limit.map(|limit| write.stress(limit.peak_pressure)),
        shakedown_depth: reference.rolling_limit.map(|limit| write.length(limit.depth)),
        shakedown_over_friction: over_friction.to_vec(),
    }
}

/// Returns the limits of shakedown over friction of a job.
pub(super) fn over_friction(
    limits: &[(f64, DepthLimit)],
    write: UnitConverter,
) -> Vec<ShakedownLimit> {
    let limit = |&(friction, limit): &(f64, DepthLimit)| ShakedownLimit {
        friction,
        pressure: write.stress(limit.peak_pressure),
        depth: write.length(limit.depth),
    };
    limits.iter().map(limit).collect()
}
