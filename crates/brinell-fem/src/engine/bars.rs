//! Relative error bars of the figures of a load step on meshes of elements, by one rule
//! ([`docs/validity.md`](../../../../docs/validity.md)); what a finding takes is the report's.

use super::solution::StepSolution;
use crate::element::StressState;
use brinell_method::bounds::{AT_ENDS, BY_ELEMENTS, Bound, FIRST_ORDER, IN_BANDS, SECOND_ORDER};
use brinell_method::figures::{Figure, Values};
use brinell_method::sought::TargetFigure;

/// Figures from which the error bars of a load step are computed.
pub struct Bars {
    stress_state: StressState,
    /// Element size over half-width, h/a.
    pub size: f64,
    /// The figures of the step.
    pub found: Values,
    coarse: Values,
    increments: Values,
    /// Least relative errors.
    shown: Values,
    /// What the least parts of the bounds are multiplied by.
    scales: Values,
    /// Whether the load is the largest so far.
    is_loading: bool,
    /// Whether the peak pressure is nearer to an end of the contact than to its middle.
    peaks_at_end: bool,
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
        let found = step.figures.values();
        let largest_approach = step.figures.approach.abs().max(step.path.reached[0]);
        let of_stiffness = step.field.unloading_stiffness * largest_approach;
        let of_bodies = step.field.bodies.each_ref().map(|body| {
            let Some(body) = body else { return [0.0; 2] };
            let points = body.stress.points.iter().flatten();
            let von_mises = points.map(|point| point.largest_von_mises).fold(0.0, f64::max);
            [von_mises, von_mises / (3.0 * body.model.elastic().shear)]
        });
        // The coarsest part of a contact may have the peak pressure.
        let part = step.field.coarsest_part().map_or(0.0, |(_, elements)| elements.recip());
        let size = (step.field.spacing / half_width).max(part);
        let scales = found.map(|figure, side, value| {
            let [von_mises, elastic_strain] = of_bodies[side];
            let scale = match figure {
                Figure::Approach | Figure::Dent => largest_approach,
                Figure::Force => value.max(of_stiffness),
                Figure::MaxPlasticStrain | Figure::MeanPlasticStrain => value + elastic_strain,
                Figure::PileUp => value + found.get(Figure::Dent, side).unwrap_or_default(),
                Figure::LeastStress | Figure::LargestVonMises => von_mises,
                _ => value,
            };
            scale.abs()
        });
        Some(Self {
            stress_state: step.field.stress_state,
            size,
            found,
            coarse: step.coarse?.values(),
            increments: step.increment_error.unwrap_or_default(),
            shown: step.path.shown,
            scales,
            is_loading: step.figures.approach >= step.path.reached[0],
            peaks_at_end: 2.0 * (step.field.peak_position - step.field.middle).abs() > half_width,
        })
    }

    /// Returns the bar of a figure that both meshes have measured. A figure of 0 has the bar 0 if it
    /// is 0 on the coarser mesh too, else no bar.
    pub fn of_figure(&self, figure: Figure, side: usize) -> Option<f64> {
        let at = |values: &Values| values.get(figure, side);
        let (found, coarse) = (at(&self.found)?, at(&self.coarse)?);
        if found == 0.0 {
            return (coarse == 0.0).then_some(0.0);
        }
        let off = self.bound(figure).of(found - coarse, self.size, at(&self.scales)?);
        // The force of a fully plastic contact follows the area.
        let off = match figure {
            Figure::Force if self.is_loading => {
                let sides = if self.stress_state == StressState::Axisymmetric { 2.0 } else { 1.0 };
                off.min(AT_ENDS.of(found - coarse, self.size, sides * found))
            }
            _ => off,
        };
        let of_mesh = off / found.abs();
        let of_increments = at(&self.increments).unwrap_or_default();
        Some(of_mesh.max(at(&self.shown).unwrap_or_default()) + of_increments)
    }

    /// Returns how the error of a figure is bounded.
    fn bound(&self, figure: Figure) -> Bound {
        let yields = self.found.largest(Figure::MaxPlasticStrain) > Some(0.0);
        let is_banded = yields && self.stress_state == StressState::PlaneStress;
        let is_circle = self.stress_state == StressState::Axisymmetric;
        match figure {
            Figure::MaxPlasticStrain | Figure::MeanPlasticStrain | Figure::PlasticArea
                if is_banded =>
            {
                IN_BANDS
            }
            Figure::PlasticArea => BY_ELEMENTS,
            Figure::MaxPlasticStrain if !is_circle => BY_ELEMENTS,
            Figure::LeastStress if is_circle => BY_ELEMENTS,
            Figure::MaxPlasticStrain | Figure::MeanPlasticStrain => FIRST_ORDER,
            Figure::PeakPressure | Figure::MiddlePressure if is_circle => FIRST_ORDER,
            // A pressure that drops from its peak to nothing tells its end worse.
            Figure::HalfWidth if self.peaks_at_end => FIRST_ORDER,
            Figure::HalfWidth | Figure::PileUp => AT_ENDS,
            Figure::Approach | Figure::Dent | Figure::LargestVonMises | Figure::LeastStress
                if is_banded =>
            {
                AT_ENDS
            }
            _ => SECOND_ORDER,
        }
    }

    /// Returns the bar of a target. A figure of both bodies has the larger of two bars.
    pub fn of_target(&self, target: TargetFigure) -> Option<f64> {
        let of_bodies = |figure: Figure| {
            let mut sides = (0..2).filter(|side| self.found.get(figure, *side).is_some());
            sides.try_fold(0.0, |most, side| Some(f64::max(most, self.of_figure(figure, side)?)))
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
