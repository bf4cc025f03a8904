//! A former answer on another mesh of the same body: where to start from on this one.

use crate::fem::assembly::Equations;
use crate::fem::element::{Kinematics, QUADRATURE_POINTS, Quad, SHAPE_AT_POINTS};
use crate::fem::mesh::{Locator, Mesh};

/// Displacements on a mesh of the same body.
#[derive(Debug, Clone, Copy)]
pub(super) struct FormerField<'a> {
    pub mesh: &'a Mesh,
    /// `[u_x, u_y]` of every node \[mm\].
    pub displacement: &'a [[f64; 2]],
}

/// A former field at the nodes of another mesh.
pub(super) struct Carried {
    /// `[u_x, u_y]` \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// `[ε_xx, ε_yy, ε_zz, γ_xy]`.
    strain: Vec<[f64; 4]>,
}

impl Carried {
    /// Carries a field to the nodes of a mesh that are wanted; zero at the others.
    pub fn new(field: FormerField<'_>, kinematics: Kinematics, mesh: &Mesh, wanted: &[bool]) -> Self {
        let known = nodal_strain(field, kinematics);
        let mut locator = Locator::new(field.mesh);
        let mut carried =
            Self { displacement: vec![[0.0; 2]; mesh.nodes.len()], strain: vec![[0.0; 4]; mesh.nodes.len()] };
        for node in (0..mesh.nodes.len()).filter(|&node| wanted[node]) {
            let place = locator.locate(mesh.nodes[node]);
            carried.displacement[node] = place.interpolate(field.displacement);
            carried.strain[node] = place.interpolate(&known);
        }
        carried
    }

    /// Strains at the Gauss points of an element with these nodes, by its shape functions.
    ///
    /// They belong to a continuous field. The strains of the carried displacements themselves jump at every edge of the
    /// former mesh, and moduli taken from them cost twice as many iterations.
    pub fn strain(&self, nodes: &[u32; 4]) -> [[f64; QUADRATURE_POINTS]; 4] {
        let mut strain = [[0.0; QUADRATURE_POINTS]; 4];
        for (&node, shape) in nodes.iter().zip(SHAPE_AT_POINTS.iter()) {
            let value = self.strain[node as usize];
            for (component, v) in strain.iter_mut().zip(value) {
                for (sum, weight) in component.iter_mut().zip(shape) {
                    *sum += weight * v;
                }
            }
        }
        strain
    }

    /// Displacements by equation, on the given ones.
    pub fn displacement_on(&self, window: &[u32], equations: &Equations) -> Vec<f64> {
        let mut displacement = vec![0.0; equations.len() + 1];
        for &equation in window {
            let (node, component) = equations.origin(equation);
            displacement[equation as usize] = self.displacement[node as usize][usize::from(component)];
        }
        displacement
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
