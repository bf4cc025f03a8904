//! The transfer of an answer to another mesh of the same body, as the initial state there.

use crate::assembly::Equations;
use crate::element::{QUADRATURE_POINTS, Quad, SHAPE_AT_POINTS, StressState};
use crate::mesh::{Locator, Mesh, Place};

/// Displacements on a mesh of the same body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NodalField<'a> {
    pub mesh: &'a Mesh,
    /// `[u_x, u_y]` of every node \[mm\].
    pub displacement: &'a [[f64; 2]],
}

/// The places of the nodes of one mesh in another one.
pub(crate) struct Places(Vec<Option<Place>>);

impl Places {
    /// Finds the wanted nodes of a mesh in another one.
    pub fn of(mesh: &Mesh, wanted: &[bool], within: &Mesh) -> Self {
        let mut locator = Locator::new(within);
        let nodes = mesh.nodes.iter().zip(wanted);
        Self(nodes.map(|(node, is_wanted)| is_wanted.then(|| locator.locate(*node))).collect())
    }
}

/// A previous field at the nodes of another mesh.
pub(crate) struct TransferredField {
    /// `[u_x, u_y]` \[mm\].
    pub displacement: Vec<[f64; 2]>,
    /// `[ε_xx, ε_yy, ε_zz, γ_xy]`.
    strain: Vec<[f64; 4]>,
}

impl TransferredField {
    /// Transfers a field to the nodes that have a place in its mesh; zero at other nodes.
    pub fn new(field: NodalField<'_>, stress_state: StressState, places: &Places) -> Self {
        let known = nodal_strain(field, stress_state);
        let Places(places) = places;
        let mut transferred = Self {
            displacement: vec![[0.0; 2]; places.len()],
            strain: vec![[0.0; 4]; places.len()],
        };
        for (node, place) in places.iter().enumerate() {
            if let Some(place) = place {
                transferred.displacement[node] = place.interpolate(field.displacement);
                transferred.strain[node] = place.interpolate(&known);
            }
        }
        transferred
    }

    /// Strains at the Gauss points of an element with these nodes, by its shape functions.
    ///
    /// They belong to a continuous field. The strains of the transferred displacements themselves
    /// jump at every edge of the previous mesh, and moduli taken from them cost twice as many
    /// iterations.
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
    pub fn displacement_on(&self, active_equations: &[u32], equations: &Equations) -> Vec<f64> {
        let mut displacement = vec![0.0; equations.len() + 1];
        for &equation in active_equations {
            let (node, component) = equations.origin(equation);
            displacement[equation as usize] =
                self.displacement[node as usize][usize::from(component)];
        }
        displacement
    }
}

/// At each node the mean of the strains in the middle of the elements around it.
fn nodal_strain(field: NodalField<'_>, stress_state: StressState) -> Vec<[f64; 4]> {
    let NodalField { mesh, displacement } = field;
    let mut sums = vec![([0.0; 4], 0u32); mesh.nodes.len()];
    for (element, nodes) in mesh.elements.iter().enumerate() {
        let quad = Quad::new(&mesh.corners(element), stress_state);
        let strain = quad.strain(&nodes.map(|node| displacement[node as usize]));
        let middle =
            strain.map(|component| component.iter().sum::<f64>() / QUADRATURE_POINTS as f64);
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
