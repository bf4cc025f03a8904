//! States of a material that stays where it is while its mesh moves.
//!
//! ```text
//! S(x_g + δx_g) = S_g + Σ_i (∇N_i · δx_g) S̄_i,     S̄_i: mean over the elements around node i
//! ```
//!
//! The gradient is that of nodal means. Within an element alone states differ by what its strains are known less well than in the
//! middle: where bodies flow at a constant volume a gradient of the four points is off by as much as it is.

use super::Unloaded;
use crate::fem::element::{QUADRATURE_POINTS, Quad, SHAPE_AT_POINTS};
use crate::fem::mesh::Mesh;
use crate::material::ConstitutiveModel;

/// The states of the points of each element, as long as its nodes are where they were.
pub(super) struct CarriedStates<'a, M: ConstitutiveModel, F> {
    model: &'a M,
    unloaded: &'a Unloaded<'a>,
    states: F,
    /// Mean over the elements around each node.
    nodal: Vec<M::State>,
}

impl<'a, M, F> CarriedStates<'a, M, F>
where
    M: ConstitutiveModel,
    F: Fn(usize) -> [M::State; QUADRATURE_POINTS],
{
    /// From the states of the points of each element of a mesh.
    pub fn new(model: &'a M, unloaded: &'a Unloaded<'a>, states: F) -> Self {
        let mesh = unloaded.mesh;
        let mut around = vec![Vec::new(); mesh.nodes.len()];
        for (element, nodes) in mesh.elements.iter().enumerate() {
            let mean = model.combined(&states(element).map(|state| (0.25, state)));
            for &node in nodes {
                around[node as usize].push(mean);
            }
        }
        let mean = |states: Vec<M::State>| {
            let part = (states.len() as f64).recip();
            let parts: Vec<_> = states.into_iter().map(|state| (part, state)).collect();
            model.combined(&parts)
        };
        Self { model, unloaded, states, nodal: around.into_iter().map(mean).collect() }
    }

    /// The states at the points of an element of the same mesh after its nodes have moved a little.
    pub fn at(&self, element: usize, moved: &Mesh) -> [M::State; QUADRATURE_POINTS] {
        let states = (self.states)(element);
        let (from, to) = (self.unloaded.mesh.corners(element), moved.corners(element));
        if from == to {
            return states;
        }
        let quad = Quad::new(&from, self.unloaded.stress_state);
        let nodes = moved.elements[element];
        std::array::from_fn(|g| {
            let by =
                |k: usize| -> f64 { (0..4).map(|i| SHAPE_AT_POINTS[i][g] * (to[i][k] - from[i][k])).sum() };
            let weight = |i: usize| quad.gradient_x[i][g] * by(0) + quad.gradient_y[i][g] * by(1);
            let nodal = |i: usize| (weight(i), self.nodal[nodes[i] as usize]);
            self.model.combined(&[(1.0, states[g]), nodal(0), nodal(1), nodal(2), nodal(3)])
        })
    }
}
