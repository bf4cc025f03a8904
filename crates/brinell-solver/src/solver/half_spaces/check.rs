//! The final check of an answer: contact conditions and plastic law, evaluated anew.
//!
//! The contact conditions are those of [`brinell_contact::kkt`]. The plastic law is asked about the deviators of whole stress tensors,
//! not about those that the iteration went by.

use brinell_contact::{KktReport, kkt};
use brinell_halfspace::DEVIATOR_COMPONENTS;

use super::system::HalfSpaces;
use crate::contact::ContactLoad;
use crate::solver::SolveStatus;
use crate::solver::method::contact_system::{BlockVector, ContactSystem as _};
use crate::solver::method::couplings::iteration::{Outcome, norm, relative};

/// What is wrong with an answer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Check {
    pub contact: KktReport,
    /// `‖Δε(σ) - Δε‖` over the contact force.
    pub plastic_residual: f64,
}

impl Check {
    /// Looks at an answer; `force_scale` is the largest norm of the contact forces so far.
    pub fn of(system: &HalfSpaces, outcome: &Outcome, load: ContactLoad, force_scale: f64) -> Self {
        let (loads, contact) = (&outcome.state.loads, &outcome.state.response.contact);
        let opening = system.gap_opening(loads);
        let gap: Vec<f64> = system.initial_gap.iter().zip(&opening).map(|(gap, u)| gap + u).collect();
        let problem = system.contact_problem(&gap, load);
        let report = kkt::check(&problem, &contact.force, contact.approach);
        let trial = trial_of_tensors(system, loads, &contact.force);
        let mut answer = system.zeros();
        system.initial_stress(&trial, &mut answer);
        let scale = norm(&contact.force).max(force_scale);
        Self { contact: report, plastic_residual: relative(system.distance(&answer, loads), scale) }
    }

    /// The status of an iteration that ended so: it has converged if nothing is wrong with its answer.
    pub fn verdict(&self, status: SolveStatus, tolerance: f64) -> SolveStatus {
        let is_sound = self.contact.is_sound() && self.plastic_residual <= tolerance;
        if status == SolveStatus::Converged && !is_sound { SolveStatus::NotConverged } else { status }
    }
}

/// `dev(σ + σ0) + 2μ Δε` from all six stresses.
fn trial_of_tensors(system: &HalfSpaces, loads: &BlockVector, force: &[f64]) -> BlockVector {
    let area = system.grid().cell_area();
    let n_cells = force.len();
    let pressure: Vec<f64> = force.iter().map(|force| force / area).collect();
    let mut trial = loads.clone();
    let mut yielding = system.yielding.borrow_mut();
    for (n, (body, trial)) in yielding.bodies.iter_mut().zip(&mut trial).enumerate() {
        let stress = body.stresses(&pressure, &loads[n]);
        let elastic = system.elastic.iter().flatten().find(|elastic| elastic.yielding == Some(n));
        for (layer, trial) in trial.chunks_exact_mut(DEVIATOR_COMPONENTS * n_cells).enumerate() {
            let [xx, yy, xy] = elastic.map_or([0.0; 3], |elastic| elastic.initial[layer]);
            let initial = [xx, yy, 0.0, xy, 0.0, 0.0];
            let tensor = |k: usize, cell: usize| stress.component(layer, k)[cell] + initial[k];
            for cell in 0..n_cells {
                let mean = (tensor(0, cell) + tensor(1, cell) + tensor(2, cell)) / 3.0;
                for (k, (row, mean)) in
                    [(0, mean), (1, mean), (3, 0.0), (4, 0.0), (5, 0.0)].into_iter().enumerate()
                {
                    trial[k * n_cells + cell] += tensor(row, cell) - mean;
                }
            }
        }
    }
    trial
}
