//! The contact that ends on the rounded edges of a flat punch.

use crate::element::StressState;
use crate::engine::ContactPatch;
use crate::engine::problem::Problem;
use brinell_material::analytical::RoundedEdge;

/// Elements of a contact on a rounded edge over its width at most.
const EDGE_ELEMENT: f64 = 0.25;

/// Closed form of the contact of elastic bodies on rounded edges.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeContact {
    pub elastic: RoundedEdge,
    /// Half-width of the flat between the edges \[mm\].
    pub flat: f64,
}

impl EdgeContact {
    /// `None` where the contact does not reach the edges: its ends are found to about an element.
    pub fn of(problem: &Problem, patch: ContactPatch, spacing: f64, force: f64) -> Option<Self> {
        let radius = problem.edge_radius();
        let flat = problem.walls()[1] - radius;
        if !flat.is_finite() || patch.half_width() + spacing < flat {
            return None;
        }
        let of = if problem.stress_state == StressState::Axisymmetric {
            RoundedEdge::circular
        } else {
            RoundedEdge::plane
        };
        Some(Self { elastic: of(radius, flat, force, problem.effective_modulus()), flat })
    }

    /// Whether elements are too large for it.
    pub fn is_narrow(&self, spacing: f64) -> bool {
        spacing > EDGE_ELEMENT * self.elastic.width()
    }
}
