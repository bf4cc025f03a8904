//! States of a material that stays where it is while its mesh moves.
//!
//! ```text
//! S(x_g + δx_g) = S_g + Σ_i (∇N_i · δx_g) S̄_i,     S̄_i: mean over the elements around node i
//! ```
//!
//! Nodal means give the gradient. Differences between the four points of one element are less accurate than its mean, most of all where
//! bodies flow at a constant volume.

use super::{StressField, Unloaded, stress};
use crate::element::{QUADRATURE_POINTS, Quad, SHAPE_AT_POINTS};
use crate::mesh::Mesh;
use brinell_material::{ConstitutiveModel, OutOfPlane};

/// Stresses where the nodes of a mesh have moved a little in the body and have kept their displacements, and states, given for the points
/// of each element, have stayed with the material.
///
/// In plane stress they move with the mesh: flow gathers in bands there that are as narrow as elements, and of states that differ so
/// much from one element to the next there is no gradient.
pub(super) fn moved_stress_field<M: ConstitutiveModel>(
    model: &M,
    unloaded: &Unloaded<'_>,
    moved: &Mesh,
    displacement: &[[f64; 2]],
    states: impl Fn(usize) -> [M::State; QUADRATURE_POINTS],
) -> StressField {
    let on_moved = Unloaded { mesh: moved, ..*unloaded };
    let differ = model.has_memory() || unloaded.initial_stress.is_some();
    if !differ || model.out_of_plane() == OutOfPlane::PlaneStress {
        return stress::evaluate(model, &on_moved, displacement, states);
    }
    let carried = CarriedStates::new(model, unloaded, states);
    stress::evaluate(model, &on_moved, displacement, |element| carried.at(element, moved))
}

/// The states of the points of each element, as long as its nodes are where they were.
struct CarriedStates<'a, M: ConstitutiveModel, F> {
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
    fn new(model: &'a M, unloaded: &'a Unloaded<'a>, states: F) -> Self {
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
    fn at(&self, element: usize, moved: &Mesh) -> [M::State; QUADRATURE_POINTS] {
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
