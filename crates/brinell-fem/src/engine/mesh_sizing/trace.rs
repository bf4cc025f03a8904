//! Traces finer than the mesh: element size for a surface that is given by points.
//!
//! Pressure follows the slope of the gap. The straight lines between the nodes deviate from a
//! surface by d within an element of size h, and leave out a slope of up to 4 d/h. This slope is
//! taken to matter where it is a noticeable part of the slope 2 δ/a with which the gap opens over
//! the half-width a, δ being the gap at its ends. Any mesh leaves out the deviation `h² δ/4 a²` of
//! a smooth surface of that opening, which does not count.
//!
//! The rounded edges of a punch are no such details: the contact ends there, and columns are
//! graded towards them. Nor is a tip that is rounded off: but for the pressure on it, of which
//! there is a closed form, a contact does not depend on its radius.

use crate::engine::problem::Problem;

/// Slope that may be left out, as a part of the mean slope of the gap.
const SLOPE_SHARE: f64 = 0.1;
/// Ratio of the element sizes of successive trials.
pub(crate) const STEP: f64 = 0.8;

/// The largest spacing \[mm\] up to `wanted` with which the nodes of a mesh see the gap over
/// `[centre - a, centre + a]` as it is.
pub(crate) fn resolving_spacing(problem: &Problem, centre: f64, a: f64, wanted: f64) -> f64 {
    let edges = problem.edges_around(centre);
    let (left, right) = ((centre - a).max(edges[0]), (centre + a).min(edges[1]));
    let knots = problem.knots_within(left, right).iter().copied();
    let inside: Vec<f64> = knots.filter(|&x| !problem.is_rounded_off(x)).collect();
    let opening = 0.5 * (problem.initial_gap(right) + problem.initial_gap(left));
    if inside.len() < 3 || opening <= 0.0 {
        return wanted;
    }
    let shortest = inside.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    let mut spacing = wanted;
    while spacing > shortest {
        let smooth = 2.0 * 0.25 * opening * (spacing / a).powi(2);
        let allowed = smooth + SLOPE_SHARE * 0.5 * opening * spacing / a;
        if largest_deviation(problem, &inside, centre, edges, spacing) <= allowed {
            break;
        }
        spacing *= STEP;
    }
    spacing
}

/// Largest distance of the gap at knots from straight lines between nodes of this spacing, edges
/// being nodes as well \[mm\].
fn largest_deviation(
    problem: &Problem,
    knots: &[f64],
    centre: f64,
    edges: [f64; 2],
    spacing: f64,
) -> f64 {
    let deviation = |(k, &x): (usize, &f64)| {
        let is_apart = |other: Option<&f64>| other.is_none_or(|other| (other - x).abs() > spacing);
        let is_node =
            is_apart(k.checked_sub(1).and_then(|j| knots.get(j))) && is_apart(knots.get(k + 1));
        if (is_node && problem.is_corner(x)) || edges.contains(&x) {
            return 0.0;
        }
        let node = centre + ((x - centre) / spacing).floor() * spacing;
        let (left, right) = (node.max(edges[0]), (node + spacing).min(edges[1]));
        let (below, above) = (problem.initial_gap(left), problem.initial_gap(right));
        (problem.initial_gap(x) - below - (above - below) * (x - left) / (right - left)).abs()
    };
    knots.iter().enumerate().map(deviation).fold(0.0, f64::max)
}
