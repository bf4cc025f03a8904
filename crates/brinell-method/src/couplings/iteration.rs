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

/// What an iteration is run with.
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
    /// Whether to stop where another linearization would pay.
    pub renewable: bool,
    /// What residuals and changes are relative to, at least.
    pub scales: Scales,
    /// The increment of a history that is iterated.
    pub increment: Option<IncrementNumber>,
}

/// The largest norms of a load history so far. Unloaded bodies have no contact forces that a
/// residual could be relative to.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Scales {
    /// `‖R‖` \[N/mm\].
    pub force: f64,
    /// `‖u‖` on the active equations \[mm\].
    pub displacement: f64,
}

/// The state an iteration ended in.
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
    /// Whether it ended because another linearization would pay.
    pub stalled: bool,
    /// Whether its strains say something of the bodies: it has converged, or no other coupling
    /// gets farther.
    pub is_conclusive: bool,
}

/// Where an iteration begins.
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

/// Iterations on one linearization before its convergence rate is estimated.
const TRIAL: usize = 8;
/// Iterations that the rate is taken from.
const RATE_SPAN: usize = 7;
/// Iterations to go that cost about as much as another linearization.
const MAX_REMAINING: f64 = 12.0;

/// Iterations over which the best residuals are compared to see whether an iteration without
/// another linearization gets to its end, and by how much it may miss that.
const OUTLOOK: usize = 50;
const OUTLOOK_SLACK: f64 = 4.0;

/// Out-of-balance force over the contact force from which no iteration comes back.
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
    /// What it is iterated with.
    pub controls: Controls<'a>,
    /// Who watches it.
    pub run: Run<'a>,
    counts: Counts,
    history: Vec<IterationRecord>,
    /// Records from before this iteration, on other moduli or another plastic region.
    begun: usize,
    /// Displacements to start from.
    start: Option<BlockVector>,
    /// Contact of the last iteration.
    previous: Option<ContactSolution>,
    /// Whether the last state is so far off that nothing can be told from it.
    has_diverged: bool,
}

impl<'a> Iteration<'a> {
    /// An iteration from an initial state.
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

    /// Displacements to start from, and the initial-stress loads that belong to them: those of a
    /// previous load on the same mesh, else zero.
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

    /// Writes down and judges an iteration that went from the displacements `start` to a response
    /// which the plastic law leaves out of balance by `residual_norm` \[N/mm\]. `Some` is the
    /// status of an iteration that ends here: it has converged where residual and change of
    /// displacement are within the tolerance.
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

    /// Whether the last state is so far off that nothing can be told from it.
    pub fn has_diverged(&self) -> bool {
        self.has_diverged
    }

    /// Whether, at the present convergence rate, the iterations left cost more than another
    /// linearization.
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

    /// Whether the iterations left would have to be many more to get to the end at the rate of the
    /// last ones.
    fn is_hopeless(&self, residual: f64) -> bool {
        // What came before was of another plastic region.
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

    /// Closes the iteration; without a status it is one that has stalled. One that has diverged
    /// ends in the state without initial-stress loads.
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
