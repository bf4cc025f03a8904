//! Estimated errors of the figures of a step.
//!
//! ```text
//! error = 0.7 |x(n) - x(n/2)| + ½ |x(N) - x(N/2)| + floor · h/a · |x|      n cells, N increments
//! ```
//! h/a is the cell over the semi-axis, along x or y where it is larger. The term of the increments
//! comes from the coarse grid. [Floors](crate::solver::floors) cover the scatter of approach and
//! semi-axes as cells at the edge enter the contact, and the scatter of all other figures if the
//! contact yields. The peak pressure of a tilted roller can lie up to half a cell from the middle
//! of the nearest cell; there, an ellipse is lower by `(h/2b)²/2`.

use super::step::HalfSpaceStep;
use crate::contact::ContactLoad;
use crate::job::TargetFigure;
use crate::solver::SolveStatus;
use crate::solver::floors::floors;
use crate::solver::method::figures::{Figure, Figures};

/// Place of half-spaces among the floors of a figure.
const HALF_SPACES: usize = 3;
const OF_GRID: f64 = 0.7;
const OF_INCREMENTS: f64 = 0.5;
/// Growth of the floor of the peak pressure with the distance of the peak from the middle over the
/// semi-axis: the pressure of single cells is jagged near the edge. For a perfectly plastic ball
/// at six yield stresses, 10 and 15 cells give 4.6 % and 3 % too much.
const OF_RING: f64 = 2.0;

/// Returns the figure whose relative error is that of the target: of a mean pressure, its area.
pub(crate) const fn figure_of(target: TargetFigure) -> Figure {
    match target {
        TargetFigure::PermanentApproach => Figure::Approach,
        TargetFigure::DentDepth => Figure::Dent,
        TargetFigure::PeakPressure => Figure::PeakPressure,
        TargetFigure::MeanPressure => Figure::ContactArea,
        TargetFigure::HalfWidth => Figure::HalfWidth,
        TargetFigure::MaxPlasticStrain => Figure::MaxPlasticStrain,
    }
}

impl HalfSpaceStep {
    /// Returns the errors by comparison with the figures on half the cells; `None` if the step has
    /// no answer.
    pub(super) fn errors_beside(&self, coarse: &Figures) -> Option<Figures> {
        if self.status != SolveStatus::Converged {
            return None;
        }
        let of_grid = self.figures.zip(coarse, |fine, coarse| OF_GRID * (fine - coarse).abs());
        let scales = self.scales_of_floors();
        let of_floors = Figures::by(|figure, side| {
            floors(figure)[HALF_SPACES].unwrap_or_default() * scales.get(figure, side)
        });
        let mut errors = of_grid.zip(&of_floors, |grid, floor| grid + floor);
        let size = self.sizes()[1];
        if self.tilt.abs() > 0.0 {
            errors.peak_pressure += 0.5 * (0.5 * size).powi(2) * self.figures.peak_pressure;
        }
        self.clear_prescribed(&mut errors);
        Some(errors)
    }

    /// Returns the estimated relative error of the target figure.
    pub fn target_error(&self, figure: TargetFigure) -> Option<f64> {
        let errors = self.errors.as_ref()?;
        let figure = figure_of(figure);
        let larger = |set: &Figures| set.get(figure, 0).max(set.get(figure, 1));
        let [error, value] = [errors, &self.figures]
            .map(|set| if figure.is_of_body() { larger(set) } else { set.get(figure, 0) });
        Some((error / value.abs().max(f64::MIN_POSITIVE)).abs())
    }

    /// Adds the relative error of a force that was sought to the errors of all figures but that of
    /// the target. No figure has an error where that of the force is unknown.
    pub(super) fn add_force_error(&mut self, error: Option<f64>, target: TargetFigure) {
        let (Some(errors), Some(error)) = (&mut self.errors, error) else {
            self.errors = None;
            return;
        };
        let exponent = |figure: Figure| match (figure, target) {
            (Figure::PeakPressure, TargetFigure::PeakPressure)
            | (Figure::HalfWidth | Figure::SemiAxisY, TargetFigure::HalfWidth) => 0.0,
            (
                Figure::PeakPressure
                | Figure::MiddlePressure
                | Figure::HalfWidth
                | Figure::SemiAxisY
                | Figure::LeastStress
                | Figure::LargestVonMises,
                _,
            ) => 0.5,
            (Figure::MaxPlasticStrain | Figure::MeanPlasticStrain, _) => 1.5,
            _ => 1.0,
        };
        let added = Figures::by(|figure, side| {
            exponent(figure) * error * self.figures.get(figure, side).abs()
        });
        *errors = errors.zip(&added, |error, added| error + added);
    }

    /// A prescribed quantity has no error.
    fn clear_prescribed(&self, errors: &mut Figures) {
        match self.load {
            ContactLoad::Force(_) => errors.force = 0.0,
            ContactLoad::Approach(_) => errors.approach = 0.0,
        }
    }

    /// Adds the relative changes of figures under half as many increments to their errors.
    /// Approach, force and widths have changes of their own; all other figures take the change of
    /// the pressure, which is the largest.
    pub(super) fn add_increments(&mut self, changes: &Figures) {
        let Some(mut errors) = self.errors else { return };
        let Figures { peak_pressure, half_width, approach, force, .. } = *changes;
        let relative = Figures {
            force,
            approach,
            half_width,
            semi_axis_y: half_width,
            contact_area: 2.0 * half_width,
            ..Figures::of([peak_pressure; Figures::COUNT])
        };
        let added = relative
            .zip(&self.figures, |relative, figure| OF_INCREMENTS * relative * figure.abs());
        errors = errors.zip(&added, |error, added| error + added);
        self.clear_prescribed(&mut errors);
        self.errors = Some(errors);
    }

    /// Returns what the floors of the figures are multiplied by.
    pub fn scales_of_floors(&self) -> Figures {
        let [along_x, along_y] = self.sizes();
        let size = along_x.max(along_y);
        let [a, b] = self.figures.semi_axes();
        let [x, y] = self.peak_position;
        let from_middle = if a.min(b) > 0.0 { (x / a).hypot(y / b).min(1.0) } else { 0.0 };
        let scatter = if self.yields() { size } else { 0.0 };
        Figures::by(|figure, side| {
            let of_figure = match figure {
                Figure::HalfWidth => along_x,
                Figure::SemiAxisY => along_y,
                Figure::ContactArea => along_x + along_y,
                Figure::Approach | Figure::Force => size,
                Figure::PeakPressure => scatter * (1.0 + OF_RING * from_middle),
                _ => scatter,
            };
            of_figure * self.figures.get(figure, side).abs()
        })
    }

    /// Returns the cell over the semi-axis, along x and y.
    fn sizes(&self) -> [f64; 2] {
        let (grid, [a, b]) = (&self.surface.grid, self.figures.semi_axes());
        [(grid.hx(), a), (grid.hy(), b)].map(|(cell, axis)| cell / axis.max(cell))
    }

    fn yields(&self) -> bool {
        self.figures.bodies.iter().any(|body| body.max_plastic_strain > 0.0)
    }
}
