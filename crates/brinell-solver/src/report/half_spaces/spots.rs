//! The spots in which heights touch.
//!
//! A spot is a set of cells in contact that share sides or corners. Its figures are those of a
//! smooth summit where it has cells enough, its surface falls gently beside it, and the pressure
//! on it is one that the bodies bear.

use crate::report::findings::Finding;
use crate::solver::half_spaces::{HalfSpaceProblem, HalfSpaceStep, SurfaceMap};

/// Cells over the shorter semi-axis below which a grid is called coarse, and over the half-width of a
/// spot of their area below which no figure has a bar. Nine balls that yield have approaches 8, 5 and
/// 3 % too small with 3, 4 and 5 cells.
pub(super) const FEW_CELLS: f64 = 5.0;
/// Part of the force on spots from which it counts.
const SHARE: f64 = 0.05;
/// Fall of the surface beside a spot over the depth to which the spot is pressed in, from which it
/// is a step. A ball of 5 cells falls by half of its depth from one cell to the next, one of more
/// cells by less.
const STEP: f64 = 1.0;
/// Largest pressure over the flow stress. A square punch carries 3.3 on average (5.71 k), a ball
/// has a peak of 3.0; more is a rise at single cells.
///
/// # Reference
/// R. T. Shield, D. C. Drucker, *The application of limit analysis to punch-indentation problems*,
/// J. Appl. Mech. 20 (1953) 453–460.
const BEARABLE: f64 = 4.0;
/// Error of the approach of a spot that yields, times the square of the cells over its half-width.
const OF_CELLS: f64 = 0.8;
/// Part of the surface in contact from which spots confine each other, and bear more.
const APART: f64 = 0.3;

/// Cells in contact that belong together.
struct Spot {
    cells: Vec<usize>,
    force: f64,
}

/// Returns the findings on a contact of heights.
pub(super) fn findings(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Vec<Finding> {
    if problem.heights.is_none() || step.figures.force <= 0.0 {
        return Vec::new();
    }
    let map = &step.field.surface;
    let spots = spots(map);
    let all: f64 = spots.iter().map(|spot| spot.force).sum();
    let share = |is_one: &dyn Fn(&Spot) -> bool| {
        spots.iter().filter(|spot| is_one(spot)).map(|spot| spot.force / all).sum::<f64>()
    };
    let mut findings = Vec::new();
    let part = share(&|spot| spot.half_width() < FEW_CELLS);
    if part >= SHARE && !step.is_preliminary {
        let number = typical(&spots);
        findings.push(Finding::SpotsOfFewCells { number, part });
    }
    let gap = problem.gap(&map.grid);
    let part = share(&|spot| spot.ends_at_step(map, &gap, step.figures.approach));
    if part >= SHARE {
        findings.push(Finding::StepsOfHeights { part });
    }
    if let Some(bearable) = unbearable(problem, step) {
        let pressure = step.figures.peak_pressure;
        findings.push(Finding::UnbearablePressure { pressure, bearable });
    }
    findings
}

/// Returns the largest pressure that the softer body bears, where the peak pressure of heights is
/// above it \[MPa\].
pub(super) fn unbearable(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Option<f64> {
    problem.heights.as_ref()?;
    let map = &step.field.surface;
    let touching = map.pressure.iter().filter(|pressure| **pressure > 0.0).count();
    if touching as f64 > APART * map.grid.n_cells() as f64 {
        return None;
    }
    let bearable = BEARABLE * flow_stress(problem, step)?;
    (step.figures.peak_pressure > bearable).then_some(bearable)
}

/// Returns the flow stress of the softer body at the largest strain that it has \[MPa\]; `None`
/// where a body of backstress yields, and where none does.
fn flow_stress(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> Option<f64> {
    let of_body = |side: usize| {
        let material = problem.materials[side].as_ref()?;
        let (law, strain) =
            (material.hardening_law()?, step.figures.bodies[side]?.max_plastic_strain);
        let strongest = material.strength().map_or(1.0, |strength| strength.range().1);
        (strain > 0.0 && material.backstress().is_empty())
            .then(|| strongest * law.stress(strain).max(law.nominal_yield_stress()))
    };
    [0, 1].into_iter().filter_map(of_body).reduce(f64::min)
}

/// Returns the relative error of the approach of heights that yield, under a force, or of the
/// force under an approach, that half the cells do not show: spots of few cells bear a load at too
/// small an approach.
///
/// Nine balls that yield, against 8 cells and the limit of more: 8, 5, 3 and 1 % with 3, 4, 5 and 8
/// cells over half of a spot.
pub(super) fn error_of_approach(problem: &HalfSpaceProblem, step: &HalfSpaceStep) -> f64 {
    let yields = step.figures.bodies.iter().flatten().any(|body| body.max_plastic_strain > 0.0);
    if problem.heights.is_none() || step.figures.force <= 0.0 || !yields {
        return 0.0;
    }
    OF_CELLS / typical(&spots(&step.field.surface)).max(1.0).powi(2)
}

/// Returns the half-width in cells of the spots that bear half of the force, largest first.
fn typical(spots: &[Spot]) -> f64 {
    let all: f64 = spots.iter().map(|spot| spot.force).sum();
    let mut sorted: Vec<&Spot> = spots.iter().collect();
    sorted.sort_by_key(|spot| std::cmp::Reverse(spot.cells.len()));
    let mut borne = 0.0;
    for spot in &sorted {
        borne += spot.force;
        if borne >= 0.5 * all {
            return spot.half_width();
        }
    }
    0.0
}

impl Spot {
    /// Radius of a circle with as many cells.
    fn half_width(&self) -> f64 {
        (self.cells.len() as f64 / std::f64::consts::PI).sqrt()
    }

    /// Whether the surface beside a cell of the spot falls by more than the spot is pressed in.
    fn ends_at_step(&self, map: &SurfaceMap, gap: &[f64], approach: f64) -> bool {
        let lowest = self.cells.iter().map(|cell| gap[*cell]).fold(f64::INFINITY, f64::min);
        let depth = STEP * (approach - lowest);
        self.cells.iter().any(|cell| {
            let mut beside = beside(map, *cell, false);
            beside.any(|next| map.pressure[next] <= 0.0 && gap[next] - gap[*cell] > depth)
        })
    }
}

/// Returns the spots of a map.
fn spots(map: &SurfaceMap) -> Vec<Spot> {
    let mut is_free: Vec<bool> = map.pressure.iter().map(|pressure| *pressure > 0.0).collect();
    let mut spots = Vec::new();
    for first in 0..is_free.len() {
        if !std::mem::replace(&mut is_free[first], false) {
            continue;
        }
        let (mut cells, mut next) = (vec![first], 0);
        while let Some(cell) = cells.get(next).copied() {
            next += 1;
            for beside in beside(map, cell, true) {
                if std::mem::replace(&mut is_free[beside], false) {
                    cells.push(beside);
                }
            }
        }
        let force = cells.iter().map(|cell| map.pressure[*cell]).sum();
        spots.push(Spot { cells, force });
    }
    spots
}

/// Returns the cells that share a side with a cell, or a corner too.
fn beside(map: &SurfaceMap, cell: usize, corners: bool) -> impl Iterator<Item = usize> {
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let (i, j) = (cell / ny, cell % ny);
    let around = (0..9_usize).map(|k| (k / 3, k % 3)).filter(move |(di, dj)| {
        let steps = di.abs_diff(1) + dj.abs_diff(1);
        steps == 1 || corners && steps == 2
    });
    around.filter_map(move |(di, dj)| {
        let (i, j) = ((i + di).checked_sub(1)?, (j + dj).checked_sub(1)?);
        (i < nx && j < ny).then_some(i * ny + j)
    })
}

#[cfg(test)]
mod tests {
    use brinell_halfspace::SurfaceGrid;

    use super::*;

    fn map(rows: &[&str]) -> SurfaceMap {
        let (nx, ny) = (rows.len(), rows[0].len());
        let grid = SurfaceGrid::new(nx, ny, 0.1, 0.1).unwrap();
        let pressure = rows.concat().bytes().map(|c| f64::from(c - b'0')).collect();
        SurfaceMap { grid, pressure, gap: vec![0.0; nx * ny] }
    }

    #[test]
    fn cells_that_share_a_corner_are_one_spot() {
        let map = map(&["1002", "0100", "0001", "3001"]);
        let mut found: Vec<_> =
            spots(&map).iter().map(|spot| (spot.cells.len(), spot.force)).collect();
        found.sort_by(|a, b| a.1.total_cmp(&b.1));
        assert_eq!(found, [(2, 2.0), (1, 2.0), (2, 2.0), (1, 3.0)]);
    }

    #[test]
    fn a_fall_deeper_than_the_spot_is_pressed_in_is_a_step() {
        let map = map(&["0000", "0110", "0110", "0000"]);
        let spot = &spots(&map)[0];
        let of = |fall: f64| -> Vec<f64> {
            map.pressure.iter().map(|p| if *p > 0.0 { 0.0 } else { fall }).collect()
        };
        assert!(spot.ends_at_step(&map, &of(0.3), 0.2));
        assert!(!spot.ends_at_step(&map, &of(0.1), 0.2));
        assert!((spot.half_width() - (4.0 / std::f64::consts::PI).sqrt()).abs() < 1e-15);
    }
}
