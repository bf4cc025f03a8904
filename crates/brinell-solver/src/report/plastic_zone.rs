//! The outline of the plastic region.
//!
//! ```text
//! f = q + 3G ε_p - σ_y [MPa]
//! q = von_mises, ε_p = equivalent_plastic_strain, σ_y = yield_stress
//! ```
//!
//! The plastic region is the set of points with `f >= 0`. Deformation theory has `q = 3G (ε_q -
//! ε_p)`, so that f is the stress of an elastic body under the same strain, less the yield stress:
//! unlike q, f is smooth across the boundary. For a law without a yield point (Ramberg–Osgood) the
//! region is by convention the set of points where q exceeds the reference stress. Under flow
//! theory q is the largest von Mises stress in the history of a point, and the region includes all
//! points that have yielded so far.
//!
//! f is recovered at the nodes. A straight line between the zeros on its edges cuts each
//! quadrilateral. Edges that two pieces share cancel, and the remaining edges are chained to
//! closed polygons.

use std::collections::BTreeMap;

use crate::analytical::Stress;
use crate::material::stress_of_yield;
use crate::solver::recovery::{Recovery, Values};
use crate::solver::{BodySolution, has_yielded};

/// Maximum number of points of a polygon; longer polygons are thinned.
const MAX_POINTS: usize = 400;
/// Maximum number of polygons; the largest are kept.
const MAX_POLYGONS: usize = 8;
/// Area of a polygon over the area of the largest polygon below which it is dropped as noise.
const NOISE: f64 = 1e-3;

/// The plastic region of a body.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct PlasticZone {
    /// Closed polygons `[x, depth]` \[mm\] without the first point repeated; anticlockwise in the
    /// axes `(x, depth)`, holes clockwise. A symmetric body is completed by its mirror image.
    pub outline: Vec<Vec<[f64; 2]>>,
    /// Whether the plastic region includes a point of the free surface.
    pub reached_surface: bool,
}

impl PlasticZone {
    /// Returns the depth at which the region begins \[mm\].
    pub fn cover(&self) -> Option<f64> {
        let depths = self.outline.iter().flatten().map(|point| point[1]);
        let drawn = depths.reduce(f64::min).map(|depth| depth.max(0.0));
        if self.reached_surface { Some(0.0) } else { drawn }
    }
}

/// A corner of the outline: a node (twice), or the two nodes of an edge with a zero between them;
/// and whether the corner is a mirror image.
type Corner = (u32, u32, bool);

/// Returns the plastic region of a body with its outline.
pub(super) fn outline(solution: &BodySolution, symmetric: bool) -> PlasticZone {
    let Some(excess) = Excess::of(solution) else { return PlasticZone::default() };
    let limit_at =
        |node: u32| excess.limit * solution.model.strength(solution.mesh.nodes[node as usize]);
    let mut recovery = Recovery::new(solution, symmetric);
    let elements = elements_near_yield(solution, &recovery);
    let mut values = BTreeMap::new();
    for &element in &elements {
        for node in solution.mesh.elements[element] {
            values
                .entry(node)
                .or_insert_with(|| excess.stress(recovery.node(node)) - limit_at(node));
        }
    }
    let mesh = &solution.mesh;
    let mut is_whole = vec![false; mesh.elements.len()];
    for &element in &elements {
        is_whole[element] = mesh.elements[element].iter().all(|node| values[node] >= 0.0);
    }
    // Two elements that both lie inside share an edge, which would cancel anyway.
    let is_within = |element: usize, (from, ..): Corner, (to, ..): Corner| {
        let shares = |&other: &u32| {
            let other = other as usize;
            other != element && is_whole[other] && mesh.elements[other].contains(&to)
        };
        is_whole[element] && recovery.elements_of(from).iter().any(shares)
    };
    let is_on_axis = |node: u32| mesh.nodes[node as usize][0] == 0.0;
    let image = |(a, b, _): Corner| (a, b, !(is_on_axis(a) && is_on_axis(b)));
    let mut edges = Edges::default();
    for &element in &elements {
        let corners = cut(mesh.elements[element], &values);
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            if is_within(element, from, to) {
                continue;
            }
            edges.add(from, to);
            if symmetric {
                edges.add(image(to), image(from));
            }
        }
    }
    let place = |corner: &Corner| position(*corner, solution, &values);
    let polygons =
        edges.chain().iter().map(|chain| chain.iter().rev().map(place).collect()).collect();
    PlasticZone {
        outline: largest(polygons),
        reached_surface: solution
            .mesh
            .free_surface_nodes
            .iter()
            .any(|node| values.get(node).is_some_and(|f| *f >= 0.0)),
    }
}

/// Constants that compute f from recovered values.
struct Excess {
    /// Stress from which on points count as yielded, at a strength of 1 \[MPa\].
    limit: f64,
    /// 3G for a law with a yield point, else 0 \[MPa\].
    triple_shear: f64,
    /// Whether q is the largest von Mises stress of the history.
    has_memory: bool,
}

impl Excess {
    fn of(solution: &BodySolution) -> Option<Self> {
        let law = solution.model.hardening()?;
        let triple_shear = 3.0 * solution.model.elastic().shear;
        // Without a yield point, points on both sides of the boundary have plastic strain.
        let is_limited = law.yield_stress() > 0.0;
        Some(Self {
            limit: stress_of_yield(law, triple_shear),
            triple_shear: if is_limited { triple_shear } else { 0.0 },
            has_memory: solution.model.has_memory(),
        })
    }

    /// Returns `q + 3G ε_p` \[MPa\].
    fn stress(&self, [sigma_x, sigma_y, sigma_z, tau_xy, plastic_strain, largest]: Values) -> f64 {
        let stress = Stress { sigma_x, sigma_y, sigma_z, tau_xy };
        let von_mises = if self.has_memory { largest } else { stress.von_mises() };
        von_mises + self.triple_shear * plastic_strain
    }
}

/// Returns the elements with a Gauss point that has yielded, and their neighbours.
fn elements_near_yield(solution: &BodySolution, recovery: &Recovery<'_>) -> Vec<usize> {
    let mut near = vec![false; solution.mesh.elements.len()];
    for (nodes, points) in solution.mesh.elements.iter().zip(&solution.stress.points) {
        if points.iter().any(has_yielded) {
            for &element in nodes.iter().flat_map(|&node| recovery.elements_of(node)) {
                near[element as usize] = true;
            }
        }
    }
    near.iter().enumerate().filter(|(_, near)| **near).map(|(element, _)| element).collect()
}

/// Returns the corners of the part of a quadrilateral with `f >= 0`, in the sense of rotation of
/// the quadrilateral.
fn cut(nodes: [u32; 4], values: &BTreeMap<u32, f64>) -> Vec<Corner> {
    let is_inside = |node: u32| values.get(&node).is_some_and(|f| *f >= 0.0);
    let mut corners = Vec::with_capacity(6);
    for (&from, &to) in nodes.iter().zip(nodes.iter().cycle().skip(1)) {
        if is_inside(from) {
            corners.push((from, from, false));
        }
        if is_inside(from) != is_inside(to) {
            corners.push((from.min(to), from.max(to), false));
        }
    }
    corners
}

/// Returns `[x, depth]` of a corner.
fn position(
    (a, b, mirrored): Corner,
    solution: &BodySolution,
    values: &BTreeMap<u32, f64>,
) -> [f64; 2] {
    let node = |node: u32| solution.mesh.nodes[node as usize];
    let value = |node: u32| values.get(&node).copied().unwrap_or(0.0);
    let ([xa, ya], [xb, yb]) = (node(a), node(b));
    let (fa, fb) = (value(a), value(b));
    let t = if a == b { 0.0 } else { fa / (fa - fb) };
    let [x, depth] = solution.mesh.frame.place([xa + t * (xb - xa), ya + t * (yb - ya)]);
    [if mirrored { -x } else { x }, depth]
}

/// Directed edges whose opposite edge has not been added.
#[derive(Default)]
struct Edges(BTreeMap<Corner, Vec<Corner>>);

impl Edges {
    /// Adds an edge of a polygon, or cancels the opposite edge.
    fn add(&mut self, from: Corner, to: Corner) {
        if let Some(ends) = self.0.get_mut(&to)
            && let Some(k) = ends.iter().position(|end| *end == from)
        {
            ends.swap_remove(k);
        } else {
            self.0.entry(from).or_default().push(to);
        }
    }

    /// Chains the remaining edges to polygons. Every corner has as many incoming as outgoing
    /// edges, so that every chain closes.
    fn chain(mut self) -> Vec<Vec<Corner>> {
        let starts: Vec<Corner> = self.0.keys().copied().collect();
        let mut chains = Vec::new();
        for start in starts {
            while let Some(mut end) = self.0.get_mut(&start).and_then(Vec::pop) {
                let mut chain = vec![start];
                while end != start {
                    chain.push(end);
                    let Some(next) = self.0.get_mut(&end).and_then(Vec::pop) else { break };
                    end = next;
                }
                chains.push(chain);
            }
        }
        chains
    }
}

/// Returns the largest polygons, in descending order of area and thinned.
fn largest(mut polygons: Vec<Vec<[f64; 2]>>) -> Vec<Vec<[f64; 2]>> {
    let size = |polygon: &Vec<[f64; 2]>| signed_area(polygon).abs();
    polygons.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let least = polygons.first().map_or(0.0, |largest| NOISE * size(largest));
    polygons.retain(|polygon| polygon.len() >= 3 && size(polygon) > least);
    polygons.truncate(MAX_POLYGONS);
    for polygon in &mut polygons {
        let stride = polygon.len().div_ceil(MAX_POINTS);
        *polygon = polygon.iter().copied().step_by(stride).collect();
    }
    polygons
}

/// Returns the area of a polygon, positive anticlockwise.
fn signed_area(polygon: &[[f64; 2]]) -> f64 {
    let pairs = polygon.iter().zip(polygon.iter().cycle().skip(1));
    0.5 * pairs.map(|([x0, y0], [x1, y1])| x0 * y1 - x1 * y0).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shared_edges_cancel_and_the_rest_closes() {
        let corner = |node: u32| (node, node, false);
        let mut edges = Edges::default();
        for nodes in [[0, 1, 4, 3], [1, 2, 5, 4]] {
            for k in 0..4 {
                edges.add(corner(nodes[k]), corner(nodes[(k + 1) % 4]));
            }
        }
        let chains = edges.chain();
        assert_eq!(chains, [[0, 1, 2, 5, 4, 3].map(corner).to_vec()]);
    }

    #[test]
    fn a_quadrilateral_is_cut_at_the_zeros() {
        let values = BTreeMap::from([(0, 1.0), (1, -1.0), (2, -1.0), (3, 1.0)]);
        assert_eq!(
            cut([0, 1, 2, 3], &values),
            [(0, 0, false), (0, 1, false), (2, 3, false), (3, 3, false)]
        );
    }

    #[test]
    fn long_polygons_are_thinned_and_specks_dropped() {
        let circle = |n: u32, r: f64| -> Vec<[f64; 2]> {
            let angles = (0..n).map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(n));
            angles.map(|t| [r * t.cos(), r * t.sin()]).collect()
        };
        let kept = largest(vec![circle(8, 0.01), circle(2000, 1.0)]);
        assert_eq!(kept.len(), 1);
        assert_eq!(kept[0].len(), MAX_POINTS);
        assert!((signed_area(&kept[0]) - std::f64::consts::PI).abs() < 1e-3);
    }
}
