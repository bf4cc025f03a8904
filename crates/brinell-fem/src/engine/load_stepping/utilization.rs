//! Utilization of a contact: von Mises stress over yield stress.

use std::f64::consts::PI;

use super::surface_stress::{
    SurfacePoint, at_contact_circle, beyond_given, surface_points, with_given,
};
use crate::assembly::GaussPoint;
use crate::element::{StressState, shape_functions};
use crate::engine::body_solution::BodySolution;
use crate::engine::problem::{GivenStress, Problem, ProblemBody};
use crate::engine::recovery::Recovery;
use crate::engine::solution::{PairState, StepSolution};
use brinell_material::analytical::RoundedEdge;
use brinell_material::von_mises;

/// Highest utilization of a step, below yield or beyond it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Utilization {
    /// Von Mises stress over yield stress.
    pub ratio: f64,
    /// 0 is the upper body, 1 the lower one.
    pub body: usize,
    /// Place `[x, y]` \[mm\].
    pub position: [f64; 2],
}

/// The place with the highest von Mises stress over the yield stress there: of the middles of
/// elements, by their means (single Gauss points lie above the field by half a percent), and of
/// the surface; where strength or the stress before the load varies with depth, by recovered
/// stresses at points within the elements; and of a rounded edge that elements leave out. Of two
/// bodies alike, the lower one; `None` if no body can yield.
pub fn highest_utilization(step: &StepSolution, problem: &Problem) -> Option<Utilization> {
    let found = [highest_within(step, problem, &|_| true), at_narrow_edge(step, problem)];
    found.into_iter().flatten().max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// Half-widths around the ends of a contact within which stress varies too fast for elements.
const AROUND_ENDS: f64 = 0.3;

/// Returns the highest utilization near the ends of the contact.
pub(crate) fn highest_at_ends(step: &StepSolution, problem: &Problem) -> Option<Utilization> {
    let patch = step.field.patch?;
    let reach = AROUND_ENDS * patch.half_width();
    let is_near = |x: f64| [patch.left, patch.right].iter().any(|end| (x - end).abs() < reach);
    highest_within(step, problem, &|[x, depth]| depth < reach && is_near(x))
}

/// Exponent of the force with which the utilization at a rounded edge grows.
pub const EDGE_UTILIZATION: f64 = 2.0 / 3.0;

/// The utilization at a rounded edge that elements leave out, of elastic bodies in closed form;
/// `None` without such an edge, and where no body can yield.
pub fn at_narrow_edge(step: &StepSolution, problem: &Problem) -> Option<Utilization> {
    let edge = step.field.rounded_edge?;
    let (width, peak) = (edge.elastic.width(), edge.elastic.peak_pressure());
    let utilizations = problem.bodies.iter().enumerate().filter_map(|(k, body)| {
        let out_of_plane = match step.field.stress_state {
            StressState::PlaneStress => 0.0,
            StressState::PlaneStrain | StressState::Axisymmetric => {
                body.material.as_ref()?.elastic().poisson_ratio
            }
        };
        let (von_mises_over_peak, [along, depth]) = RoundedEdge::von_mises_over_peak(out_of_plane);
        let x = edge.half_width + (along - 1.0) * width;
        let position = [x, body.outline.height(x) - depth * width];
        let ratio = peak * von_mises_over_peak / body.yield_stress_at(position)?;
        Some(Utilization { ratio, body: k, position })
    });
    utilizations.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// Error of the utilization at a rounded edge in closed form, beside the exact half-plane of flats
/// of 4 mm with edges of 0.02 to 1 mm.
const EDGE_ERROR: f64 = 0.015;

/// Error of the force under which yield begins at a rounded edge in closed form: what the pressure
/// in the middle half of the contact is off from that of a flat punch on a half-space, and what
/// the closed form itself is off by.
pub(crate) fn error_at_narrow_edge(step: &StepSolution) -> Option<f64> {
    let half_width = step.field.rounded_edge?.half_width;
    let mean = match step.field.stress_state {
        StressState::Axisymmetric => step.figures.force / (2.0 * PI * half_width * half_width),
        StressState::PlaneStrain | StressState::PlaneStress => {
            step.figures.force / (PI * half_width)
        }
    };
    let off = |pair: &PairState| {
        let part = pair.x.abs() / half_width;
        (part < 0.5).then(|| pair.pressure * (1.0 - part * part).sqrt() / mean - 1.0)
    };
    let off: Vec<f64> = step.field.pairs.iter().filter_map(off).collect();
    Some(EDGE_ERROR + (off.iter().sum::<f64>() / off.len() as f64).abs())
}

/// Returns the highest utilization over the elements with their middle at certain places
/// `[x, depth]` \[mm\].
fn highest_within(
    step: &StepSolution,
    problem: &Problem,
    counts: &dyn Fn([f64; 2]) -> bool,
) -> Option<Utilization> {
    let solutions = step.field.bodies.iter().zip(&problem.bodies).enumerate();
    let highest = solutions.filter_map(|(body, (solution, limits))| {
        let (solution, (least, greatest)) = (solution.as_ref()?, limits.strength_range());
        let surface = surface_points(step, solution, limits);
        let inside = if least < greatest || limits.initial_stress.is_some() {
            highest_of_graded(solution, step.field.symmetric, limits, &surface, counts)?
        } else {
            highest_of_elements(solution, limits, counts)?
        };
        let at_surface = highest_of_surface(step, &surface, limits)
            .into_iter()
            .flatten()
            .filter(|(_, position)| counts(solution.mesh.frame.place(*position)));
        let (ratio, position) = at_surface
            .fold(inside, |highest, next| if next.0 > highest.0 { next } else { highest });
        Some(Utilization { ratio, body, position })
    });
    highest.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// The highest ratio of an element and its centroid.
fn highest_of_elements(
    solution: &BodySolution,
    limits: &ProblemBody,
    counts: &dyn Fn([f64; 2]) -> bool,
) -> Option<(f64, [f64; 2])> {
    let frame = solution.mesh.frame;
    let elements = solution.stress.points.iter().filter_map(|points| {
        let mean = GaussPoint::mean(points);
        if frame.is_near_core(mean.position) || !counts(frame.place(mean.position)) {
            return None;
        }
        Some((von_mises(mean.stress) / limits.yield_stress_at(mean.position)?, mean.position))
    });
    elements.max_by(|a, b| a.0.total_cmp(&b.0))
}

/// The highest ratio at the surface and its place, and the one at the edge of a contact circle.
fn highest_of_surface(
    step: &StepSolution,
    points: &[SurfacePoint],
    limits: &ProblemBody,
) -> [Option<(f64, [f64; 2])>; 2] {
    let ratio = |stress: f64, position: [f64; 2]| {
        Some((stress / limits.yield_stress_at(position)?, position))
    };
    let ratios = points.iter().filter_map(|point| {
        ratio(von_mises(with_given(point.beyond_given, limits, point.position)), point.position)
    });
    let edge = at_contact_circle(step, limits, points)
        .and_then(|(stress, position)| ratio(stress, position));
    [ratios.max_by(|a, b| a.0.total_cmp(&b.0)), edge]
}

/// Parts of an element's side at whose ends a strength that varies is looked at.
const PARTS: u32 = 8;

/// The highest ratio of recovered stresses to a yield stress where one of them varies within
/// elements: at even points within them, and where they cross the depths of the profiles, at which
/// strength and given stress may change so fast that they jump between such points.
fn highest_of_graded(
    solution: &BodySolution,
    symmetric: bool,
    limits: &ProblemBody,
    surface: &[SurfacePoint],
    counts: &dyn Fn([f64; 2]) -> bool,
) -> Option<(f64, [f64; 2])> {
    let mesh = &solution.mesh;
    let given = limits.initial_stress.as_deref();
    let beyond = given.map(|given| beyond_given(solution.clone(), given));
    let recovered = Recovery::new(beyond.as_ref().unwrap_or(solution), symmetric).nodes();
    let mut stress: Vec<[f64; 4]> =
        recovered.into_iter().map(|[x, y, z, t, ..]| [x, y, z, t]).collect();
    // Between two points of the surface.
    for (&node, points) in mesh.contact_nodes.iter().skip(1).zip(surface.windows(2)) {
        let mean = |k: usize| points.iter().map(|point| 0.5 * point.beyond_given[k]).sum();
        stress[node as usize] = std::array::from_fn(mean);
    }
    if let (true, Some(&node), [first, second, ..]) =
        (symmetric, mesh.contact_nodes.first(), surface)
    {
        // Even about the axis.
        stress[node as usize] =
            std::array::from_fn(|k| (9.0 * first.beyond_given[k] - second.beyond_given[k]) / 8.0);
    }
    let is_near_core = |node: u32| mesh.frame.is_near_core(mesh.nodes[node as usize]);
    // Within an element depth and normal of the surface vary evenly: a foot for every place would
    // cost more than the mesh solve.
    let feet: Vec<(f64, [f64; 2])> =
        mesh.nodes.iter().map(|&node| limits.outline.foot(node)).collect();
    let yield_stress = limits.yield_stress()?;
    let strength = limits.material.as_ref()?.strength();
    let ratio = |stress: [f64; 4], foot: (f64, [f64; 2]), limit: Option<f64>| {
        let given = given.map_or([0.0; 4], |given| given.below(foot));
        let factor = || strength.as_ref().map_or(1.0, |profile| profile.factor(foot.0));
        von_mises(std::array::from_fn(|k| stress[k] + given[k]))
            / limit.unwrap_or_else(|| yield_stress * factor())
    };
    let at_node = |node: u32| {
        if is_near_core(node) {
            0.0
        } else {
            ratio(stress[node as usize], feet[node as usize], None)
        }
    };
    let nodal: Vec<f64> = (0u32..).take(mesh.nodes.len()).map(at_node).collect();
    let highest = nodal.iter().copied().fold(0.0, f64::max);
    let depths_of_strength = strength.iter().flat_map(|profile| {
        profile.points().iter().map(|[z, factor]| (*z, Some(yield_stress * factor)))
    });
    let depths_of_stress = given.into_iter().flat_map(GivenStress::depths).map(|z| (z, None));
    let knots: Vec<(f64, Option<f64>)> = depths_of_strength.chain(depths_of_stress).collect();
    let mut best = (0.0, [0.0; 2]);
    for (element, nodes) in mesh.elements.iter().enumerate() {
        let corners = mesh.corners(element);
        let middle = std::array::from_fn(|axis| {
            0.25 * corners.iter().map(|corner| corner[axis]).sum::<f64>()
        });
        if nodes.iter().any(|&node| is_near_core(node)) || !counts(mesh.frame.place(middle)) {
            continue;
        }
        let depths = nodes.map(|node| feet[node as usize].0);
        let (least, greatest) = depths
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &z| (z.min(a), z.max(b)));
        let crossed = knots.iter().filter(|(z, _)| least < *z && *z < greatest);
        let mut look = |natural: [f64; 2], limit: Option<f64>| {
            let shape = shape_functions(natural);
            let mix =
                |values: &dyn Fn(usize) -> f64| (0..4).map(|c| shape[c] * values(c)).sum::<f64>();
            let normal = std::array::from_fn(|axis| mix(&|c| feet[nodes[c] as usize].1[axis]));
            let stress = std::array::from_fn(|s| mix(&|c| stress[nodes[c] as usize][s]));
            let found = ratio(stress, (mix(&|c| depths[c]), normal), limit);
            if found > best.0 {
                best = (found, std::array::from_fn(|axis| mix(&|c| corners[c][axis])));
            }
        };
        for &(z, limit) in crossed {
            for natural in crossings(depths, z) {
                look(natural, limit);
            }
        }
        // Between nodes and depths of the profile it is higher by no more than the strength varies
        // within an element.
        if nodes.iter().any(|&node| nodal[node as usize] >= 0.5 * highest) {
            for k in 0..(PARTS + 1) * (PARTS + 1) {
                look([k % (PARTS + 1), k / (PARTS + 1)].map(even), None);
            }
        }
    }
    Some(best)
}

/// The place of an even point along a side, -1 to 1.
fn even(k: u32) -> f64 {
    2.0 * f64::from(k) / f64::from(PARTS) - 1.0
}

/// Returns the crossings of lines along both natural directions with the depth z. Depth is
/// interpolated between the corners of an element.
fn crossings(depths: [f64; 4], z: f64) -> impl Iterator<Item = [f64; 2]> {
    (0..2 * (PARTS + 1)).filter_map(move |k| {
        let (axis, fixed) = (usize::from(k > PARTS), even(k % (PARTS + 1)));
        let at = |along: f64| {
            let natural = if axis == 0 { [along, fixed] } else { [fixed, along] };
            let shape = shape_functions(natural);
            (natural, (0..4).map(|c| shape[c] * depths[c]).sum::<f64>())
        };
        let (start, end) = (at(-1.0).1, at(1.0).1);
        let part = (z - start) / (end - start);
        (0.0..=1.0).contains(&part).then(|| at(2.0 * part - 1.0).0)
    })
}
