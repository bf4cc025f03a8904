//! Estimated errors of the figures of a step.
//!
//! ```text
//! error = 0.7 |x(n) - x(n/2)| + ½ |x(N) - x(N/2)| + floor      n cells, N increments
//! ```
//! The term of the increments comes from the coarse grid. Floors cover the scatter of approach and
//! semi-axes as cells at the edge enter the contact, and the scatter of all other figures if the
//! contact yields. Factors and floors cover the deviations of the prototype on 16 to 64 cells a
//! side; the floors of semi-axes and plastic strain cover the deviations of random contacts on 4
//! to 10 cells over a semi-axis. The peak pressure of a tilted roller can lie up to half a cell
//! from the middle of the nearest cell; there, an ellipse is lower by `(h/2b)²/2`.

use super::step::HalfSpaceStep;
use crate::contact::ContactLoad;
use crate::solver::SolveStatus;
use crate::solver::method::figures::{BodyFigures, Figures};

const OF_GRID: f64 = 0.7;
const OF_INCREMENTS: f64 = 0.5;
/// Relative floors of pressure, dent and stress, and of the approach. The floors of semi-axes and
/// plastic strain are multiplied by the ratio of cell to semi-axis.
const SCATTER: f64 = 1e-2;
const SCATTER_OF_APPROACH: f64 = 1.5e-3;
const SCATTER_OF_AXES: f64 = 0.2;
const SCATTER_OF_STRAIN: f64 = 0.3;
/// Additional floor of the peak pressure, multiplied by the distance of the peak from the middle
/// over the semi-axis: the pressure of single cells is jagged near the edge. For a perfectly
/// plastic ball at six yield stresses, 10 and 15 cells give 4.6 % and 3 % too much.
const SCATTER_OF_RING: f64 = 2e-2;
/// Exponent of the growth of the force with the approach.
const FORCE_OVER_APPROACH: f64 = 1.5;

impl HalfSpaceStep {
    /// Returns the errors by comparison with the figures on half the cells; `None` if the step has
    /// no answer.
    pub(super) fn errors_beside(&self, coarse: &Figures) -> Option<Figures> {
        if self.status != SolveStatus::Converged {
            return None;
        }
        let of_grid = self.figures.zip(coarse, |fine, coarse| OF_GRID * (fine - coarse).abs());
        let of_floors = floors(self).zip(&self.figures, |floor, figure| floor * figure.abs());
        let mut errors = of_grid.zip(&of_floors, |grid, floor| grid + floor);
        // A prescribed quantity has no error.
        match self.load {
            ContactLoad::Force(_) => errors.force = 0.0,
            ContactLoad::Approach(_) => errors.approach = 0.0,
        }
        Some(errors)
    }

    fn yields(&self) -> bool {
        self.figures.bodies.iter().any(|body| body.max_plastic_strain > 0.0)
    }
}

/// Returns the floors relative to the figures.
fn floors(step: &HalfSpaceStep) -> Figures {
    let scatter = if step.yields() { 1.0 } else { 0.0 };
    let (force, approach) = match step.load {
        ContactLoad::Force(_) => (0.0, SCATTER_OF_APPROACH),
        ContactLoad::Approach(_) => (FORCE_OVER_APPROACH * SCATTER_OF_APPROACH, 0.0),
    };
    let (grid, [a, b]) = (&step.surface.grid, step.figures.semi_axes());
    let sizes = [(grid.hx(), a), (grid.hy(), b)].map(|(cell, axis)| cell / axis.max(cell));
    let semi_axes = sizes.map(|size| SCATTER_OF_AXES * size);
    let strain = scatter * SCATTER_OF_STRAIN * sizes[0].max(sizes[1]);
    let [x, y] = step.peak_position;
    let from_middle = if a.min(b) > 0.0 { (x / a).hypot(y / b).min(1.0) } else { 0.0 };
    let is_between = step.tilt.abs() > 0.0;
    let between = if is_between { 0.5 * (0.5 * sizes[1]).powi(2) } else { 0.0 };
    let of_body = BodyFigures {
        max_plastic_strain: strain,
        dent: scatter * SCATTER,
        pile_up: scatter * SCATTER,
        least_stress: scatter * SCATTER,
        ..BodyFigures::default()
    };
    Figures {
        force,
        approach,
        peak_pressure: scatter * (SCATTER + SCATTER_OF_RING * from_middle) + between,
        half_width: semi_axes[0],
        semi_axis_y: semi_axes[1],
        contact_area: semi_axes.iter().sum(),
        bodies: [of_body; 2],
    }
}

/// Adds the relative changes of figures under half as many increments to their errors. Approach,
/// force and widths have changes of their own; all other figures take the change of the pressure,
/// which is the largest.
pub(super) fn add_increments(errors: &mut Figures, figures: &Figures, changes: &Figures) {
    let Figures { peak_pressure, half_width, approach, force, .. } = *changes;
    let relative = Figures {
        force,
        approach,
        half_width,
        semi_axis_y: half_width,
        contact_area: 2.0 * half_width,
        ..Figures::of([peak_pressure; Figures::COUNT])
    };
    let added = relative.zip(figures, |relative, figure| OF_INCREMENTS * relative * figure.abs());
    *errors = errors.zip(&added, |error, added| error + added);
}
