//! The force under which a figure of the contact has a value: the onset of yield, or a target.
//!
//! ```text
//! guess:    the force whose mean pressure is about what the figure suggests
//! coarse:   whole solves on meshes of a third of the density, until a force meets the value nearly
//! fine:     whole solves as the job asks for them, from there on with the slope that the coarse ones have shown
//! ```
//!
//! Figures of contacts follow powers of the force over long ranges, so that both are looked at in logarithms.

use super::load_sequence::LoadSequence;
use super::load_stepper::auxiliary;
use super::utilization::{highest_at_ends, highest_utilization};
use crate::contact::{ActiveSetSolver, ContactLoad};
use crate::job::{Job, MeshSettings, SolverSettings, TargetFigure};
use crate::solver::error::{Unreachable, UnreachableReason};
use crate::solver::loads::Sought;
use crate::solver::mesh_sizing::contact_size::ContactSizeEstimate;
use crate::solver::method::bracket::{Bracket, Next};
use crate::solver::method::run::Run;
use crate::solver::problem::{Problem, ProblemBody};
use crate::solver::reference::ElasticReference;
use crate::solver::solution::{BodySolution, StepSolution};
use crate::solver::{SolveError, SolveStatus};

/// Error at least of the force under which yield begins, over h/a; where it begins at an end of the contact, 0.51 on 10 elements and 0.4
/// on 20 and 40.
const ONSET_FLOOR: f64 = 0.2;
const ONSET_FLOOR_AT_ENDS: f64 = 0.6;
/// Error of the utilization at the ends of the contact over its change to half the density.
const ENDS_MARGIN: f64 = 1.5;
const MOST_HIDDEN: f64 = 0.15;
/// How much coarser than asked the meshes are on which the force is looked for, the same where the figure follows the width of
/// the contact, which a mesh knows to half an element, and the fewest elements.
const COARSER: u32 = 3;
const COARSER_FOR_WIDTH: u32 = 2;
const FEWEST_ELEMENTS: u32 = 6;
/// Deviation of the figure that is near enough on a coarse mesh, which is itself off by as much.
const NEAR: f64 = 0.01;
/// Deviation that ends the search. At 20 elements figures scatter by 0.02 % (peak pressure) to 0.4 %
/// (half-width) with the mesh.
const TOLERANCE: f64 = 1e-3;
/// The same for the onset of yield, which scatters less.
const ONSET_TOLERANCE: f64 = 2e-4;
/// Deviation of the utilization from which on an onset counts as missed: at the edge of a contact circle it scatters with the radius.
const ONSET_MISSED: f64 = 3e-3;
/// Deviation from which on the value counts as missed, and the same in elements where it follows the width of the contact.
const MISSED: f64 = 0.01;
const MISSED_ELEMENTS: f64 = 0.5;
/// Most solves on coarse and on fine meshes.
const MAX_COARSE: usize = 40;
const MAX_FINE: usize = 4;
const MAX_FINE_OF_ONSET: usize = 8;
/// Slope of the logarithms below which the figure does not tell the force.
const INSENSITIVE: f64 = 0.02;
/// Deviation up to which such a figure is looked upon as having the value under any force.
const FLAT: f64 = 0.03;
/// Least change of a force, as a logarithm, over which a slope is read off two fine solves.
const SLOPE_SPAN: f64 = 0.02;
/// Change of a force that shows the slope where the first trial is near already.
const NEIGHBOUR: f64 = 1.1;
/// Largest change of the logarithm of the force on fine meshes.
const LARGEST_CORRECTION: f64 = 0.3;
/// Mean pressure over the yield stress under which plastic strain is first looked for.
const PLASTIC_START: f64 = 1.5;
/// Mean pressure over the yield stress that a first trial does not exceed.
const HIGHEST_START: f64 = 2.5;
/// Mean over peak pressure of a first trial.
const MEAN_OF_PEAK: f64 = 0.75;

/// What a search has found.
pub(super) struct ForceFound {
    /// Those of the last solve: the force itself and, for a figure that is permanent, the contact after it is taken away.
    pub steps: Vec<StepSolution>,
    /// Relative change of the figure over that of the force.
    pub sensitivity: f64,
}

/// Solves for the force.
///
/// # Errors
/// [`SolveError::NoYieldPoint`], [`SolveError::Unreachable`], and those of a solve.
pub(super) fn run(
    sought: Sought,
    sequence: &LoadSequence<'_>,
    run: &mut Run<'_>,
) -> Result<ForceFound, SolveError> {
    let problem = sequence.problem;
    if sought != Sought::Onset {
        return ForceSearch { sought, problem, sequence: *sequence }.run(run);
    }
    if weakest(problem).is_none() {
        return Err(SolveError::NoYieldPoint);
    }
    let elastic = problem.without_plasticity();
    let sequence = LoadSequence { problem: &elastic, with_memory: None, ..*sequence };
    ForceSearch { sought, problem, sequence }.run(run)
}

/// Lowest yield stress of all depths \[MPa\].
fn weakest(problem: &Problem) -> Option<f64> {
    let strength = |body: &ProblemBody| Some(body.yield_stress()? * body.strength_range().0);
    problem.bodies.iter().filter_map(strength).reduce(f64::min)
}

/// Whether the force to start from is that of a mean pressure; if not, it is that of a width or of nothing at all.
pub(crate) fn starts_from_pressure(sought: Sought, problem: &Problem) -> bool {
    let is_pressure = |figure| matches!(figure, TargetFigure::PeakPressure | TargetFigure::MeanPressure);
    let is_width = |figure| figure == TargetFigure::HalfWidth;
    match sought {
        Sought::Target(target) if is_width(target.figure) => false,
        Sought::Target(target) if is_pressure(target.figure) => true,
        _ => weakest(problem).is_some(),
    }
}

/// A force to start from, by what closed forms say of the size of the contact.
///
/// # Errors
/// [`SolveError::Conforming`] or [`SolveError::TouchesAtEnd`].
pub(crate) fn first_force(sought: Sought, problem: &Problem) -> Result<f64, SolveError> {
    let weakest = weakest(problem).unwrap_or(f64::INFINITY);
    let mean = match sought {
        Sought::Onset => weakest,
        Sought::Target(target) => match target.figure {
            TargetFigure::HalfWidth => return force_below(problem, |_, a| a < target.value.get()),
            TargetFigure::PeakPressure => MEAN_OF_PEAK * target.value.get(),
            TargetFigure::MeanPressure => target.value.get(),
            _ => PLASTIC_START * weakest,
        },
    };
    let mean = mean.min(HIGHEST_START * weakest);
    force_below(problem, |force, a| problem.mean_pressure(force, a) < mean)
}

struct ForceSearch<'a> {
    sought: Sought,
    /// The bodies with the plasticity that the job gives them.
    problem: &'a Problem,
    sequence: LoadSequence<'a>,
}

/// What a force has given.
struct Trial {
    /// The figure over its wanted value.
    ratio: f64,
    steps: Vec<StepSolution>,
}

/// A trial, or why its force is too large to be solved.
type Tried = Result<Trial, String>;

impl ForceSearch<'_> {
    fn run(&self, run: &mut Run<'_>) -> Result<ForceFound, SolveError> {
        let (force, sensitivity) = run.silently(|run| self.coarse(run))?;
        let steps = self.fine(force, sensitivity, run)?;
        Ok(ForceFound { steps, sensitivity })
    }

    /// A force that meets the value nearly, and the slope of the logarithms there.
    fn coarse(&self, run: &mut Run<'_>) -> Result<(f64, f64), SolveError> {
        let job = self.coarse_job();
        let sequence = LoadSequence { job: &job, contact: &ActiveSetSolver, ..self.sequence };
        let mut bracket = Bracket::new(self.expected_slope());
        let mut force = first_force(self.sought, self.problem)?;
        let mut reason = UnreachableReason::LargestForce;
        let mut near = None;
        for _ in 0..MAX_COARSE {
            match self.trial(&sequence, force, run)? {
                Ok(trial) if trial.is_converged() => {
                    bracket.record(force, trial.ratio);
                    if trial.deviation() <= NEAR {
                        near = Some(force);
                    }
                    let is_flat = || bracket.slope_at(force).is_some_and(|slope| slope < INSENSITIVE);
                    if trial.deviation() <= FLAT && is_flat() {
                        return Err(self.unreachable(force, trial.ratio, UnreachableReason::Insensitive));
                    }
                }
                Ok(trial) => {
                    if bracket.limit(force) {
                        reason = UnreachableReason::Limit(trial.why_not_converged().to_owned());
                    }
                }
                Err(why) => {
                    if bracket.limit(force) {
                        reason = UnreachableReason::Limit(why);
                    }
                }
            }
            if let Some(near) = near.or_else(|| bracket.jump()) {
                match bracket.slope_at(near) {
                    Some(slope) if slope < INSENSITIVE => {
                        return Err(self.unreachable(near, 1.0, UnreachableReason::Insensitive));
                    }
                    Some(slope) => return Ok((near, slope)),
                    None => force = near * NEIGHBOUR,
                }
                continue;
            }
            match bracket.next() {
                Next::Force(next) => force = next,
                Next::NoSmaller => {
                    return Err(self.unreachable(force, f64::NAN, UnreachableReason::SmallestForce));
                }
                Next::AtLimit => break,
            }
        }
        let (nearest, ratio) = bracket.largest().unwrap_or((force, 0.0));
        let largest_force = bracket.largest_force().unwrap_or(nearest);
        Err(self.unreachable_up_to(largest_force, nearest, ratio, reason))
    }

    /// From a force that is nearly right to the answer.
    fn fine(
        &self,
        mut force: f64,
        sensitivity: f64,
        run: &mut Run<'_>,
    ) -> Result<Vec<StepSolution>, SolveError> {
        let (tolerance, most) = match self.sought {
            Sought::Onset => (ONSET_TOLERANCE, MAX_FINE_OF_ONSET),
            Sought::Target(_) => (TOLERANCE, MAX_FINE),
        };
        let mut slope = sensitivity;
        let mut best: Option<Trial> = None;
        let mut last: Option<[f64; 2]> = None;
        for _ in 0..most {
            let trial = match self.trial(&self.sequence, force, run)? {
                Ok(trial) => trial,
                Err(why) => {
                    let ratio = best.map_or(0.0, |best| best.ratio);
                    return Err(self.unreachable(force, ratio, UnreachableReason::Limit(why)));
                }
            };
            if !trial.is_converged() {
                return Ok(trial.steps);
            }
            let at = [force.ln(), trial.ratio.max(f64::MIN_POSITIVE).ln()];
            if best.as_ref().is_none_or(|best| trial.deviation() < best.deviation()) {
                best = Some(trial);
            }
            if best.as_ref().is_some_and(|best| best.deviation() <= tolerance) {
                break;
            }
            if let Some(last) = last
                && (at[0] - last[0]).abs() >= SLOPE_SPAN
            {
                let found = (at[1] - last[1]) / (at[0] - last[0]);
                slope = found.clamp(0.5 * slope, 2.0 * slope);
            }
            last = Some(at);
            force *= (-at[1] / slope).clamp(-LARGEST_CORRECTION, LARGEST_CORRECTION).exp();
        }
        let Some(mut best) = best else { return Err(SolveError::NoLoad) };
        if self.sought == Sought::Onset {
            let error = self.force_error(&best, slope, run)?;
            if let Some(step) = best.steps.last_mut() {
                step.onset_error = Some(error);
            }
        }
        // Of a figure that rises more steeply than others an equally small change of the force is a larger one.
        let steepness = (sensitivity / self.expected_slope()).max(1.0);
        if best.deviation() > (steepness * self.missed()).max(tolerance) {
            for step in &mut best.steps {
                (step.status, step.missed) = (SolveStatus::NotConverged, Some(best.ratio));
            }
        }
        Ok(best.steps)
    }

    /// Relative error of the force under which yield begins, by how much half the density changes utilization under it: where it
    /// is highest, and at the ends of the contact, where more may be hidden from the mesh.
    fn force_error(&self, found: &Trial, slope: f64, run: &mut Run<'_>) -> Result<f64, SolveError> {
        let elements = self.sequence.job.mesh.elements_per_half_width;
        let half = elements.div_ceil(2).max(MeshSettings::MIN_ELEMENTS_PER_HALF_WIDTH);
        let job = self.coarser_job(half);
        let sequence = LoadSequence { job: &job, contact: &ActiveSetSolver, ..self.sequence };
        let Some(force) = found.steps.last().map(StepSolution::force) else { return Ok(0.0) };
        let trial = run.silently(|run| self.trial(&sequence, force, run))?;
        let change = match trial {
            Ok(trial) if trial.is_converged() => {
                let at_ends = |trial: &Trial| {
                    let highest = trial.steps.last().and_then(|step| highest_at_ends(step, self.problem));
                    highest.map_or(f64::MIN_POSITIVE, |highest| highest.ratio).ln()
                };
                let (ends, highest) = (at_ends(found), found.ratio.ln());
                let hidden = (ENDS_MARGIN * (ends - at_ends(&trial)).abs()).min(MOST_HIDDEN) + ends - highest;
                let floor = if ends < highest { ONSET_FLOOR } else { ONSET_FLOOR_AT_ENDS };
                let floor = floor / f64::from(elements);
                ((trial.ratio.ln() - highest).abs().max(hidden) / slope).max(floor)
            }
            _ => ONSET_FLOOR / f64::from(elements),
        };
        let change = change.max(self.beyond_closed_form(force));
        Ok(found.ratio.ln().abs() / slope + change)
    }

    /// By how much a force is larger than the one under which yield begins below the middle in closed form, in bodies whose strength
    /// varies over the depth: in a layer thinner than an element.
    fn beyond_closed_form(&self, force: f64) -> f64 {
        let is_graded = self.problem.bodies.iter().any(|body| {
            let (least, greatest) = body.strength_range();
            least < greatest
        });
        let reference = is_graded.then(|| ElasticReference::of(self.sequence.job, force)).flatten();
        let onset = reference.and_then(|reference| reference.yield_onset_force);
        onset.map_or(0.0, |onset| force / onset - 1.0)
    }

    /// Solves under one force.
    fn trial(&self, sequence: &LoadSequence<'_>, force: f64, run: &mut Run<'_>) -> Result<Tried, SolveError> {
        let mut loads = vec![ContactLoad::Force(force)];
        if matches!(self.sought, Sought::Target(target) if target.figure.is_permanent()) {
            loads.push(ContactLoad::Force(0.0));
        }
        let mut steps = Vec::new();
        let interrupt = match sequence.solve(&loads, run, &mut steps) {
            Ok(interrupt) => interrupt,
            Err(SolveError::TooWide { .. } | SolveError::TooFarRound { .. }) => {
                return Ok(Err(
                    "the contact would spread over more of the surfaces than is solved".to_owned()
                ));
            }
            Err(SolveError::Mesh(error)) => return Ok(Err(error.to_string())),
            Err(error) => return Err(error),
        };
        if let Some(interrupt) = interrupt.or_else(|| steps.iter().find_map(|step| step.status.interrupt())) {
            return Err(SolveError::Interrupted(interrupt));
        }
        if steps.iter().any(|step| step.has_collapsed) {
            return Ok(Err("a body collapses: its plastic strain is above 100 %".to_owned()));
        }
        let ratio = steps.last().map_or(0.0, |step| self.ratio(step));
        Ok(Ok(Trial { ratio, steps }))
    }

    /// The figure over its wanted value.
    fn ratio(&self, step: &StepSolution) -> f64 {
        match self.sought {
            Sought::Onset => highest_utilization(step, self.problem).map_or(0.0, |highest| highest.ratio),
            Sought::Target(target) => target_figure(step, target.figure) / target.value.get(),
        }
    }

    /// Whether the figure follows the width of the contact.
    fn is_of_width(&self) -> bool {
        let of_width = [TargetFigure::HalfWidth, TargetFigure::MeanPressure];
        matches!(self.sought, Sought::Target(target) if of_width.contains(&target.figure))
    }

    /// Deviation from which on the value counts as missed.
    fn missed(&self) -> f64 {
        let elements = f64::from(self.sequence.job.mesh.elements_per_half_width);
        match self.sought {
            Sought::Onset => ONSET_MISSED,
            Sought::Target(_) if self.is_of_width() => MISSED.max(2.0 * MISSED_ELEMENTS / elements),
            Sought::Target(_) => MISSED,
        }
    }

    /// What is expected of `d ln figure / d ln force`.
    fn expected_slope(&self) -> f64 {
        match self.sought {
            Sought::Onset => 0.5,
            Sought::Target(target) => match target.figure {
                TargetFigure::PeakPressure | TargetFigure::MeanPressure => 0.4,
                TargetFigure::HalfWidth => 0.5,
                TargetFigure::PermanentApproach
                | TargetFigure::DentDepth
                | TargetFigure::MaxPlasticStrain => 2.0,
            },
        }
    }

    /// The job on the meshes on which the force is looked for.
    fn coarse_job(&self) -> Job {
        let job = self.sequence.job;
        let coarser = if self.is_of_width() { COARSER_FOR_WIDTH } else { COARSER };
        self.coarser_job((job.mesh.elements_per_half_width / coarser).max(FEWEST_ELEMENTS))
    }

    /// The job with other elements.
    fn coarser_job(&self, elements: u32) -> Job {
        let job = self.sequence.job;
        let SolverSettings { theory, increments, .. } = job.solver;
        Job {
            mesh: MeshSettings { elements_per_half_width: elements },
            solver: SolverSettings { theory, increments, ..auxiliary() },
            ..job.clone()
        }
    }

    /// The error of a value that no force gives; `ratio` is what the nearest force that was solved gives of it.
    fn unreachable(&self, force: f64, ratio: f64, reason: UnreachableReason) -> SolveError {
        self.unreachable_up_to(force, force, ratio, reason)
    }

    /// The same where larger forces were solved than the nearest one.
    fn unreachable_up_to(
        &self,
        largest_force: f64,
        force: f64,
        ratio: f64,
        reason: UnreachableReason,
    ) -> SolveError {
        let (target, nearest) = match self.sought {
            Sought::Onset => (None, ratio),
            Sought::Target(target) => (Some(target), ratio * target.value.get()),
        };
        SolveError::Unreachable(Unreachable { target, nearest, force, largest_force, reason })
    }
}

impl Trial {
    fn is_converged(&self) -> bool {
        self.steps.iter().all(|step| step.status == SolveStatus::Converged)
    }

    fn why_not_converged(&self) -> &'static str {
        if self.steps.iter().any(|step| step.reaches_edge) {
            "the contact is wider than what can be meshed"
        } else {
            "the iteration does not converge"
        }
    }

    fn deviation(&self) -> f64 {
        (self.ratio - 1.0).abs()
    }
}

/// A figure of the contact at the end of the loads by which it is found \[mm, MPa or 1\].
pub(crate) fn target_figure(step: &StepSolution, figure: TargetFigure) -> f64 {
    let largest =
        |of: fn(&BodySolution) -> f64| step.bodies.iter().flatten().map(|body| of(body)).fold(0.0, f64::max);
    match figure {
        TargetFigure::PermanentApproach => step.approach,
        TargetFigure::DentDepth => largest(BodySolution::dent_depth),
        TargetFigure::PeakPressure => step.peak_pressure,
        TargetFigure::MeanPressure => step.mean_pressure(),
        TargetFigure::HalfWidth => step.half_width(),
        TargetFigure::MaxPlasticStrain => largest(BodySolution::max_plastic_strain),
    }
}

/// The largest force of which something is expected to hold that holds for small ones; `holds` takes the force and the
/// half-width that is expected under it.
fn force_below(problem: &Problem, holds: impl Fn(f64, f64) -> bool) -> Result<f64, SolveError> {
    let (mut low, mut high) = (1e-9, 1e9);
    let expected = |force: f64| ContactSizeEstimate::expected(problem, ContactLoad::Force(force));
    if let Err(error @ (SolveError::Conforming | SolveError::TouchesAtEnd { .. })) = expected(low) {
        return Err(error);
    }
    for _ in 0..80 {
        let middle = f64::sqrt(low * high);
        match expected(middle) {
            Ok(extent) if holds(middle, extent.half_width) => low = middle,
            _ => high = middle,
        }
    }
    Ok(low)
}
