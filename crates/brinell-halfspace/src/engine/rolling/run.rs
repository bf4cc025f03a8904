//! Solves the passes of a load: first on half the columns, then on all of them.

use crate::Fatigue;
use crate::engine::watch::watched;
use crate::line::LineSpace;
use crate::raceway::RacewaySpace;
use crate::track::{Operators, PassStrain, SteadyState, TrackBody, TrackLimits};

use super::design::TrackDesign;
use super::engine::TrackEngine;
use super::error::TrackError;
use super::errors::PassErrors;
use super::fatigue::{Passed, fatigue};
use super::pass::Pass;
use super::problem::{HardeningRules, Limit, RollingProblem};
use super::step::{KinematicPasses, TrackField, TrackStep};
use super::system::Track;
use brinell_method::Interrupted as _;
use brinell_method::couplings::iteration::Controls;
use brinell_method::observer::SolveStatus;
use brinell_method::observer::{IncrementNumber, Interrupt, IterationRecord, Observer};
use brinell_method::phases::{Phase, PhaseTimes};
use brinell_method::run::Run;
use brinell_method::solve::{Leave, LeaveOf, solve};
use brinell_method::steps::StepReceiver;

/// Times, counts and the end of a run, beside its step.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TrackRun {
    /// Wall time by phase.
    pub phases: PhaseTimes,
    /// Number of tracks built.
    pub tracks: usize,
    /// Why the run ended before the last pass.
    pub interrupted: Option<Interrupt>,
}

/// Solves the passes of a load and hands over its step.
///
/// # Errors
/// [`TrackError`]. A pass that does not converge is no error: it ends the passes, and the step has
/// its status.
pub fn run(
    problem: &RollingProblem,
    observer: &mut dyn Observer,
    receiver: &mut dyn StepReceiver<TrackField>,
) -> Result<TrackRun, TrackError> {
    problem.bears()?;
    let asked = problem.load.hardening;
    let other = problem.hardening_kinematically().filter(|_| asked != HardeningRules::Isotropic);
    let (problem, other) = match &other {
        Some(kinematic) if asked == HardeningRules::Kinematic => (kinematic, None),
        other => (problem, other.as_ref()),
    };
    let mut done = TrackRun::default();
    let mut run = Run { phases: &mut done.phases, passes: &mut done.tracks, observer };
    let step = if problem.is_line() {
        step_on::<LineSpace, 4, 3>(problem, other, Some(kinematic_limit), &mut run)?
    } else {
        step_on::<RacewaySpace, 6, 5>(problem, other, None, &mut run)?
    };
    let interrupted = step.status.interrupt();
    receiver.step(step, run.observer);
    Ok(TrackRun { interrupted, ..done })
}

fn step_on<O: Operators<D, R>, const D: usize, const R: usize>(
    problem: &RollingProblem,
    other: Option<&RollingProblem>,
    limit: Option<LimitOf<O, D, R>>,
    run: &mut Run<'_>,
) -> Result<TrackStep, TrackError> {
    let design = TrackDesign::new(problem, problem.columns);
    let passes = problem.load.passes as usize;
    let engine = TrackEngine::<O, D, R>::new(problem);
    let ends_at_verdict = problem.load.ends_at_verdict;
    let fine = sequence(&engine, design, (passes, ends_at_verdict), limit, run)?;
    let coarse = beside::<O, D, R>(problem, &fine, 1.0, run)?;
    let long = beside::<O, D, R>(problem, &fine, 2.0, run)?;
    let other = other.filter(|_| !long.is_stopped() && may_differ(problem, &fine.passes));
    let kinematic = match other {
        Some(other) => Some(kinematic::<O, D, R>(other, &fine, run)?),
        None => None,
    };
    let pairs = coarse.passes.iter().zip(&long.passes).map(|(coarse, long)| [coarse, long]);
    let errors = errors(problem, &fine, pairs);
    let verdicts_of_fine = verdicts(problem, &fine.passes);
    let sequences = [&fine, &coarse, &long];
    let (fatigue, stopped) = fatigue_after(problem, &verdicts_of_fine, sequences, run);
    let mut last = fine.last.ok_or(TrackError::NoTrack)?;
    let after = [&coarse.last, &long.last, &kinematic.as_ref().map(|of| of.last.clone())];
    let interrupt = after.iter().find_map(|last| last.as_ref()?.status.interrupt());
    if let Some(interrupt) = interrupt.or(stopped) {
        last.status = interrupt.into();
    }
    let field = TrackField {
        errors,
        verdicts: verdicts_of_fine,
        fatigue,
        coarse_verdicts: verdicts(problem, &coarse.passes),
        kinematic,
        limits: [problem.perfect_limit(), fine.kinematic],
        passes: fine.passes,
        last,
        x: fine.x,
        column: fine.column,
        cell: fine.cell,
        grid: fine.grid,
        pressure: fine.pressure,
        gap: fine.gap,
    };
    Ok(field.step(problem.load.force, fine.history, fine.enlargements))
}

/// Whether another rule of hardening may have a worse word: not where nothing yields, and not where
/// these passes tell nothing and are too few for a worse one.
fn may_differ(problem: &RollingProblem, passes: &[Pass]) -> bool {
    let yields = passes.first().is_some_and(|first| first.plastic_work() > 0.0);
    let each = if problem.load.alternating { 2 } else { 1 };
    let many = problem.load.passes as usize >= each * SteadyState::LEAST;
    yields && (many || is_decided(problem, passes))
}

/// The passes of a sequence once more, on half the columns of a track so many times as long.
fn beside<O: Operators<D, R>, const D: usize, const R: usize>(
    problem: &RollingProblem,
    fine: &Sequence,
    times: f64,
    run: &mut Run<'_>,
) -> Result<Sequence, TrackError> {
    if fine.passes.is_empty() || fine.is_stopped() {
        return Ok(Sequence::default());
    }
    let half = TrackDesign::new(problem, (problem.columns / 2).max(2));
    let design =
        TrackDesign { length: times * fine.length, enlargements: fine.enlargements, ..half };
    let engine = TrackEngine::<O, D, R>::auxiliary(problem);
    let found =
        run.preliminarily(|run| sequence(&engine, design, (fine.passes.len(), false), None, run));
    found.or_else(|error| stopped_beside(fine, error))
}

/// A sequence that was stopped in its first pass, beside one that has an answer.
fn stopped_beside(fine: &Sequence, error: TrackError) -> Result<Sequence, TrackError> {
    let last = fine.last.clone().zip(error.interrupt());
    let (last, interrupt) = last.ok_or(error)?;
    let last = Pass { status: interrupt.into(), ..last };
    Ok(Sequence { last: Some(last), ..Sequence::default() })
}

/// Passes over bodies that harden kinematically.
fn kinematic<O: Operators<D, R>, const D: usize, const R: usize>(
    problem: &RollingProblem,
    given: &Sequence,
    run: &mut Run<'_>,
) -> Result<KinematicPasses, TrackError> {
    let design = TrackDesign::new(problem, problem.columns);
    let passes = (problem.load.passes as usize, problem.load.ends_at_verdict);
    let engine = TrackEngine::<O, D, R>::new(problem);
    let fine = run.preliminarily(|run| sequence(&engine, design, passes, None, run));
    let fine = fine.or_else(|error| stopped_beside(given, error))?;
    let coarse = beside::<O, D, R>(problem, &fine, 1.0, run)?;
    let errors = errors(problem, &fine, coarse.passes.iter().map(|pass| [pass; 2]));
    let verdicts = verdicts(problem, &fine.passes);
    let sequences = [&fine, &coarse, &coarse];
    let (fatigue, stopped) = fatigue_after(problem, &verdicts, sequences, run);
    let mut last = fine.last.ok_or(TrackError::NoTrack)?;
    let stopped_beside = coarse.last.and_then(|last| last.status.interrupt());
    if let Some(interrupt) = stopped_beside.or(stopped) {
        last.status = interrupt.into();
    }
    Ok(KinematicPasses {
        errors: errors.into_iter().next_back().flatten(),
        verdicts,
        fatigue,
        last,
        passes: fine.passes,
    })
}

/// Errors of passes beside the same on half the columns of a track and of a longer one.
fn errors<'a>(
    problem: &RollingProblem,
    fine: &Sequence,
    mut beside: impl Iterator<Item = [&'a Pass; 2]>,
) -> Vec<Option<PassErrors>> {
    let columns = (fine.column, problem.columns);
    let passes = fine.passes.iter();
    passes
        .map(|pass| Some(PassErrors::of([pass, &fine.passes[0]], beside.next()?, columns)))
        .collect()
}

/// The fatigue of both bodies after the last pass of the first sequence, with errors where the
/// others have as many passes; none where the observer stops it.
fn fatigue_after(
    problem: &RollingProblem,
    verdicts: &[Option<SteadyState>; 2],
    [fine, coarse, long]: [&Sequence; 3],
    run: &mut Run<'_>,
) -> ([Option<Fatigue>; 2], Option<Interrupt>) {
    let is_asked = problem.materials.iter().flatten().any(|material| material.fatigue().is_some());
    let is_asked = is_asked && !long.is_stopped();
    let Some(last) = is_asked.then(|| fine.passed()).flatten() else {
        return ([None, None], None);
    };
    let as_many = |of: &&Sequence| of.passes.len() == fine.passes.len();
    let passed = |of| Some(of).filter(as_many).and_then(Sequence::passed);
    let beside = passed(coarse).zip(passed(long)).map(|(coarse, long)| [coarse, long]);
    let found = watched(run, Phase::Output, |stop| {
        fatigue(problem, verdicts, &last, beside.as_ref(), stop)
    });
    found.map_or_else(|error| ([None, None], error.interrupt()), |found| (found, None))
}

/// Passes on one track.
#[derive(Default)]
struct Sequence {
    passes: Vec<Pass>,
    last: Option<Pass>,
    kinematic: Option<Limit>,
    x: Vec<f64>,
    column: f64,
    cell: f64,
    grid: [usize; 3],
    pressure: Vec<f64>,
    gap: Vec<f64>,
    /// Design of the track and pressure in its cells, of the last pass that has converged.
    under: Option<(TrackDesign, Vec<f64>)>,
    history: Vec<IterationRecord>,
    /// Length of the track over the semi-axis along the travel.
    length: f64,
    enlargements: usize,
}

impl Sequence {
    /// The last pass that has converged.
    fn passed(&self) -> Option<Passed<'_>> {
        let (design, pressure) = self.under.as_ref()?;
        let (grid, layers) = design.lay().ok()?;
        Some(Passed { pass: self.passes.last()?, grid, layers, pressure })
    }

    fn is_stopped(&self) -> bool {
        self.last.as_ref().is_some_and(|last| last.status.is_stopped())
    }

    /// Keeps the passes that are finished if the observer stopped the next one.
    fn stopped_by<D>(mut self, leave: Leave<D, TrackError>) -> Result<Self, Leave<D, TrackError>> {
        if let (Leave::Failed(error), Some(last)) = (&leave, &mut self.last)
            && let Some(interrupt) = error.interrupt()
        {
            last.status = interrupt.into();
            return Ok(self);
        }
        Err(leave)
    }
}

/// Solves at most so many passes, one after the other.
fn sequence<O: Operators<D, R>, const D: usize, const R: usize>(
    engine: &TrackEngine<'_, O, D, R>,
    design: TrackDesign,
    (passes, ends_at_verdict): (usize, bool),
    limit: Option<LimitOf<O, D, R>>,
    run: &mut Run<'_>,
) -> Result<Sequence, TrackError> {
    let (problem, load) = (engine.problem, engine.problem.load);
    solve(engine, design, None, run, |on, mut track, mut start, run| {
        let grid = &track.grid;
        let layers = |body: &TrackBody<O, D, R>| body.space().ground().layers.len();
        let layers = track.bodies.borrow().iter().map(layers).max();
        let kinematic = limit.map(|limit| limit(&track, problem, run)).transpose();
        let mut done = Sequence {
            kinematic: kinematic.map_err(LeaveOf::<TrackEngine<'_, O, D, R>>::Failed)?.flatten(),
            x: grid.places(),
            column: grid.column(),
            cell: grid.cell_area(),
            grid: [grid.n_columns(), layers.unwrap_or(0), grid.n_rows()],
            length: track.design.length,
            enlargements: track.design.enlargements,
            ..Sequence::default()
        };
        for number in 1..=passes {
            if load.alternating && number > 1 {
                track.turn();
            }
            let increment = IncrementNumber { number: 1, count: 1, load: number, loads: passes };
            let controls = Controls { increment: Some(increment), ..engine.controls() };
            let answer = match on.solve(track, start, engine.coupling, controls, run) {
                Ok(answer) => answer,
                Err(leave) => return done.stopped_by(leave),
            };
            let contact = &answer.outcome.state.response.contact;
            let pressure = answer.track.pressure(&contact.force);
            done.pressure = answer.track.grid.along(&pressure);
            done.gap = answer.track.grid.along(&contact.gap);
            let (pass, next, history) = answer.pass(engine, &done.passes);
            done.history = history;
            let is_converged = pass.status == SolveStatus::Converged;
            if is_converged {
                done.passes.push(pass.clone());
                done.under = Some((next.design, pressure));
            }
            done.last = Some(pass);
            start = Some(next.accepted.clone());
            track = next;
            if !is_converged || ends_at_verdict && is_decided(problem, &done.passes) {
                break;
            }
        }
        Ok(done)
    })
}

/// The limit of shakedown of bodies that harden kinematically without bound, on their track.
type LimitOf<O, const D: usize, const R: usize> =
    fn(&Track<O, D, R>, &RollingProblem, &mut Run<'_>) -> Result<Option<Limit>, TrackError>;

/// The limit of bodies on a line. Across the travel of an ellipse a residual stress may touch every
/// component: there is no such form.
fn kinematic_limit(
    track: &Track<LineSpace, 4, 3>,
    problem: &RollingProblem,
    run: &mut Run<'_>,
) -> Result<Option<Limit>, TrackError> {
    let [a, _] = problem.semi_axes();
    let pressure = track.grid.sample(|x, _| (1.0 - (x / a).powi(2)).max(0.0).sqrt());
    let bodies = track.bodies.borrow();
    let limited = problem.yielding().zip(&*bodies);
    let mut least: Option<Limit> = None;
    for ((side, _), body) in limited.filter(|((_, of), _)| of.yield_stress().is_some()) {
        let limits = watched(run, Phase::Flexibility, |stop| {
            let strength = |layer: usize| body.law().yield_stress(layer);
            TrackLimits::new(body.space(), &pressure, body.friction(), strength, stop)
        })?;
        let kinematic = limits.kinematic;
        let of_body = Limit { peak_pressure: kinematic.value, depth: kinematic.depth, side };
        if least.is_none_or(|least| of_body.peak_pressure < least.peak_pressure) {
            least = Some(of_body);
        }
    }
    Ok(least.filter(|limit| limit.peak_pressure.is_finite()))
}

/// Returns the verdict on each body after these passes. Passes there and back are judged by pairs.
fn verdicts(problem: &RollingProblem, passes: &[Pass]) -> [Option<SteadyState>; 2] {
    std::array::from_fn(|side| {
        let material = problem.materials[side].as_ref()?;
        material.hardening_law()?;
        let of = |pass: &Pass| pass.bodies[side].clone();
        let strains: Vec<PassStrain> = if problem.load.alternating {
            let pairs = passes.chunks_exact(2);
            let pair = |pair: &[Pass]| {
                let [there, back] = [of(&pair[0])?, of(&pair[1])?];
                Some(PassStrain::of_pair(&there.outlet, &back.outlet))
            };
            pairs.filter_map(pair).collect()
        } else {
            passes.iter().filter_map(of).map(|body| body.strain).collect()
        };
        Some(SteadyState::that_counts(&strains, RollingProblem::yield_strain(material)))
    })
}

fn is_decided(problem: &RollingProblem, passes: &[Pass]) -> bool {
    let verdicts = verdicts(problem, passes);
    !verdicts.iter().flatten().any(|verdict| matches!(verdict, SteadyState::Undecided { .. }))
}
