//! Estimated errors of the figures of a step.
//!
//! ```text
//! error = 0.7 |x(n) - x(n/2)| + ½ |x(N) - x(N/2)| + floor      n cells, N increments, the latter on the coarse grid
//! ```
//! Floors are for what scatters with the cells at the edge of the contact: approach and semi-axes, and all other figures of
//! contacts that yield. Factors and floors are those by which the prototype's figures on 16 to 64 cells a side are covered.

use super::raw_step::RawStep;
use super::step::HalfSpaceFigures;
use crate::contact::ContactLoad;
use crate::solver::SolveStatus;

const OF_GRID: f64 = 0.7;
const OF_INCREMENTS: f64 = 0.5;
/// Floors over the figure: pressure, dent, strain and stress; approach; semi-axes.
const SCATTER: f64 = 1e-2;
const SCATTER_OF_APPROACH: f64 = 1.5e-3;
const SCATTER_OF_AXES: f64 = 1.5e-2;
/// By how much the force changes with the approach, of both logarithms.
const FORCE_OVER_APPROACH: f64 = 1.5;

/// Of a load that stands for itself; `None` where the coarse grid has no answer.
pub(super) fn of_grid(fine: &RawStep, coarse: &RawStep) -> Option<HalfSpaceFigures> {
    let has_answer = coarse.status == SolveStatus::Converged;
    has_answer.then(|| estimate(fine, coarse, &HalfSpaceFigures::default()))
}

/// Of a load of a history; `halved` is the coarse grid with half the increments.
pub(super) fn of_history(fine: &RawStep, coarse: &RawStep, halved: &RawStep) -> Option<HalfSpaceFigures> {
    let has_answer = [coarse, halved].iter().all(|step| step.status == SolveStatus::Converged);
    let change = difference(&coarse.measured.figures, &halved.measured.figures);
    has_answer.then(|| estimate(fine, coarse, &change))
}

fn estimate(fine: &RawStep, coarse: &RawStep, of_increments: &HalfSpaceFigures) -> HalfSpaceFigures {
    let figures = fine.measured.figures.values();
    let of_grid = difference(&fine.measured.figures, &coarse.measured.figures).values();
    let floors = floors(fine).values();
    let increments = of_increments.values();
    HalfSpaceFigures::of(std::array::from_fn(|k| {
        OF_GRID * of_grid[k] + OF_INCREMENTS * increments[k] + floors[k] * figures[k].abs()
    }))
}

fn difference(a: &HalfSpaceFigures, b: &HalfSpaceFigures) -> HalfSpaceFigures {
    let (a, b) = (a.values(), b.values());
    HalfSpaceFigures::of(std::array::from_fn(|k| (a[k] - b[k]).abs()))
}

/// Over the figure.
fn floors(step: &RawStep) -> HalfSpaceFigures {
    let scatter = if step.yields() { 1.0 } else { 0.0 };
    let (force, approach) = match step.load {
        ContactLoad::Force(_) => (0.0, SCATTER_OF_APPROACH),
        ContactLoad::Approach(_) => (FORCE_OVER_APPROACH * SCATTER_OF_APPROACH, 0.0),
    };
    HalfSpaceFigures {
        force,
        approach,
        peak_pressure: scatter * SCATTER,
        semi_axes: [SCATTER_OF_AXES; 2],
        area: 2.0 * SCATTER_OF_AXES,
        max_plastic_strain: [scatter * SCATTER; 2],
        dent: [scatter * SCATTER; 2],
        pile_up: [scatter * SCATTER; 2],
        least_stress: [scatter * SCATTER; 2],
    }
}

impl HalfSpaceFigures {
    fn values(&self) -> [f64; 14] {
        let Self { force, approach, peak_pressure, semi_axes: [a, b], area, .. } = *self;
        let [[e0, e1], [d0, d1], [p0, p1], [s0, s1]] =
            [self.max_plastic_strain, self.dent, self.pile_up, self.least_stress];
        [force, approach, peak_pressure, a, b, area, e0, e1, d0, d1, p0, p1, s0, s1]
    }

    fn of([force, approach, peak_pressure, a, b, area, e0, e1, d0, d1, p0, p1, s0, s1]: [f64; 14]) -> Self {
        Self {
            force,
            approach,
            peak_pressure,
            semi_axes: [a, b],
            area,
            max_plastic_strain: [e0, e1],
            dent: [d0, d1],
            pile_up: [p0, p1],
            least_stress: [s0, s1],
        }
    }
}
