//! Error bars: estimated bounds of the discretization errors in the figures of a load step.
//!
//! ```text
//! bar · |x| = |x(h) - x(2h)| + floor · h/a · scale + |x(Δt) - x(2Δt)|
//! ```
//! h is the element size and Δt stands for the increments of flow theory. a is the half-width of
//! the contact or, without contact, the largest half-width of the history. The end of the contact
//! lies anywhere between two nodes, and errors scatter with its position. The difference between
//! two meshes is therefore sometimes far smaller than the error; the floors cover these cases. The
//! scale is |x|, except for these figures:
//!
//! - approach and dent: the largest approach of the history;
//! - pile-up: the sum of dent and pile-up;
//! - force: the product of unloading stiffness and largest approach, if it is larger than |x|; while
//!   loads rise, with a floor of at most that of the contact area;
//! - stresses: the largest von Mises stress;
//! - plastic strains: |x| plus the largest von Mises stress over 3 G.
//!
//! `docs/validity.md` has the same table. `docs/notes/error_bars.md` counts how often the bars
//! held.

use serde::{Deserialize, Serialize};

use super::findings::{Finding, Known, left_unknown};
use super::surface_stress::UncertainStress;
use super::{PerBody, validity};
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

/// Estimated bounds of the relative discretization errors. They hold in at least 95 of 100 cases
/// and say nothing about the theory: for that see `validity`, which also says why a bound is
/// `null`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct ErrorEstimate {
    /// Of the peak pressure \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub peak_pressure: Option<f64>,
    /// Of the pressure in the middle of the contact \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub middle_pressure: Option<f64>,
    /// Of the half-width \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub half_width: Option<f64>,
    /// Of the approach; 0 where it is prescribed \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub approach: Option<f64>,
    /// Of the contact force; 0 where it is prescribed \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub force: Option<f64>,
    /// Of the contact stiffness, where there is one \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub contact_stiffness: Option<f64>,
    /// Of figures of each body; absent in three dimensions, which have their own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bodies: Option<PerBody<Option<BodyErrors>>>,
}

/// Estimated relative errors of figures of one body; 0 of a figure that is 0.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct BodyErrors {
    /// Of the largest plastic strain \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub max_equivalent_plastic_strain: Option<f64>,
    /// Of the mean plastic strain \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub mean_equivalent_plastic_strain: Option<f64>,
    /// Of the plastic area \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub area: Option<f64>,
    /// Of the depth by which the surface is lowered, in three dimensions by plastic strain alone
    /// \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub depth: Option<f64>,
    /// Of the height by which it is raised \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub pile_up: Option<f64>,
    /// Of the least stress along the surface below the middle of the contact, in three dimensions
    /// below the largest pressure; without load that is the residual stress \[1 >= 0\].
    #[cfg_attr(feature = "openapi", schema(required))]
    pub least_stress: Option<f64>,
    /// Of the largest von Mises stress there over the yield stress \[1 >= 0\].
    #[serde(default)]
    #[cfg_attr(feature = "openapi", schema(required))]
    pub utilization: Option<f64>,
}

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
                .filter(|_| of_target(target.figure, &bars, false).is_some())
            {
                Some(error) => bars.with_force_error(error, Some(target.figure)),
                None => bars.without_force(target.figure),
            }
        }
        (ContactLoad::Force(_), _) => ErrorEstimate { force: Some(0.0), ..bars },
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

/// Returns what the floors of the figures of a load step are multiplied by; `None` where the step
/// has no bars.
pub fn scales_of_floors(step: &StepSolution) -> Option<Values> {
    Bars::of(step).map(|bars| bars.scales)
}

/// Returns the error bars of a load step, as if its force were prescribed.
pub(super) fn under_its_force(step: &StepSolution, findings: &[Finding]) -> Option<ErrorEstimate> {
    let known = Known::by(findings);
    if !known.has_estimate() {
        return None;
    }
    let bars = Bars::of(step)?;
    let of_contact = |figure: Figure| known.bar(figure, 0, bars.of_figure(figure, 0));
    let is_approach_given = matches!(step.load, ContactLoad::Approach(_));
    let uncertain = |side: usize| {
        findings.iter().find_map(|finding| match finding {
            Finding::SurfaceStress { bodies, .. } => bodies[side].as_ref(),
            _ => None,
        })
    };
    let of_body = |side: usize| {
        step.field.bodies[side].as_ref()?;
        let of = |figure: Figure| known.bar(figure, side, bars.of_figure(figure, side));
        let at_surface = |figure: Figure, beyond: fn(&UncertainStress, f64) -> f64| {
            let found = bars.found.get(figure, side)?;
            let added = uncertain(side).map_or(0.0, |stress| beyond(stress, found) / found.abs());
            of(figure).map(|bar| bar + added).filter(|bar| bar.is_finite())
        };
        Some(BodyErrors {
            max_equivalent_plastic_strain: of(Figure::MaxPlasticStrain),
            mean_equivalent_plastic_strain: of(Figure::MeanPlasticStrain),
            area: of(Figure::PlasticArea),
            depth: of(Figure::Dent),
            pile_up: of(Figure::PileUp),
            least_stress: at_surface(Figure::LeastStress, UncertainStress::below),
            utilization: at_surface(Figure::LargestVonMises, UncertainStress::above),
        })
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
    Some(ErrorEstimate {
        peak_pressure: of_contact(Figure::PeakPressure),
        middle_pressure: of_contact(Figure::MiddlePressure)
            .filter(|_| known.has(Figure::PeakPressure, 0) || !is_peak_in_middle)
            .map(|bar| bar + of_end),
        half_width: of_contact(Figure::HalfWidth),
        approach: if is_approach_given { Some(0.0) } else { of_contact(Figure::Approach) },
        force: of_contact(Figure::Force),
        contact_stiffness: stiffness.map(|_| stiffness_bar(step, bars.size)),
        bodies: Some(PerBody { upper: of_body(0), lower: of_body(1) }),
    })
}

impl ErrorEstimate {
    /// Returns the bar of a figure, of a body that of one side.
    pub fn of_figure(&self, figure: Figure, side: usize) -> Option<f64> {
        let body = self.bodies.and_then(|bodies| [bodies.upper, bodies.lower][side]);
        match figure {
            Figure::PeakPressure => self.peak_pressure,
            Figure::MiddlePressure => self.middle_pressure,
            Figure::HalfWidth => self.half_width,
            Figure::Approach => self.approach,
            Figure::Force => self.force,
            Figure::MaxPlasticStrain => body?.max_equivalent_plastic_strain,
            Figure::MeanPlasticStrain => body?.mean_equivalent_plastic_strain,
            Figure::PlasticArea => body?.area,
            Figure::Dent => body?.depth,
            Figure::PileUp => body?.pile_up,
            Figure::LeastStress => body?.least_stress,
            Figure::LargestVonMises => body?.utilization,
            Figure::SemiAxisY
            | Figure::ContactArea
            | Figure::ContactRatio
            | Figure::PlasticDepth => None,
        }
    }

    /// Takes the bars of the figures that depend on a force whose error is unknown: of all but the
    /// target.
    fn without_force(self, target: TargetFigure) -> Self {
        let of = |is_target: bool, bar: Option<f64>| bar.filter(|_| is_target);
        let body = |errors: BodyErrors| BodyErrors {
            max_equivalent_plastic_strain: of(
                target == TargetFigure::MaxPlasticStrain,
                errors.max_equivalent_plastic_strain,
            ),
            depth: of(target == TargetFigure::DentDepth, errors.depth),
            ..BodyErrors::default()
        };
        Self {
            peak_pressure: of(target == TargetFigure::PeakPressure, self.peak_pressure),
            half_width: of(target == TargetFigure::HalfWidth, self.half_width),
            bodies: self.bodies.map(|PerBody { upper, lower }| PerBody {
                upper: upper.map(body),
                lower: lower.map(body),
            }),
            ..Self::default()
        }
    }

    /// Adds the relative error of a force that the solver has searched for. The error widens the
    /// bars of all figures that depend on the force, except the figure of the `target`.
    fn with_force_error(mut self, error: f64, target: Option<TargetFigure>) -> Self {
        let wider = |bar: &mut Option<f64>, exponent: f64| {
            *bar = bar.map(|bar| bar + exponent * error);
        };
        self.force = Some(error);
        wider(&mut self.approach, 1.0);
        if target != Some(TargetFigure::PeakPressure) {
            wider(&mut self.peak_pressure, WITH_FORCE);
        }
        if target != Some(TargetFigure::HalfWidth) {
            wider(&mut self.half_width, WITH_FORCE);
        }
        wider(&mut self.middle_pressure, WITH_FORCE);
        wider(&mut self.contact_stiffness, WITH_FORCE);
        if let Some(bodies) = &mut self.bodies {
            for body in [&mut bodies.upper, &mut bodies.lower].into_iter().flatten() {
                wider(&mut body.max_equivalent_plastic_strain, STRAIN_WITH_FORCE);
                wider(&mut body.mean_equivalent_plastic_strain, STRAIN_WITH_FORCE);
                wider(&mut body.area, 1.0);
                wider(&mut body.depth, 1.0);
                wider(&mut body.pile_up, 1.0);
                wider(&mut body.least_stress, WITH_FORCE);
                wider(&mut body.utilization, WITH_FORCE);
            }
        }
        self
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
    of_revolution: bool,
) -> Option<f64> {
    let of_bodies = |bar: fn(&BodyErrors) -> Option<f64>| {
        let PerBody { upper, lower } = bars.bodies?;
        [upper, lower]
            .iter()
            .flatten()
            .try_fold(0.0, |most, body| Some(f64::max(most, bar(body)?)))
    };
    match figure {
        TargetFigure::PeakPressure => bars.peak_pressure,
        TargetFigure::HalfWidth => bars.half_width,
        TargetFigure::MeanPressure => {
            bars.half_width.map(|bar| if of_revolution { 2.0 } else { 1.0 } * bar)
        }
        TargetFigure::PermanentApproach => bars.approach,
        TargetFigure::DentDepth => of_bodies(|body| body.depth),
        TargetFigure::MaxPlasticStrain => of_bodies(|body| body.max_equivalent_plastic_strain),
    }
}

#[cfg(test)]
mod tests {
    use super::Figure;
    use crate::report::figure_names::name_of;
    use crate::solver::floors::floors;

    #[test]
    fn the_document_has_the_same_floors() {
        let document = include_str!("../../../../docs/validity.md");
        for (figure, name) in Figure::ALL.iter().filter_map(|row| Some((row, name_of(*row)?))) {
            let cells = floors(*figure)
                .map(|floor| floor.map_or_else(String::new, |floor| format!("{floor}")));
            let row = format!("| {name} | {} |", cells.join(" | "));
            assert!(document.contains(&row), "{row}");
        }
    }
}
