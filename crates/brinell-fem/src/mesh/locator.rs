//! The location of points in a mesh, for the transfer of fields between meshes.

use std::collections::HashMap;

use super::Mesh;
use crate::element::{natural_coordinates, shape_functions};

/// Finds points by walking from element to element. A search starts where the last one ended, so
/// that points taken in the order of a structured mesh cost a few steps each.
#[derive(Debug)]
pub struct Locator<'a> {
    mesh: &'a Mesh,
    /// Element beyond each side of each element; side k runs from corner k to the next.
    neighbours: Vec<[Option<u32>; 4]>,
    last: usize,
}

/// A point in a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Nodes of the element that holds it.
    pub nodes: [u32; 4],
    /// Their shape functions there.
    pub shape: [f64; 4],
}

impl Place {
    /// The value of a field given at the nodes of the mesh.
    pub fn interpolate<const N: usize>(&self, field: &[[f64; N]]) -> [f64; N] {
        let mut value = [0.0; N];
        for (&node, weight) in self.nodes.iter().zip(self.shape) {
            for (sum, v) in value.iter_mut().zip(&field[node as usize]) {
                *sum += weight * v;
            }
        }
        value
    }
}

/// Steps after which a walk counts as a cycle.
const MAX_STEPS: usize = 10_000;

impl<'a> Locator<'a> {
    /// Prepares the search. Cost: linear in the elements.
    pub fn new(mesh: &'a Mesh) -> Self {
        let mut open: HashMap<(u32, u32), (u32, usize)> =
            HashMap::with_capacity(2 * mesh.elements.len());
        let mut neighbours = vec![[None; 4]; mesh.elements.len()];
        for (element, nodes) in (0u32..).zip(&mesh.elements) {
            for side in 0..4 {
                let (a, b) = (nodes[side], nodes[(side + 1) % 4]);
                // A neighbour runs along the common side the other way.
                if let Some((other, its_side)) = open.remove(&(b, a)) {
                    neighbours[element as usize][side] = Some(other);
                    neighbours[other as usize][its_side] = Some(element);
                } else {
                    open.insert((a, b), (element, side));
                }
            }
        }
        Self { mesh, neighbours, last: 0 }
    }

    /// Returns the place of a point `[x, y]`. A point slightly outside the mesh is moved to its
    /// boundary.
    pub fn locate(&mut self, point: [f64; 2]) -> Place {
        let mut element = self.last;
        for _ in 0..MAX_STEPS {
            match self.way_out(element, point) {
                Some(next) => element = next as usize,
                None => break,
            }
        }
        self.last = element;
        let natural =
            natural_coordinates(&self.mesh.corners(element), point).map(|t| t.clamp(-1.0, 1.0));
        Place { nodes: self.mesh.elements[element], shape: shape_functions(natural) }
    }

    /// The neighbour beyond the side that a point lies farthest outside of, relative to the length
    /// of the side.
    fn way_out(&self, element: usize, [x, y]: [f64; 2]) -> Option<u32> {
        let corners = self.mesh.corners(element);
        let outside = |side: usize| {
            let ([ax, ay], [bx, by]) = (corners[side], corners[(side + 1) % 4]);
            let (dx, dy) = (bx - ax, by - ay);
            ((x - ax) * dy - (y - ay) * dx) / (dx * dx + dy * dy)
        };
        let beyond =
            (0..4).filter_map(|side| Some((outside(side), self.neighbours[element][side]?)));
        let farthest = beyond.max_by(|a, b| a.0.total_cmp(&b.0));
        farthest.filter(|(distance, _)| *distance > 1e-9).map(|(_, next)| next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{ContactZone, Outline, Refinement};

    fn mesh(columns: usize, symmetric: bool) -> Mesh {
        let outline = Outline::arc(0.05, 20.0, 20.0);
        let x_min = if symmetric { 0.0 } else { -0.5 };
        let zone = ContactZone::uniform(x_min, 0.5, columns, symmetric);
        Mesh::generate(&outline, &zone, Refinement { growth: 1.3 }).unwrap()
    }

    /// A linear field is transferred exactly, but for the sagitta of the arc between two nodes of
    /// the surface.
    #[test]
    fn a_linear_field_is_read_exactly_at_the_nodes_of_another_mesh() {
        for symmetric in [true, false] {
            let (coarse, fine) = (mesh(8, symmetric), mesh(14, symmetric));
            let linear = |[x, y]: [f64; 2]| [1.0 + 0.3 * x - 0.2 * y, 0.5 * x + 0.1 * y];
            let field: Vec<[f64; 2]> = coarse.nodes.iter().map(|&node| linear(node)).collect();
            let mut locator = Locator::new(&coarse);
            let surface = |[x, y]: [f64; 2]| x.hypot(y + 20.0) > 19.999 || y > -1e-3;
            for &node in fine.nodes.iter().filter(|node| !surface(**node)) {
                let (found, expected) = (locator.locate(node).interpolate(&field), linear(node));
                for (a, b) in found.iter().zip(expected) {
                    assert!((a - b).abs() < 1e-9, "{node:?}: {found:?} for {expected:?}");
                }
            }
        }
    }

    #[test]
    fn a_point_beside_the_mesh_takes_the_value_at_the_border() {
        let mesh = mesh(8, true);
        let field: Vec<[f64; 1]> = mesh.nodes.iter().map(|[x, _]| [*x]).collect();
        let [value] = Locator::new(&mesh).locate([-1.0, -3.0]).interpolate(&field);
        assert!(value.abs() < 1e-12);
    }
}
