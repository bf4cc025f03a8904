//! How an answer changes where its mesh moves with the ends of the contact.
//!
//! The mesh moves along the surfaces, by the velocity of one end of the contact there, by none at the other end and by none far
//! away. Displacements of nodes being kept, out-of-balance forces and gaps arise at the rates
//!
//! ```text
//! f' = d/dt ∫ Bᵀ σ(ε) dV,     g' = δ0'(x) ẋ
//! ```

use crate::fem::element::StressState;
use crate::fem::mesh::{Mesh, Outline};
use crate::solver::body_system::system::System;
use crate::solver::mesh_solve::MeshSolve;
use crate::solver::method::contact_system::BlockVector;
use crate::solver::method::observer::ask;
use crate::solver::problem::Problem;
use crate::solver::{Interrupt, Observer};

/// Distance from the middle of the contact, and from the surface, up to which the mesh moves as its surface does, over the half-width;
/// where there is room.
const RIGID: f64 = 2.0;
/// Elements between a corner that does not move and the end of the contact that does, at least.
const FEWEST_ELEMENTS: f64 = 4.0;
/// Part of the extent of a body, along its surface and down from it, beyond which nothing moves; where there is room.
const STILL: f64 = 0.5;
/// Finite step of the mesh over the element size.
const STEP: f64 = 1e-5;

/// A motion of the mesh with one end of the contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct MeshMotion {
    /// Where surfaces do not move, and where they move by 1 \[mm\].
    still: f64,
    end: f64,
    /// Middle and half-width of the contact \[mm\].
    centre: f64,
    half_width: f64,
}

impl MeshMotion {
    /// One for each end of the contact that is not held by an edge; none where the contact is in several parts, and for a pin in
    /// its hole, whose nodes are on circles, and in plane stress for bodies with a stress before the load, which moves with their nodes.
    ///
    /// The last corner of the surfaces within the contact that is some elements from its end does not move.
    pub fn of(solve: &MeshSolve) -> Vec<Self> {
        let MeshSolve { system, outcome, patch, .. } = solve;
        let zone = &system.zone;
        let active = &outcome.state.response.contact.active_set;
        let is_stressed = system.bodies.iter().any(|body| body.initial_stress.is_some());
        let is_plane_stress = system.stress_state == StressState::PlaneStress;
        if system.conforming.is_some() || is_stressed && is_plane_stress {
            return Vec::new();
        }
        let (Some(patch), [_]) = (patch, solve.parts().as_slice()) else { return Vec::new() };
        let (Some(first), Some(last)) = (active.iter().min(), active.iter().max()) else { return Vec::new() };
        let left = if zone.is_symmetric() { zone.centre() } else { patch.left };
        let corners: Vec<f64> =
            (first + 1..last).filter(|&k| zone.is_corner(k)).map(|k| zone.abscissa(k)).collect();
        let (centre, half_width) = (0.5 * (patch.left + patch.right), patch.half_width());
        let motion = |still: f64, end: f64| Self { still, end, centre, half_width };
        // Between a corner and the end that moves there have to be elements that tell how pressure falls off.
        let far = |corner: f64, end: f64| (end - corner).abs() >= FEWEST_ELEMENTS * zone.spacing();
        let mut motions = Vec::new();
        if zone.edge(last).is_none() {
            let still =
                corners.iter().rev().copied().find(|&corner| far(corner, patch.right)).unwrap_or(left);
            motions.push(motion(still, patch.right));
        }
        if !zone.is_symmetric() && zone.edge(first).is_none() {
            let still =
                corners.iter().copied().find(|&corner| far(corner, patch.left)).unwrap_or(patch.right);
            motions.push(motion(still, patch.left));
        }
        motions.retain(|motion| (motion.end - motion.still).abs() > zone.spacing());
        motions
    }

    /// Distance of an abscissa from where surfaces do not move, towards the end that does \[mm\].
    pub fn arm(&self, x: f64) -> f64 {
        (x - self.still) * (self.end - self.still).signum()
    }

    /// ẋ at an abscissa of the surface.
    fn velocity(&self, x: f64) -> f64 {
        ((x - self.still) / (self.end - self.still)).max(0.0)
    }

    /// g' of every pair.
    pub fn gap_rates(&self, problem: &Problem, system: &System) -> Vec<f64> {
        let step = STEP * system.zone.spacing();
        let rate = |&x: &f64| {
            let by = step * self.velocity(x);
            (problem.initial_gap(x + by) - problem.initial_gap(x - by)) / (2.0 * step)
        };
        system.zone.abscissae().iter().map(rate).collect()
    }

    /// f' on all equations of each model.
    pub fn force_rates(
        &self,
        solve: &MeshSolve,
        observer: &mut dyn Observer,
    ) -> Result<BlockVector, Interrupt> {
        let step = STEP * solve.system.zone.spacing();
        let bodies = solve.system.bodies.iter().zip(&solve.fields);
        bodies
            .map(|(body, field)| {
                ask(observer)?;
                let elastic = &body.elastic;
                let mesh = self.moved(&elastic.mesh, &elastic.key.outline, step);
                ask(observer)?;
                let mut rates = elastic.zeros();
                for (node, change) in (0u32..).zip(body.force_change(&mesh, &field.nodal, &field.stress)) {
                    for (&k, change) in elastic.equations.of_node(node).iter().zip(change) {
                        rates[k as usize] += change / step;
                    }
                }
                if let Some(held) = rates.last_mut() {
                    *held = 0.0;
                }
                Ok(rates)
            })
            .collect()
    }

    /// The mesh after a step of so much at the end of the contact.
    fn moved(&self, mesh: &Mesh, outline: &Outline, step: f64) -> Mesh {
        let (left, right) = outline.span();
        let width = (right - self.centre).min(self.centre - left);
        let along = Fade::new(self.half_width, self.half_width, width);
        let down = Fade::new(0.0, self.half_width, outline.depth());
        let mut mesh = mesh.clone();
        for node in &mut mesh.nodes {
            let [x, y] = *node;
            let height = outline.height(x);
            let fade = along.at((x - self.centre).abs()) * down.at((y - height).abs());
            let by = step * fade * self.velocity(x);
            if by != 0.0 {
                *node = [x + by, y + outline.height(x + by) - height];
            }
        }
        mesh
    }
}

/// The part of a motion that is left at a distance: all of it up to one, nothing from another one on.
struct Fade {
    near: f64,
    far: f64,
}

impl Fade {
    /// All of it within `least`, and where the body has room for it within twice the half-width of the contact; nothing at the
    /// `extent` of the body, nor before it where there is room.
    fn new(least: f64, half_width: f64, extent: f64) -> Self {
        let room = STILL * extent;
        let near = (RIGID * half_width).min(least.max(0.5 * room).max((least * extent).sqrt()));
        Self { near, far: room.max((near * extent).sqrt()) }
    }

    fn at(&self, distance: f64) -> f64 {
        if distance <= self.near {
            1.0
        } else if distance >= self.far {
            0.0
        } else {
            (self.far / distance).ln() / (self.far / self.near).ln()
        }
    }
}
