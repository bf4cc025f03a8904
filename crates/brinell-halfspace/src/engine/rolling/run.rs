//! Solves the passes of a load: first on half the columns, then on all of them.

use crate::raceway::RacewayGrid;
use crate::track::{PassStrain, Rolls, TrackFault, TrackGrid, Verdict};

use super::course::Course;
use super::design::TrackDesign;
use super::engine::TrackEngine;
use super::error::TrackError;
use super::errors::PassErrors;
use super::pass::Pass;
use super::problem::{Limit, RollingProblem};
use brinell_method::Interrupted as _;
use brinell_method::couplings::iteration::Controls;
use brinell_method::observer::SolveStatus;
use brinell_method::observer::{IncrementNumber, Interrupt, IterationRecord, Observer};
use brinell_method::phases::PhaseTimes;
use brinell_method::run::Run;
use brinell_method::solve::{Leave, LeaveOf, solve};

/// The passes of a load and what becomes of the track.
#[derive(Debug, Clone)]
pub struct RollingSolution {
    /// The status of the last pass.
    pub status: SolveStatus,
    /// The passes that have converged.
    pub passes: Vec<Pass>,
    /// The last pass, converged or not.
    pub last: Pass,
    /// Estimated errors of the passes; `None` where the coarse track has no such pass.
    pub errors: Vec<Option<PassErrors>>,
    /// Verdict on each body; `None` for one that cannot yield.
    pub verdicts: [Option<Verdict>; 2],
    /// Verdict by all passes on half the columns.
    pub coarse_verdicts: [Option<Verdict>; 2],
    /// Limit of shakedown of perfectly plastic bodies, and of bodies with kinematic hardening
    /// without bound on these layers.
    pub limits: [Option<Limit>; 2],
    /// Middle of the columns of the window, in the direction of travel \[mm\].
    pub x: Vec<f64>,
    /// Their width \[mm\].
    pub column: f64,
    /// Area of a cell \[mm²\]; of a line the width of a column.
    pub cell: f64,
    /// Columns of the track, layers of each body, rows of cells in a layer.
    pub grid: [usize; 3],
    /// Pressure of the last pass, on the axis of the track \[MPa\].
    pub pressure: Vec<f64>,
    /// Gap of the last pass \[mm\].
    pub gap: Vec<f64>,
    /// Records of the iterations of the last pass.
    pub history: Vec<IterationRecord>,
    /// Why the pass after the last one has no answer.
    pub fault: Option<TrackFault>,
    /// Times the track was enlarged.
    pub enlargements: usize,
    /// Wall time by phase.
    pub phases: PhaseTimes,
    /// Number of tracks built.
    pub tracks: usize,
    /// Why the run ended before the last pass.
    pub interrupted: Option<Interrupt>,
}

/// Solves the passes of a load.
///
/// # Errors
/// [`TrackError`]. A pass that does not converge is no error: it ends the passes, and the
/// solution has its status.
pub fn run(
    problem: &RollingProblem,
    observer: &mut dyn Observer,
) -> Result<RollingSolution, TrackError> {
    problem.bears()?;
    if problem.is_line() {
        run_on::<TrackGrid>(problem, observer)
    } else {
        run_on::<RacewayGrid>(problem, observer)
    }
}

fn run_on<C: Course>(
    problem: &RollingProblem,
    observer: &mut dyn Observer,
) -> Result<RollingSolution, TrackError> {
    let (mut phases, mut tracks) = (PhaseTimes::default(), 0);
    let mut run = Run { phases: &mut phases, passes: &mut tracks, observer };
    let half = (problem.columns / 2).max(2);
    let design = TrackDesign::new(problem, half);
    let auxiliary = TrackEngine::<C>::auxiliary(problem);
    let passes = problem.load.passes as usize;
    let coarse = run.preliminarily(|run| sequence(&auxiliary, design, (passes, false), run))?;
    interrupted(&coarse)?;
    let long = TrackDesign { length: 2.0 * design.length, ..design };
    let long = run.preliminarily(|run| sequence(&auxiliary, long, (1, false), run))?;
    interrupted(&long)?;
    let engine = TrackEngine::<C>::new(problem);
    let fine = TrackDesign::new(problem, problem.columns);
    let fine = sequence(&engine, fine, (passes, problem.load.ends_at_verdict), &mut run)?;
    let lengths = coarse.passes.first().zip(long.passes.first());
    let errors = fine.passes.iter().enumerate().map(|(k, pass)| {
        let beside = coarse.passes.get(k)?;
        let lengths = lengths.filter(|_| k == 0).map(|(one, two)| [one, two]);
        let columns = (fine.column, problem.columns);
        Some(PassErrors::of([pass, &fine.passes[0], beside], lengths, columns))
    });
    let errors = errors.collect();
    let last = fine.last.ok_or(TrackError::NoTrack)?;
    Ok(RollingSolution {
        status: last.status,
        errors,
        verdicts: verdicts(problem, &fine.passes),
        coarse_verdicts: verdicts(problem, &coarse.passes),
        limits: [problem.perfect_limit(), fine.kinematic],
        passes: fine.passes,
        x: fine.x,
        column: fine.column,
        cell: fine.cell,
        grid: fine.grid,
        pressure: fine.pressure,
        gap: fine.gap,
        history: fine.history,
        fault: fine.fault,
        enlargements: fine.enlargements,
        interrupted: last.status.interrupt(),
        last,
        phases,
        tracks,
    })
}

/// Returns an error if the observer stopped auxiliary passes, which have nothing to report.
fn interrupted(passes: &Sequence) -> Result<(), TrackError> {
    let status = passes.last.as_ref().map(|last| last.status);
    status.and_then(SolveStatus::interrupt).map_or(Ok(()), |interrupt| {
        Err(TrackError::Method(brinell_method::Error::Interrupted(interrupt)))
    })
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
    history: Vec<IterationRecord>,
    fault: Option<TrackFault>,
    enlargements: usize,
}

impl Sequence {
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
fn sequence<C: Course>(
    engine: &TrackEngine<'_, C>,
    design: TrackDesign,
    (passes, ends_at_verdict): (usize, bool),
    run: &mut Run<'_>,
) -> Result<Sequence, TrackError> {
    let (problem, load) = (engine.problem, engine.problem.load);
    solve(engine, design, None, run, |on, mut track, mut start, run| {
        let grid = &track.grid;
        let layers = track.bodies.borrow().iter().map(Rolls::n_layers).max();
        let mut done = Sequence {
            kinematic: grid
                .kinematic(problem, &track.bodies.borrow(), run)
                .map_err(LeaveOf::<TrackEngine<'_, C>>::Failed)?,
            x: grid.x(),
            column: grid.column(),
            cell: grid.area(),
            grid: [grid.n_columns(), layers.unwrap_or(0), grid.n_rows()],
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
            done.fault = answer.fault;
            let contact = &answer.outcome.state.response.contact;
            done.pressure = answer.track.grid.along(&answer.track.pressure(&contact.force));
            done.gap = answer.track.grid.along(&contact.gap);
            let (pass, next, history) = answer.pass(engine);
            done.history = history;
            let is_converged = pass.status == SolveStatus::Converged;
            if is_converged {
                done.passes.push(pass.clone());
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

/// Returns the verdict on each body after these passes. Passes there and back are judged by pairs.
fn verdicts(problem: &RollingProblem, passes: &[Pass]) -> [Option<Verdict>; 2] {
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
        Some(Verdict::that_counts(&strains, RollingProblem::yield_strain(material)))
    })
}

fn is_decided(problem: &RollingProblem, passes: &[Pass]) -> bool {
    let verdicts = verdicts(problem, passes);
    !verdicts.iter().flatten().any(|verdict| matches!(verdict, Verdict::Undecided { .. }))
}
