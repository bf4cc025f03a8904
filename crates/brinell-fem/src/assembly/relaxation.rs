//! The residual stress of an unloaded body, from a given stress σ_g that need not be in
//! equilibrium.
//!
//! ```text
//! K u_0 = -∫ Bᵀ σ_g dV,   σ_r = σ_g + D ε(u_0)        ∫ Bᵀ σ_r dV = 0
//! ```
//!
//! The displacements u_0 are not kept: the outline of a job describes the stressed body. A stress
//! that depends only on the depth below a plane is in equilibrium and is not relaxed: the
//! continuation of the body would exert its tractions on the side walls.

use super::{Equations, PointStresses};
use crate::element::{QUADRATURE_POINTS, Quad, StressState};
use crate::mesh::Mesh;
use brinell_material::{ElasticModuli, OutOfPlane, PerPoint};

/// Evaluates a given stress field at the points of a mesh. Each element takes the mean pressure,
/// for which the plain strain matrix and B-bar give the same nodal forces.
pub fn given_stress(
    mesh: &Mesh,
    stress_state: StressState,
    stress: impl Fn([f64; 2]) -> [f64; 4],
) -> PointStresses {
    let at_element = |element: usize| {
        let corners = mesh.corners(element);
        let quad = Quad::new(&corners, stress_state);
        let mut points: [[f64; 4]; QUADRATURE_POINTS] =
            std::array::from_fn(|g| stress(Quad::point(&corners, g)));
        if stress_state != StressState::PlaneStress {
            let pressure = points.map(|[x, y, z, _]| (x + y + z) / 3.0);
            let total: f64 = pressure.iter().zip(quad.weight).map(|(p, w)| p * w).sum();
            let mean = total / quad.volume();
            for (point, own) in points.iter_mut().zip(pressure) {
                for component in &mut point[..3] {
                    *component += mean - own;
                }
            }
        }
        points
    };
    (0..mesh.elements.len()).map(at_element).collect()
}

/// `∫ Bᵀ σ dV` by equation, with the extra entry that stands for held components left zero
/// \[N/mm\].
pub fn initial_force(
    mesh: &Mesh,
    stress_state: StressState,
    equations: &Equations,
    stress: &PointStresses,
) -> Vec<f64> {
    let mut force = vec![0.0; equations.len() + 1];
    for (element, points) in stress.iter().enumerate() {
        let quad = Quad::new(&mesh.corners(element), stress_state);
        let components: [PerPoint; 4] =
            std::array::from_fn(|k| std::array::from_fn(|g| points[g][k]));
        for (&node, at_node) in mesh.elements[element].iter().zip(quad.nodal_forces(&components)) {
            for (&k, f) in equations.of_node(node).iter().zip(at_node) {
                force[k as usize] += f;
            }
        }
    }
    force[equations.len()] = 0.0;
    force
}

/// The stress after elastic displacements `[u_x, u_y]` of every node \[mm\].
pub fn relaxed_stress(
    mesh: &Mesh,
    stress_state: StressState,
    elastic: ElasticModuli,
    given: &PointStresses,
    displacement: &[[f64; 2]],
) -> PointStresses {
    let out_of_plane = super::out_of_plane(stress_state);
    let at_element = |(element, given): (usize, &[[f64; 4]; QUADRATURE_POINTS])| {
        let quad = Quad::new(&mesh.corners(element), stress_state);
        let mut strain =
            quad.strain(&mesh.elements[element].map(|node| displacement[node as usize]));
        if out_of_plane == OutOfPlane::Strained {
            quad.average_dilatation(&mut strain);
        }
        std::array::from_fn(|g| {
            let added = elastic.stress(strain.map(|component| component[g]), out_of_plane);
            std::array::from_fn(|k| given[g][k] + added[k])
        })
    };
    given.iter().enumerate().map(at_element).collect()
}
