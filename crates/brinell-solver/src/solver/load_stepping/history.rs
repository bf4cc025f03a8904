//! A history of loads on bodies with a memory.
//!
//! ```text
//! size:     deformation theory under the largest load
//! coarse:   a mesh of half the density through the whole history, with smaller and smaller increments until their error is
//!           small
//! fine:     the mesh that was asked for through the whole history, with these increments
//!   each increment   moduli after the change that the coarse mesh has found; iterate from the accepted states;
//!                    look for yield outside of the plastic region; accept, or repeat in halves
//! ```
//!
//! One mesh serves for all of a history, because states are never carried from one mesh to another.
//!
//! An increment that comes to no end, or ends with strains that are not small, is repeated in halves, and these as well, five times at
//! most. A history ends with the increment under which a body collapses all the same: what is reported of its load is that increment.

use std::sync::Arc;

use super::history_steps::{Estimates, HistorySteps, keep_preliminary};
use super::increments::{Division, IncrementEnds, Leg, exponent};
use super::load_stepper::{LoadStepper, auxiliary};
use super::path::Path;
use super::progress::Progress;
use super::steps::StepReceiver;
use crate::contact::{ContactLoad, ContactSolver};
use crate::fem::mesh::ContactZone;
use crate::job::Job;
use crate::material::ReferenceModuli;
use crate::solver::body_system::plastic_search_region::PlasticSearchRegion;
use crate::solver::body_system::system::System;
use crate::solver::body_system::transfer::NodalField;
use crate::solver::final_check::LeastScales;
use crate::solver::finite_elements::{FiniteElements, MeshDesign};
use crate::solver::loads::largest_loads;
use crate::solver::mesh_sizing::contact_size::ContactSizeEstimate;
use crate::solver::mesh_solve::{MeshSolve, MeshSolveRequest};
use crate::solver::method::contact_system::{ContactSystem as _, Linearize as _};
use crate::solver::method::couplings::iteration::{Controls, Outcome};
use crate::solver::method::observer::Held;
use crate::solver::method::run::Run;
use crate::solver::method::solve::{Leave, OnSystem, solve};
use crate::solver::problem::Problem;
use crate::solver::reference::ElasticReference;
use crate::solver::solution::{CoarseFigures, IncrementRecord, LastIncrement, StepSolution};
use crate::solver::strategy::coupling;
use crate::solver::{IncrementNumber, Interrupt, SolveError, SolveStatus, final_check};

/// Relative differences of the figures of two divisions that end the search for increments. The peak pressure scatters with
/// the discrete edge of the contact; the approach that is left without force is a small part of the approach that was.
const PEAK_TOLERANCE: f64 = 4e-3;
const APPROACH_TOLERANCE: f64 = 1.5e-3;
/// Part of the difference before that a difference may be while it still falls like an error of first order, with room for
/// scatter. Above it what is left is the discrete edge of the contact, which no increment makes smaller.
const FALLING: f64 = 0.7;
/// Finest level of division that is tried.
const MAX_LEVEL: u32 = 5;
/// An increment on the way to a load is iterated to so many times the tolerance, but to no more than the second figure: what is
/// left of its residual the next increment takes up, and in the strain path it is far below the error of the increments.
const WITHIN_LOAD: f64 = 100.0;
const LARGEST_WITHIN_LOAD: f64 = 1e-4;
/// How far beyond its last extent plastic flow is looked for.
const PLASTIC_MARGIN: f64 = 1.15;

/// What a history is solved with.
#[derive(Clone, Copy)]
pub(super) struct HistoryRequest<'a> {
    /// Bodies with the models of the history.
    pub problem: &'a Problem,
    /// The same bodies under deformation theory, and how their meshes are sized.
    pub sizing: &'a LoadStepper<'a>,
    pub job: &'a Job,
    pub contact: &'a dyn ContactSolver,
    /// The loads in order, at least one of them above zero.
    pub loads: &'a [ContactLoad],
    /// Increments of each load where the program does not choose them.
    pub increments: Option<u32>,
}

/// Solves the history; each load becomes a step.
///
/// Where the observer stops it, loads that are finished keep their steps, the one that is iterated has its last iteration, and of the
/// others there is what the coarse mesh has found.
pub(super) fn run(
    request: HistoryRequest<'_>,
    run: &mut Run<'_>,
    receiver: &mut dyn StepReceiver,
) -> Result<Option<Interrupt>, SolveError> {
    let candidates = largest_loads(request.loads);
    let mut widest: Option<ContactSizeEstimate> = None;
    for &load in &candidates {
        let (size, _) = request.sizing.size(load, run)?;
        if widest.is_none_or(|widest| size.half_width > widest.half_width) {
            widest = Some(size);
        }
    }
    let (Some(mut size), Some(&largest)) = (widest, candidates.first()) else {
        return Err(SolveError::NoLoad);
    };
    let elements = request.job.mesh.elements_per_half_width as usize;
    let mesh = request.sizing.request(largest, size, (elements / 2).max(2), 1.0, auxiliary());
    let mut preliminary = Vec::new();
    let chosen = run.silently(|run| choose_increments(&request, mesh, size, &mut preliminary, run));
    let (coarse, division, errors) = match chosen {
        Err(SolveError::Interrupted(interrupt)) => {
            return keep_preliminary(preliminary, 0, interrupt, receiver, run).map(Some);
        }
        chosen => chosen?,
    };
    size = coarse.size;
    let mut mesh = request.sizing.request(largest, size, elements, 1.0, request.job.solver);
    mesh.contact = request.contact;
    let guide = coupling(request.job.solver.coupling).uses_tangent_moduli().then_some(&coarse.path);
    let history = MeshHistory { request: &request, mesh, size, division, guide };
    let estimates = Estimates { coarse: &coarse.figures, increments: &errors };
    let mut steps = HistorySteps::new(estimates, &mut *receiver);
    let interrupt = match history.solve(&mut steps, run) {
        Ok(found) => found.interrupted,
        Err(SolveError::Interrupted(interrupt)) => Some(interrupt),
        Err(error) => return Err(error),
    };
    let done = steps.done();
    interrupt.map(|interrupt| keep_preliminary(preliminary, done, interrupt, receiver, run)).transpose()
}

/// What a history on one mesh has found.
struct Found {
    mesh: ContactZone,
    /// The contact at its widest.
    size: ContactSizeEstimate,
    path: Path,
    /// At the end of each load.
    figures: Vec<Option<CoarseFigures>>,
    /// Whether a body collapsed, so that the loads after `figures` were not applied.
    has_collapsed: bool,
    /// Why it ended early.
    interrupted: Option<Interrupt>,
}

/// Halves the increments on the coarse mesh until that no longer changes the figures at the ends of the loads.
///
/// Errors fall at least like the increments, so that the difference to increments twice as large is at least the error.
fn choose_increments(
    request: &HistoryRequest<'_>,
    mut mesh: MeshSolveRequest<'_>,
    size: ContactSizeEstimate,
    preliminary: &mut Vec<StepSolution>,
    run: &mut Run<'_>,
) -> Result<(Found, Division, Vec<Option<CoarseFigures>>), SolveError> {
    let mut division = request.increments.map_or(Division::Level(0), Division::Fixed);
    let mut last: Option<Found> = None;
    let mut worst_before = f64::INFINITY;
    loop {
        let guide = last.as_ref().map(|last| &last.path);
        let history = MeshHistory { request, mesh: mesh.clone(), size, division, guide };
        let now = history.solve(&mut HistorySteps::Preliminary(preliminary), run)?;
        mesh.zone = now.mesh.clone();
        // Finer increments do not help a body that does not bear the load.
        if now.has_collapsed {
            let errors = last.map_or_else(Vec::new, |before| differences(&before.figures, &now.figures).0);
            let division = request.increments.map_or(division, Division::Fixed);
            return Ok((now, division, errors));
        }
        if let Some(before) = last {
            let (errors, worst) = differences(&before.figures, &now.figures);
            match division {
                // What was asked for, beside half as large increments.
                Division::Fixed(_) => {
                    return Ok((before, Division::Fixed(request.increments.unwrap_or(1)), errors));
                }
                Division::Level(level)
                    if worst <= 1.0 || worst > FALLING * worst_before || level >= MAX_LEVEL =>
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

/// Relative differences of figures at the end of each load, and the worst of peak pressure and approach over its tolerance.
fn differences(
    before: &[Option<CoarseFigures>],
    now: &[Option<CoarseFigures>],
) -> (Vec<Option<CoarseFigures>>, f64) {
    let largest =
        |of: fn(&CoarseFigures) -> f64| now.iter().flatten().map(of).fold(f64::MIN_POSITIVE, f64::max);
    let (peak, width, approach) =
        (largest(|f| f.peak_pressure), largest(|f| f.half_width), largest(|f| f.approach));
    let mut worst: f64 = 0.0;
    let relative = |a: f64, b: f64, least: f64| (a - b).abs() / b.abs().max(0.05 * least);
    let pairs = before.iter().zip(now).map(|(before, now)| {
        let (before, now) = (before.as_ref()?, now.as_ref()?);
        let errors = CoarseFigures {
            peak_pressure: relative(before.peak_pressure, now.peak_pressure, peak),
            half_width: relative(before.half_width, now.half_width, width),
            approach: relative(before.approach, now.approach, approach),
            force: relative(before.force, now.force, largest(|f| f.force)),
        };
        worst = worst.max(errors.peak_pressure / PEAK_TOLERANCE).max(errors.approach / APPROACH_TOLERANCE);
        Some(errors)
    });
    (pairs.collect(), worst)
}

/// A history on one mesh.
struct MeshHistory<'a> {
    request: &'a HistoryRequest<'a>,
    mesh: MeshSolveRequest<'a>,
    size: ContactSizeEstimate,
    division: Division,
    /// What a coarser mesh has found.
    guide: Option<&'a Path>,
}

/// The end of a load.
struct LoadEnd {
    number: usize,
    /// What was asked for, and what was applied of it.
    load: ContactLoad,
    target: ContactLoad,
    /// Largest half-width of the history so far \[mm\].
    widest: f64,
    last_increment: LastIncrement,
    increments: Vec<IncrementRecord>,
}

impl MeshHistory<'_> {
    /// Solves all loads, on wider and wider meshes while the contact reaches the edge of the zone.
    fn solve(&self, steps: &mut HistorySteps<'_>, run: &mut Run<'_>) -> Result<Found, SolveError> {
        let problem = self.request.problem;
        let engine = FiniteElements { problem, request: &self.mesh, is_history: true };
        let mut is_begun = false;
        solve(
            &engine,
            MeshDesign::new(self.mesh.zone.clone(), self.search_region()),
            None,
            run,
            |mesh, system, _, run| {
                if std::mem::replace(&mut is_begun, true) {
                    steps.begin_anew();
                }
                self.solve_on(mesh, system, steps, run)
            },
        )
    }

    /// Solves all loads on one mesh.
    fn solve_on(
        &self,
        mesh: &OnSystem<'_, FiniteElements<'_>>,
        mut system: System,
        steps: &mut HistorySteps<'_>,
        run: &mut Run<'_>,
    ) -> Result<Found, Leave<MeshDesign>> {
        let mut found = Found {
            mesh: system.zone.clone(),
            size: self.size,
            path: Path {
                meshes: system.bodies.iter().map(|body| Arc::clone(&body.elastic.mesh)).collect(),
                points: Vec::new(),
            },
            figures: Vec::new(),
            has_collapsed: false,
            interrupted: None,
        };
        self.hold(&found.path, run)?;
        let mut progress = Progress::at_rest();
        let mut widest = 0.0;
        // Of all loads so far: what follows an increment that has not converged inherits its error.
        let mut status = SolveStatus::Converged;
        for (number, &load) in self.request.loads.iter().enumerate() {
            let leg = self.leg(load, &progress);
            progress.begin(&leg);
            let mut ends = IncrementEnds::of(&leg, self.division);
            let (mut history, mut increments) = (Vec::new(), Vec::new());
            let mut k = 0;
            while k < ends.count() {
                let (count, end) = (ends.count(), ends.measure(k));
                let time = number as f64 + if k + 1 == count { 1.0 } else { leg.part(end) };
                let (target, loads) = (leg.load(end), self.request.loads.len());
                progress.number = IncrementNumber { number: k + 1, count, load: number + 1, loads };
                let mut solve = self.increment(mesh, system, target, time, &leg, &progress, run)?;
                let interrupted = solve.outcome.status.interrupt();
                history.append(&mut solve.outcome.history.clone());
                let start = progress.reached_measure(&leg);
                let may_halve = status == SolveStatus::Converged && self.request.increments.is_none();
                if may_halve && self.fails(&solve) && ends.halve(k, start) {
                    system = solve.system;
                    continue;
                }
                // A state that another coupling has left without an answer says nothing of the bodies.
                let inherits_error = status != SolveStatus::Converged;
                solve.outcome.is_conclusive &= !inherits_error || self.is_accelerated();
                status = worse(status, solve.outcome.status);
                if interrupted.is_none() {
                    progress.accept(&mut solve, target, time, &leg);
                }
                increments.push(increment_record(&solve));
                let half_width = solve.patch.map_or(0.0, |patch| patch.half_width());
                if half_width > widest {
                    widest = half_width;
                    found.size = self.size.found_by(&solve);
                }
                found.size.plastic = solve.system.accepted.plastic;
                found.has_collapsed = final_check::has_collapsed(&solve);
                found.interrupted = interrupted;
                if let (false, Some(interrupt)) = (steps.are_final(), interrupted) {
                    return Err(SolveError::Interrupted(interrupt).into());
                }
                let is_end = k + 1 == count || interrupted.is_some() || found.has_collapsed;
                if !steps.are_final() {
                    let nodal = solve.fields.iter().map(|field| field.nodal.clone()).collect();
                    found.path.points.push((time, nodal));
                    self.hold(&found.path, run)?;
                }
                if is_end {
                    found.figures.push(Some(solve.all_figures()));
                }
                if is_end {
                    solve.outcome.history = std::mem::take(&mut history);
                    solve.outcome.status = status;
                    let increments = std::mem::take(&mut increments);
                    let last_increment = leg.increment(start, end, inherits_error);
                    let end = LoadEnd { number, load, target, widest, last_increment, increments };
                    found.interrupted = self.end_load(end, &mut solve, &mut progress, steps, run);
                    if found.interrupted.is_some() {
                        return Ok(found);
                    }
                }
                if found.has_collapsed {
                    steps.end_before(number);
                    return Ok(found);
                }
                system = solve.system;
                system.commit(solve.outcome.state.response.displacement);
                k += 1;
            }
        }
        Ok(found)
    }

    /// Tells the observer what the increments on this mesh and on the one before hold.
    fn hold(&self, path: &Path, run: &mut Run<'_>) -> Result<(), SolveError> {
        run.hold(Held::Increments, path.bytes() + self.guide.map_or(0, Path::bytes))
    }

    /// How far plastic flow is looked for at first.
    fn search_region(&self) -> PlasticSearchRegion {
        match self.mesh.search_region {
            PlasticSearchRegion::WholeBody => PlasticSearchRegion::WholeBody,
            PlasticSearchRegion::Within(_) => {
                PlasticSearchRegion::Within(self.size.plastic.scaled(PLASTIC_MARGIN))
            }
        }
    }

    /// Makes a step of the end of a load. It may be stopped while its fields are formed.
    fn end_load(
        &self,
        end: LoadEnd,
        solve: &mut MeshSolve,
        progress: &mut Progress,
        steps: &mut HistorySteps<'_>,
        run: &mut Run<'_>,
    ) -> Option<Interrupt> {
        let LoadEnd { number, load, target, widest, last_increment, increments } = end;
        let step = if steps.are_final() {
            self.step(solve, target, progress, run)
        } else {
            final_check::as_iterated(solve, target, self.mesh.solver.tolerance.get())
        };
        let interrupted = step.status.interrupt();
        let reached = [progress.reached[1], widest];
        steps.take(number, StepSolution { load, last_increment, increments, reached, ..step }, run.observer);
        interrupted
    }

    /// A load as a leg of the history, from where the bodies are.
    fn leg(&self, load: ContactLoad, progress: &Progress) -> Leg {
        let problem = self.request.problem;
        let (from, reached) = match load {
            ContactLoad::Force(_) => (progress.force, progress.reached[0]),
            ContactLoad::Approach(_) => (progress.approach, progress.reached[1]),
        };
        let onset = if problem.bodies.iter().all(|body| body.hardening().is_none()) {
            Some(f64::INFINITY)
        } else {
            match load {
                ContactLoad::Force(force) => {
                    ElasticReference::of(self.request.job, force.max(f64::MIN_POSITIVE))
                        .and_then(|reference| reference.yield_onset_force)
                }
                ContactLoad::Approach(_) => None,
            }
        };
        Leg {
            is_force: matches!(load, ContactLoad::Force(_)),
            from,
            to: load.magnitude(),
            reached,
            onset,
            exponent: exponent(problem.stress_state, load),
        }
    }

    fn is_accelerated(&self) -> bool {
        coupling(self.mesh.solver.coupling).uses_tangent_moduli()
    }

    /// Whether smaller increments may come farther: strains are not small, or Newton's method has come to no end before it has made
    /// as many iterations as the job allows. Couplings without it diverge in small increments as well.
    fn fails(&self, solve: &MeshSolve) -> bool {
        let Outcome { status, history, .. } = &solve.outcome;
        let is_lost = *status == SolveStatus::NotConverged
            && self.is_accelerated()
            && history.len() < self.mesh.solver.max_iterations as usize;
        is_lost || (!status.is_stopped() && final_check::has_collapsed(solve))
    }

    /// One increment, from the accepted states; nothing of the system but its stiffness and the extent of its plastic region
    /// is changed.
    #[expect(clippy::too_many_arguments, reason = "what an increment needs of a history")]
    fn increment(
        &self,
        mesh: &OnSystem<'_, FiniteElements<'_>>,
        mut system: System,
        target: ContactLoad,
        time: f64,
        leg: &Leg,
        progress: &Progress,
        run: &mut Run<'_>,
    ) -> Result<MeshSolve, Leave<MeshDesign>> {
        let (scales, increment) = (progress.scales, Some(progress.number));
        let mut controls = Controls { load: target, scales, increment, ..self.mesh.controls() };
        if progress.number.number < progress.number.count {
            controls.tolerance = within_load(controls.tolerance);
        }
        let coupling = coupling(self.mesh.solver.coupling);
        let mut start = system.accepted().clone();
        if coupling.uses_tangent_moduli() {
            if leg.falls() {
                system.linearize(None, run)?;
            } else if let Some(guide) = self.guide {
                let change = guide.change(progress.time, time);
                let fields = guide.meshes.iter().zip(&change);
                let fields: Vec<_> =
                    fields.map(|(mesh, displacement)| NodalField { mesh, displacement }).collect();
                start = system.linearize_after(&start, &fields, run)?;
            } else {
                start = progress.extrapolated(start, target.magnitude(), leg);
                system.linearize(Some((&start, ReferenceModuli::Tangent)), run)?;
            }
        }
        mesh.solve(system, Some(start), coupling, controls, run)
    }

    /// The end of a load, or of what the bodies bear of it, as a step of the solution.
    fn step(
        &self,
        solve: &mut MeshSolve,
        load: ContactLoad,
        progress: &mut Progress,
        run: &mut Run<'_>,
    ) -> StepSolution {
        let tolerance = self.mesh.solver.tolerance.get();
        solve.is_within_earlier_contact = progress.is_below_largest_load();
        let mut step = final_check::finish(
            self.request.problem,
            solve,
            load,
            tolerance,
            LeastScales { residual: progress.scales.force, contact: progress.contact_scales },
            run,
        );
        if step.patch.is_some() {
            if step.peak_pressure > progress.peak[0] {
                progress.peak = [step.peak_pressure, step.peak_position, step.middle];
            }
        } else {
            [_, step.peak_position, step.middle] = progress.peak;
        }
        // Plastic strain stays as it is where the load begins to fall, so that the stiffness is that of the elastic bodies.
        let elastic = solve.system.linearize(None, run);
        if elastic.is_ok() {
            step.unloading_stiffness = final_check::unloading_stiffness(solve, run);
        }
        step
    }
}

/// The tolerance of increments that do not end a load.
fn within_load(tolerance: f64) -> f64 {
    (WITHIN_LOAD * tolerance).min(LARGEST_WITHIN_LOAD.max(tolerance))
}

fn increment_record(solve: &MeshSolve) -> IncrementRecord {
    let CoarseFigures { force, approach, peak_pressure, half_width } = solve.all_figures();
    IncrementRecord {
        force,
        approach,
        peak_pressure,
        half_width,
        iterations: solve.outcome.history.len(),
        plastic_points: solve.outcome.history.last().map_or(0, |record| record.plastic_points),
        status: solve.outcome.status,
    }
}

/// The less good of two.
fn worse(a: SolveStatus, b: SolveStatus) -> SolveStatus {
    if a == SolveStatus::Converged { b } else { a }
}
