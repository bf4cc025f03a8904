//! Error bars: what the mesh may have done to the headline figures.
//!
//! ```text
//! peak pressure   max(|Δ|, 0.25 (h/a)²), on a body of revolution at least 0.021 below 16 elements; on a rounded edge or tip
//!                 that is not resolved its distance from the closed form, of bodies that yield at most what flow leaves, of a power
//!                 below 2 0.1 h/a more; 0.2 (h/d)² with the distance d of the peak from the nearer end, where it is not in the middle;
//!                 0.25 (h/l)² with the distance l of points that a surface is given by; in plane strain with flow 0.03 h/a, of a body of revolution
//!                 under flow theory 2 (h/a)²; in plane stress
//!                 what it is above the plateau beside it; at a sharp corner two times what it is above the pairs beside it, 1 where
//!                 it has no limit
//! half-width      max(|Δ|, 0.5 h/a), 0.75 h/a where the pressure is highest next to an end, up to as much in plane stress with flow; on a
//!                 rounded edge that is not resolved its distance from the closed form
//! approach        max(|Δ|, 0.25 (h/a)²), of a plastic body of revolution max(|Δ|, 0.06 h/a), in plane strain with flow 0.08 h/a, in plane
//!                 stress max((1 + w) |Δ|, (0.08 + 0.2 w) h/a), with w from 0 of Hertz's pressure to 1 of a plateau; 0.15 h/a on a rounded
//!                 edge that is not resolved, 0.6 h/a on one of a body of revolution; 0.25 (h/l)²; what a clamped end may do that rings are too thick for on top; 0 where it is prescribed
//!                 where nothing touches any more, of what is left: max(|Δ|, that floor · the largest approach / what is left, 0.15 h/a),
//!                 h/a of the widest contact
//! stiffness       0.1 h/a of elastic bodies; 0.02 of a difference between loads, in plane stress 0.05
//! force           0; of the onset of yield max(|Δ|, 0.2 h/a), at an end of the contact 0.6 h/a; under a prescribed approach
//!                 max(|Δ|, floor of the approach · 1.5, 2 of bodies of revolution), where that of a plastic body of revolution is 0.1 h/a
//! ```
//!
//! At the onset of yield what the error of the force is on the curves over force, of the stiffness half of it, and under flow theory the
//! difference to half as many increments on top, with `Δ` the relative difference to a mesh of half the density, `h` the element size and `a`
//! the half-width. For errors that fall with h or faster, |Δ| is at least the error of the finer mesh. But the errors also scatter with
//! where the edge of the contact happens to fall between two nodes, so that now and then Δ is far below the error.
//! The second terms are floors for that: half an element for the half-width, second order for elastic bodies (the rings grow
//! by `g - 1 = 1.3 h/a`, so their error is of that order too), first order where flow makes approach and pressure follow the discrete half-width.
//!
//! The constants are measured: twelve problems (elastic, bilinear, perfectly plastic and Ramberg–Osgood cylinders,
//! plane stress, cylinder on block, elastic and plastic spheres, ball on flat) on ten meshes of 8 to 40 elements, each
//! against the same problem with 80, and 250 random jobs of the whole format against meshes four times as dense
//! (`docs/validity.md`). `tests/solver/error_bars.rs` holds a part of both to them.

use serde::{Deserialize, Serialize};

use super::contact_stiffness;
use super::mesh_effects::{
    clamped_end, flows, is_ring_on_few_elements, overshoot, peak_is_next_to_end, peak_is_unbounded, plateau,
    rise_at_corners, size_beside_peak, size_between_points,
};
use super::onset::is_onset_unknown;
use crate::contact::ContactLoad;
use crate::fem::element::StressState;
use crate::job::Job;
use crate::solver::CoarseFigures;
use crate::solver::StepSolution;

/// Floor of the error of the peak pressure over (h/a)².
const PEAK_FLOOR: f64 = 0.25;
/// Floor of the error of the peak pressure of a body of revolution whose contact has too few nodes for the pressure
/// next to the axis to be recovered: the axis node is low by 1.2 % whatever the mesh.
const AXIS_FLOOR: f64 = 0.021;
/// Elements over the contact radius from which that pressure is recovered.
const RECOVERED: f64 = 16.5;
/// Floor of the error of the half-width over h/a.
const HALF_WIDTH_FLOOR: f64 = 0.5;
/// The same where the pressure is highest next to an end of the contact, as below a punch with rounded edges or a high power: the
/// outermost nodes do not see it fall like the square root of the distance. Of powers 12 to 25 it is 0.61.
const STEEP_HALF_WIDTH_FLOOR: f64 = 0.75;
/// Elements from an end of the contact that are next to it.
const NEXT_TO_END: f64 = 4.0;
/// Floor of the error of the approach over (h/a)².
const APPROACH_FLOOR: f64 = 0.25;

/// Floor of the error of the approach over h/a for a body of revolution that yields: its approach follows the discrete
/// radius of the contact.
const PLASTIC_REVOLUTION_FLOOR: f64 = 0.06;
/// The same where the approach is prescribed, for that of the force.
const PLASTIC_REVOLUTION_FORCE_FLOOR: f64 = 0.1;

/// The same in plane strain, and in plane stress; the latter grows by the second as the pressure becomes a plateau, which ends within an
/// element: the approach, and the force under it, follow where the outermost pair happens to be.
const FLOW_FLOOR: f64 = 0.08;
const PLATEAU_FLOOR: f64 = 0.2;

/// The same where the contact ends on a rounded edge that elements do not resolve; on a body of revolution, where the force goes with
/// the square of the radius.
const NARROW_EDGE_FLOOR: f64 = 0.15;
const CIRCULAR_EDGE_FLOOR: f64 = 0.6;

/// The floor of the half-width over h/a grows by so much on such a plateau.
const PLATEAU_HALF_WIDTH_FLOOR: f64 = 0.25;

/// The bar of a peak pressure that has no limit.
const UNBOUNDED: f64 = 1.0;

/// Floor of the error of the peak pressure over h/a in plane strain where bodies flow: it follows the discrete half-width.
const FLOW_PEAK_FLOOR: f64 = 0.03;
/// The same over (h/a)² of a body of revolution under flow theory: what flows first next to the axis is known to few points.
const REVOLUTION_FLOW_PEAK_FLOOR: f64 = 2.0;

/// Floor of the error of the peak pressure over the square of the element size over the length within which the pressure falls from its peak.
const BESIDE_PEAK_FLOOR: f64 = 0.2;

/// Floor of the error of the approach that a history leaves over h/a.
const RESIDUAL_FLOOR: f64 = 0.15;

/// Error of the contact stiffness of elastic bodies over h/a.
const STIFFNESS_FLOOR: f64 = 0.1;

/// Relative change of the force over that of the approach, at most: of lines, and of bodies of revolution up to a cone.
const STEEPEST: [f64; 2] = [1.5, 2.0];

/// The bar of the contact stiffness for elements of a size over the half-width; 0 where there is none.
fn stiffness_bar(step: &StepSolution, yields: bool, size: f64) -> f64 {
    match (step.contact_stiffness, step.stress_state) {
        (None, _) => 0.0,
        (Some(_), _) if !yields || step.approach < step.reached[0] => STIFFNESS_FLOOR * size,
        (Some(_), StressState::PlaneStress) => contact_stiffness::PLANE_STRESS_ERROR,
        (Some(_), StressState::PlaneStrain | StressState::Axisymmetric) => contact_stiffness::ERROR,
    }
}

/// The floor of the error of the approach for elements of a size over the half-width.
fn approach_floor(step: &StepSolution, yields: bool, flows: bool, size: f64) -> f64 {
    let elastic = APPROACH_FLOOR * size * size;
    let edge = match step.stress_state {
        _ if step.rounded_edge.is_none() => 0.0,
        StressState::Axisymmetric => CIRCULAR_EDGE_FLOOR * size,
        StressState::PlaneStrain | StressState::PlaneStress => NARROW_EDGE_FLOOR * size,
    };
    let plastic = match step.stress_state {
        StressState::Axisymmetric if yields => {
            let floor = match step.load {
                ContactLoad::Force(_) => PLASTIC_REVOLUTION_FLOOR,
                ContactLoad::Approach(_) => PLASTIC_REVOLUTION_FORCE_FLOOR,
            };
            return edge.max(floor * size);
        }
        StressState::PlaneStress if flows => FLOW_FLOOR + PLATEAU_FLOOR * plateau(step),
        StressState::PlaneStrain if flows => FLOW_FLOOR,
        StressState::PlaneStrain | StressState::PlaneStress | StressState::Axisymmetric => 0.0,
    };
    elastic.max(edge).max(plastic * size)
}

/// Floor of the error of the half-width over h/a.
fn half_width_floor(step: &StepSolution, flows: bool) -> f64 {
    let is_next = |end: f64| (end - step.peak_position).abs() < NEXT_TO_END * step.spacing;
    let is_steep = step.patch.is_some_and(|patch| {
        let is_wide = patch.half_width() > 2.0 * NEXT_TO_END * step.spacing;
        is_wide && (is_next(patch.left) || is_next(patch.right))
    });
    if is_steep {
        STEEP_HALF_WIDTH_FLOOR
    } else if step.stress_state == StressState::PlaneStress && flows {
        HALF_WIDTH_FLOOR + PLATEAU_HALF_WIDTH_FLOOR * plateau(step)
    } else {
        HALF_WIDTH_FLOOR
    }
}

/// The bars where nothing touches any more: of the approach that earlier loads have left; the rest is exactly zero.
fn after_unloading(step: &StepSolution, coarse: CoarseFigures) -> Option<ErrorEstimate> {
    let [approach, half_width] = step.reached;
    let left = step.approach.abs();
    if left <= 0.0 || half_width <= 0.0 || !matches!(step.load, ContactLoad::Force(_)) {
        return None;
    }
    let size = step.spacing / half_width;
    let floor = approach_floor(step, true, flows(step), size) * approach;
    let difference = (step.approach - coarse.approach).abs();
    let increments = step.increment_error.unwrap_or_default().approach;
    let bar = increments + (difference.max(floor) / left).max(RESIDUAL_FLOOR * size);
    Some(ErrorEstimate {
        peak_pressure: 0.0,
        half_width: 0.0,
        approach: bar,
        force: 0.0,
        contact_stiffness: 0.0,
    })
}

/// Estimated bounds of the relative discretization errors. They hold in at least 95 of 100 cases and say nothing about
/// the theory: for that see `validity`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ErrorEstimate {
    /// Of the peak pressure \[1 >= 0\].
    pub peak_pressure: f64,
    /// Of the half-width \[1 >= 0\].
    pub half_width: f64,
    /// Of the approach; 0 where it is prescribed \[1 >= 0\].
    pub approach: f64,
    /// Of the contact force; 0 where it is prescribed \[1 >= 0\].
    #[serde(default)]
    pub force: f64,
    /// Of the contact stiffness \[1 >= 0\].
    #[serde(default)]
    pub contact_stiffness: f64,
}

/// Exponent of the force with which peak pressure, half-width and stiffness of a contact of arcs grow at most: those of a line contact.
const WITH_FORCE: f64 = 0.5;

/// The bars of a step; `None` where nothing touches, the coarser mesh is missing, a ring touches on few elements, or the onset of
/// yield is not known.
pub(super) fn estimate(job: &Job, step: &StepSolution) -> Option<ErrorEstimate> {
    let coarse = step.coarse?;
    if step.has_collapsed || is_onset_unknown(job, step) {
        return None;
    }
    let half_width = match step.patch {
        Some(patch) => patch.half_width(),
        None => return after_unloading(step, coarse),
    };
    if half_width <= 0.0 || is_ring_on_few_elements(step) {
        return None;
    }
    let size = step.spacing / half_width;
    let relative = |fine: f64, coarse: f64| if fine == 0.0 { 0.0 } else { ((fine - coarse) / fine).abs() };
    let is_axis_raw = step.stress_state == StressState::Axisymmetric && size * RECOVERED > 1.0;
    // Of a contact in several parts the coarsest one may have the peak.
    let peak_size = step.coarsest_part().map_or(size, |(_, elements)| size.max(elements.recip()));
    let peak_floor = (PEAK_FLOOR * peak_size * peak_size).max(if is_axis_raw { AXIS_FLOOR } else { 0.0 });
    let edge_floor = step.rounded_edge.map_or(0.0, |edge| edge.pressure_error / step.peak_pressure);
    let tip_floor = step.rounded_tip.map_or(0.0, |tip| tip.pressure_error / step.peak_pressure);
    let yields = step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0);
    let corner_floor =
        if peak_is_unbounded(step) || peak_is_next_to_end(step) { UNBOUNDED } else { rise_at_corners(step) };
    let plateau_floor = if yields { overshoot(step) } else { 0.0 };
    let beside = if plateau_floor > 0.0 { 0.0 } else { BESIDE_PEAK_FLOOR * size_beside_peak(step).powi(2) };
    let flows = flows(step);
    let flow_floor = match step.stress_state {
        StressState::PlaneStrain if flows => FLOW_PEAK_FLOOR * size,
        StressState::Axisymmetric if flows && step.energy.is_some() => {
            REVOLUTION_FLOW_PEAK_FLOOR * size * size
        }
        StressState::PlaneStrain | StressState::PlaneStress | StressState::Axisymmetric => 0.0,
    };
    let between_points = size_between_points(job, step).powi(2);
    let floors =
        [edge_floor, tip_floor, corner_floor, plateau_floor, beside, flow_floor, PEAK_FLOOR * between_points];
    let peak_floor = floors.into_iter().fold(peak_floor, f64::max);
    // Where flow gathers in bands that are narrower than elements errors fall more slowly than these, and are above the difference.
    let bands =
        if flows && step.stress_state == StressState::PlaneStress { 1.0 + plateau(step) } else { 1.0 };
    let approach_floor = approach_floor(step, yields, flows, size).max(APPROACH_FLOOR * between_points);
    let clamped_end = clamped_end(job, step);
    // Half as many increments differ by more than what these are wrong by.
    let increments = step.increment_error.unwrap_or_default();
    let approach = increments.approach
        + (bands * relative(step.approach, coarse.approach)).max(approach_floor)
        + clamped_end;
    // What an error of the force is on the curves over force.
    let onset = step.onset_error.unwrap_or(0.0);
    let of_stiffness = stiffness_bar(step, yields, size) + WITH_FORCE * onset;
    let (approach, force) = match step.load {
        ContactLoad::Force(_) => (approach + onset, onset),
        ContactLoad::Approach(_) => {
            // What an error of the approach is on the curve of force over approach.
            let force = step.force();
            let steepest = match step.stress_state {
                StressState::Axisymmetric => STEEPEST[1],
                StressState::PlaneStrain | StressState::PlaneStress => STEEPEST[0],
            };
            // Below an earlier load, what that one has left is part of the approach.
            let is_left = step.approach < step.reached[0] && force > 0.0;
            let slope = if is_left { step.unloading_stiffness * step.approach / force } else { 0.0 };
            let slope = slope.max(steepest);
            let floor = (increments.approach + approach_floor) * slope;
            (0.0, (bands * relative(force, coarse.force)).max(floor) + slope * clamped_end)
        }
    };
    let width_floor = (half_width_floor(step, flows) * size)
        .max(step.rounded_edge.map_or(0.0, |edge| relative(edge.half_width, half_width)));
    // What an error of the force under a prescribed approach is on the curves over force.
    let by_force = match step.load {
        ContactLoad::Force(_) => WITH_FORCE * onset,
        ContactLoad::Approach(_) => WITH_FORCE * clamped_end,
    };
    Some(ErrorEstimate {
        peak_pressure: increments.peak_pressure
            + by_force
            + relative(step.peak_pressure, coarse.peak_pressure).max(peak_floor),
        half_width: increments.half_width
            + by_force
            + relative(half_width, coarse.half_width).max(width_floor),
        approach,
        force,
        contact_stiffness: of_stiffness,
    })
}
