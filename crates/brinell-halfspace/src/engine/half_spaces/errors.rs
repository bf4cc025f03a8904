//! Estimated errors of the figures of a step.
//!
//! ```text
//! error = ½ |x(n) - x(n/2)| + L (h/a)^p |x| + ½ |x(N) - x(N/2)|      n cells, N increments
//! ```
//! L and p are those of a [bound](brinell_method::bounds). Of an extrapolated figure the first term is
//! what the extrapolation has added. Under flow theory, an error of any other figure, less the term of
//! the increments, is at least what the loads so far have shown. h/a is the cell over the semi-axis,
//! along x or y where it is larger; without contact, of the widest contact of the history. The term of
//! the increments comes from the coarse grid.

use super::extrapolation::{ADDED, is_extrapolated};
use super::step::HalfSpaceStep;
use brinell_contact::ContactLoad;
use brinell_method::bounds::{BY_ELEMENTS, FIRST_ORDER, SECOND_ORDER};
use brinell_method::figures::{Figure, Figures, Values};
use brinell_method::observer::SolveStatus;
use brinell_method::sought::TargetFigure;

/// Part of the differences to half the cells and to half the increments.
const OF_DIFFERENCES: f64 = 0.5;

/// Returns the figure whose relative error is that of the target: of a mean pressure, its area.
pub const fn figure_of(target: TargetFigure) -> Figure {
    match target {
        TargetFigure::PermanentApproach => Figure::Approach,
        TargetFigure::DentDepth => Figure::Dent,
        TargetFigure::PeakPressure => Figure::PeakPressure,
        TargetFigure::MeanPressure => Figure::ContactArea,
        TargetFigure::HalfWidth => Figure::HalfWidth,
        TargetFigure::MaxPlasticStrain => Figure::MaxPlasticStrain,
    }
}

/// Returns the estimated absolute errors of the figures of a step; `None` where it, or the solve on
/// half the cells, has no answer. `sought` is the figure for which the force was sought.
pub fn errors(step: &HalfSpaceStep, sought: Option<TargetFigure>) -> Option<Values> {
    if step.status != SolveStatus::Converged {
        return None;
    }
    let (found, coarse) = (step.figures.values(), step.coarse?.values());
    let yields = found.largest(Figure::MaxPlasticStrain) > Some(0.0);
    let relative = relative_sizes(step);
    let is_tilted = step.field.tilt.abs() > 0.0;
    let differences = found.zip(&coarse, |fine, coarse| fine - coarse);
    let of_grid = differences.map(|figure, side, difference| {
        let bound = match figure {
            Figure::MaxPlasticStrain | Figure::PileUp => BY_ELEMENTS,
            // The contact of a tilted roller ends on one row.
            Figure::SemiAxisY if is_tilted => BY_ELEMENTS,
            Figure::PeakPressure if is_tilted && yields => FIRST_ORDER,
            Figure::HalfWidth | Figure::SemiAxisY | Figure::ContactArea | Figure::LeastStress => {
                FIRST_ORDER
            }
            _ => SECOND_ORDER,
        };
        let [size, value] = [&relative, &found].map(|of| of.get(figure, side).unwrap_or_default());
        let part = if is_extrapolated(step, figure) { ADDED } else { OF_DIFFERENCES };
        bound.of(part * difference, size, value)
    });
    let shown = found.zip(&step.path.shown, |figure, shown| figure.abs() * shown);
    let shown =
        shown.map(|figure, _, shown| if is_extrapolated(step, figure) { 0.0 } else { shown });
    let mut errors = of_grid.with(&shown, f64::max);
    clear_prescribed(step.load, &mut errors);
    if let Some(changes) = &step.increment_error {
        errors = errors.zip(&of_increments(&found, changes), |error, added| error + added);
        clear_prescribed(step.load, &mut errors);
    }
    let Some(target) = sought else { return Some(errors) };
    let of_force = of_force(&found, step.search.force_error?, target);
    Some(errors.zip(&of_force, |error, added| error + added))
}

/// Returns a figure of the contact at the end of its loads \[mm, MPa or 1\].
pub fn target_figure(figures: &Figures, figure: TargetFigure) -> f64 {
    let area = figures.contact_area.unwrap_or_default();
    figure.of(figures, figures.force / area.max(f64::MIN_POSITIVE))
}

/// Returns the estimated relative error of the target figure.
pub fn target_error(step: &HalfSpaceStep, errors: &Values, figure: TargetFigure) -> Option<f64> {
    let figure = figure_of(figure);
    let (error, value) = (errors.largest(figure)?, step.figures.values().largest(figure)?);
    Some((error / value.abs().max(f64::MIN_POSITIVE)).abs())
}

/// Returns the errors by the relative error of a force that was sought. The figure of the target
/// has none.
fn of_force(found: &Values, error: f64, target: TargetFigure) -> Values {
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
    found.map(|figure, _, value| exponent(figure) * error * value.abs())
}

/// A prescribed quantity has no error.
fn clear_prescribed(load: ContactLoad, errors: &mut Values) {
    match load {
        ContactLoad::Force(_) => errors.set(Figure::Force, 0, 0.0),
        ContactLoad::Approach(_) => errors.set(Figure::Approach, 0, 0.0),
    }
}

/// Returns the errors by the relative changes of figures under half as many increments. Approach,
/// force and widths have changes of their own; all other figures take the change of the pressure,
/// which is the largest.
fn of_increments(found: &Values, changes: &Values) -> Values {
    let change = |figure: Figure| changes.get(figure, 0).unwrap_or_default();
    found.map(|figure, _, value| {
        let relative = match figure {
            Figure::Force | Figure::Approach => change(figure),
            Figure::HalfWidth | Figure::SemiAxisY => change(Figure::HalfWidth),
            Figure::ContactArea => 2.0 * change(Figure::HalfWidth),
            _ => change(Figure::PeakPressure),
        };
        OF_DIFFERENCES * relative * value.abs()
    })
}

/// Returns the size of cells that counts for each figure: over the semi-axis, of the peak pressure over
/// the distance to the end of the contact, beside which the pressure is that of single cells.
fn relative_sizes(step: &HalfSpaceStep) -> Values {
    let [along_x, along_y] = sizes(step);
    let at_peak = cells_beside_peak(step).max(1) as f64;
    step.figures.values().map(|figure, _, _| match figure {
        Figure::HalfWidth => along_x,
        Figure::SemiAxisY => along_y,
        Figure::PeakPressure => at_peak.recip(),
        _ => along_x.max(along_y),
    })
}

/// Returns the number of cells from the peak to the nearest end of the contact along x or y.
fn cells_beside_peak(step: &HalfSpaceStep) -> usize {
    let (map, [x, y]) = (&step.field.surface, step.field.peak_position);
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let i = (0..nx).find(|i| map.grid.x(*i) >= x).unwrap_or_default();
    let j = (0..ny).find(|j| map.grid.y(*j) >= y).unwrap_or_default();
    let touches = |i: usize, j: usize| map.pressure[i * ny + j] > 0.0;
    let left = (0..=i).rev().take_while(|i| touches(*i, j)).count();
    let right = (i..nx).take_while(|i| touches(*i, j)).count();
    let below = (0..=j).rev().take_while(|j| touches(i, *j)).count();
    let above = (j..ny).take_while(|j| touches(i, *j)).count();
    left.min(right).min(below).min(above)
}

/// Returns the cell over the semi-axis, along x and y. Grids have as many cells over both, so that the
/// half-width of the widest contact stands for one that is gone.
fn sizes(step: &HalfSpaceStep) -> [f64; 2] {
    let (grid, [a, b]) = (&step.field.surface.grid, step.figures.semi_axes());
    if a <= 0.0 {
        return [grid.hx() / step.path.reached[1].max(grid.hx()); 2];
    }
    [(grid.hx(), a), (grid.hy(), b)].map(|(cell, axis)| cell / axis.max(cell))
}
