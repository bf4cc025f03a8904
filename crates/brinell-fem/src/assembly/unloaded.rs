//! A body before any load, from which points start.

use crate::element::{QUADRATURE_POINTS, Quad, StressState};
use crate::mesh::Mesh;
use brinell_material::{ConstitutiveModel, PointOrigin};

/// Stress `[σ_xx, σ_yy, σ_zz, τ_xy]` at the points of each element \[MPa\].
pub type PointStresses = Vec<[[f64; 4]; QUADRATURE_POINTS]>;

/// A meshed body before any load.
#[derive(Debug, Clone, Copy)]
pub struct Unloaded<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The condition of the third direction.
    pub stress_state: StressState,
    /// The residual stress in equilibrium; `None` if there is none.
    pub initial_stress: Option<&'a PointStresses>,
}

impl Unloaded<'_> {
    /// The states of a model at the points of an element.
    pub(super) fn states<M: ConstitutiveModel>(
        &self,
        model: &M,
        element: usize,
    ) -> [M::State; QUADRATURE_POINTS] {
        let corners = self.mesh.corners(element);
        std::array::from_fn(|g| {
            model.at_rest(&PointOrigin {
                position: Quad::point(&corners, g),
                initial_stress: self.initial_stress.map_or([0.0; 4], |stress| stress[element][g]),
            })
        })
    }
}
