//! A history of loads on bodies with a memory.
//!
//! ```text
//! coarse:   the whole history, with smaller and smaller increments until their error is small
//! fine:     as it was asked for, through the whole history with these increments
//!   each increment   prepare by what the coarse history has found; iterate from the accepted state; accept, or repeat in halves
//! ```
//!
//! One system serves for all of a history, because states are never carried from one to another.
//!
//! An increment that comes to no end, or ends with strains that are not small, is repeated in
//! halves, and these as well, five times at most. A history ends with the increment under which a
//! body collapses all the same: what is reported of its load is that increment.

use super::contact_system::{BlockVector, ContactSystem as _};
use super::couplings::Coupling;
use super::couplings::iteration::{Controls, Outcome};
use super::history_steps::{Estimates, HistorySteps, keep_preliminary};
use super::increments::{Division, Growth, IncrementEnds, Leg};
use super::observer::{Held, IncrementNumber, Interrupt, SolveStatus};
use super::progress::Progress;
use super::run::Run;
use super::solve::{Answer, Engine, Leave, LeaveOf, OnSystem, solve};
use super::steps::{CoarseFigures, IncrementRecord, LoadEnd, Step, StepReceiver};
use crate::{Error, Interrupted as _};
use brinell_contact::ContactLoad;

/// Relative differences of the figures of two divisions that end the search for increments. The
/// peak pressure scatters with the discrete edge of the contact; the approach that is left without
/// force is a small part of the approach that was.
const PEAK_TOLERANCE: f64 = 4e-3;
const APPROACH_TOLERANCE: f64 = 1.5e-3;
/// Part of the difference before that a difference may be while it still falls like an error of
/// first order, with room for scatter. Above it what is left is the discrete edge of the contact,
/// which no increment makes smaller.
const FALLING: f64 = 0.7;
/// Finest level of division that is tried.
const MAX_LEVEL: u32 = 5;
/// An increment on the way to a load is iterated to so many times the tolerance, but to no more
/// than the second figure: what is left of its residual the next increment takes up, and in the
/// strain path it is far below the error of the increments.
const WITHIN_LOAD: f64 = 100.0;
const LARGEST_WITHIN_LOAD: f64 = 1e-4;

/// An engine whose systems go on from accepted states.
pub trait HistoryEngine: Engine {
    /// A load as a step.
    type Step: Step;
    /// What a history leaves behind beside the accepted state: it sizes the next one, and guides
    /// its increments.
    type Memory;

    /// What alternates contact and plasticity.
    fn coupling(&self) -> &dyn Coupling;

    /// What increments are iterated with; their load and number are filled in.
    fn controls(&self) -> Controls<'_>;

    /// The memory of a history that begins on a system.
    fn begin(&self, system: &Self::System) -> Self::Memory;

    /// Bytes that a memory holds.
    fn bytes(memory: &Self::Memory) -> usize;

    /// The design of the same history once more.
    fn design_after(&self, memory: &Self::Memory) -> Self::Design;

    /// How the contact grows on the way to a load.
    fn growth(&self, load: ContactLoad) -> Growth;

    /// Prepares a system for an increment. Returns displacements to start from.
    ///
    /// # Errors
    /// Those of a factorization.
    fn prepare(
        &self,
        system: &mut Self::System,
        increment: &NextIncrement<'_, Self::Memory>,
        run: &mut Run<'_>,
    ) -> Result<BlockVector, Self::Error>;

    /// Takes over what an increment has found, before the system accepts it.
    fn remember(
        &self,
        answer: &mut Self::Answer,
        memory: &mut Self::Memory,
        time: f64,
        falls: bool,
    );

    /// The end of a load as a step, checked afresh.
    fn step(
        &self,
        answer: &mut Self::Answer,
        load: ContactLoad,
        memory: &mut Self::Memory,
        progress: &Progress,
        run: &mut Run<'_>,
    ) -> Self::Step;

    /// The end of a load as the last iteration has left it.
    fn step_as_iterated(&self, answer: &Self::Answer, load: ContactLoad) -> Self::Step;
}

/// What an increment is prepared by.
pub struct NextIncrement<'a, M> {
    /// Load at the end of the increment.
    pub target: ContactLoad,
    /// Number of the load plus the part of it that is done at the end.
    pub time: f64,
    /// The load as a leg of the history.
    pub leg: &'a Leg,
    /// Where the history is.
    pub progress: &'a Progress,
    /// What a coarser history has left.
    pub guide: Option<&'a M>,
}

/// The bodies of a history at two densities.
pub trait TwoDensities {
    /// The engine at both densities.
    type Engine: HistoryEngine;

    /// The coarse engine, sized for the largest load.
    ///
    /// # Errors
    /// Those of a design.
    fn coarse(
        &self,
        run: &mut Run<'_>,
    ) -> Result<EngineAndDesign<Self::Engine>, ErrorOf<Self::Engine>>;

    /// The engine that was asked for, sized by the coarse history.
    fn fine(
        &self,
        found: &<Self::Engine as HistoryEngine>::Memory,
    ) -> EngineAndDesign<Self::Engine>;
}

/// An engine, and how finely and how far it makes its systems.
pub type EngineAndDesign<E> = (E, <E as Engine>::Design);

type ErrorOf<E> = <E as Engine>::Error;

/// Solves the history; each load becomes a step. Increments of each load are chosen where none are
/// given.
///
/// Where the observer stops it, loads that are finished keep their steps, the one that is iterated
/// has its last iteration, and of the others there is what the coarse history has found.
///
/// # Errors
/// Those of the engines and of a contact solve.
pub fn run<B: TwoDensities>(
    bodies: &B,
    loads: &[ContactLoad],
    increments: Option<u32>,
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<<B::Engine as HistoryEngine>::Step>,
) -> Result<Option<Interrupt>, ErrorOf<B::Engine>> {
    let (engine, design) = bodies.coarse(run)?;
    let mut preliminary = Vec::new();
    let chosen = run.silently(|run| {
        let division = increments.map_or(Division::Level(0), Division::Fixed);
        let history = History { engine: &engine, loads, division, guide: None };
        history.choose_increments(design, &mut preliminary, run)
    });
    let (coarse, division, errors) = match chosen {
        Ok(chosen) => chosen,
        Err(error) => {
            let interrupt = error.interrupt().ok_or(error)?;
            return Ok(Some(keep_preliminary(preliminary, 0, interrupt, receiver, run)?));
        }
    };
    let (engine, design) = bodies.fine(&coarse.memory);
    let history = History { engine: &engine, loads, division, guide: Some(&coarse.memory) };
    let estimates = Estimates { coarse: &coarse.figures, increments: &errors };
    let mut steps = HistorySteps::new(estimates, &mut *receiver);
    let interrupt = match history.solve(design, &mut steps, run) {
        Ok(found) => found.interrupted,
        Err(error) => Some(error.interrupt().ok_or(error)?),
    };
    let done = steps.done();
    let Some(interrupt) = interrupt else { return Ok(None) };
    Ok(Some(keep_preliminary(preliminary, done, interrupt, receiver, run)?))
}

/// What a history has found.
struct Found<M> {
    memory: M,
    /// At the end of each load.
    figures: Vec<Option<CoarseFigures>>,
    /// Whether a body collapsed, so that the loads after `figures` were not applied.
    has_collapsed: bool,
    /// Why it ended early.
    interrupted: Option<Interrupt>,
}

/// A history by one engine and one division of its loads.
struct History<'a, E: HistoryEngine> {
    engine: &'a E,
    loads: &'a [ContactLoad],
    division: Division,
    /// What a coarser history has left.
    guide: Option<&'a E::Memory>,
}

/// What has been found, the division by which, and what half as large increments change.
type Chosen<M> = (Found<M>, Division, Vec<Option<CoarseFigures>>);

impl<E: HistoryEngine> History<'_, E> {
    /// Halves the increments until that no longer changes the figures at the ends of the loads.
    ///
    /// Errors fall at least like the increments, so that the difference to increments twice as
    /// large is at least the error.
    fn choose_increments(
        &self,
        mut design: E::Design,
        preliminary: &mut Vec<E::Step>,
        run: &mut Run<'_>,
    ) -> Result<Chosen<E::Memory>, E::Error> {
        let given = self.division;
        let mut division = given;
        let mut last: Option<Found<E::Memory>> = None;
        let mut worst_before = f64::INFINITY;
        loop {
            let guide = last.as_ref().map(|last| &last.memory);
            let history = History { division, guide, ..*self };
            let now = history.solve(design, &mut HistorySteps::Preliminary(preliminary), run)?;
            design = self.engine.design_after(&now.memory);
            // Finer increments do not help a body that does not bear the load.
            if now.has_collapsed {
                let errors = last
                    .map_or_else(Vec::new, |before| differences(&before.figures, &now.figures).0);
                let is_given = matches!(given, Division::Fixed(_));
                return Ok((now, if is_given { given } else { division }, errors));
            }
            if let Some(before) = last {
                let (errors, worst) = differences(&before.figures, &now.figures);
                match division {
                    // What was asked for, beside half as large increments.
                    Division::Fixed(_) => return Ok((before, given, errors)),
                    Division::Level(level)
                        if worst <= 1.0
                            || worst > FALLING * worst_before
                            || level >= MAX_LEVEL =>
                    {
                        return Ok((now, division, errors));
                    }
                    Division::Level(_) => worst_before = worst,
                }
            }
            last = Some(now);
            division = division.finer();
        }
    }

    /// Solves all loads, on one system after another until one serves.
    fn solve(
        &self,
        design: E::Design,
        steps: &mut HistorySteps<'_, E::Step>,
        run: &mut Run<'_>,
    ) -> Result<Found<E::Memory>, E::Error> {
        let mut is_begun = false;
        solve(self.engine, design, None, run, |on, system, _, run| {
            if std::mem::replace(&mut is_begun, true) {
                steps.begin_anew();
            }
            self.solve_on(on, system, steps, run)
        })
    }

    /// Solves all loads on one system.
    fn solve_on(
        &self,
        on: &OnSystem<'_, E>,
        mut system: E::System,
        steps: &mut HistorySteps<'_, E::Step>,
        run: &mut Run<'_>,
    ) -> Result<Found<E::Memory>, LeaveOf<E>> {
        let engine = self.engine;
        let mut found = Found {
            memory: engine.begin(&system),
            figures: Vec::new(),
            has_collapsed: false,
            interrupted: None,
        };
        self.hold(&found.memory, run)?;
        let mut progress = Progress::at_rest();
        let mut widest: f64 = 0.0;
        // Of all loads so far: what follows an increment that has not converged inherits its
        // error.
        let mut status = SolveStatus::Converged;
        for (number, &load) in self.loads.iter().enumerate() {
            let leg = self.leg(load, &progress);
            let mut ends = IncrementEnds::of(&leg, self.division);
            let (mut history, mut increments) = (Vec::new(), Vec::new());
            let mut k = 0;
            while k < ends.count() {
                let (count, end) = (ends.count(), ends.measure(k));
                let time = number as f64 + if k + 1 == count { 1.0 } else { leg.part(end) };
                let target = leg.load(end);
                progress.number = IncrementNumber {
                    number: k + 1,
                    count,
                    load: number + 1,
                    loads: self.loads.len(),
                };
                let guide = self.guide;
                let next = NextIncrement { target, time, leg: &leg, progress: &progress, guide };
                let mut answer = self.increment(on, system, &next, run)?;
                let interrupted = answer.outcome().status.interrupt();
                history.extend_from_slice(&answer.outcome().history);
                let start = progress.reached_measure(&leg);
                let may_halve = status == SolveStatus::Converged
                    && matches!(self.division, Division::Level(_));
                if may_halve && self.fails(&answer) && ends.halve(k, start) {
                    system = answer.into_parts().0;
                    continue;
                }
                // A state that another coupling has left without an answer says nothing of the
                // bodies.
                let inherits_error = status != SolveStatus::Converged;
                let is_accelerated = engine.coupling().uses_tangent_moduli();
                answer.outcome_mut().is_conclusive &= !inherits_error || is_accelerated;
                status = worse(status, answer.outcome().status);
                if interrupted.is_none() {
                    progress.accept(answer.system(), answer.outcome(), target, time, &leg);
                    engine.remember(&mut answer, &mut found.memory, time, leg.falls());
                    self.hold(&found.memory, run)?;
                }
                let figures = answer.figures();
                increments.push(IncrementRecord::of(figures, answer.outcome()));
                widest = widest.max(figures.half_width);
                found.has_collapsed = answer.has_collapsed();
                found.interrupted = interrupted;
                if let (false, Some(interrupt)) = (steps.are_final(), interrupted) {
                    return Err(Error::Interrupted(interrupt).into());
                }
                if k + 1 == count || interrupted.is_some() || found.has_collapsed {
                    found
                        .figures
                        .push(Some(CoarseFigures { bodies: answer.body_figures(), ..figures }));
                    let outcome = answer.outcome_mut();
                    (outcome.history, outcome.status) = (std::mem::take(&mut history), status);
                    let last_increment = leg.increment(start, end, inherits_error);
                    let increments = std::mem::take(&mut increments);
                    let reached = [progress.reached[1], widest];
                    let mut step = if steps.are_final() {
                        engine.step(&mut answer, target, &mut found.memory, &progress, run)
                    } else {
                        engine.step_as_iterated(&answer, target)
                    };
                    // It may be stopped while its fields are formed.
                    found.interrupted = step.status().interrupt();
                    step.end_load(LoadEnd { load, last_increment, increments, reached });
                    steps.take(number, step, run.observer);
                    if found.interrupted.is_some() {
                        return Ok(found);
                    }
                }
                if found.has_collapsed {
                    steps.end_before(number);
                    return Ok(found);
                }
                let outcome;
                (system, outcome) = answer.into_parts();
                system.commit(outcome.state.response.displacement);
                k += 1;
            }
        }
        Ok(found)
    }

    /// Tells the observer what this history and the one before hold.
    fn hold(&self, memory: &E::Memory, run: &mut Run<'_>) -> Result<(), Error> {
        run.hold(Held::Increments, E::bytes(memory) + self.guide.map_or(0, E::bytes))
    }

    /// A load as a leg of the history, from where the bodies are.
    fn leg(&self, load: ContactLoad, progress: &Progress) -> Leg {
        let (from, reached) = match load {
            ContactLoad::Force(_) => (progress.force, progress.reached[0]),
            ContactLoad::Approach(_) => (progress.approach, progress.reached[1]),
        };
        let growth = self.engine.growth(load);
        Leg {
            is_force: matches!(load, ContactLoad::Force(_)),
            from,
            to: load.magnitude(),
            reached,
            growth,
        }
    }

    /// Whether smaller increments may come farther: strains are not small, or Newton's method has
    /// come to no end before it has made as many iterations as the job allows. Couplings without
    /// it diverge in small increments as well.
    fn fails(&self, answer: &E::Answer) -> bool {
        let Outcome { status, history, .. } = answer.outcome();
        let is_lost = *status == SolveStatus::NotConverged
            && self.engine.coupling().uses_tangent_moduli()
            && history.len() < self.engine.controls().max_iterations;
        is_lost || (!status.is_stopped() && answer.has_collapsed())
    }

    /// One increment, from the accepted state.
    fn increment(
        &self,
        on: &OnSystem<'_, E>,
        mut system: E::System,
        next: &NextIncrement<'_, E::Memory>,
        run: &mut Run<'_>,
    ) -> Result<E::Answer, LeaveOf<E>> {
        let Progress { scales, number, .. } = *next.progress;
        let mut controls = Controls {
            load: next.target,
            scales,
            increment: Some(number),
            ..self.engine.controls()
        };
        if number.number < number.count {
            controls.tolerance = within_load(controls.tolerance);
        }
        let start = self.engine.prepare(&mut system, next, run).map_err(Leave::Failed)?;
        on.solve(system, Some(start), self.engine.coupling(), controls, run)
    }
}

/// Part of the largest value of a figure in a history below which its changes are relative to that
/// part.
const LEAST_FIGURE: f64 = 0.05;

/// Relative differences of figures at the end of each load, and the worst of peak pressure and
/// approach over its tolerance.
fn differences(
    before: &[Option<CoarseFigures>],
    now: &[Option<CoarseFigures>],
) -> (Vec<Option<CoarseFigures>>, f64) {
    let mut largest = [f64::MIN_POSITIVE; CoarseFigures::COUNT];
    for figures in now.iter().flatten() {
        largest
            .iter_mut()
            .zip(figures.values())
            .for_each(|(most, value)| *most = most.max(value.abs()));
    }
    let mut worst: f64 = 0.0;
    let pairs = before.iter().zip(now).map(|(before, now)| {
        let (before, now) = (before.as_ref()?.values(), now.as_ref()?.values());
        let relative =
            |k: usize| (before[k] - now[k]).abs() / now[k].abs().max(LEAST_FIGURE * largest[k]);
        let errors = CoarseFigures::of(std::array::from_fn(relative));
        worst = worst
            .max(errors.peak_pressure / PEAK_TOLERANCE)
            .max(errors.approach / APPROACH_TOLERANCE);
        Some(errors)
    });
    (pairs.collect(), worst)
}

/// The tolerance of increments that do not end a load.
fn within_load(tolerance: f64) -> f64 {
    (WITHIN_LOAD * tolerance).min(LARGEST_WITHIN_LOAD.max(tolerance))
}

/// The less good of two.
fn worse(a: SolveStatus, b: SolveStatus) -> SolveStatus {
    if a == SolveStatus::Converged { b } else { a }
}
