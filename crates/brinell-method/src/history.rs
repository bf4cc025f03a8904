//! A history of loads on bodies with a memory.
//!
//! ```text
//! coarse:   solve the whole history coarsely, with increments twice as large and with all of them
//! fine:     solve the whole history at the requested density, by the coarse one
//!   each increment   follow the path of the coarse history; prepare the system by it
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
use super::figures::{Figures, Values};
use super::history_steps::{Estimates, HistorySteps, keep_preliminary};
use super::increments::{Division, Growth, IncrementEnds, Increments, LastIncrement, Leg};
use super::loads::Stretch;
use super::observer::{Held, IncrementNumber, Interrupt, IterationRecord, SolveStatus};
use super::progress::Progress;
use super::run::Run;
use super::solve::{Engine, Leave, LeaveOf, OnSystem, solve};
use super::steps::{IncrementRecord, Path, Step, StepReceiver};
use super::strays::Rising;
use crate::{Error, Interrupted as _};
use brinell_contact::ContactLoad;

/// Tolerance of increments before the last of a load, over the tolerance of the job; the second
/// constant is its upper limit. The next increment takes up the residual, whose effect on the
/// strain path is far below the error of the increments.
const WITHIN_LOAD: f64 = 1000.0;
const LARGEST_WITHIN_LOAD: f64 = 1e-3;

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

    /// Returns the system of a history with the bodies at rest again, for the next history; by
    /// default it is built anew.
    fn at_rest(&self, _system: Self::System) -> Option<Self::System> {
        None
    }

    /// Returns the engine of the requested density and the design of its first system, by what a
    /// coarse history has found.
    fn finer(&self, found: &Self::Record) -> (Self, Self::Design);

    /// Returns whether [`Self::prepare`] takes the bodies along the path of a coarser history.
    fn follows_path(&self) -> bool {
        false
    }

    /// Returns the growth of the contact on the way to a load.
    fn growth(&self, load: ContactLoad) -> Growth;

    /// Prepares a system for an increment: takes the states of its points along the path of the
    /// guide if the increment follows it. Returns displacements to start from.
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
    /// Whether the bodies follow its path from increment to increment within this one.
    pub follows: bool,
}

/// Solves the history by a coarse engine, from this design, and then by the finer one; each load
/// becomes a step. Where the job gives no increments the contact grows by the same width in each,
/// and a single load is followed along the path of the coarse history.
///
/// If the observer stops the solve, finished loads keep their steps, the present load reports its
/// last iteration, and the other loads report the coarse history.
///
/// # Errors
/// Those of the engine and of a contact solve.
pub fn run<E: Memory>(
    (engine, design): (E, E::Design),
    stretch: Stretch<'_>,
    increments: Increments,
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver<E::Field>,
) -> Result<Option<Interrupt>, E::Error> {
    let mut preliminary = Vec::new();
    let is_path = engine.follows_path() && stretch.loads.len() == 1;
    let (half, all, fine, times) = match increments {
        Increments::Given(n) => {
            let [half, all, fine] = [n.div_ceil(2), n.max(2), n].map(Division::Fixed);
            (half, all, fine, 1)
        }
        Increments::Chosen(times) if is_path => {
            (Division::HalvedPath, Division::Path, Division::Followed, times)
        }
        Increments::Chosen(times) => (Division::Halved, Division::Grown, Division::Grown, times),
    };
    let compared = run.preliminarily(|run| {
        let history = History { engine: &engine, stretch, division: half, times, guide: None };
        let is_one = increments == Increments::Given(1);
        history.compare_increments(design, all, is_one, &mut preliminary, run)
    });
    let (mut coarse, errors) = match compared {
        Ok(compared) => compared,
        Err(error) => {
            let interrupt = error.interrupt().ok_or(error)?;
            return Ok(Some(keep_preliminary(preliminary, 0, interrupt, receiver, run)?));
        }
    };
    let division = match fine {
        Division::Followed if coarse.has_collapsed => Division::Grown,
        division => division,
    };
    coarse.system = None;
    let (engine, design) = engine.finer(&coarse.memory);
    let history =
        History { engine: &engine, stretch, division, times, guide: Some(&coarse.memory) };
    let estimates =
        Estimates { coarse: &coarse.figures, increments: &errors, steps: &preliminary };
    let mut steps = HistorySteps::new(estimates, &mut *receiver);
    let interrupt = match history.solve(design, None, &mut steps, run) {
        Ok(found) => found.interrupted,
        Err(error) => Some(error.interrupt().ok_or(error)?),
    };
    let done = steps.done();
    let Some(interrupt) = interrupt else { return Ok(None) };
    Ok(Some(keep_preliminary(preliminary, done, interrupt, receiver, run)?))
}

/// The result of a history.
struct Found<M, S> {
    memory: M,
    /// The system after the last load, unless a body collapsed or the observer stopped the history.
    system: Option<S>,
    /// Figures at the end of each load.
    figures: Vec<Option<Figures>>,
    /// Whether no load has increments that can be halved.
    is_finest: bool,
    /// Whether a body collapsed, so that the loads after `figures` were not applied.
    has_collapsed: bool,
    /// Why the history ended early.
    interrupted: Option<Interrupt>,
}

impl<M, S> Found<M, S> {
    /// The result before the first load.
    const fn at_rest(memory: M) -> Self {
        Self {
            memory,
            system: None,
            figures: Vec::new(),
            is_finest: true,
            has_collapsed: false,
            interrupted: None,
        }
    }
}

/// How far a history on one system has come.
struct HistoryState<M, S> {
    found: Found<M, S>,
    progress: Progress,
    rising: Rising,
    /// Largest half-width so far \[mm\].
    widest: f64,
    /// The worst status so far: a load after an increment that has not converged inherits its
    /// error.
    status: SolveStatus,
}

impl<M, S> HistoryState<M, S> {
    /// The state before the first load.
    fn at_rest(memory: M) -> Self {
        Self {
            found: Found::at_rest(memory),
            progress: Progress::at_rest(),
            rising: Rising::default(),
            widest: 0.0,
            status: SolveStatus::Converged,
        }
    }

    fn inherits_error(&self) -> bool {
        self.status != SolveStatus::Converged
    }
}

/// The load that a history solves.
struct CurrentLoad {
    /// Its number, from 0.
    number: usize,
    load: ContactLoad,
    leg: Leg,
    ends: IncrementEnds,
    /// Whether the bodies follow the path of the coarser history within its increments.
    follows: bool,
    /// Iterations of all increments, or of the last one of a preliminary history.
    history: Vec<IterationRecord>,
    increments: Vec<IncrementRecord>,
}

impl CurrentLoad {
    fn record_iterations(&mut self, outcome: &Outcome, are_final: bool) {
        if !are_final {
            self.history.clear();
        }
        self.history.extend_from_slice(&outcome.history);
    }

    /// Bytes of its records.
    fn bytes(&self) -> usize {
        self.history.capacity() * size_of::<IterationRecord>()
            + self.increments.capacity() * size_of::<IncrementRecord>()
    }
}

/// A history by one engine and one division of its loads.
struct History<'a, E: Memory> {
    engine: &'a E,
    stretch: Stretch<'a>,
    division: Division,
    /// Increments over those by default.
    times: u32,
    /// The memory of the coarser history.
    guide: Option<&'a E::Record>,
}

/// The result with the types of an engine.
type FoundOf<E> = Found<<E as Memory>::Record, <E as Engine>::System>;

/// A history, and the change of its figures when the increments are halved.
type Compared<E> = (FoundOf<E>, Vec<Option<Values>>);

impl<E: Memory> History<'_, E> {
    /// Solves the history with these increments and then with those of the finer history, about
    /// half as large; a single one that is given is compared with two.
    ///
    /// Errors fall at least like the increments, so that the difference is at least the error of all
    /// increments. Up to an elastic peak of four yield stresses they fall like the square: there it
    /// also holds the error of a path that is followed with half of them.
    fn compare_increments(
        &self,
        design: E::Design,
        division: Division,
        keeps_larger: bool,
        preliminary: &mut Vec<Step<E::Field>>,
        run: &mut Run<'_>,
    ) -> Result<Compared<E>, E::Error> {
        let mut steps = HistorySteps::Preliminary(preliminary);
        let mut larger = self.solve(design, None, &mut steps, run)?;
        // Smaller increments do not help a body that cannot bear the load.
        if larger.is_finest || larger.has_collapsed {
            return Ok((larger, Vec::new()));
        }
        let design = self.engine.design_after(&larger.memory);
        let known = larger.system.take().and_then(|system| self.engine.at_rest(system));
        let history = History { division, guide: Some(&larger.memory), ..*self };
        let smaller = history.solve(design, known, &mut steps, run)?;
        let errors = differences(&larger.figures, &smaller.figures);
        let keeps_larger = keeps_larger && !smaller.has_collapsed;
        Ok((if keeps_larger { larger } else { smaller }, errors))
    }

    /// Solves all loads on one system after another, the known one first, until the contact fits.
    fn solve(
        &self,
        design: E::Design,
        known: Option<E::System>,
        steps: &mut HistorySteps<'_, E::Field>,
        run: &mut Run<'_>,
    ) -> Result<FoundOf<E>, E::Error> {
        let mut is_begun = false;
        let mut division = self.division;
        solve(self.engine, design, known, run, |on, system, _, run| {
            if std::mem::replace(&mut is_begun, true) {
                steps.begin_anew();
            }
            self.solve_on(on, system, &mut division, steps, run)
        })
    }

    /// Solves all loads on one system. An increment that fails on the path of a coarser history
    /// ends this, for a repetition without it.
    fn solve_on(
        &self,
        on: &OnSystem<'_, E>,
        mut system: E::System,
        division: &mut Division,
        steps: &mut HistorySteps<'_, E::Field>,
        run: &mut Run<'_>,
    ) -> Result<FoundOf<E>, LeaveOf<E>> {
        let mut state = HistoryState::at_rest(self.engine.begin(&system));
        self.hold(&state.found.memory, 0, run)?;
        for number in 0..self.stretch.loads.len() {
            let next = self.solve_load(number, (on, system), division, &mut state, steps, run)?;
            let Some(next) = next else { return Ok(state.found) };
            system = next;
        }
        state.found.system = Some(system);
        Ok(state.found)
    }

    /// Solves the increments of a load; `None` where the history ends there.
    fn solve_load(
        &self,
        number: usize,
        (on, mut system): (&OnSystem<'_, E>, E::System),
        division: &mut Division,
        state: &mut HistoryState<E::Record, E::System>,
        steps: &mut HistorySteps<'_, E::Field>,
        run: &mut Run<'_>,
    ) -> Result<Option<E::System>, LeaveOf<E>> {
        let mut current = self.begin_load(number, *division, state);
        let mut k = 0;
        while k < current.ends.count() {
            let (count, end) = (current.ends.count(), current.ends.measure(k));
            let is_last = k + 1 == count;
            let target = current.leg.load(end);
            let time = number as f64 + if is_last { 1.0 } else { current.leg.part(end) };
            state.progress.number = self.number(number, k, count);
            let (leg, guide, follows) = (&current.leg, self.guide, current.follows);
            let progress = &state.progress;
            let next = NextIncrement { target, time, leg, progress, guide, follows };
            let mut answer = self.increment(on, system, &next, run)?;
            current.record_iterations(E::parts(&answer).1, steps.are_final());
            let start = state.progress.reached_measure(&current.leg);
            let is_given = matches!(division, Division::Fixed(_));
            if !state.inherits_error() && !is_given && self.fails(&answer) {
                if current.follows {
                    *division = Division::Grown;
                    let design = self.engine.design_after(&state.found.memory);
                    return Err(Leave::Again(Box::new(design)));
                }
                if current.ends.halve(k, start) {
                    system = E::into_parts(answer).0;
                    continue;
                }
            }
            let last_increment = current.leg.increment(start, end, state.inherits_error());
            self.accept(&mut answer, (target, time), &mut current, state, run)?;
            if let (false, Some(interrupt)) = (steps.are_final(), state.found.interrupted) {
                return Err(Error::Interrupted(interrupt).into());
            }
            if is_last || state.found.interrupted.is_some() || state.found.has_collapsed {
                self.end_load(
                    &mut answer,
                    (target, last_increment),
                    &mut current,
                    state,
                    steps,
                    run,
                );
                if state.found.interrupted.is_some() {
                    return Ok(None);
                }
            }
            if state.found.has_collapsed {
                steps.end_before(number);
                return Ok(None);
            }
            let outcome;
            (system, outcome) = E::into_parts(answer);
            system.commit(outcome.state.response.displacement);
            k += 1;
        }
        Ok(Some(system))
    }

    /// Divides a load into increments.
    fn begin_load(
        &self,
        number: usize,
        division: Division,
        state: &mut HistoryState<E::Record, E::System>,
    ) -> CurrentLoad {
        let load = self.stretch.loads[number];
        let leg = self.leg(load, &state.progress);
        let ends = IncrementEnds::of(&leg, division);
        let is_finest = ends.count() == leg.ends(division.finer()).len();
        state.found.is_finest &= is_finest;
        let follows = division == Division::Followed && !is_finest;
        CurrentLoad {
            number,
            load,
            leg,
            ends,
            follows,
            history: Vec::new(),
            increments: Vec::new(),
        }
    }

    /// Takes up the outcome of an increment.
    fn accept(
        &self,
        answer: &mut E::Answer,
        (target, time): (ContactLoad, f64),
        current: &mut CurrentLoad,
        state: &mut HistoryState<E::Record, E::System>,
        run: &mut Run<'_>,
    ) -> Result<(), Error> {
        // After an increment that has not converged, only a coupling with Newton's method ends in
        // a state that shows a collapse.
        let is_accelerated = self.engine.coupling().uses_tangent_moduli();
        let outcome = E::outcome_mut(answer);
        outcome.is_conclusive &= !state.inherits_error() || is_accelerated;
        state.status = worse(state.status, outcome.status);
        state.found.interrupted = outcome.status.interrupt();
        if state.found.interrupted.is_none() {
            let (system, outcome) = E::parts(answer);
            state.progress.accept(system, outcome, target, time, &current.leg);
            let memory = &mut state.found.memory;
            self.engine.remember(answer, memory, time, current.leg.falls());
            self.hold(memory, current.bytes(), run)?;
        }
        let figures = E::figures(answer);
        current.increments.push(IncrementRecord::of(figures, E::parts(answer).1));
        state.rising.extend(&current.increments);
        state.widest = state.widest.max(figures.half_width);
        state.found.has_collapsed = E::has_collapsed(answer);
        Ok(())
    }

    /// Measures the end of a load and hands over its step. The observer may stop the solve while
    /// the fields are computed.
    fn end_load(
        &self,
        answer: &mut E::Answer,
        (target, last_increment): (ContactLoad, LastIncrement),
        current: &mut CurrentLoad,
        state: &mut HistoryState<E::Record, E::System>,
        steps: &mut HistorySteps<'_, E::Field>,
        run: &mut Run<'_>,
    ) {
        let found = &mut state.found;
        let measure = || self.engine.measure(answer, &found.memory);
        found.figures.push((!steps.are_final()).then(measure));
        let shown = state.rising.strays(&current.leg);
        let outcome = E::outcome_mut(answer);
        (outcome.history, outcome.status) = (std::mem::take(&mut current.history), state.status);
        let increments = std::mem::take(&mut current.increments);
        let reached = [state.progress.reached[1], state.widest];
        let mut step = if steps.are_final() {
            self.engine.step(answer, target, &mut found.memory, &state.progress, run)
        } else {
            self.engine.step_as_iterated(answer, target)
        };
        found.interrupted = step.status.interrupt();
        step.load = current.load;
        step.path = Path { increments, last_increment, reached, shown, ..step.path };
        steps.take(current.number, step, run.observer);
    }

    /// Returns the number of increment `k` of a load of the stretch.
    const fn number(&self, load: usize, k: usize, count: usize) -> IncrementNumber {
        let Stretch { before, all, .. } = self.stretch;
        IncrementNumber { number: k + 1, count, load: before + load + 1, loads: all }
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
            times: self.times,
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
        if number.is_on_way() {
            controls.tolerance = within_load(controls.tolerance);
        }
        let start = self.engine.prepare(&mut system, next, run).map_err(Leave::Failed)?;
        on.solve(system, Some(start), self.engine.coupling(), controls, run)
    }
}

/// Least scale of the changes of a figure, over its largest value in the history.
const LEAST_FIGURE: f64 = 0.05;

/// Returns the relative differences of the figures at the end of each load.
fn differences(before: &[Option<Figures>], now: &[Option<Figures>]) -> Vec<Option<Values>> {
    let least = now.iter().flatten().fold(Values::default(), |largest, figures| {
        largest.with(&figures.values(), |most, value| most.max(value.abs()))
    });
    let least = least.map(|_, _, most| LEAST_FIGURE * most.max(f64::MIN_POSITIVE));
    let pairs = before.iter().zip(now).map(|(before, now)| {
        let (before, now) = (before.as_ref()?.values(), now.as_ref()?.values());
        let scales = now.zip(&least, |now, least| now.abs().max(least));
        Some(before.zip(&now, |before, now| (before - now).abs()).zip(&scales, |a, b| a / b))
    });
    pairs.collect()
}

/// The tolerance of increments that do not end a load.
fn within_load(tolerance: f64) -> f64 {
    (WITHIN_LOAD * tolerance).min(LARGEST_WITHIN_LOAD.max(tolerance))
}

/// Returns the worse of two statuses.
fn worse(a: SolveStatus, b: SolveStatus) -> SolveStatus {
    if a == SolveStatus::Converged { b } else { a }
}
