//! Relative error bars of the figures of a load step on meshes of elements, by one rule
//! ([`docs/validity.md`](../../../../docs/validity.md)); what a finding takes is the report's.

use super::solution::StepSolution;
use crate::element::StressState;
use brinell_method::figures::{Figure, Figures};
use brinell_method::floors::floors;
use brinell_method::sought::TargetFigure;

/// Returns the place of an analysis among the floors of a figure.
const fn class_of(state: StressState) -> usize {
    match state {
        StressState::PlaneStrain => 0,
        StressState::PlaneStress => 1,
        StressState::Axisymmetric => 2,
    }
}

/// Figures from which the error bars of a load step are computed.
pub struct Bars {
    stress_state: StressState,
    /// Element size over half-width, h/a.
    pub size: f64,
    /// The figures of the step.
    pub found: Figures,
    coarse: Figures,
    increments: Figures,
    /// Least relative errors.
    shown: Figures,
    /// Factors of the floors.
    pub scales: Figures,
}

impl Bars {
    /// `None` without a coarser mesh, and before anything touches.
    pub fn of(step: &StepSolution) -> Option<Self> {
        let half_width = if step.field.patch.is_some() {
            step.figures.half_width
        } else {
            step.path.reached[1]
        };
        if half_width <= 0.0 {
            return None;
        }
        let figures = step.figures;
        let mut scales = figures;
        let largest_approach = step.figures.approach.abs().max(step.path.reached[0]);
        scales.approach = largest_approach;
        let of_stiffness = step.field.unloading_stiffness * largest_approach;
        let is_loading = step.figures.approach >= step.path.reached[0];
        let most = if is_loading { most_of_force(step) } else { f64::INFINITY };
        scales.force = scales.force.max(of_stiffness.min(most));
        for (scales, body) in scales.bodies.iter_mut().zip(&step.field.bodies) {
            let Some(body) = body else { continue };
            let points = body.stress.points.iter().flatten();
            let von_mises = points.map(|point| point.largest_von_mises).fold(0.0, f64::max);
            let elastic_strain = von_mises / (3.0 * body.model.elastic().shear);
            scales.max_plastic_strain += elastic_strain;
            scales.mean_plastic_strain += elastic_strain;
            scales.pile_up += scales.dent;
            scales.dent = largest_approach;
            (scales.least_stress, scales.largest_von_mises) = (von_mises, von_mises);
        }
        // The coarsest part of a contact may have the peak pressure.
        let part = step.field.coarsest_part().map_or(0.0, |(_, elements)| elements.recip());
        let size = (step.field.spacing / half_width).max(part);
        Some(Self {
            stress_state: step.field.stress_state,
            size,
            found: figures,
            coarse: step.coarse?,
            increments: step.increment_error.unwrap_or_default(),
            shown: step.path.shown,
            scales: scales.zip(&scales, |scale, _| size * scale.abs()),
        })
    }

    /// Returns the bar of a figure. A figure of 0 has the bar 0 if it is 0 on the coarser mesh too,
    /// else no bar.
    pub fn of_figure(&self, figure: Figure, side: usize) -> Option<f64> {
        let at = |figures: &Figures| figures.values()[figure.at(side)];
        let (found, coarse) = (at(&self.found), at(&self.coarse));
        if found == 0.0 {
            return (coarse == 0.0).then_some(0.0);
        }
        let floor = floors(figure)[class_of(self.stress_state)]? * at(&self.scales);
        let of_mesh = ((found - coarse).abs() + floor) / found.abs();
        Some(of_mesh.max(at(&self.shown)) + at(&self.increments))
    }

    /// Returns the bar of a target. A figure of both bodies has the larger of two bars.
    pub fn of_target(&self, target: TargetFigure) -> Option<f64> {
        let of_bodies = |figure: Figure| {
            let [upper, lower] = [0, 1].map(|side| self.of_figure(figure, side));
            Some(upper?.max(lower?))
        };
        let is_circle = self.stress_state == StressState::Axisymmetric;
        match target {
            TargetFigure::PeakPressure => self.of_figure(Figure::PeakPressure, 0),
            TargetFigure::HalfWidth => self.of_figure(Figure::HalfWidth, 0),
            TargetFigure::MeanPressure => {
                let of_width = self.of_figure(Figure::HalfWidth, 0);
                of_width.map(|bar| if is_circle { 2.0 * bar } else { bar })
            }
            TargetFigure::PermanentApproach => self.of_figure(Figure::Approach, 0),
            TargetFigure::DentDepth => of_bodies(Figure::Dent),
            TargetFigure::MaxPlasticStrain => of_bodies(Figure::MaxPlasticStrain),
        }
    }
}

/// Returns the largest scale of the force while loads rise. The force of a fully plastic contact
/// follows the area, whose error is that of the half-width.
fn most_of_force(step: &StepSolution) -> f64 {
    let state = step.field.stress_state;
    let [of_width, of_force] =
        [Figure::HalfWidth, Figure::Force].map(|figure| floors(figure)[class_of(state)]);
    let power = if state == StressState::Axisymmetric { 2.0 } else { 1.0 };
    match (of_width, of_force) {
        (Some(width), Some(force)) => power * width / force * step.figures.force.abs(),
        _ => f64::INFINITY,
    }
}
