//! What a mesh does to the figures of an answer that the difference to a coarser mesh does not
//! show.

use std::sync::Arc;

use crate::fem::element::StressState;
use crate::job::{Body, Job, Support};
use crate::solver::{BodySolution, ContactPatch, StepSolution};

/// Change of the peak pressure by half the elements from which on it is said to grow at a corner.
const GROWTH: f64 = 0.02;
/// Elements over a half-width, and over a ring, below which a mesh is called coarse. Meshes are
/// sized by an estimate of the half-width, so one of 10 elements may turn out to have 9.5.
pub(super) const COARSE_MESH: f64 = 9.0;
/// Elements from an end of a contact that are next to it, of one that is wider to each side than
/// the last, and of a circle or ring.
const NEXT_TO_END: f64 = 4.0;
const NEXT_TO_END_OF_CIRCLE: f64 = 5.0;
const WIDE: f64 = 6.0;
/// Elements from the middle of a contact within which the peak is in the middle.
const PEAK_IN_MIDDLE: f64 = 1.5;

/// Whether a body of revolution touches on a ring of so few elements that coarser ones do not tell
/// what finer ones change.
pub(super) fn is_ring_on_few_elements(step: &StepSolution) -> bool {
    let is_few = |part: &ContactPatch| {
        let holds_peak = (part.left..=part.right).contains(&step.peak_position);
        holds_peak && part.left > 0.0 && part.right - part.left < COARSE_MESH * step.spacing
    };
    step.stress_state == StressState::Axisymmetric && step.parts.iter().any(is_few)
}

/// Whether the largest pressure lies beside the middle and next to an end of its part of the
/// contact, as below a flat with rounded edges that is given by points: there pressure rises
/// within elements.
pub(super) fn peak_is_next_to_end(step: &StepSolution) -> bool {
    let is_round = step.stress_state == StressState::Axisymmetric;
    let next = if is_round { NEXT_TO_END_OF_CIRCLE } else { NEXT_TO_END };
    let is_next = |part: &ContactPatch| {
        let holds_peak = (part.left..=part.right).contains(&step.peak_position);
        let is_on_axis = step.symmetric && part.left == 0.0;
        let to_left = if is_on_axis { f64::INFINITY } else { step.peak_position - part.left };
        let half_width = if is_on_axis { part.right } else { 0.5 * (part.right - part.left) };
        let beside = to_left.min(part.right - step.peak_position);
        holds_peak
            && beside < next * step.spacing
            && beside < half_width - PEAK_IN_MIDDLE * step.spacing
    };
    let is_wide = step.patch.is_some_and(|patch| patch.half_width() > WIDE * step.spacing);
    let yields = step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0);
    // In plane stress the pressure of bodies that yield has a limit.
    let is_limited = yields && step.stress_state == StressState::PlaneStress;
    let is_known = !step.loaded_corners.is_empty() || step.rounded_edge.is_some() || is_limited;
    !is_known && (is_wide || is_round) && step.parts.iter().any(is_next)
}

/// Whether the peak pressure has no limit on smaller and smaller elements: that of an elastic
/// contact over a sharp corner, and that at a corner where it still grows although the bodies
/// yield.
pub(super) fn peak_is_unbounded(step: &StepSolution) -> bool {
    if step.loaded_corners.is_empty() || step.rounded_edge.is_some() {
        return false;
    }
    if !step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0) {
        return true;
    }
    let is_at_peak = |x: &f64| (x - step.peak_position).abs() <= step.spacing;
    let growth = step.coarse.map_or(0.0, |coarse| 1.0 - coarse.peak_pressure / step.peak_pressure);
    step.loaded_corners.iter().any(is_at_peak) && growth > GROWTH
}

/// Whether the mesh does not tell the largest pressure.
pub(super) fn is_peak_unknown(step: &StepSolution) -> bool {
    step.rounded_tip.is_some() || peak_is_unbounded(step) || peak_is_next_to_end(step)
}

/// Whether a clamped body of a plane analysis is deeper than wide. Its end is kept from widening
/// over half its width, in which the rows of the mesh are few, whatever its density: what that
/// does to the approach no coarser mesh shows.
pub(super) fn is_clamped_column(job: &Job, step: &StepSolution) -> bool {
    let is_column = |(body, solution): (&Body, &Option<Arc<BodySolution>>)| {
        let clamped = solution.as_ref().filter(|_| body.support == Support::Clamped);
        clamped.is_some_and(|solution| solution.depth() > solution.width(step.symmetric))
    };
    let is_plane = step.stress_state != StressState::Axisymmetric && step.conforming.is_none();
    is_plane && [&job.upper, &job.lower].into_iter().zip(&step.bodies).any(is_column)
}
