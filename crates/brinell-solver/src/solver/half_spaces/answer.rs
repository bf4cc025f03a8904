//! An outcome as a step: checked afresh, measured.
//!
//! The contact conditions are checked by [`judge`] with the gap that the plastic strain leaves. The plastic law is asked about the
//! deviators of whole stress tensors, not about those that the iteration went by.

use std::sync::Arc;

use brinell_contact::{Flexibility as _, KktReport};
use brinell_halfspace::DEVIATOR_COMPONENTS;

use super::engine::{Answer, HalfSpaceEngine, ends_reached};
use super::measure::{Measured, measure};
use super::step::HalfSpaceStep;
use super::system::HalfSpaces;
use crate::contact::ContactLoad;
use crate::contact::kkt::ContactScales;
use crate::solver::SolveStatus;
use crate::solver::method::contact_system::{BlockVector, ContactSystem as _};
use crate::solver::method::couplings::iteration::{norm, relative};
use crate::solver::method::final_check::{Evidence, LeastScales, judge};
use crate::solver::method::solve::Answer as _;

impl Answer {
    /// The step of a load, checked; `last_peak` is where the pressure was largest before.
    pub fn step(
        &self,
        engine: &HalfSpaceEngine<'_>,
        load: ContactLoad,
        last_peak: [f64; 2],
        least: LeastScales,
    ) -> HalfSpaceStep {
        if self.outcome.status.is_stopped() {
            return self.step_as_iterated(engine, load, last_peak);
        }
        let evidence = self.evidence(least.residual);
        let judged = judge(&self.system, &self.outcome, &evidence, load, engine.tolerance, least.contact);
        self.reported(engine, load, last_peak, &evidence, judged)
    }

    /// The same as the last iteration has left it.
    pub fn step_as_iterated(
        &self,
        engine: &HalfSpaceEngine<'_>,
        load: ContactLoad,
        last_peak: [f64; 2],
    ) -> HalfSpaceStep {
        let evidence = Evidence::of_iteration(&self.system, &self.outcome, false);
        let least = ContactScales::default();
        let judged = judge(&self.system, &self.outcome, &evidence, load, engine.tolerance, least);
        self.reported(engine, load, last_peak, &evidence, judged)
    }

    fn evidence(&self, least_residual: f64) -> Evidence {
        let (system, state) = (&self.system, &self.outcome.state);
        let force = &state.response.contact.force;
        let trial = trial_of_tensors(system, &state.loads, force);
        let mut answer = system.zeros();
        system.initial_stress(&trial, &mut answer);
        let mut unloaded_gap = vec![0.0; force.len()];
        system.surface.apply(force, &mut unloaded_gap);
        let opening = system.gap_opening(&state.loads);
        for ((gap, initial), opening) in unloaded_gap.iter_mut().zip(&system.initial_gap).zip(opening) {
            *gap += initial + opening;
        }
        Evidence {
            unloaded_gap,
            equilibrium_residual: relative(
                system.distance(&answer, &state.loads),
                norm(force).max(least_residual),
            ),
            has_collapsed: self.has_collapsed(),
            reaches_edge: ends_reached(system, force) != [false; 3],
        }
    }

    fn reported(
        &self,
        engine: &HalfSpaceEngine<'_>,
        load: ContactLoad,
        last_peak: [f64; 2],
        evidence: &Evidence,
        (status, contact_check): (SolveStatus, KktReport),
    ) -> HalfSpaceStep {
        let measured = measure(&self.system, &self.outcome, last_peak);
        let Measured { figures, peak_position, largest_cell_pressure, surface, energy, bodies } = measured;
        HalfSpaceStep {
            status,
            load,
            figures,
            errors: None,
            peak_position,
            largest_cell_pressure,
            hertz: (figures.force > 0.0).then(|| engine.problem.hertz(figures.force)),
            surface: Arc::new(surface),
            energy,
            bodies,
            history: self.outcome.history.clone(),
            contact_check,
            plastic_residual: evidence.equilibrium_residual,
            increments: Vec::new(),
            enlargements: self.system.design.enlargements,
            reaches_edge: evidence.reaches_edge,
            has_collapsed: evidence.has_collapsed,
            is_preliminary: false,
            missed: None,
        }
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
