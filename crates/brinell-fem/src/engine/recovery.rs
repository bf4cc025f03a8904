//! Stresses at any point of a body, recovered from the Gauss points.
//!
//! The mean stress over an element is the most accurate value it has, and it belongs to its
//! centroid. Around each node the means of the surrounding elements are fitted by a plane,
//! component by component, and the plane is read at the node; between nodes values are
//! interpolated by the shape functions. At a boundary the patch is one layer of elements deeper;
//! on the symmetry axis it is completed by mirror images.
//!
//! # Reference
//! O. C. Zienkiewicz, J. Z. Zhu, *The superconvergent patch recovery and a posteriori error
//! estimates*, Int. J. Numer. Meth. Engng 33 (1992) 1331–1364.

use std::collections::HashMap;

use nalgebra::{Matrix3, RowSVector, SMatrix, Vector3};

use crate::assembly::GaussPoint;
use crate::element::{QUADRATURE_POINTS, natural_coordinates, shape_functions};
use crate::engine::body_solution::BodySolution;
use crate::mesh::Mesh;

/// `[σ_xx, σ_yy, σ_zz, τ_xy, ε_p, q]` at a point, q the largest von Mises stress so far \[MPa,
/// MPa, MPa, MPa, 1, MPa\].
pub type Values = [f64; 6];

/// Recovers values on one body, node by node as they are needed.
pub struct Recovery<'a> {
    body: &'a BodySolution,
    symmetric: bool,
    elements_around: ElementsAround,
    at_node: HashMap<u32, Values>,
    /// The element that the last point was found in.
    last: usize,
}

/// The elements around each node: those of node `k` are `elements[offsets[k]..offsets[k + 1]]`.
struct ElementsAround {
    offsets: Vec<u32>,
    elements: Vec<u32>,
}

impl ElementsAround {
    fn of(mesh: &Mesh) -> Self {
        // The first entry of a node serves as the place of its next element while they are filled
        // in.
        let mut offsets = vec![0u32; mesh.nodes.len() + 2];
        for &node in mesh.elements.iter().flatten() {
            offsets[node as usize + 2] += 1;
        }
        let mut total = 0;
        for offset in &mut offsets {
            total += *offset;
            *offset = total;
        }
        let mut elements = vec![0; 4 * mesh.elements.len()];
        for (element, nodes) in (0u32..).zip(&mesh.elements) {
            for &node in nodes {
                let place = &mut offsets[node as usize + 1];
                elements[*place as usize] = element;
                *place += 1;
            }
        }
        Self { offsets, elements }
    }

    fn node(&self, node: u32) -> &[u32] {
        let range = self.offsets[node as usize]..self.offsets[node as usize + 1];
        &self.elements[range.start as usize..range.end as usize]
    }
}

impl<'a> Recovery<'a> {
    /// Recovers fields of a body; of a half model, with its image.
    pub fn new(body: &'a BodySolution, symmetric: bool) -> Self {
        let elements_around = ElementsAround::of(&body.mesh);
        Self { body, symmetric, elements_around, at_node: HashMap::new(), last: 0 }
    }

    /// Values at a point `[x, y]` of the body \[mm\]; `None` outside the mesh. Cheap next to the
    /// point before.
    pub fn at(&mut self, point: [f64; 2]) -> Option<Values> {
        let mesh = &self.body.mesh;
        let within = |element: usize| {
            shape_within(&mesh.corners(element), point).map(|shape| (element, shape))
        };
        let around = mesh.elements[self.last].iter().flat_map(|&node| self.elements_of(node));
        let near = around.map(|&element| element as usize).find_map(within);
        let (element, shape) = near.or_else(|| (0..mesh.elements.len()).find_map(within))?;
        self.last = element;
        let mut values = [0.0; 6];
        for (&node, weight) in mesh.elements[element].iter().zip(shape) {
            for (value, recovered) in values.iter_mut().zip(self.node(node)) {
                *value += weight * recovered;
            }
        }
        values[4] = values[4].max(0.0);
        Some(values)
    }

    /// Takes stress and equivalent plastic strain at a node as known.
    pub fn know(&mut self, node: u32, stress: [f64; 4], plastic_strain: f64) {
        let [.., largest_von_mises] = self.node(node);
        let [x, y, z, shear] = stress;
        self.at_node.insert(node, [x, y, z, shear, plastic_strain, largest_von_mises]);
    }

    /// Values at a node.
    pub fn node(&mut self, node: u32) -> Values {
        if let Some(values) = self.at_node.get(&node) {
            return *values;
        }
        let values = self.fit(node);
        self.at_node.insert(node, values);
        values
    }

    /// Values at every node, in time proportional to their number.
    pub fn nodes(&mut self) -> Vec<Values> {
        (0u32..)
            .take(self.body.mesh.nodes.len())
            .map(|node| {
                let mut values = self.node(node);
                values[4] = values[4].max(0.0);
                values
            })
            .collect()
    }

    /// The elements around a node.
    pub fn elements_of(&self, node: u32) -> &[u32] {
        self.elements_around.node(node)
    }

    fn fit(&self, node: u32) -> Values {
        let centre = self.body.mesh.nodes[node as usize];
        let on_axis = self.symmetric && centre[0] == 0.0;
        let own = self.elements_of(node);
        let mut patch = own.to_vec();
        // An interior node has four elements, one on the axis two and their images.
        if own.len() * if on_axis { 2 } else { 1 } < 4 {
            let nodes = own.iter().flat_map(|&e| self.body.mesh.elements[e as usize]);
            patch = nodes.flat_map(|n| self.elements_of(n).iter().copied()).collect();
            patch.sort_unstable();
            patch.dedup();
        }
        let mut samples: Vec<([f64; 2], Values)> =
            patch.iter().map(|&e| element_mean(&self.body.stress.points[e as usize])).collect();
        if on_axis {
            let images = samples.clone();
            samples.extend(images.into_iter().map(|([x, y], mut values)| {
                values[3] = -values[3];
                ([-x, y], values)
            }));
        }
        plane_fit(&samples, centre)
    }
}

/// Centroid of an element and the mean values over it.
fn element_mean(points: &[GaussPoint; QUADRATURE_POINTS]) -> ([f64; 2], Values) {
    let mean = GaussPoint::mean(points);
    let [x, y, z, t] = mean.stress;
    (mean.position, [x, y, z, t, mean.equivalent_plastic_strain, mean.largest_von_mises])
}

/// Least-squares plane through samples, read at `centre`; their mean where they determine no
/// plane.
fn plane_fit(samples: &[([f64; 2], Values)], centre: [f64; 2]) -> Values {
    let scale = samples
        .iter()
        .map(|([x, y], _)| (x - centre[0]).abs().max((y - centre[1]).abs()))
        .fold(f64::MIN_POSITIVE, f64::max);
    let (mut normal, mut right) = (Matrix3::zeros(), SMatrix::<f64, 3, 6>::zeros());
    for ([x, y], values) in samples {
        let basis = Vector3::new(1.0, (x - centre[0]) / scale, (y - centre[1]) / scale);
        normal += basis * basis.transpose();
        right += basis * RowSVector::from(*values);
    }
    let at_centre = normal.cholesky().map(|factor| factor.solve(&right).row(0).into_owned());
    at_centre.unwrap_or_else(|| right.row(0) / samples.len() as f64).into()
}

/// Shape functions of a quadrilateral at a point; `None` if the point lies outside it.
fn shape_within(corners: &[[f64; 2]; 4], point: [f64; 2]) -> Option<[f64; 4]> {
    const OUTSIDE: f64 = 1.0 + 1e-7;
    for (k, &coordinate) in point.iter().enumerate() {
        let values = corners.iter().map(|c| c[k]);
        let (low, high) = (
            values.clone().fold(f64::INFINITY, f64::min),
            values.fold(f64::NEG_INFINITY, f64::max),
        );
        let slack = 1e-9 * (high - low);
        if coordinate < low - slack || coordinate > high + slack {
            return None;
        }
    }
    let natural = natural_coordinates(corners, point);
    natural.iter().all(|t| t.abs() <= OUTSIDE).then(|| shape_functions(natural))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_is_recovered_exactly() {
        let value = |x: f64, y: f64| [1.0 + x, y, 2.0 * x - y, 3.0, 0.0, x + y];
        let samples: Vec<_> = [(0.0, 0.0), (1.0, 0.1), (0.2, 1.0), (1.3, 0.9), (2.0, 0.4)]
            .map(|(x, y)| ([x, y], value(x, y)))
            .to_vec();
        for (got, expected) in plane_fit(&samples, [5.0, -2.0]).iter().zip(value(5.0, -2.0)) {
            assert!((got - expected).abs() < 1e-12);
        }
    }

    #[test]
    fn points_are_found_inside_and_refused_outside() {
        let corners = [[0.0, 0.0], [2.0, 0.3], [2.4, 1.9], [-0.2, 1.5]];
        let shape = shape_within(&corners, [1.1, 0.9]).unwrap();
        for k in 0..2 {
            let position: f64 = shape.iter().zip(&corners).map(|(n, c)| n * c[k]).sum();
            assert!((position - [1.1, 0.9][k]).abs() < 1e-12);
        }
        assert_eq!(shape_within(&corners, [2.3, 0.2]), None);
        assert!(shape_within(&corners, [0.0, 0.0]).is_some());
    }
}
