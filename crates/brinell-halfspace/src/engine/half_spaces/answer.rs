//! An outcome as a step: checked afresh, measured.
//!
//! The contact conditions are checked by [`judge`] with the gap that the plastic strain leaves.
//! The plastic law is asked about the deviators of whole stress tensors, not about those that the
//! iteration went by.

use std::sync::Arc;

use crate::DEVIATOR_COMPONENTS;
use brinell_contact::{Flexibility as _, KktReport};

use super::engine::{Answer, HalfSpaceEngine, ends_reached};
use super::measure::{Measured, measure, stresses};
use super::step::{HalfSpaceBody, HalfSpaceField, HalfSpaceStep};
use super::system::HalfSpaces;
use crate::engine::watch::watched;
use brinell_contact::ContactLoad;
use brinell_contact::kkt::ContactScales;
use brinell_method::contact_system::{BlockVector, ContactSystem as _};
use brinell_method::couplings::iteration::{norm, relative};
use brinell_method::final_check::{Evidence, LeastScales, judge};
use brinell_method::observer::SolveStatus;
use brinell_method::phases::Phase;
use brinell_method::run::Run;
use brinell_method::steps::{Checks, Path, Search, Step};

impl Answer {
    /// The step of a load, checked; `last_peak` is where the pressure was largest before.
    pub fn step(
        &self,
        engine: &HalfSpaceEngine<'_>,
        load: ContactLoad,
        last_peak: [f64; 2],
        least: LeastScales,
        run: &mut Run<'_>,
    ) -> HalfSpaceStep {
        if self.outcome.status.is_stopped() {
            return self.step_as_iterated(engine, load, last_peak);
        }
        let stresses =
            watched(run, Phase::Output, |stop| stresses(&self.system, &self.outcome, stop));
        let stresses = match stresses {
            Ok(stresses) => stresses,
            Err(error) => {
                let status = match error {
                    brinell_method::Error::Interrupted(interrupt) => interrupt.into(),
                    _ => SolveStatus::NotConverged,
                };
                return HalfSpaceStep { status, ..self.step_as_iterated(engine, load, last_peak) };
            }
        };
        let measured = measure(&self.system, &self.outcome, last_peak, Some(stresses));
        let evidence = self.evidence(&measured.bodies, least.residual);
        let (status, mut check) =
            judge(&self.system, &self.outcome, &evidence, load, engine.tolerance, least.contact);
        check.equilibrium = check.equilibrium.max(self.missing_moment());
        let status = match status {
            SolveStatus::Converged if !check.is_sound() => SolveStatus::NotConverged,
            status => status,
        };
        self.reported(engine, load, measured, &evidence, (status, check))
    }

    /// Returns the step as the last iteration has left it.
    pub fn step_as_iterated(
        &self,
        engine: &HalfSpaceEngine<'_>,
        load: ContactLoad,
        last_peak: [f64; 2],
    ) -> HalfSpaceStep {
        let evidence = Evidence::of_iteration(&self.system, &self.outcome, false);
        let least = ContactScales::default();
        let judged = judge(&self.system, &self.outcome, &evidence, load, engine.tolerance, least);
        let measured = measure(&self.system, &self.outcome, last_peak, None);
        self.reported(engine, load, measured, &evidence, judged)
    }

    /// Returns the deviation from a prescribed moment, over force and half the length.
    fn missing_moment(&self) -> f64 {
        let contact = &self.outcome.state.response.contact;
        self.system.moment.map_or(0.0, |moment| {
            moment.missing(self.system.moment_of(&contact.force), contact.total_force).abs()
        })
    }

    fn evidence(&self, bodies: &[Option<Arc<HalfSpaceBody>>; 2], least_residual: f64) -> Evidence {
        let (system, state) = (&self.system, &self.outcome.state);
        let force = &state.response.contact.force;
        let trial = trial_of_tensors(system, &state.loads, bodies);
        let mut answer = system.zeros();
        system.initial_stress(&trial, &mut answer);
        let mut unloaded_gap = vec![0.0; force.len()];
        system.surface.apply(force, &mut unloaded_gap);
        let tilted = system.tilted(&system.initial_gap, state.response.contact.tilt);
        for (gap, initial) in unloaded_gap.iter_mut().zip(&tilted) {
            *gap += initial;
        }
        for body in bodies.iter().flatten() {
            for (gap, plastic) in unloaded_gap.iter_mut().zip(&body.plastic_displacement) {
                *gap += plastic;
            }
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
        measured: Measured,
        evidence: &Evidence,
        (status, contact): (SolveStatus, KktReport),
    ) -> HalfSpaceStep {
        let Measured { figures, peak_position, largest_cell_pressure, surface, energy, bodies } =
            measured;
        let missing_moment = self.missing_moment();
        Step {
            status,
            load,
            figures,
            coarse: None,
            increment_error: None,
            checks: Checks {
                contact,
                residual: evidence.equilibrium_residual,
                reaches_edge: evidence.reaches_edge,
                has_collapsed: evidence.has_collapsed,
            },
            history: self.outcome.history.clone(),
            path: Path {
                flows: self.system.flows(&self.outcome.state.loads),
                energy: Some(energy),
                ..Path::default()
            },
            search: Search::default(),
            contact_stiffness: None,
            enlargements: self.system.design.enlargements,
            is_preliminary: false,
            field: HalfSpaceField {
                peak_position,
                largest_cell_pressure,
                tilt: engine.problem.tilt() + self.outcome.state.response.contact.tilt,
                hertz: (figures.force > 0.0 && engine.problem.has_hertz())
                    .then(|| engine.problem.hertz(figures.force)),
                surface: Arc::new(surface),
                bodies,
                missing_moment,
            },
        }
    }
}

/// `dev(σ + σ0) + 2μ Δε` from all six stresses.
fn trial_of_tensors(
    system: &HalfSpaces,
    loads: &BlockVector,
    bodies: &[Option<Arc<HalfSpaceBody>>; 2],
) -> BlockVector {
    let n_cells = system.grid().n_cells();
    let mut trial = loads.clone();
    for (n, trial) in trial.iter_mut().enumerate() {
        let sides = system.elastic.iter().zip(bodies);
        let mut of_body =
            sides.filter(|(elastic, _)| elastic.as_ref().is_some_and(|e| e.yielding == Some(n)));
        let Some((_, Some(body))) = of_body.next() else { continue };
        for (layer, trial) in trial.chunks_exact_mut(DEVIATOR_COMPONENTS * n_cells).enumerate() {
            let tensor = |k: usize, cell: usize| body.stress.component(layer, k)[cell];
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
