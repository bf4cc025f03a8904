//! The bookkeeping that all couplings share: settings, history, convergence, interruption.

use std::ops::ControlFlow;

use super::phases::{Phase, PhaseTimes};
use super::system::{PerModel, Response, System};
use super::{Interrupt, IterationRecord, Observer, SolveError, SolveStatus};
use crate::contact::{ContactLoad, ContactProblem, ContactSolution, ContactSolver};
use sparse_cholesky::Cholesky;

/// What an iteration is run with.
#[derive(Clone, Copy)]
pub(super) struct Controls<'a> {
    pub contact: &'a dyn ContactSolver,
    /// Load of the meshed part: half of the job's force on a half model.
    pub load: ContactLoad,
    pub tolerance: f64,
    pub max_iterations: usize,
    /// Whether to stop where another linearization would pay.
    pub renewable: bool,
}

/// The state an iteration ended in.
pub(super) struct State {
    /// Displacements on the windows and contact forces, in equilibrium with [`Self::loads`].
    pub response: Response,
    /// Initial-stress loads that were applied.
    pub loads: PerModel,
    /// Factors of the stiffness in force, where it is not that of the system: the secant one.
    pub factors: Option<Vec<Cholesky>>,
}

/// How an iteration ended.
pub(super) struct Outcome {
    pub state: State,
    pub status: SolveStatus,
    pub history: Vec<IterationRecord>,
    /// Whether it ended because another linearization would pay.
    pub stalled: bool,
}

/// Where an iteration begins.
#[derive(Default)]
pub(super) struct Beginning {
    /// Displacements to start from.
    pub displacement: Option<PerModel>,
    /// Iterations made before, on other linearizations.
    pub history: Vec<IterationRecord>,
    /// Factorizations made for this one, to be told with its first iteration.
    pub factorizations: usize,
}

/// Iterations on one linearization before its pace is judged.
const TRIAL: usize = 8;
/// Iterations that the pace is taken from.
const PACE_SPAN: usize = 7;
/// Iterations to go that cost about as much as another linearization.
const MAX_REMAINING: f64 = 12.0;

/// Work done since the last record.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    pivots: usize,
    updates: usize,
    factorizations: usize,
}

/// A running iteration.
pub(super) struct Iteration<'a> {
    pub system: &'a System,
    pub controls: Controls<'a>,
    pub observer: &'a mut dyn Observer,
    pub phases: &'a mut PhaseTimes,
    counts: Counts,
    history: Vec<IterationRecord>,
    /// Length of the history at the beginning.
    begun: usize,
    /// Displacements to start from.
    start: Option<PerModel>,
    /// Contact of the last iteration.
    previous: Option<ContactSolution>,
}

impl<'a> Iteration<'a> {
    pub fn new(
        system: &'a System,
        controls: Controls<'a>,
        beginning: Beginning,
        observer: &'a mut dyn Observer,
        phases: &'a mut PhaseTimes,
    ) -> Self {
        Self {
            system,
            controls,
            observer,
            phases,
            counts: Counts { factorizations: beginning.factorizations, ..Counts::default() },
            begun: beginning.history.len(),
            history: beginning.history,
            start: beginning.displacement,
            previous: None,
        }
    }

    /// Displacements to start from, and the initial-stress loads that belong to them: those of a former load on the
    /// same mesh, else zero.
    pub fn initial_state(&mut self) -> (PerModel, PerModel) {
        let mut loads = self.system.zeros();
        match self.start.take() {
            Some(start) => {
                self.initial_stress(&start, &mut loads);
                (start, loads)
            }
            None => (self.system.zeros(), loads),
        }
    }

    /// Contact and equilibrium for given initial-stress loads, warm-started from the last contact.
    pub fn respond(&mut self, loads: &PerModel) -> Result<Response, SolveError> {
        let Controls { contact, load, .. } = self.controls;
        let warm = self.previous.as_ref().map(|contact| &contact.active_set);
        let response = self.system.respond(loads, contact, load, warm, self.phases, self.observer)?;
        self.counts.pivots += response.contact.pivots;
        Ok(response)
    }

    /// Contact alone, for a gap that plastic flow has widened by `growth`.
    pub fn contact(&mut self, growth: &[f64]) -> Result<ContactSolution, SolveError> {
        let gap: Vec<f64> = self.system.initial_gap.iter().zip(growth).map(|(g, u)| g + u).collect();
        let load = self.controls.load;
        self.solve_contact(&ContactProblem { flexibility: &self.system.flexibility, initial_gap: &gap, load })
    }

    /// A contact problem, warm-started from the last contact.
    pub fn solve_contact(&mut self, problem: &ContactProblem<'_>) -> Result<ContactSolution, SolveError> {
        let warm = self.previous.as_ref().map(|contact| &contact.active_set);
        let solver = self.controls.contact;
        let contact = self.phases.time(Phase::Contact, self.observer, || solver.solve(problem, warm))?;
        self.counts.pivots += contact.pivots;
        Ok(contact)
    }

    /// `u = K⁻¹ (P_e + R)` on the windows.
    pub fn displacement(&mut self, loads: &PerModel, force: &[f64]) -> PerModel {
        let system = self.system;
        self.phases.time(Phase::Solves, self.observer, || system.displacement(loads, force))
    }

    /// `‖u - u_start‖ / ‖u‖` on the windows.
    pub fn displacement_change(&mut self, start: &PerModel, u: &PerModel) -> f64 {
        let system = self.system;
        self.phases
            .time(Phase::Plasticity, self.observer, || relative(system.distance(u, start), system.norm(u)))
    }

    /// Initial-stress loads of given displacements.
    pub fn initial_stress(&mut self, displacement: &PerModel, loads: &mut PerModel) -> usize {
        let system = self.system;
        self.phases.time(Phase::Plasticity, self.observer, || system.initial_stress(displacement, loads))
    }

    /// Counts one initial-stress load, or set of secant moduli, put into effect.
    pub fn count_update(&mut self) {
        self.counts.updates += 1;
    }

    /// Counts one factorization of every model.
    pub fn count_factorizations(&mut self) {
        self.counts.factorizations += self.system.bodies.len();
    }

    /// Writes down an iteration that went from the displacements `start` to a response which the plastic law
    /// finds to be `imbalance` \[N/mm\] off balance. `Some` says that it was the last, and how it ended.
    pub fn record(
        &mut self,
        start: &PerModel,
        response: &Response,
        plastic_points: usize,
        imbalance: f64,
    ) -> Option<SolveStatus> {
        let force = norm(&response.contact.force);
        let displacement_change = self.displacement_change(start, &response.displacement);
        if !(force + displacement_change + imbalance).is_finite() {
            return Some(SolveStatus::NotConverged);
        }
        let force_change = self
            .previous
            .as_ref()
            .map_or(1.0, |previous| relative(distance(&response.contact.force, &previous.force), force));
        let counts = std::mem::take(&mut self.counts);
        let record = IterationRecord {
            iteration: self.history.len() + 1,
            contact_pivots: counts.pivots,
            initial_stress_updates: counts.updates,
            factorizations: counts.factorizations,
            displacement_change,
            force_change,
            equilibrium_residual: relative(imbalance, force),
            plastic_points: plastic_points * self.system.copies(),
            contact_pairs: self.system.mirrored_count(&response.contact.active_set),
            approach: response.contact.approach,
            peak_pressure: self.system.peak_pressure(&response.contact.force),
            elapsed_ms: 1e3 * self.observer.elapsed().as_secs_f64(),
        };
        self.previous = Some(response.contact.clone());
        let verdict = self.observer.on_iteration(&record);
        let status = self.status_after(&record, verdict);
        self.history.push(record);
        status
    }

    fn status_after(&self, record: &IterationRecord, verdict: ControlFlow<Interrupt>) -> Option<SolveStatus> {
        if let ControlFlow::Break(interrupt) = verdict {
            return Some(interrupt.into());
        }
        let tolerance = self.controls.tolerance;
        let residual = record.equilibrium_residual;
        // Without any imbalance (elastic bodies) there is nothing left to change.
        if residual <= tolerance && (record.displacement_change <= tolerance || residual == 0.0) {
            Some(SolveStatus::Converged)
        } else if record.iteration >= self.controls.max_iterations {
            Some(SolveStatus::NotConverged)
        } else {
            None
        }
    }

    /// Whether, at the pace of late, so many more iterations are needed that another linearization would pay.
    pub fn has_stalled(&self) -> bool {
        let residual = |k: usize| self.history[k].equilibrium_residual;
        let now = self.history.len();
        if !self.controls.renewable || now - self.begun < TRIAL {
            return false;
        }
        let pace = (residual(now - PACE_SPAN) / residual(now - 1)).ln() / (PACE_SPAN - 1) as f64;
        let way = (residual(now - 1) / self.controls.tolerance).ln();
        // So does a pace of zero, or backwards.
        way >= MAX_REMAINING * pace
    }

    /// Closes the iteration; without a status it is one that has stalled.
    pub fn finish(self, state: State, status: Option<SolveStatus>) -> Outcome {
        Outcome {
            state,
            status: status.unwrap_or(SolveStatus::NotConverged),
            history: self.history,
            stalled: status.is_none(),
        }
    }
}

/// Euclidean norm.
pub(super) fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(v: &[f64], w: &[f64]) -> f64 {
    v.iter().zip(w).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// A quotient that is zero where there is nothing to compare.
pub(super) fn relative(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole.max(f64::MIN_POSITIVE) }
}
