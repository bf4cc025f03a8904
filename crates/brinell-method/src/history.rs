//! A history of loads on bodies with a memory.
//!
//! ```text
//! coarse:   solve the whole history coarsely; halve the increments until their error is small
//! fine:     solve the whole history at the requested density with these increments
//!   each increment   prepare the system by the coarse history
//!                    iterate from the accepted state
//!                    accept, or repeat in halves
//! ```
//!
//! A history runs on one system from end to end, because states are never transferred between
//! systems.
//!
//! An increment that does not converge, or ends with strains that are not small, is halved, at
//! most five times over. If a body collapses even in the smallest increment, the history ends
//! there, and the step of this load reports that increment.

use super::contact_system::{BlockVector, ContactSystem as _};
use super::couplings::Coupling;
use super::couplings::iteration::{Controls, Outcome};
use super::figures::{Figure, Figures, Values};
use super::history_steps::{Estimates, HistorySteps, keep_preliminary};
use super::increments::{Division, Growth, IncrementEnds, Leg};
use super::loads::Stretch;
use super::observer::{Held, IncrementNumber, Interrupt, IterationRecord, SolveStatus};
use super::progress::Progress;
use super::run::Run;
use super::solve::{Engine, Leave, LeaveOf, OnSystem, solve};
use super::steps::{IncrementRecord, Path, Step, StepReceiver};
use super::strays::Rising;
use crate::{Error, Interrupted as _};
use brinell_contact::ContactLoad;

/// Relative differences of the figures of two divisions below which the increments are small
/// enough. The peak pressure scatters with the discrete edge of the contact. The approach that
/// remains after unloading is a small part of the largest approach.
const PEAK_TOLERANCE: f64 = 4e-3;
const APPROACH_TOLERANCE: f64 = 1.5e-3;
/// Part of the strays of a coarse history up to which a difference of the approach is small enough:
/// smaller increments do not help what the mesh leaves.
const WITHIN_STRAYS: f64 = 0.3;
/// Largest ratio of successive differences that counts as the fall of a first-order error, with
/// room for scatter. Above this ratio the discrete edge of the contact causes the difference,
/// which smaller increments do not reduce.
const FALLING: f64 = 0.7;
/// Finest level of division that is tried.
const MAX_LEVEL: u32 = 5;
/// Tolerance of increments before the last of a load, over the tolerance of the job; the second
/// constant is its upper limit. The next increment takes up the residual, whose effect on the
/// strain path is far below the error of the increments.
const WITHIN_LOAD: f64 = 100.0;
const LARGEST_WITHIN_LOAD: f64 = 1e-4;

/// An engine whose systems continue from accepted states.
pub trait Memory: Engine + Sized {
    /// The fields of a step.
    type Field;
    /// The record of a history beside the accepted state. It sizes the system of the next history
    /// and guides its increments.
    type Record;

    /// Returns the coupling of contact and plasticity.
    fn coupling(&self) -> &dyn Coupling;

    /// Returns the controls of the iteration; the history fills in load and number of each
    /// increment.
    fn controls(&self) -> Controls<'_>;

    /// Returns the parts of an answer.
    fn parts(answer: &Self::Answer) -> (&Self::System, &Outcome);

    /// Returns the outcome of an answer, to be changed.
    fn outcome_mut(answer: &mut Self::Answer) -> &mut Outcome;

    /// Takes an answer apart.
    fn into_parts(answer: Self::Answer) -> (Self::System, Outcome);

    /// Returns force, approach, peak pressure and half-width of an answer, 0 without contact, and
    /// the pressure in the middle where that is at hand.
    fn figures(answer: &Self::Answer) -> Figures;

    /// Returns whether strains have outgrown the theory of small strains.
    fn has_collapsed(answer: &Self::Answer) -> bool;

    /// Returns all figures at the end of a load.
    fn measure(&self, answer: &Self::Answer, memory: &Self::Record) -> Figures;

    /// Returns the empty memory of a history on a system.
    fn begin(&self, system: &Self::System) -> Self::Record;

    /// Returns the bytes that a memory holds.
    fn bytes(memory: &Self::Record) -> usize;

    /// Returns the design for a repetition of the same history.
    fn design_after(&self, memory: &Self::Record) -> Self::Design;

    /// Returns the engine of the requested density and the design of its first system, by what a
    /// coarse history has found.
    fn finer(&self, found: &Self::Record) -> (Self, Self::Design);

    /// Returns the growth of the contact on the way to a load.
    fn growth(&self, load: ContactLoad) -> Growth;

    /// Prepares a system for an increment. Returns displacements to start from.
    ///
    /// # Errors
    /// Those of a factorization.
    fn prepare(
        &self,
        system: &mut Self::System,
        increment: &NextIncrement<'_, Self::Record>,
        run: &mut Run<'_>,
    ) -> Result<BlockVector, Self::Error>;

    /// Records the outcome of an increment, before the system accepts it.
    fn remember(
        &self,
        answer: &mut Self::Answer,
        memory: &mut Self::Record,
        time: f64,
        falls: bool,
    );

    /// Returns the end of a load as a step, with the final check.
    fn step(
        &self,
        answer: &mut Self::Answer,
        load: ContactLoad,
        memory: &mut Self::Record,
        progress: &Progress,
        run: &mut Run<'_>,
    ) -> Step<Self::Field>;

    /// Returns the end of a load as a step, from the last iteration and without the final check.
    fn step_as_iterated(&self, answer: &Self::Answer, load: ContactLoad) -> Step<Self::Field>;
}

/// The data for the preparation of an increment.
pub struct NextIncrement<'a, M> {
    /// Load at the end of the increment.
    pub target: ContactLoad,
    /// Number of the load plus the part of it that is applied at the end of the increment.
    pub time: f64,
    /// The load as a leg of the history.
    pub leg: &'a Leg,
    /// The progress of the history.
    pub progress: &'a Progress,
    /// The memory of the coarser history.
    pub guide: Option<&'a M>,
}

/// Solves the history by a coarse engine, from this design, and then by the finer one; each load
/// becomes a step. Chooses the increments of each load where the job
/// gives none.
///
/// If the observer stops the solve, finished loads keep their steps, the present load reports its
/// last iteration, and the other loads report the coarse history.
///
/// # Errors
/// Those of the engine and of a contact solve.
pub fn run<E: Memory>(
    (engine, design): (E, E::Design),
    stretch: Stretch<'_>,
    increments: Option<u32>,
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<E::Field>,
) -> Result<Option<Interrupt>, E::Error> {
    let mut preliminary = Vec::new();
    let chosen = run.preliminarily(|run| {
        let division = increments.map_or(Division::Level(0), Division::Fixed);
        let history = History { engine: &engine, stretch, division, guide: None };
        history.choose_increments(design, &mut preliminary, run)
    });
    let (coarse, division, errors) = match chosen {
        Ok(chosen) => chosen,
        Err(error) => {
            let interrupt = error.interrupt().ok_or(error)?;
            return Ok(Some(keep_preliminary(preliminary, 0, interrupt, receiver, run)?));
        }
    };
    let (engine, design) = engine.finer(&coarse.memory);
    let history = History { engine: &engine, stretch, division, guide: Some(&coarse.memory) };
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

/// The result of a history.
struct Found<M> {
    memory: M,
    /// Figures at the end of each load.
    figures: Vec<Option<Figures>>,
    /// Strays of the figures on the way to each of these loads.
    strays: Vec<Values>,
    /// Whether a body collapsed, so that the loads after `figures` were not applied.
    has_collapsed: bool,
    /// Why the history ended early.
    interrupted: Option<Interrupt>,
}

/// A history by one engine and one division of its loads.
struct History<'a, E: Memory> {
    engine: &'a E,
    stretch: Stretch<'a>,
    division: Division,
    /// The memory of the coarser history.
    guide: Option<&'a E::Record>,
}

/// The result, its division, and the change of the figures when the increments are halved.
type Chosen<M> = (Found<M>, Division, Vec<Option<Values>>);

impl<E: Memory> History<'_, E> {
    /// Halves the increments until the figures at the ends of the loads no longer change.
    ///
    /// Errors fall at least like the increments, so that the difference to increments twice as
    /// large is at least the error.
    fn choose_increments(
        &self,
        mut design: E::Design,
        preliminary: &mut Vec<Step<E::Field>>,
        run: &mut Run<'_>,
    ) -> Result<Chosen<E::Record>, E::Error> {
        let given = self.division;
        let mut division = given;
        let mut last: Option<Found<E::Record>> = None;
        let mut worst_before = f64::INFINITY;
        loop {
            let guide = last.as_ref().map(|last| &last.memory);
            let history = History { division, guide, ..*self };
            let now = history.solve(design, &mut HistorySteps::Preliminary(preliminary), run)?;
            design = self.engine.design_after(&now.memory);
            // Smaller increments do not help a body that cannot bear the load.
            if now.has_collapsed {
                let errors =
                    last.map_or_else(Vec::new, |before| differences(&before.figures, &now).0);
                let is_given = matches!(given, Division::Fixed(_));
                return Ok((now, if is_given { given } else { division }, errors));
            }
            if let Some(before) = last {
                let (errors, worst) = differences(&before.figures, &now);
                match division {
                    // The given increments, compared with increments half as large.
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

    /// Solves all loads on one system after another until the contact fits.
    fn solve(
        &self,
        design: E::Design,
        steps: &mut HistorySteps<'_, E::Field>,
        run: &mut Run<'_>,
    ) -> Result<Found<E::Record>, E::Error> {
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
        steps: &mut HistorySteps<'_, E::Field>,
        run: &mut Run<'_>,
    ) -> Result<Found<E::Record>, LeaveOf<E>> {
        let engine = self.engine;
        let mut found = Found {
            memory: engine.begin(&system),
            figures: Vec::new(),
            strays: Vec::new(),
            has_collapsed: false,
            interrupted: None,
        };
        self.hold(&found.memory, 0, run)?;
        let mut progress = Progress::at_rest();
        let mut rising = Rising::default();
        let mut widest: f64 = 0.0;
        // The worst status so far: a load after an increment that has not converged inherits its
        // error.
        let mut status = SolveStatus::Converged;
        for (number, &load) in self.stretch.loads.iter().enumerate() {
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
                    load: self.stretch.before + number + 1,
                    loads: self.stretch.all,
                };
                let guide = self.guide;
                let next = NextIncrement { target, time, leg: &leg, progress: &progress, guide };
                let mut answer = self.increment(on, system, &next, run)?;
                let interrupted = E::outcome_mut(&mut answer).status.interrupt();
                if !steps.are_final() {
                    history.clear();
                }
                history.extend_from_slice(&E::parts(&answer).1.history);
                let start = progress.reached_measure(&leg);
                let may_halve = status == SolveStatus::Converged
                    && matches!(self.division, Division::Level(_));
                if may_halve && self.fails(&answer) && ends.halve(k, start) {
                    system = E::into_parts(answer).0;
                    continue;
                }
                // After an increment that has not converged, only a coupling with Newton's method
                // ends in a state that shows a collapse.
                let inherits_error = status != SolveStatus::Converged;
                let is_accelerated = engine.coupling().uses_tangent_moduli();
                let outcome = E::outcome_mut(&mut answer);
                outcome.is_conclusive &= !inherits_error || is_accelerated;
                status = worse(status, outcome.status);
                if interrupted.is_none() {
                    let (system, outcome) = E::parts(&answer);
                    progress.accept(system, outcome, target, time, &leg);
                    engine.remember(&mut answer, &mut found.memory, time, leg.falls());
                    let records = history.capacity() * size_of::<IterationRecord>()
                        + increments.capacity() * size_of::<IncrementRecord>();
                    self.hold(&found.memory, records, run)?;
                }
                let figures = E::figures(&answer);
                increments.push(IncrementRecord::of(figures, E::parts(&answer).1));
                rising.extend(&increments);
                widest = widest.max(figures.half_width);
                found.has_collapsed = E::has_collapsed(&answer);
                found.interrupted = interrupted;
                if let (false, Some(interrupt)) = (steps.are_final(), interrupted) {
                    return Err(Error::Interrupted(interrupt).into());
                }
                if k + 1 == count || interrupted.is_some() || found.has_collapsed {
                    let measure = || engine.measure(&answer, &found.memory);
                    found.figures.push((!steps.are_final()).then(measure));
                    let shown = rising.strays(&leg);
                    found.strays.push(shown);
                    let outcome = E::outcome_mut(&mut answer);
                    (outcome.history, outcome.status) = (std::mem::take(&mut history), status);
                    let last_increment = leg.increment(start, end, inherits_error);
                    // A preliminary step keeps its last increment alone: a coarse history may have
                    // a thousand loads of thousands of increments.
                    let kept = if steps.are_final() { 0 } else { increments.len() - 1 };
                    let increments = increments.split_off(kept);
                    let reached = [progress.reached[1], widest];
                    let mut step = if steps.are_final() {
                        engine.step(&mut answer, target, &mut found.memory, &progress, run)
                    } else {
                        engine.step_as_iterated(&answer, target)
                    };
                    // The observer may stop the solve while the fields are computed.
                    found.interrupted = step.status.interrupt();
                    step.load = load;
                    step.path = Path { increments, last_increment, reached, shown, ..step.path };
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
                (system, outcome) = E::into_parts(answer);
                system.commit(outcome.state.response.displacement);
                k += 1;
            }
        }
        Ok(found)
    }

    /// Tells the observer the memory that this history, the one before, and `records` of the
    /// present load hold.
    fn hold(&self, memory: &E::Record, records: usize, run: &mut Run<'_>) -> Result<(), Error> {
        let before = self.guide.map_or(0, E::bytes);
        run.hold(Held::Increments, E::bytes(memory) + before + records)
    }

    /// Returns a load as a leg of the history from the present state.
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

    /// Whether smaller increments may help: strains are not small, or Newton's method has stopped
    /// before the iteration limit of the job. Couplings without Newton's method diverge in small
    /// increments too.
    fn fails(&self, answer: &E::Answer) -> bool {
        let Outcome { status, history, .. } = E::parts(answer).1;
        let is_lost = *status == SolveStatus::NotConverged
            && self.engine.coupling().uses_tangent_moduli()
            && history.len() < self.engine.controls().max_iterations;
        is_lost || (!status.is_stopped() && E::has_collapsed(answer))
    }

    /// Solves one increment from the accepted state.
    fn increment(
        &self,
        on: &OnSystem<'_, E>,
        mut system: E::System,
        next: &NextIncrement<'_, E::Record>,
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

/// Least scale of the changes of a figure, over its largest value in the history.
const LEAST_FIGURE: f64 = 0.05;

/// Returns the relative differences of the figures at the end of each load, and the largest ratio
/// of a difference of peak pressure or approach to its tolerance.
fn differences<M>(
    before: &[Option<Figures>],
    Found { figures: now, strays, .. }: &Found<M>,
) -> (Vec<Option<Values>>, f64) {
    let least = now.iter().flatten().fold(Values::default(), |largest, figures| {
        largest.with(&figures.values(), |most, value| most.max(value.abs()))
    });
    let least = least.map(|_, _, most| LEAST_FIGURE * most.max(f64::MIN_POSITIVE));
    let mut worst: f64 = 0.0;
    let pairs = before.iter().zip(now).zip(strays).map(|((before, now), strays)| {
        let (before, now) = (before.as_ref()?.values(), now.as_ref()?.values());
        let scales = now.zip(&least, |now, least| now.abs().max(least));
        let errors =
            before.zip(&now, |before, now| (before - now).abs()).zip(&scales, |a, b| a / b);
        let of = |values: &Values, figure| values.get(figure, 0).unwrap_or_default();
        let of_approach = APPROACH_TOLERANCE.max(WITHIN_STRAYS * of(strays, Figure::Approach));
        worst = worst
            .max(of(&errors, Figure::PeakPressure) / PEAK_TOLERANCE)
            .max(of(&errors, Figure::Approach) / of_approach);
        Some(errors)
    });
    (pairs.collect(), worst)
}

/// The tolerance of increments that do not end a load.
fn within_load(tolerance: f64) -> f64 {
    (WITHIN_LOAD * tolerance).min(LARGEST_WITHIN_LOAD.max(tolerance))
}

/// Returns the worse of two statuses.
fn worse(a: SolveStatus, b: SolveStatus) -> SolveStatus {
    if a == SolveStatus::Converged { b } else { a }
}
