//! Errors of the mesh that a comparison with a coarser mesh does not reveal.

use std::sync::Arc;

use crate::fem::element::StressState;
use crate::job::{Body, FarSupport, Job};
use crate::solver::{BodySolution, ContactPatch, StepSolution};

/// Relative growth of the peak pressure, from half the elements to the full number, above which
/// the pressure at a corner counts as growing with the density of the mesh.
const GROWTH: f64 = 0.02;
/// Number of elements over a half-width, or over a ring, below which a mesh is called coarse. The
/// mesh generator estimates the half-width, so that a mesh of 10 elements may turn out to have
/// 9.5.
pub(super) const COARSE_MESH: f64 = 9.0;
/// Distance in elements within which a peak is next to the end of the contact: in plane analyses,
/// for contacts with a half-width above `WIDE`, and for a circle or ring.
const NEXT_TO_END: f64 = 4.0;
const NEXT_TO_END_OF_CIRCLE: f64 = 5.0;
const WIDE: f64 = 6.0;
/// Distance in elements within which a peak is in the middle of the contact.
const PEAK_IN_MIDDLE: f64 = 1.5;

/// Returns whether a body of revolution touches on a ring of so few elements that a comparison
/// with coarser elements does not bound the error.
pub(super) fn is_ring_on_few_elements(step: &StepSolution) -> bool {
    let is_few = |part: &ContactPatch| {
        let holds_peak = (part.left..=part.right).contains(&step.field.peak_position);
        holds_peak && part.left > 0.0 && part.right - part.left < COARSE_MESH * step.field.spacing
    };
    step.field.stress_state == StressState::Axisymmetric && step.field.parts.iter().any(is_few)
}

/// Returns whether the peak pressure lies off the middle and next to an end of its part of the
/// contact, for example below a flat with rounded edges that is given by points. The pressure
/// there rises within single elements.
pub(super) fn peak_is_next_to_end(step: &StepSolution) -> bool {
    let is_round = step.field.stress_state == StressState::Axisymmetric;
    let next = if is_round { NEXT_TO_END_OF_CIRCLE } else { NEXT_TO_END };
    let is_next = |part: &ContactPatch| {
        let holds_peak = (part.left..=part.right).contains(&step.field.peak_position);
        let is_on_axis = step.field.symmetric && part.left == 0.0;
        let to_left =
            if is_on_axis { f64::INFINITY } else { step.field.peak_position - part.left };
        let half_width = if is_on_axis { part.right } else { 0.5 * (part.right - part.left) };
        let beside = to_left.min(part.right - step.field.peak_position);
        holds_peak
            && beside < next * step.field.spacing
            && beside < half_width - PEAK_IN_MIDDLE * step.field.spacing
    };
    let is_wide =
        step.field.patch.is_some_and(|patch| patch.half_width() > WIDE * step.field.spacing);
    let is_limited =
        pressure_has_limit(step) && step.field.stress_state == StressState::PlaneStress;
    let is_known =
        !step.field.loaded_corners.is_empty() || step.field.rounded_edge.is_some() || is_limited;
    !is_known && (is_wide || is_round) && step.field.parts.iter().any(is_next)
}

/// Returns whether the pressure has a limit: a body yields, and no curve of a body that yields
/// rises without bound.
fn pressure_has_limit(step: &StepSolution) -> bool {
    let yielding =
        || step.field.bodies.iter().flatten().filter(|body| body.max_plastic_strain() > 0.0);
    let is_bounded = |body: &Arc<BodySolution>| {
        body.model.hardening().is_some_and(|law| law.largest_stress().is_finite())
    };
    yielding().next().is_some() && yielding().all(is_bounded)
}

/// Returns whether the peak pressure grows without limit as the elements get smaller: with a loaded
/// sharp corner of elastic bodies and of bodies whose curve rises without bound, and at one of
/// other bodies whose pressure still grows with the density of the mesh.
pub(super) fn peak_is_unbounded(step: &StepSolution) -> bool {
    if step.field.loaded_corners.is_empty() || step.field.rounded_edge.is_some() {
        return false;
    }
    if !pressure_has_limit(step) {
        return true;
    }
    let is_at_peak = |x: &f64| (x - step.field.peak_position).abs() <= step.field.spacing;
    let growth =
        step.coarse.map_or(0.0, |coarse| 1.0 - coarse.peak_pressure / step.figures.peak_pressure);
    step.field.loaded_corners.iter().any(is_at_peak)
        && (growth > GROWTH || !pressure_has_limit(step))
}

/// Returns whether a clamped body of a plane analysis is deeper than wide. The clamp prevents the
/// lateral strain of the body up to half its width from its end. At any density the mesh has few
/// rows there, and no coarser mesh reveals their effect on the approach.
pub(super) fn is_clamped_column(job: &Job, step: &StepSolution) -> bool {
    let is_column = |(body, solution): (&Body, &Option<Arc<BodySolution>>)| {
        let clamped = solution.as_ref().filter(|_| body.support == FarSupport::Clamped);
        clamped.is_some_and(|solution| solution.depth() > solution.width(step.field.symmetric))
    };
    let is_plane =
        step.field.stress_state != StressState::Axisymmetric && step.field.conforming.is_none();
    is_plane && job.bodies().into_iter().zip(&step.field.bodies).any(is_column)
}
