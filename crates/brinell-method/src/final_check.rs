//! Judges the final state by quantities that its engine has recomputed.

use super::contact_system::ContactSystem;
use super::couplings::iteration::Outcome;
use super::observer::SolveStatus;
use brinell_contact::kkt::{self, ContactScales};
use brinell_contact::{ContactLoad, KktReport};

/// The residual over whole bodies may exceed that of the iteration's active equations by rounding
/// only.
const RESIDUAL_SLACK: f64 = 1.5;
/// Rounding floor of the residual.
const RESIDUAL_FLOOR: f64 = 1e-9;

/// Plastic strain above which a body has collapsed: the theory of small strains no longer holds.
pub const COLLAPSE_STRAIN: f64 = 1.0;

/// Least scales of the checks of a step. Earlier loads of a history may have been much larger.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LeastScales {
    /// `‖R‖` \[N/mm\].
    pub residual: f64,
    /// Of the contact conditions.
    pub contact: ContactScales,
}

/// The quantities of the final state that are checked. Nothing that the iteration computed is
/// reused.
pub struct Evidence {
    /// Initial gap and the displacements of both bodies that open it further, at each pair \[mm\].
    pub unloaded_gap: Vec<f64>,
    /// `‖∫Bᵀσ dV - R‖ / ‖R‖`.
    pub equilibrium_residual: f64,
    /// Whether strains exceed the range of the theory of small strains.
    pub has_collapsed: bool,
    /// Whether the contact reaches the edge of the candidate pairs.
    pub reaches_edge: bool,
}

impl Evidence {
    /// Takes the evidence from the last iterate, for an iteration that was stopped.
    pub fn of_iteration(
        system: &impl ContactSystem,
        outcome: &Outcome,
        reaches_edge: bool,
    ) -> Self {
        let contact = &outcome.state.response.contact;
        let closing =
            system.contact_problem(system.initial_gap(), ContactLoad::Force(0.0)).closing;
        let gaps = contact.gap.iter().zip(closing);
        Self {
            unloaded_gap: gaps.map(|(gap, closing)| gap + contact.approach * closing).collect(),
            equilibrium_residual: outcome
                .history
                .last()
                .map_or(1.0, |record| record.equilibrium_residual),
            has_collapsed: false,
            reaches_edge,
        }
    }
}

/// Returns the status of a solve and the check of the contact conditions at the gap that the
/// displacements leave, `δ0 + w_u + w_l - α`.
pub fn judge(
    system: &impl ContactSystem,
    outcome: &Outcome,
    evidence: &Evidence,
    load: ContactLoad,
    tolerance: f64,
    least: ContactScales,
) -> (SolveStatus, KktReport) {
    let contact = &outcome.state.response.contact;
    let problem = system.contact_problem(&evidence.unloaded_gap, load);
    let mut gap = vec![0.0; contact.force.len()];
    problem.flexibility.apply(&contact.force, &mut gap);
    for (elastic, total) in gap.iter_mut().zip(&evidence.unloaded_gap) {
        *elastic = total - *elastic;
    }
    let problem = system.contact_problem(&gap, load);
    let check = kkt::check_beside(&problem, &contact.force, contact.approach, least);
    let balanced = evidence.equilibrium_residual <= RESIDUAL_FLOOR.max(RESIDUAL_SLACK * tolerance);
    let is_answer =
        check.is_sound() && balanced && !evidence.has_collapsed && !evidence.reaches_edge;
    let status = match outcome.status {
        SolveStatus::Converged if !is_answer => SolveStatus::NotConverged,
        status => status,
    };
    (status, check)
}
