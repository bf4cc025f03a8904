//! Error bars: estimated bounds of the discretization errors in the figures of a load step.
//!
//! ```text
//! bar · |x| = |x(h) - x(2h)| + L (h/a)^p · scale + |x(Δt) - x(2Δt)|
//! ```
//! h is the element size and Δt stands for the increments of flow theory. a is the half-width of
//! the contact or, without contact, the largest half-width of the history. L and p are those of
//! a [bound](crate::solver::method::bounds). The scale is |x|, except for these figures:
//!
//! - approach and dent: the largest approach of the history;
//! - pile-up: the sum of dent and pile-up;
//! - force: the product of unloading stiffness and largest approach, if it is larger than |x|; while
//!   loads rise, with a bar of at most that of the contact area;
//! - stresses: the largest von Mises stress;
//! - plastic strains: |x| plus the largest von Mises stress over 3 G.
//!
//! `docs/validity.md` has the same table. `docs/notes/error_bars.md` counts how often the bars
//! held.

use super::findings::{Finding, Known, left_unknown};
use super::known::ErrorEstimate;
use super::surface_stress::UncertainStress;
use super::validity;
use crate::contact::ContactLoad;
use crate::fem::element::StressState;
use crate::inputs::meshed_contact;
use crate::job::{Job, Load, TargetFigure};
use crate::solver::bars::Bars;
use crate::solver::method::figures::{Figure, FigureSet, Values};
use crate::solver::{
    ElasticReference, MeshedContact, SLOPE_ERROR, SLOPE_ERROR_IN_PLANE_STRESS, StepSolution,
};

/// Floors of the contact stiffness over h/a, for bodies that are elastic or unload: in plane
/// analyses, and of bodies of revolution.
const STIFFNESS_FLOORS: [f64; 2] = [0.1, 0.2];
/// Largest exponent of the force in the power laws of peak pressure, half-width and stiffness of a
/// contact of arcs: the exponent of a line contact.
const WITH_FORCE: f64 = 0.5;
/// Elements from the middle within which a peak is that in the middle.
pub(super) const BESIDE: f64 = 2.5;
/// Exponent of the force in the growth of plastic strain well beyond the onset of yield.
const STRAIN_WITH_FORCE: f64 = 1.5;

/// Returns the error bars of a load step. Returns `None` without an answer or without a coarser
/// mesh, and where a finding takes the estimate away. Single figures have no bar where a finding
/// takes it away.
pub(super) fn estimate(
    job: &Job,
    step: &StepSolution,
    findings: &[Finding],
) -> Option<ErrorEstimate> {
    let bars = under_its_force(step, findings)?;
    Some(match (step.load, &job.load) {
        (ContactLoad::Approach(_), _) => bars,
        (ContactLoad::Force(_), Load::Onset) => {
            bars.with_force_error(step.search.force_error.unwrap_or(0.0), None)
        }
        (ContactLoad::Force(force), Load::Target(target)) if force > 0.0 => {
            match step
                .search
                .force_error
                .filter(|_| of_target(target.figure, &bars, step).is_some())
            {
                Some(error) => bars.with_force_error(error, Some(target.figure)),
                None => bars.without_force(target.figure),
            }
        }
        (ContactLoad::Force(_), _) => bars.with(Figure::Force, Some(0.0)),
    })
}

/// Returns the error bars of a load step, and the figures of the bodies that it leaves unknown to
/// the loads that follow it in a history.
pub fn estimate_error(job: &Job, step: &StepSolution) -> (Option<ErrorEstimate>, FigureSet) {
    let MeshedContact { problem, .. } = &meshed_contact(job);
    let reference = ElasticReference::of(problem, step.figures.force);
    let findings = validity::findings(job, problem, step, reference.as_ref());
    (estimate(job, step, &findings), left_unknown(step.path.unknown_before, &findings))
}

/// Returns the error bars of a load step, as if its force were prescribed.
pub(super) fn under_its_force(step: &StepSolution, findings: &[Finding]) -> Option<ErrorEstimate> {
    let known = Known::by(findings);
    if !known.has_estimate() {
        return None;
    }
    let bars = Bars::of(step)?;
    let is_approach_given = matches!(step.load, ContactLoad::Approach(_));
    let uncertain = |side: usize| {
        findings.iter().find_map(|finding| match finding {
            Finding::SurfaceStress { bodies, .. } => bodies[side].as_ref(),
            _ => None,
        })
    };
    // The stress at the surface may be beyond what the elements show.
    let at_surface = |figure: Figure, side: usize, bar: f64| {
        let beyond = match figure {
            Figure::LeastStress => UncertainStress::below,
            Figure::LargestVonMises => UncertainStress::above,
            _ => return Some(bar),
        };
        let found = bars.found.get(figure, side)?;
        let added = uncertain(side).map_or(0.0, |stress| beyond(stress, found) / found.abs());
        Some(bar + added).filter(|bar| bar.is_finite())
    };
    // Of a tip the peak in the middle is without bound.
    let is_peak_in_middle =
        (step.field.peak_position - step.field.middle).abs() < BESIDE * step.field.spacing;
    // Where an edge is left out, the contact ends anywhere on an element.
    let is_edge_left_out =
        findings.iter().any(|finding| matches!(finding, Finding::RoundedEdge { .. }));
    let of_end = if is_edge_left_out { 0.5 * bars.size } else { 0.0 };
    // The stiffness is known where the contact size is.
    let stiffness = step.contact_stiffness.filter(|_| known.has(Figure::HalfWidth, 0));
    let mut figures = Values::default();
    for figure in Figure::ALL.iter().copied().filter(|figure| HAVE_BARS.contains(figure)) {
        for side in
            (0..2).filter(|side| !figure.is_of_body() || step.field.bodies[*side].is_some())
        {
            let bar = known.bar(figure, side, bars.of_figure(figure, side));
            figures.set(figure, side, bar.and_then(|bar| at_surface(figure, side, bar)));
        }
    }
    let middle = figures.get(Figure::MiddlePressure, 0);
    let middle = middle.filter(|_| known.has(Figure::PeakPressure, 0) || !is_peak_in_middle);
    figures.set(Figure::MiddlePressure, 0, middle.map(|bar| bar + of_end));
    if is_approach_given {
        figures.set(Figure::Approach, 0, 0.0);
    }
    let contact_stiffness = stiffness.map(|_| stiffness_bar(step, bars.size));
    Some(ErrorEstimate { figures, contact_stiffness })
}

impl ErrorEstimate {
    /// Returns the bar of a figure, of a body that of one side.
    pub const fn of_figure(&self, figure: Figure, side: usize) -> Option<f64> {
        self.figures.get(figure, side)
    }

    /// Returns these bars with another one of a figure of the contact.
    fn with(mut self, figure: Figure, bar: Option<f64>) -> Self {
        self.figures.set(figure, 0, bar);
        self
    }

    /// Takes the bars of the figures that depend on a force whose error is unknown: of all but the
    /// target.
    fn without_force(self, target: TargetFigure) -> Self {
        let mut figures = Values::default();
        if let Some(figure) = figure_of(target) {
            for side in 0..2 {
                figures.set(figure, side, self.of_figure(figure, side));
            }
        }
        Self { figures, contact_stiffness: None }
    }

    /// Adds the relative error of a force that the solver has searched for. The error widens the
    /// bars of all figures that depend on the force, except the figure of the `target`.
    fn with_force_error(self, error: f64, target: Option<TargetFigure>) -> Self {
        let kept = match target {
            Some(TargetFigure::PeakPressure) => Some(Figure::PeakPressure),
            Some(TargetFigure::HalfWidth) => Some(Figure::HalfWidth),
            _ => None,
        };
        let wider = |figure: Figure, _, bar: f64| {
            if kept == Some(figure) { bar } else { bar + with_force(figure) * error }
        };
        let contact_stiffness = self.contact_stiffness.map(|bar| bar + WITH_FORCE * error);
        Self { figures: self.figures.map(wider), contact_stiffness }
            .with(Figure::Force, Some(error))
    }
}

/// Figures that have bars of two meshes.
const HAVE_BARS: [Figure; 12] = [
    Figure::PeakPressure,
    Figure::MiddlePressure,
    Figure::HalfWidth,
    Figure::Approach,
    Figure::Force,
    Figure::MaxPlasticStrain,
    Figure::MeanPlasticStrain,
    Figure::PlasticArea,
    Figure::Dent,
    Figure::PileUp,
    Figure::LeastStress,
    Figure::LargestVonMises,
];

/// Returns the largest exponent of the force in a figure.
const fn with_force(figure: Figure) -> f64 {
    match figure {
        Figure::MaxPlasticStrain | Figure::MeanPlasticStrain => STRAIN_WITH_FORCE,
        Figure::Approach | Figure::PlasticArea | Figure::Dent | Figure::PileUp => 1.0,
        _ => WITH_FORCE,
    }
}

/// Returns the figure whose bar is that of a target.
const fn figure_of(target: TargetFigure) -> Option<Figure> {
    match target {
        TargetFigure::PeakPressure => Some(Figure::PeakPressure),
        TargetFigure::HalfWidth => Some(Figure::HalfWidth),
        TargetFigure::DentDepth => Some(Figure::Dent),
        TargetFigure::MaxPlasticStrain => Some(Figure::MaxPlasticStrain),
        TargetFigure::MeanPressure | TargetFigure::PermanentApproach => None,
    }
}

/// Returns the error bar of the contact stiffness.
fn stiffness_bar(step: &StepSolution, size: f64) -> f64 {
    let yields = step.field.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0);
    match step.field.stress_state {
        state if !yields || !step.path.flows && step.figures.approach < step.path.reached[0] => {
            STIFFNESS_FLOORS[usize::from(state == StressState::Axisymmetric)] * size
        }
        StressState::PlaneStress => SLOPE_ERROR_IN_PLANE_STRESS,
        StressState::PlaneStrain | StressState::Axisymmetric => SLOPE_ERROR,
    }
}

/// Returns the error bar of a figure, if it has one. A figure of both bodies has the larger of two
/// bars.
pub(super) fn of_target(
    figure: TargetFigure,
    bars: &ErrorEstimate,
    step: &StepSolution,
) -> Option<f64> {
    let of_revolution = step.field.stress_state == StressState::Axisymmetric;
    let sides = step.field.bodies.each_ref().map(Option::is_some);
    let of = |figure: Figure| bars.of_figure(figure, 0);
    match figure {
        TargetFigure::PeakPressure => of(Figure::PeakPressure),
        TargetFigure::HalfWidth => of(Figure::HalfWidth),
        TargetFigure::MeanPressure => {
            of(Figure::HalfWidth).map(|bar| if of_revolution { 2.0 } else { 1.0 } * bar)
        }
        TargetFigure::PermanentApproach => of(Figure::Approach),
        TargetFigure::DentDepth | TargetFigure::MaxPlasticStrain => {
            let figure = figure_of(figure)?;
            let deformable = sides.iter().enumerate().filter(|(_, is)| **is);
            deformable
                .map(|(side, _)| bars.of_figure(figure, side))
                .try_fold(0.0, |most, bar| Some(f64::max(most, bar?)))
        }
    }
}
