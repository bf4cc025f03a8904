//! What a mesh does to the figures of an answer that the difference to a coarser mesh does not show.

use crate::fem::element::StressState;
use crate::job::{Body, Job, Material, Shape, Support};
use crate::material::von_mises;
use crate::solver::outline_of;
use crate::solver::{BodySolution, ContactPatch, PairState, StepSolution};

/// Mean pressure over peak of an elastic line contact, and from which on it is that of a plateau.
const HERTZ_MEAN: f64 = std::f64::consts::FRAC_PI_4;
/// Elements over which the pressure next to the edge of a plateau overshoots, and the factor that its level on the plateau may be off by.
const OVERSHOOT: f64 = 4.2;
const OVERSHOOT_SLACK: f64 = 1.2;
/// Change of the peak pressure by half the elements from which on it is said to grow at a corner.
const GROWTH: f64 = 0.02;
/// What the pressure at a corner may still rise by, over what it is above that of the pairs beside it: two more halvings of the
/// elements add as much each where it grows with the logarithm of the distance.
const FURTHER_RISE: f64 = 2.0;
/// Size of elements over the distance of points beyond which details are not resolved.
const RESOLVED: f64 = 0.25;
/// Thickness of the rings of a mesh over their distance and h/a.
const RING: f64 = 1.3;
/// Thickness of the last ring over the width of a column that hides its clamped end.
const HIDDEN_END: f64 = 0.4;
/// By how much less than a free one a clamped end of a column is shortened, over `ν² P / E`. Two parabolas of ν = 0.3 and 0.499 that
/// are 3.7 times as deep as wide gave 0.44.
const CLAMPED_END: f64 = 0.5;
/// Depth over width from which the column below a contact is meshed in rows that do not get smaller.
const SHAFT: f64 = 4.0;

/// Elements over a ring that are few.
const RING_ELEMENTS: f64 = 6.0;
/// Elements from an end of a contact that are next to it, of one that is wider to each side than the last, and of a circle or ring.
const NEXT_TO_END: f64 = 4.0;
const NEXT_TO_END_OF_CIRCLE: f64 = 5.0;
const WIDE: f64 = 6.0;
/// Elements from the middle of a contact within which the peak is in the middle.
const PEAK_IN_MIDDLE: f64 = 1.5;

/// Whether a body flows: its plastic strain is above the elastic one.
pub(super) fn flows(step: &StepSolution) -> bool {
    let flows = |body: &BodySolution| {
        let stresses = body.stress.points.iter().flatten().map(|point| von_mises(point.stress));
        let stress = stresses.fold(0.0, f64::max);
        body.max_plastic_strain() > stress / (3.0 * body.model.elastic().shear)
    };
    step.bodies.iter().flatten().any(|body| flows(body))
}

/// How far the pressure is a plateau, from 0 of an elastic line contact to 1 of the same pressure everywhere.
pub(super) fn plateau(step: &StepSolution) -> f64 {
    if step.peak_pressure <= 0.0 {
        return 0.0;
    }
    let share = step.mean_pressure() / step.peak_pressure;
    ((share - HERTZ_MEAN) / (1.0 - HERTZ_MEAN)).clamp(0.0, 1.0)
}

/// The pressure beyond the plateau of a body that yields in plane stress: next to where the plateau ends meshes overshoot, by a
/// part that does not fall with their elements at first. Over the peak pressure; 0 where the peak is in the middle or a smooth one.
pub(super) fn overshoot(step: &StepSolution) -> f64 {
    let Some(patch) = step.patch.filter(|_| step.stress_state == StressState::PlaneStress) else {
        return 0.0;
    };
    let middle = 0.5 * (patch.left + patch.right);
    let offset = step.peak_position - middle;
    if offset.abs() < 1.5 * step.spacing || !step.loaded_corners.is_empty() {
        return 0.0;
    }
    // From the peak towards the middle.
    let inward = |pair: &&PairState| {
        let distance = (step.peak_position - pair.x) * offset.signum();
        pair.force > 0.0 && distance >= 0.0 && distance < OVERSHOOT * step.spacing
    };
    let mut levels: Vec<f64> = step.pairs.iter().filter(inward).map(|pair| pair.pressure).collect();
    if offset > 0.0 {
        levels.reverse();
    }
    match levels.as_slice() {
        // A smooth peak is the flatter the nearer to it.
        [peak, next, after, ..] if peak - next > next - after => {
            let least = levels.iter().copied().fold(f64::INFINITY, f64::min);
            if least > 0.0 { OVERSHOOT_SLACK * (peak / least - 1.0) } else { 0.0 }
        }
        _ => 0.0,
    }
}

/// Size of the elements over the length within which the pressure falls from its peak: the shorter of its distance from the ends of the
/// contact, where it is not in the middle.
pub(super) fn size_beside_peak(step: &StepSolution) -> f64 {
    let Some(patch) = step.patch else { return 0.0 };
    let beside = (step.peak_position - patch.left).min(patch.right - step.peak_position);
    let is_off = beside < patch.half_width() - 1.5 * step.spacing;
    if is_off && step.loaded_corners.is_empty() && step.rounded_edge.is_none() {
        (step.spacing / beside.max(step.spacing)).min(1.0)
    } else {
        0.0
    }
}

/// Size of the elements over the smallest distance of points that a surface is given by within the contact, at which its curvature jumps;
/// at most the size with which such details count as resolved.
pub(super) fn size_between_points(job: &Job, step: &StepSolution) -> f64 {
    let Some(patch) = step.patch else { return 0.0 };
    let profiles =
        [&job.upper, &job.lower].into_iter().filter(|body| matches!(body.shape, Shape::Profile(_)));
    let distances = profiles.flat_map(|body| {
        let knots = outline_of(&body.shape).knots();
        let within: Vec<f64> = knots.into_iter().filter(|x| (patch.left..=patch.right).contains(x)).collect();
        within.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>()
    });
    distances.reduce(f64::min).map_or(0.0, |least| (step.spacing / least).min(RESOLVED))
}

/// Whether a body of revolution touches on a ring of so few elements that coarser ones do not tell what finer ones change.
pub(super) fn is_ring_on_few_elements(step: &StepSolution) -> bool {
    let is_few = |part: &ContactPatch| {
        let holds_peak = (part.left..=part.right).contains(&step.peak_position);
        holds_peak && part.left > 0.0 && part.right - part.left < RING_ELEMENTS * step.spacing
    };
    step.stress_state == StressState::Axisymmetric && step.parts.iter().any(is_few)
}

/// Whether the largest pressure lies beside the middle and next to an end of its part of the contact, as below a flat with rounded edges
/// that is given by points: there pressure rises within elements.
pub(super) fn peak_is_next_to_end(step: &StepSolution) -> bool {
    let is_round = step.stress_state == StressState::Axisymmetric;
    let next = if is_round { NEXT_TO_END_OF_CIRCLE } else { NEXT_TO_END };
    let is_next = |part: &ContactPatch| {
        let holds_peak = (part.left..=part.right).contains(&step.peak_position);
        let is_on_axis = step.symmetric && part.left == 0.0;
        let to_left = if is_on_axis { f64::INFINITY } else { step.peak_position - part.left };
        let half_width = if is_on_axis { part.right } else { 0.5 * (part.right - part.left) };
        let beside = to_left.min(part.right - step.peak_position);
        holds_peak && beside < next * step.spacing && beside < half_width - PEAK_IN_MIDDLE * step.spacing
    };
    let is_wide = step.patch.is_some_and(|patch| patch.half_width() > WIDE * step.spacing);
    let yields = step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0);
    // In plane stress the pressure of bodies that yield has a limit.
    let is_limited = yields && step.stress_state == StressState::PlaneStress;
    let is_known = !step.loaded_corners.is_empty() || step.rounded_edge.is_some() || is_limited;
    !is_known && (is_wide || is_round) && step.parts.iter().any(is_next)
}

/// By what part of the peak the pressure at a sharp corner may be above it on smaller elements.
pub(super) fn rise_at_corners(step: &StepSolution) -> f64 {
    let loaded: Vec<&PairState> = step.pairs.iter().filter(|pair| pair.force > 0.0).collect();
    let above = step.loaded_corners.iter().filter_map(|x| {
        let at = (0..loaded.len()).min_by(|a, b| {
            let distance = |k: usize| (loaded[k].x - x).abs();
            distance(*a).total_cmp(&distance(*b))
        })?;
        let beside = [at.checked_sub(1), Some(at + 1)].into_iter().flatten();
        let highest = beside.filter_map(|k| Some(loaded.get(k)?.pressure)).reduce(f64::max)?;
        let pressure = loaded[at].pressure;
        (pressure > highest)
            .then(|| (pressure + FURTHER_RISE * (pressure - highest)) / step.peak_pressure - 1.0)
    });
    above.fold(0.0, f64::max)
}

/// Whether the peak pressure has no limit on smaller and smaller elements: that of an elastic contact over a sharp corner, and that at a
/// corner where it still grows although the bodies yield.
pub(super) fn peak_is_unbounded(step: &StepSolution) -> bool {
    if step.loaded_corners.is_empty() || step.rounded_edge.is_some() {
        return false;
    }
    if !step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0) {
        return true;
    }
    let is_at_peak = |x: &f64| (x - step.peak_position).abs() <= step.spacing;
    let growth = step.coarse.map_or(0.0, |coarse| 1.0 - coarse.peak_pressure / step.peak_pressure);
    step.loaded_corners.iter().any(is_at_peak) && growth.max(rise_at_corners(step) / FURTHER_RISE) > GROWTH
}

/// The part of the approach by which a mesh may miss what the clamped end of a body does that is deeper than wide.
///
/// Below a depth of its width such a body is a column under even stress. Its end, which is kept from widening, is shortened less,
/// over a length of about half the width, by `ν² P / E` times a number. The rings of the mesh are thicker than that until h/a is small, and
/// the rows of a shaft always are.
pub(super) fn clamped_end(job: &Job, step: &StepSolution) -> f64 {
    let half_width = step.half_width();
    let is_plane = step.stress_state != StressState::Axisymmetric && step.conforming.is_none();
    if !is_plane || half_width <= 0.0 || step.approach <= 0.0 {
        return 0.0;
    }
    let of = |(body, solution): (&Body, &Option<_>)| {
        let solution: &BodySolution = solution.as_deref().filter(|_| body.support == Support::Clamped)?;
        let Material::Deformable(material) = &body.material else { return None };
        let (depth, width) = (solution.depth(), width(solution, step.symmetric));
        let elastic = material.elastic();
        let (young_modulus, poisson_ratio) = (elastic.young_modulus.get(), elastic.poisson_ratio.get());
        let (modulus, ratio) = match step.stress_state {
            StressState::PlaneStress => (young_modulus, poisson_ratio),
            StressState::PlaneStrain | StressState::Axisymmetric => {
                (young_modulus / (1.0 - poisson_ratio.powi(2)), poisson_ratio / (1.0 - poisson_ratio))
            }
        };
        let ring = if depth > SHAFT * width { width } else { RING * step.spacing / half_width * depth };
        let hidden = (ring / (HIDDEN_END * width)).min(1.0);
        let shortening = CLAMPED_END * ratio * ratio * step.force() / (modulus * step.approach);
        (depth > width).then_some(hidden * shortening)
    };
    [&job.upper, &job.lower].into_iter().zip(&step.bodies).filter_map(of).sum()
}

/// Width of a body \[mm\].
fn width(solution: &BodySolution, symmetric: bool) -> f64 {
    let x = || solution.mesh.nodes.iter().map(|node| node[0]);
    let (left, right) = (x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max));
    if symmetric { 2.0 * right } else { right - left }
}
