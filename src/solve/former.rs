//! A former answer on another mesh of the same body: where to start from on this one.

use crate::element::{Kinematics, QUADRATURE_POINTS, Quad};
use crate::mesh::{Locator, Mesh};

/// Displacements on a mesh of the same body.
#[derive(Debug, Clone, Copy)]
pub(super) struct FormerField<'a> {
    pub mesh: &'a Mesh,
    /// `[u_x, u_y]` of every node \[mm\].
    pub displacement: &'a [[f64; 2]],
}

/// A former field made ready to be read at any point.
pub(super) struct Carrier<'a> {
    locator: Locator<'a>,
    displacement: &'a [[f64; 2]],
    strain: Vec<[f64; 4]>,
}

impl<'a> Carrier<'a> {
    pub fn new(field: FormerField<'a>, kinematics: Kinematics) -> Self {
        Self {
            locator: Locator::new(field.mesh),
            displacement: field.displacement,
            strain: nodal_strain(field, kinematics),
        }
    }

    /// Displacement at a point \[mm\].
    pub fn displacement(&mut self, point: [f64; 2]) -> [f64; 2] {
        self.locator.interpolate(point, self.displacement)
    }

    /// Strains `[ε_xx, ε_yy, ε_zz, γ_xy]` at the Gauss points of an element with these corners.
    ///
    /// They are read off a continuous field. The strains of the carried displacements themselves jump at every edge of
    /// the former mesh, and moduli taken from them cost half as many iterations again.
    pub fn strain(&mut self, corners: &[[f64; 2]; 4]) -> [[f64; QUADRATURE_POINTS]; 4] {
        let mut strain = [[0.0; QUADRATURE_POINTS]; 4];
        for g in 0..QUADRATURE_POINTS {
            let value = self.locator.interpolate(Quad::point(corners, g), &self.strain);
            for (component, v) in strain.iter_mut().zip(value) {
                component[g] = v;
            }
        }
        strain
    }
}

/// At each node the mean of the strains in the middle of the elements around it.
fn nodal_strain(field: FormerField<'_>, kinematics: Kinematics) -> Vec<[f64; 4]> {
    let FormerField { mesh, displacement } = field;
    let mut sums = vec![([0.0; 4], 0u32); mesh.nodes.len()];
    for (element, nodes) in mesh.elements.iter().enumerate() {
        let quad = Quad::new(&mesh.corners(element), kinematics);
        let strain = quad.strain(&nodes.map(|node| displacement[node as usize]));
        let middle = strain.map(|component| component.iter().sum::<f64>() / QUADRATURE_POINTS as f64);
        for &node in nodes {
            let (sum, count) = &mut sums[node as usize];
            *count += 1;
            for (total, value) in sum.iter_mut().zip(middle) {
                *total += value;
            }
        }
    }
    sums.into_iter().map(|(sum, count)| sum.map(|total| total / f64::from(count.max(1)))).collect()
}
