//! Stresses at the Gauss points of a whole body.

use super::out_of_plane;
use crate::fem::element::{QUADRATURE_POINTS, Quad, StressState};
use crate::fem::mesh::Mesh;
use crate::job::Deformable;
use crate::material::PointLaw;
use sparse_cholesky::wide;

/// State of one Gauss point.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct GaussPoint {
    /// `[x, y]` \[mm\].
    pub position: [f64; 2],
    /// Area times thickness that the point stands for.
    pub weight: f64,
    /// Area of the section that the point stands for \[mm²\].
    pub area: f64,
    /// `[σ_xx, σ_yy, σ_zz, τ_xy]` \[MPa\], tensile positive.
    pub stress: [f64; 4],
    /// Equivalent plastic strain.
    pub equivalent_plastic_strain: f64,
    /// Secant shear modulus G_s \[MPa\].
    pub secant_shear: f64,
    /// Whether the point is beyond yield.
    pub yielded: bool,
}

/// All Gauss points of a body and the nodal forces of their stresses.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StressField {
    /// Points of each element.
    pub points: Vec<[GaussPoint; QUADRATURE_POINTS]>,
    /// `∫ B̄ᵀ σ dV` for every node, `[x, y]` \[N/mm\].
    pub internal_force: Vec<[f64; 2]>,
}

impl StressField {
    /// Evaluates the material law at nodal displacements `[u_x, u_y]` \[mm\].
    pub fn evaluate(
        mesh: &Mesh,
        stress_state: StressState,
        material: &Deformable,
        displacement: &[[f64; 2]],
    ) -> Self {
        let law = PointLaw::new(material, out_of_plane(stress_state));
        let mut field = Self {
            points: Vec::with_capacity(mesh.elements.len()),
            internal_force: vec![[0.0; 2]; mesh.nodes.len()],
        };
        wide(|| {
            for (element, nodes) in mesh.elements.iter().enumerate() {
                let corners = mesh.corners(element);
                let quad = Quad::new(&corners, stress_state);
                let strain = quad.strain(&nodes.map(|node| displacement[node as usize]));
                let dilatation = quad.mean_dilatation(&strain);
                let mut points = [GaussPoint::default(); QUADRATURE_POINTS];
                let mut stress = [[0.0; QUADRATURE_POINTS]; 4];
                for (g, point) in points.iter_mut().enumerate() {
                    let state = law.respond(strain.map(|component| component[g]), dilatation);
                    for (component, value) in stress.iter_mut().zip(state.stress) {
                        component[g] = value;
                    }
                    *point = GaussPoint {
                        position: Quad::point(&corners, g),
                        weight: quad.weight[g],
                        area: quad.area(&corners, g),
                        stress: state.stress,
                        equivalent_plastic_strain: state.equivalent_plastic_strain,
                        secant_shear: state.secant_shear,
                        yielded: state.yielded,
                    };
                }
                for (node, force) in nodes.iter().zip(quad.nodal_forces(&stress)) {
                    let total = &mut field.internal_force[*node as usize];
                    *total = [total[0] + force[0], total[1] + force[1]];
                }
                field.points.push(points);
            }
        });
        field
    }

    /// Gauss points beyond yield.
    pub fn plastic_points(&self) -> usize {
        self.points.iter().flatten().filter(|point| point.yielded).count()
    }

    /// Secant shear moduli at the points of an element \[MPa\].
    pub fn secant_shear(&self, element: usize) -> [f64; QUADRATURE_POINTS] {
        self.points[element].map(|point| point.secant_shear)
    }
}
