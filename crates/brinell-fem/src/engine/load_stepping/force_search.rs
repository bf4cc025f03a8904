//! The force under which a figure of a meshed contact has a value: the onset of yield, or a
//! target. The first guess is the force whose mean pressure is about what the figure suggests;
//! meshes on which the force is looked for have a third of the density.

use super::load_sequence::LoadSequence;
use super::load_stepper::auxiliary;
use super::utilization::{
    at_narrow_edge, error_at_narrow_edge, highest_at_ends, highest_utilization,
};
use crate::engine::bars::Bars;
use crate::engine::body_solution::BodySolution;
use crate::engine::error::MeshedError;
use crate::engine::mesh_sizing::contact_size::ContactSizeEstimate;
use crate::engine::meshed_contact::Asked;
use crate::engine::problem::{Problem, ProblemBody};
use crate::engine::reference::ElasticReference;
use crate::engine::solution::{SectionField, StepSolution};
use crate::mesh::MeshError;
use brinell_contact::{ActiveSetSolver, ContactLoad};
use brinell_method::Limit;
use brinell_method::force_search::{Density, ForceFound, Terms, find};
use brinell_method::loads::{Trial, Tried, Wanted};
use brinell_method::observer::SolveStatus;
use brinell_method::run::Run;
use brinell_method::settings::Settings;
use brinell_method::sought::{Sought, TargetFigure};

/// Error at least of the force under which yield begins, over h/a; where it begins at an end of
/// the contact, 0.51 on 10 elements and 0.4 on 20 and 40.
const ONSET_FLOOR: f64 = 0.2;
const ONSET_FLOOR_AT_ENDS: f64 = 0.6;
/// Error of the utilization at the ends of the contact over its change to half the density.
const ENDS_MARGIN: f64 = 1.5;
const MOST_HIDDEN: f64 = 0.15;
/// Factor by which the meshes on which the force is looked for are coarser than asked. Factor where
/// the figure follows the width of the contact, which a mesh knows to half an element. Fewest
/// elements of these meshes.
const COARSER: u32 = 3;
const COARSER_FOR_WIDTH: u32 = 2;
const FEWEST_ELEMENTS: u32 = 6;
/// Fewest elements of a mesh by which the error of the onset of yield is told.
const FEWEST_BESIDE: u32 = 4;
/// Most fine solves.
const MAX_FINE: usize = 4;
const MAX_FINE_OF_ONSET: usize = 8;
/// Deviation that ends the search. At 20 elements figures scatter by 0.02 % (peak pressure) to 0.4
/// % (half-width) with the mesh.
const TOLERANCE: f64 = 1e-3;
/// Deviation that ends the search for the onset of yield, which scatters less.
const ONSET_TOLERANCE: f64 = 2e-4;
/// Deviation of the utilization from which on an onset counts as missed: at the edge of a contact
/// circle it scatters with the radius.
const ONSET_MISSED: f64 = 3e-3;
/// Deviation from which on the value counts as missed, and the same in elements where it follows
/// the width of the contact.
const MISSED: f64 = 0.01;
const MISSED_ELEMENTS: f64 = 0.5;
/// Mean pressure over the yield stress under which plastic strain is first looked for.
const PLASTIC_START: f64 = 1.5;
/// Mean pressure over the yield stress that a first trial does not exceed.
const HIGHEST_START: f64 = 2.5;
/// Mean over peak pressure of a first trial.
const MEAN_OF_PEAK: f64 = 0.75;

/// Solves for the force. Returns the steps of the last solve, of the force itself and, for a
/// figure that is permanent, of the contact after it is taken away; and the relative change of the
/// figure over that of the force.
///
/// # Errors
/// [`MeshedError::NoYieldPoint`], [`brinell_method::Error::Unreachable`], and those of a solve.
pub(super) fn run(
    sought: Sought,
    sequence: &LoadSequence<'_>,
    run: &mut Run<'_>,
) -> Result<(Vec<StepSolution>, f64), MeshedError> {
    let problem = sequence.problem;
    if sought != Sought::Onset {
        return ForceSearch { sought, problem, sequence: *sequence }.run(run);
    }
    if weakest(problem).is_none() {
        return Err(MeshedError::NoYieldPoint);
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

/// Whether the force to start from is that of a mean pressure; if not, it is that of a width or of
/// nothing at all.
pub(crate) fn starts_from_pressure(sought: Sought, problem: &Problem) -> bool {
    let is_pressure =
        |figure| matches!(figure, TargetFigure::PeakPressure | TargetFigure::MeanPressure);
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
/// [`MeshedError::Conforming`] or [`MeshedError::TouchesAtEnd`].
pub(crate) fn first_force(sought: Sought, problem: &Problem) -> Result<f64, MeshedError> {
    let weakest = weakest(problem).unwrap_or(f64::INFINITY);
    let mean = match sought {
        Sought::Onset => weakest,
        Sought::Target(target) => match target.figure {
            TargetFigure::HalfWidth => return force_below(problem, |_, a| a < target.value),
            TargetFigure::PeakPressure => MEAN_OF_PEAK * target.value,
            TargetFigure::MeanPressure => target.value,
            _ => PLASTIC_START * weakest,
        },
    };
    let mean = mean.min(HIGHEST_START * weakest);
    force_below(problem, |force, a| problem.mean_pressure(force, a) < mean)
}

struct ForceSearch<'a> {
    sought: Sought,
    /// The bodies with the plasticity that they are given.
    problem: &'a Problem,
    sequence: LoadSequence<'a>,
}

impl ForceSearch<'_> {
    fn run(&self, run: &mut Run<'_>) -> Result<(Vec<StepSolution>, f64), MeshedError> {
        let before = *run.passes;
        let asked = self.coarse();
        let coarse = LoadSequence { asked, contact: &ActiveSetSolver, ..self.sequence };
        let trial = |density, force, run: &mut Run<'_>| {
            let is_asked = density == Density::Asked;
            self.trial_by(if is_asked { &self.sequence } else { &coarse }, force, run)
        };
        let ForceFound { mut trial, sensitivity, slope } = find(trial, self.terms()?, run)?;
        if self.sought == Sought::Onset
            && trial
                .steps
                .iter()
                .all(|step| step.status == SolveStatus::Converged || step.search.missed.is_some())
        {
            let error = self.force_error(&trial, slope, run)?;
            if let Some(step) = trial.steps.last_mut() {
                step.search.force_error = Some(error);
            }
        }
        if let Sought::Target(target) = self.sought {
            let bars = trial.steps.last().and_then(Bars::of);
            let error = bars.and_then(|bars| bars.of_target(target.figure));
            for step in &mut trial.steps {
                step.search.force_error = error.map(|error| error / sensitivity);
            }
        }
        if let Some(step) = trial.steps.first_mut() {
            step.search.systems = *run.passes - before;
        }
        Ok((trial.steps, sensitivity))
    }

    fn terms(&self) -> Result<Terms, MeshedError> {
        let (tolerance, most_fine) = match self.sought {
            Sought::Onset => (ONSET_TOLERANCE, MAX_FINE_OF_ONSET),
            Sought::Target(_) => (TOLERANCE, MAX_FINE),
        };
        let first_force = first_force(self.sought, self.problem)?;
        let (expected_slope, missed) = (self.expected_slope(), self.missed());
        Ok(Terms { first_force, expected_slope, tolerance, most_fine, missed })
    }

    /// Relative error of the force under which yield begins, by how much half the density changes
    /// utilization under it: where it is highest, and at the ends of the contact, where more may
    /// be hidden from the mesh.
    fn force_error(
        &self,
        found: &Trial<SectionField>,
        slope: f64,
        run: &mut Run<'_>,
    ) -> Result<f64, MeshedError> {
        let last = found.steps.last();
        let at_edge = last.and_then(|step| at_narrow_edge(step, self.problem));
        if at_edge.is_some_and(|edge| edge.ratio >= found.ratio) {
            let error = last.and_then(error_at_narrow_edge).unwrap_or_default();
            return Ok(found.ratio.ln().abs() / slope + error);
        }
        let elements = self.sequence.asked.elements;
        let half = elements.div_ceil(2).max(FEWEST_BESIDE);
        let asked = self.coarser(half);
        let sequence = LoadSequence { asked, contact: &ActiveSetSolver, ..self.sequence };
        let Some(force) = found.steps.last().map(|step| step.figures.force) else {
            return Ok(0.0);
        };
        let trial = run.preliminarily(|run| self.trial_by(&sequence, force, run))?;
        let change = match trial {
            Ok(trial) if trial.is_converged() => {
                let at_ends = |trial: &Trial<SectionField>| {
                    let highest =
                        trial.steps.last().and_then(|step| highest_at_ends(step, self.problem));
                    highest.map_or(f64::MIN_POSITIVE, |highest| highest.ratio).ln()
                };
                let (ends, highest) = (at_ends(found), found.ratio.ln());
                let hidden = (ENDS_MARGIN * (ends - at_ends(&trial)).abs()).min(MOST_HIDDEN)
                    + ends
                    - highest;
                let floor = if ends < highest { ONSET_FLOOR } else { ONSET_FLOOR_AT_ENDS };
                let floor = floor / f64::from(elements);
                ((trial.ratio.ln() - highest).abs().max(hidden) / slope).max(floor)
            }
            _ => ONSET_FLOOR / f64::from(elements),
        };
        let change = change.max(self.beyond_closed_form(force));
        Ok(found.ratio.ln().abs() / slope + change)
    }

    /// Returns the relative excess of a force over the one under which yield begins below the
    /// middle in closed form. In bodies whose strength varies over the depth, yield may begin in a
    /// layer thinner than an element. The excess is 0 for other bodies.
    fn beyond_closed_form(&self, force: f64) -> f64 {
        let is_graded = self.problem.bodies.iter().any(|body| {
            let (least, greatest) = body.strength_range();
            least < greatest
        });
        let reference = is_graded.then(|| ElasticReference::of(self.problem, force)).flatten();
        let onset = reference.and_then(|reference| reference.yield_onset_force);
        onset.map_or(0.0, |onset| force / onset - 1.0)
    }

    /// Solves under one force.
    fn trial_by(
        &self,
        sequence: &LoadSequence<'_>,
        force: f64,
        run: &mut Run<'_>,
    ) -> Result<Tried<SectionField>, MeshedError> {
        let too_large = |error: MeshedError| match error {
            MeshedError::TooWide { .. } | MeshedError::TooFarRound { .. } => {
                Ok("the contact would spread over more of the surfaces than is solved".into())
            }
            MeshedError::Mesh(MeshError::ZoneBeyondBody { half_width, available }) => {
                Ok(Limit::NoRoom { half_width, available })
            }
            MeshedError::Mesh(MeshError::TooSteep { x, slope }) => {
                Ok(Limit::TooSteep { x, slope })
            }
            MeshedError::Mesh(error) => Ok(Limit::Other(error.to_string())),
            error => Err(error),
        };
        let wanted = Wanted {
            is_permanent: self.sought.is_permanent(),
            ratio: &|step| self.ratio(step),
            too_large: &too_large,
        };
        wanted.trial(force, |loads, steps| sequence.solve(loads, run, steps))
    }

    /// The figure over its wanted value.
    fn ratio(&self, step: &StepSolution) -> f64 {
        match self.sought {
            Sought::Onset => {
                highest_utilization(step, self.problem).map_or(0.0, |highest| highest.ratio)
            }
            Sought::Target(target) => target_figure(step, target.figure) / target.value,
        }
    }

    /// Whether the figure follows the width of the contact.
    fn is_of_width(&self) -> bool {
        let of_width = [TargetFigure::HalfWidth, TargetFigure::MeanPressure];
        matches!(self.sought, Sought::Target(target) if of_width.contains(&target.figure))
    }

    /// Deviation from which on the value counts as missed.
    fn missed(&self) -> f64 {
        let elements = f64::from(self.sequence.asked.elements);
        match self.sought {
            Sought::Onset => ONSET_MISSED,
            Sought::Target(_) if self.is_of_width() => {
                MISSED.max(2.0 * MISSED_ELEMENTS / elements)
            }
            Sought::Target(_) => MISSED,
        }
    }

    /// Returns the expected `d ln figure / d ln force`.
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

    /// The meshes on which the force is looked for.
    fn coarse(&self) -> Asked {
        let coarser = if self.is_of_width() { COARSER_FOR_WIDTH } else { COARSER };
        self.coarser((self.sequence.asked.elements / coarser).max(FEWEST_ELEMENTS))
    }

    /// Auxiliary meshes of other elements.
    fn coarser(&self, elements: u32) -> Asked {
        let Settings { theory, increments, .. } = self.sequence.asked.solver;
        Asked { elements, solver: Settings { theory, increments, ..auxiliary() } }
    }
}

/// A figure of the contact at the end of the loads by which it is found \[mm, MPa or 1\].
pub fn target_figure(step: &StepSolution, figure: TargetFigure) -> f64 {
    let largest = |of: fn(&BodySolution) -> f64| {
        step.field.bodies.iter().flatten().map(|body| of(body)).fold(0.0, f64::max)
    };
    match figure {
        TargetFigure::PermanentApproach => step.figures.approach,
        TargetFigure::DentDepth => largest(BodySolution::dent_depth),
        TargetFigure::PeakPressure => step.figures.peak_pressure,
        TargetFigure::MeanPressure => step.field.mean_pressure(&step.figures),
        TargetFigure::HalfWidth => step.figures.half_width,
        TargetFigure::MaxPlasticStrain => largest(BodySolution::max_plastic_strain),
    }
}

/// The largest force of which something is expected to hold that holds for small ones; `holds`
/// takes the force and the half-width that is expected under it.
fn force_below(problem: &Problem, holds: impl Fn(f64, f64) -> bool) -> Result<f64, MeshedError> {
    let (mut low, mut high) = (1e-9, 1e9);
    let expected = |force: f64| ContactSizeEstimate::expected(problem, ContactLoad::Force(force));
    if let Err(error @ (MeshedError::Conforming { .. } | MeshedError::TouchesAtEnd { .. })) =
        expected(low)
    {
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
