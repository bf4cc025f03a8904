//! The bookkeeping that all couplings share: settings, history, convergence, interruption.

use std::ops::ControlFlow;

use crate::Error;
use crate::contact_system::{
    BlockVector, ContactFigures, ContactSystem, Response, SecantStiffness,
};
use crate::observer::{IncrementNumber, Interrupt, IterationRecord, SolveStatus};
use crate::phases::Phase;
use crate::run::Run;
use brinell_contact::{ContactLoad, ContactSolution, ContactSolver};

/// The settings of an iteration.
#[derive(Clone, Copy)]
pub struct Controls<'a> {
    /// Solves the contact conditions.
    pub contact: &'a dyn ContactSolver,
    /// Load of the whole contact.
    pub load: ContactLoad,
    /// Relative change and residual at which the iteration has converged \[1 > 0\].
    pub tolerance: f64,
    /// Iterations at most.
    pub max_iterations: usize,
    /// Whether to stop where a renewed stiffness costs less than the iterations left.
    pub renewable: bool,
    /// Least scales of residuals and changes.
    pub scales: Scales,
    /// The increment of a history.
    pub increment: Option<IncrementNumber>,
}

/// The largest norms of a load history so far. After unloading there is no contact force that
/// could scale a residual.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Scales {
    /// `‖R‖` \[N/mm\].
    pub force: f64,
    /// `‖u‖` on the active equations \[mm\].
    pub displacement: f64,
}

/// The last state of an iteration.
pub struct State {
    /// Displacements on the active equations and contact forces, in equilibrium with
    /// [`Self::loads`].
    pub response: Response,
    /// Initial-stress loads that were applied.
    pub loads: BlockVector,
    /// Whether the displacements are known on all equations and not on the active ones alone.
    pub is_complete: bool,
}

/// How an iteration ended.
pub struct Outcome {
    /// The last state.
    pub state: State,
    /// How the iteration ended.
    pub status: SolveStatus,
    /// One record for each iteration.
    pub history: Vec<IterationRecord>,
    /// Whether the iteration has stalled: a renewed stiffness costs less than the iterations left.
    pub stalled: bool,
    /// Whether its strains are meaningful: the iteration has converged, or no other coupling would
    /// come closer.
    pub is_conclusive: bool,
}

/// The initial state of an iteration.
#[derive(Default)]
pub struct InitialState {
    /// Displacements to start from.
    pub displacement: Option<BlockVector>,
    /// Iterations made before, on other linearizations.
    pub history: Vec<IterationRecord>,
    /// Factorizations made for this iteration, recorded with its first step.
    pub factorizations: usize,
    /// Contact of the last iteration.
    pub contact: Option<ContactSolution>,
}

/// Iterations with one stiffness before its convergence rate is estimated.
const TRIAL: usize = 8;
/// Iterations from which the rate is computed.
const RATE_SPAN: usize = 7;
/// Iterations that cost about as much as a renewed stiffness.
const MAX_REMAINING: f64 = 12.0;

/// Window of iterations whose best residuals give the rate of an iteration that keeps its
/// stiffness; the factor by which the expected number of iterations may exceed the iterations
/// left.
const OUTLOOK: usize = 50;
const OUTLOOK_SLACK: f64 = 4.0;

/// Out-of-balance force over the contact force above which an iteration has diverged.
const DIVERGED: f64 = 1e8;

/// Work done since the last record.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    pivots: usize,
    updates: usize,
    factorizations: usize,
}

/// A running iteration.
pub struct Iteration<'a> {
    /// The bodies.
    pub system: &'a dyn ContactSystem,
    /// The settings.
    pub controls: Controls<'a>,
    /// The running solve with its observer.
    pub run: Run<'a>,
    counts: Counts,
    history: Vec<IterationRecord>,
    /// Number of records from before this iteration, with other moduli or another plastic region.
    begun: usize,
    /// Displacements to start from.
    start: Option<BlockVector>,
    /// Contact of the last iteration.
    previous: Option<ContactSolution>,
    /// Whether the iteration has diverged.
    has_diverged: bool,
}

impl<'a> Iteration<'a> {
    /// Begins an iteration from an initial state.
    pub fn new(
        system: &'a dyn ContactSystem,
        controls: Controls<'a>,
        initial: InitialState,
        run: Run<'a>,
    ) -> Self {
        Self {
            system,
            controls,
            run,
            counts: Counts { factorizations: initial.factorizations, ..Counts::default() },
            begun: initial.history.len(),
            history: initial.history,
            start: initial.displacement,
            previous: initial.contact,
            has_diverged: false,
        }
    }

    /// Returns the initial displacements and their initial-stress loads: those of the load before
    /// on the same system, otherwise zero.
    pub fn initial_state(&mut self) -> (BlockVector, BlockVector) {
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
    ///
    /// # Errors
    /// Those of the contact solver.
    pub fn solve_equilibrium(&mut self, loads: &BlockVector) -> Result<Response, Error> {
        let Controls { contact, load, .. } = self.controls;
        let start = self.previous.as_ref();
        let response = self.system.equilibrium(loads, contact, load, start, &mut self.run)?;
        self.counts.pivots += response.contact.pivots;
        Ok(response)
    }

    /// Contact alone, for a gap that plastic flow has widened by `gap_opening`.
    ///
    /// # Errors
    /// Those of the contact solver.
    pub fn contact(&mut self, gap_opening: &[f64]) -> Result<ContactSolution, Error> {
        let Controls { contact, load, .. } = self.controls;
        let start = self.previous.as_ref();
        let contact = self.system.contact(gap_opening, contact, load, start, &mut self.run)?;
        self.counts.pivots += contact.pivots;
        Ok(contact)
    }

    /// Contact and equilibrium with secant moduli, warm-started from the last contact.
    ///
    /// # Errors
    /// Those of the contact solver, and where the observer stops it.
    pub fn secant_equilibrium(
        &mut self,
        stiffness: &dyn SecantStiffness,
    ) -> Result<Response, Error> {
        let Controls { contact, load, .. } = self.controls;
        let start = self.previous.as_ref();
        let response = stiffness.equilibrium(contact, load, start, &mut self.run)?;
        self.counts.pivots += response.contact.pivots;
        Ok(response)
    }

    /// `u = K⁻¹ (P_e + R)` on the active equations.
    pub fn displacement(&mut self, loads: &BlockVector, force: &[f64]) -> BlockVector {
        let system = self.system;
        self.run.time(Phase::Solves, || system.displacement(loads, force))
    }

    /// `‖u - u_start‖ / ‖u‖` on the active equations.
    pub fn displacement_change(&mut self, start: &BlockVector, u: &BlockVector) -> f64 {
        let (system, least) = (self.system, self.controls.scales.displacement);
        self.run.time(Phase::Plasticity, || {
            relative(system.distance(u, start), system.norm(u).max(least))
        })
    }

    /// Initial-stress loads of given displacements.
    pub fn initial_stress(
        &mut self,
        displacement: &BlockVector,
        loads: &mut BlockVector,
    ) -> usize {
        let system = self.system;
        self.run.time(Phase::Plasticity, || system.initial_stress(displacement, loads))
    }

    /// Counts one initial-stress load, or set of secant moduli, put into effect.
    pub fn count_update(&mut self) {
        self.counts.updates += 1;
    }

    /// Initial-stress updates of all iterations so far.
    pub fn updates(&self) -> usize {
        self.history.iter().map(|record| record.initial_stress_updates).sum()
    }

    /// Counts factorizations.
    pub fn count_factorizations(&mut self, count: usize) {
        self.counts.factorizations += count;
    }

    /// Records an iteration from the displacements `start` to `response`, whose out-of-balance
    /// force is `residual_norm` \[N/mm\]. Returns the status if the iteration ends here. It has
    /// converged when the residual and the change of displacement are within the tolerance.
    pub fn record(
        &mut self,
        start: &BlockVector,
        response: &Response,
        plastic_points: usize,
        residual_norm: f64,
    ) -> Option<SolveStatus> {
        let force = norm(&response.contact.force).max(self.controls.scales.force);
        let displacement_change = self.displacement_change(start, &response.displacement);
        let equilibrium_residual = relative(residual_norm, force);
        if !(force + displacement_change + equilibrium_residual).is_finite() {
            self.has_diverged = true;
            return (!self.controls.renewable).then_some(SolveStatus::NotConverged);
        }
        let force_change = self.previous.as_ref().map_or(1.0, |previous| {
            relative(distance(&response.contact.force, &previous.force), force)
        });
        let counts = std::mem::take(&mut self.counts);
        let ContactFigures { approach, peak_pressure, pairs, .. } =
            self.system.figures(&response.contact);
        let record = IterationRecord {
            iteration: self.history.len() + 1,
            contact_pivots: counts.pivots,
            initial_stress_updates: counts.updates,
            factorizations: counts.factorizations,
            displacement_change,
            force_change,
            equilibrium_residual,
            plastic_points,
            contact_pairs: pairs,
            approach,
            peak_pressure,
            elapsed_ms: 1e3 * self.run.observer.elapsed().as_secs_f64(),
            increment: self.controls.increment,
        };
        self.previous = Some(response.contact.clone());
        let verdict = self.run.show(&record);
        self.has_diverged = equilibrium_residual > DIVERGED;
        let status = self.status_after(&record, verdict);
        self.history.push(record);
        status
    }

    fn status_after(
        &self,
        record: &IterationRecord,
        verdict: ControlFlow<Interrupt>,
    ) -> Option<SolveStatus> {
        if let ControlFlow::Break(interrupt) = verdict {
            return Some(interrupt.into());
        }
        let tolerance = self.controls.tolerance;
        let residual = record.equilibrium_residual;
        // A residual of zero (elastic bodies) cannot change any more.
        if residual <= tolerance && (record.displacement_change <= tolerance || residual == 0.0) {
            Some(SolveStatus::Converged)
        } else if record.iteration >= self.controls.max_iterations
            || !self.controls.renewable && (self.has_diverged || self.is_hopeless(residual))
        {
            Some(SolveStatus::NotConverged)
        } else {
            None
        }
    }

    /// Whether the iteration has diverged.
    pub fn has_diverged(&self) -> bool {
        self.has_diverged
    }

    /// Whether, at the present convergence rate, the iterations left cost more than a renewed
    /// stiffness.
    pub fn has_stalled(&self) -> bool {
        if self.has_diverged {
            return self.controls.renewable;
        }
        let residual = |k: usize| self.history[k].equilibrium_residual;
        let now = self.history.len();
        if !self.controls.renewable || now - self.begun < TRIAL {
            return false;
        }
        let rate = (residual(now - RATE_SPAN) / residual(now - 1)).ln() / (RATE_SPAN - 1) as f64;
        let remaining = (residual(now - 1) / self.controls.tolerance).ln();
        // True as well for a rate of zero or below.
        remaining >= MAX_REMAINING * rate
    }

    /// Whether, at the rate of the last iterations, convergence needs far more iterations than the
    /// limit leaves.
    fn is_hopeless(&self, residual: f64) -> bool {
        // Earlier records belong to another plastic region.
        let records = &self.history[self.begun..];
        let now = records.len() + 1;
        if now < 2 * OUTLOOK {
            return false;
        }
        let best = |records: &[IterationRecord]| {
            records.iter().map(|record| record.equilibrium_residual).fold(f64::INFINITY, f64::min)
        };
        let (before, lately) = records[now - 2 * OUTLOOK..].split_at(OUTLOOK);
        let lately = best(lately).min(residual);
        let rate = (best(before) / lately).ln() / OUTLOOK as f64;
        let left = self.controls.max_iterations.saturating_sub(self.history.len() + 1) as f64;
        (lately / self.controls.tolerance).ln() > OUTLOOK_SLACK * left * rate.max(0.0)
    }

    /// Ends the iteration. No status means that it has stalled. An iteration that has diverged
    /// ends in the elastic state, without initial-stress loads.
    ///
    /// # Errors
    /// Those of a contact solve.
    pub fn finish(mut self, state: State, status: Option<SolveStatus>) -> Result<Outcome, Error> {
        let state = if self.has_diverged {
            let loads = self.system.zeros();
            State { response: self.solve_equilibrium(&loads)?, loads, is_complete: false }
        } else {
            state
        };
        Ok(Outcome {
            state,
            status: status.unwrap_or(SolveStatus::NotConverged),
            history: self.history,
            stalled: status.is_none(),
            is_conclusive: status == Some(SolveStatus::Converged) || self.controls.renewable,
        })
    }
}

/// Euclidean norm.
pub fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn distance(v: &[f64], w: &[f64]) -> f64 {
    v.iter().zip(w).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// A quotient that is zero where there is nothing to compare.
pub fn relative(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole.max(f64::MIN_POSITIVE) }
}
