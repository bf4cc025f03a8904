//! Stresses at the Gauss points of a whole body.

use super::Unloaded;
use crate::element::{QUADRATURE_POINTS, Quad};
use crate::mesh::Mesh;
use brinell_material::{ConstitutiveModel, OutOfPlane, von_mises};
use dense_cholesky::simd_dispatch;

/// State of one Gauss point.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct GaussPoint {
    /// `[x, y]` \[mm\].
    pub position: [f64; 2],
    /// Area times thickness of the point.
    pub weight: f64,
    /// Area of the section of the point \[mm²\].
    pub area: f64,
    /// `[σ_xx, σ_yy, σ_zz, τ_xy]` \[MPa\], tensile positive.
    pub stress: [f64; 4],
    /// Equivalent plastic strain.
    pub equivalent_plastic_strain: f64,
    /// Equivalent strain `√(2/3 e:e)` of the total strain, in plane stress for constant volume.
    pub equivalent_strain: f64,
    /// Secant shear modulus G_s \[MPa\].
    pub secant_shear: f64,
    /// Whether the point is beyond yield.
    pub yielded: bool,
    /// Equivalent plastic strain gained since the load last began to fall.
    pub reverse_plastic_strain: f64,
    /// Largest von Mises stress at the ends of the increments so far \[MPa\].
    pub largest_von_mises: f64,
    /// `∫σ:dε_p` over the history \[MPa\].
    pub plastic_work: f64,
    /// The part of this work that the backstress stores \[MPa\].
    pub backstress_energy: f64,
}

impl GaussPoint {
    /// The strain that decides whether strains are small: the equivalent plastic one or, where
    /// that accumulates over a history of loads, the equivalent strain if it is less.
    pub fn strain(&self, accumulates: bool) -> f64 {
        if accumulates {
            self.equivalent_plastic_strain.min(self.equivalent_strain)
        } else {
            self.equivalent_plastic_strain
        }
    }

    /// The mean over an element, weighted by volume, at the centroid of the points; it stands for
    /// the whole element and has yielded if one of its points has.
    pub fn mean(points: &[Self; QUADRATURE_POINTS]) -> Self {
        let weight: f64 = points.iter().map(|point| point.weight).sum();
        let mean = |value: &dyn Fn(&Self) -> f64| {
            points.iter().map(|point| point.weight / weight * value(point)).sum::<f64>()
        };
        Self {
            position: std::array::from_fn(|k| mean(&|point| point.position[k])),
            weight,
            area: points.iter().map(|point| point.area).sum(),
            stress: std::array::from_fn(|k| mean(&|point| point.stress[k])),
            equivalent_plastic_strain: mean(&|point| point.equivalent_plastic_strain),
            equivalent_strain: mean(&|point| point.equivalent_strain),
            secant_shear: mean(&|point| point.secant_shear),
            yielded: points.iter().any(|point| point.yielded),
            reverse_plastic_strain: mean(&|point| point.reverse_plastic_strain),
            largest_von_mises: mean(&|point| point.largest_von_mises),
            plastic_work: mean(&|point| point.plastic_work),
            backstress_energy: mean(&|point| point.backstress_energy),
        }
    }
}

/// All Gauss points of a body and the nodal forces of their stresses.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StressField {
    /// Points of each element.
    pub points: Vec<[GaussPoint; QUADRATURE_POINTS]>,
    /// `∫ B̄ᵀ σ dV` for every node, `[x, y]` \[N/mm\].
    pub internal_force: Vec<[f64; 2]>,
}

/// Evaluates a model at nodal displacements `[u_x, u_y]` \[mm\], from the states of the points of
/// each element that has them. Points of other elements are zero.
pub(super) fn evaluate<M: ConstitutiveModel>(
    model: &M,
    unloaded: &Unloaded<'_>,
    displacement: &[[f64; 2]],
    states: impl Fn(usize) -> Option<[M::State; QUADRATURE_POINTS]>,
) -> StressField {
    let Unloaded { mesh, stress_state, .. } = *unloaded;
    let mut field = StressField {
        points: Vec::with_capacity(mesh.elements.len()),
        internal_force: vec![[0.0; 2]; mesh.nodes.len()],
    };
    simd_dispatch(|| {
        for (element, nodes) in mesh.elements.iter().enumerate() {
            let Some(states) = states(element) else {
                field.points.push(Default::default());
                continue;
            };
            let corners = mesh.corners(element);
            let quad = Quad::new(&corners, stress_state);
            let mut strain = quad.strain(&nodes.map(|node| displacement[node as usize]));
            if model.out_of_plane() == OutOfPlane::Strained {
                quad.average_dilatation(&mut strain);
            }
            let mut points = [GaussPoint::default(); QUADRATURE_POINTS];
            let mut stress = [[0.0; QUADRATURE_POINTS]; 4];
            for (g, point) in points.iter_mut().enumerate() {
                let at_point = strain.map(|component| component[g]);
                let (response, _) = model.update(at_point, &states[g]);
                for (component, value) in stress.iter_mut().zip(response.stress) {
                    component[g] = value;
                }
                *point = GaussPoint {
                    position: Quad::point(&corners, g),
                    weight: quad.weight[g],
                    area: quad.area(&corners, g),
                    stress: response.stress,
                    equivalent_plastic_strain: response.equivalent_plastic_strain,
                    equivalent_strain: equivalent(at_point, model.out_of_plane()),
                    secant_shear: response.secant_shear,
                    yielded: response.yielded,
                    reverse_plastic_strain: 0.0,
                    largest_von_mises: von_mises(response.stress),
                    plastic_work: response.plastic_work,
                    backstress_energy: response.backstress_energy,
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

/// `√(2/3 e:e)` of a strain `[ε_xx, ε_yy, ε_zz, γ_xy]`.
fn equivalent([xx, yy, zz, shear]: [f64; 4], out_of_plane: OutOfPlane) -> f64 {
    let zz = if out_of_plane == OutOfPlane::Strained { zz } else { -(xx + yy) };
    let mean = (xx + yy + zz) / 3.0;
    let squares =
        (xx - mean).powi(2) + (yy - mean).powi(2) + (zz - mean).powi(2) + 0.5 * shear * shear;
    (squares / 1.5).sqrt()
}

impl StressField {
    /// The stresses of a mesh on which none are evaluated.
    pub fn zeros(mesh: &Mesh) -> Self {
        Self {
            points: vec![Default::default(); mesh.elements.len()],
            internal_force: vec![[0.0; 2]; mesh.nodes.len()],
        }
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
