//! Fatigue of bodies over which a load rolls: the pass after the last one, which is elastic where a
//! body has shaken down.

use brinell_material::fatigue::{Criterion, hydrostatic};

use crate::track::{Outlet, SteadyState, TrackGrid};
use crate::{Fatigue, Layers, Passing, Stop, Stopped};

use super::errors::error_of;
use super::pass::Pass;
use super::problem::{RollingProblem, initial_stress};

/// A pass, its pressure in the cells of the window \[MPa\], and the layers below.
pub(super) struct Passed<'a> {
    pub pass: &'a Pass,
    pub grid: TrackGrid,
    pub layers: Layers,
    pub pressure: &'a [f64],
}

/// The fatigue of each body after a pass; `None` of a body that is rigid, without limits, or not
/// known to have shaken down. `beside` are that pass on half the columns of two tracks, where there
/// is one, by which errors are estimated.
///
/// # Errors
/// [`Stopped`].
pub(super) fn fatigue(
    problem: &RollingProblem,
    verdicts: &[Option<SteadyState>; 2],
    fine: &Passed<'_>,
    beside: Option<&[Passed<'_>; 2]>,
    stop: &mut Stop<'_>,
) -> Result<[Option<Fatigue>; 2], Stopped> {
    let mut found = [None, None];
    for (side, found) in found.iter_mut().enumerate() {
        let remaining = match verdicts[side] {
            None | Some(SteadyState::Elastic) => 0.0,
            Some(SteadyState::ShakesDown { remaining }) => remaining,
            Some(_) => continue,
        };
        let Some(mut fatigue) = of_body(problem, side, fine, stop)? else { continue };
        if let Some([coarse, long]) = beside {
            let coarse = of_body(problem, side, coarse, stop)?;
            let long = of_body(problem, side, long, stop)?;
            if let Some((coarse, long)) = coarse.zip(long) {
                estimate_errors(problem, side, &mut fatigue, [&coarse, &long], remaining);
            }
        }
        *found = Some(fatigue);
    }
    Ok(found)
}

/// A strain that is still to come changes the residual stress by about E times it.
fn estimate_errors(
    problem: &RollingProblem,
    side: usize,
    fine: &mut Fatigue,
    [coarse, long]: [&Fatigue; 2],
    remaining: f64,
) {
    let Some(material) = &problem.materials[side] else { return };
    let Some(strength) = material.fatigue() else { return };
    let beside = coarse.largest().into_iter().zip(long.largest());
    let all = fine.criteria.iter_mut().zip(beside).zip(Criterion::ALL);
    for ((criterion, (coarse, long)), name) in all {
        let Some((criterion, (coarse, long))) = criterion.as_mut().zip(coarse.zip(long)) else {
            continue;
        };
        let weight = strength.limits().weight(name).unwrap_or(0.0);
        let to_come = weight * material.elastic().young_modulus * remaining
            / strength.torsion(criterion.largest.depth);
        let figures = [criterion.largest.value, coarse, long];
        criterion.error = Some(error_of(figures, problem.columns) + to_come);
    }
}

fn of_body(
    problem: &RollingProblem,
    side: usize,
    Passed { pass, grid, layers, pressure }: &Passed<'_>,
    stop: &mut Stop<'_>,
) -> Result<Option<Fatigue>, Stopped> {
    let Some(material) = &problem.materials[side] else { return Ok(None) };
    let poisson = material.elastic().poisson_ratio;
    let passing = if problem.is_line() {
        Passing::line(pressure, grid.column(), poisson)
    } else {
        grid.surface().ok().and_then(|cells| Passing::area(pressure, &cells, poisson))
    };
    let Some((strength, passing)) = material.fatigue().zip(passing) else { return Ok(None) };
    let depths = layers.faces_and_middles();
    let outlet = pass.bodies[side].as_ref().map(|body| &body.outlet);
    let initial = initial_stress(material, layers);
    let at_rest = |depth: f64, y: f64| {
        let layer = layers.at(depth);
        outlet.map_or_else(
            || hydrostatic(&[initial[layer][0], initial[layer][1], 0.0, 0.0, 0.0, 0.0]),
            |outlet| hydrostatic(&outlet.residual[place(outlet, layer, y)]),
        )
    };
    let friction = problem.frictions()[side];
    let found = Fatigue::of(&passing, friction, strength, depths, at_rest, stop)?;
    found.beside(problem.hertz(poisson).as_ref(), friction, strength, stop).map(Some)
}

/// The row of a layer that is nearest to a y.
fn place(outlet: &Outlet, layer: usize, y: f64) -> usize {
    let rows = outlet.across.len().max(1);
    let from = |row: usize| outlet.across.get(row).map_or(0.0, |of| (of - y.abs()).abs());
    let nearest = (0..rows).min_by(|a, b| from(*a).total_cmp(&from(*b))).unwrap_or(0);
    layer * rows + nearest
}
