//! Fatigue under a contact of meshed bodies, as if its pressure passed over half-spaces.
//!
//! Loads that roll have it in their field
//! ([`TrackField::fatigue`](crate::solver::rolling::TrackField::fatigue)), half-spaces by a function
//! of theirs ([`HalfSpaceField::fatigue`](crate::solver::half_spaces::HalfSpaceField::fatigue)).

use brinell_halfspace::{Fatigue, Passing, Stop, Stopped, SurfaceGrid};

use crate::fem::element::StressState;
use crate::material::Solid;
use crate::material::fatigue::hydrostatic;
use crate::solver::{ElasticReference, Problem, StepSolution};

/// Strips over half the width of a line, and cells over the radius of a circle.
const STRIPS: usize = 40;
const CELLS: usize = 20;

/// Part of the half-width beyond which a largest pressure is that of an edge. Below a ball at 2.3
/// times the limit of shakedown the pressure is largest at 0.6 of it, below flat punches whose rounded
/// corners are as narrow as a step of depth at 0.95 and beyond.
const EDGE: f64 = 0.8;

/// Why a contact is not one smooth contact, on which widths of strips and depths rest.
pub fn not_smooth(parts: usize, peak: f64, [left, right]: [f64; 2]) -> Option<&'static str> {
    if parts > 1 {
        return Some("the contact has several parts");
    }
    let is_at_edge = (2.0 * peak - left - right).abs() > EDGE * (right - left);
    is_at_edge.then_some("the largest pressure stands at the edge of the contact")
}

/// The fatigue of a body (0 for the upper one) under one elastic pass of the pressure of a load
/// step over [one smooth contact](not_smooth); `None` of a body that is rigid or without limits,
/// and without contact.
///
/// The body counts as a half-plane, under a contact of revolution as a half-space. The stress that
/// stands still is the initial stress alone: what yield leaves in a meshed body is known after
/// unloading only.
///
/// # Errors
/// [`Stopped`].
pub fn of_section(
    step: &StepSolution,
    problem: &Problem,
    side: usize,
    stop: &mut Stop<'_>,
) -> Result<Option<Fatigue>, Stopped> {
    let Some(material) = &problem.bodies[side].material else { return Ok(None) };
    let asked = material.fatigue().zip(passing(step, material));
    let Some((strength, (passing, half_width))) = asked else { return Ok(None) };
    let profile = material.initial_stress();
    let initial = |depth: f64, _: f64| {
        let [along, across] = profile.at(depth);
        hydrostatic(&[along, across, 0.0, 0.0, 0.0, 0.0])
    };
    // Three half-widths, in steps of a cell.
    let depths = (0..=3 * CELLS).map(|k| k as f64 * half_width / CELLS as f64).collect();
    let found = Fatigue::of(&passing, 0.0, strength, depths, initial, stop)?;
    found.beside(hertz(step, problem, material).as_ref(), 0.0, strength, stop).map(Some)
}

/// Hertz's contact of the same force.
fn hertz(step: &StepSolution, problem: &Problem, material: &Solid) -> Option<Passing> {
    let hertz = ElasticReference::of(problem, step.figures.force)?;
    let state = step.field.stress_state;
    let passing = if state == StressState::Axisymmetric {
        let poisson = material.elastic().poisson_ratio;
        Passing::hertz_ellipse([hertz.half_width; 2], [CELLS; 2], poisson)
    } else {
        Passing::hertz_line(hertz.half_width, STRIPS, out_of_plane(state, material))
    };
    Some(passing?.times(hertz.peak_pressure))
}

/// The pressure of a load step in cells that carry its force, with half its width \[mm\].
fn passing(step: &StepSolution, material: &Solid) -> Option<(Passing, f64)> {
    let field = &step.field;
    let half_width = field.patch.filter(|_| step.figures.force > 0.0)?.half_width();
    let at = |x: f64| {
        let x = if field.symmetric { x.abs() } else { field.middle + x };
        pressure_at(step, x)
    };
    let passing = if field.stress_state == StressState::Axisymmetric {
        let side = half_width / CELLS as f64;
        let grid = SurfaceGrid::new(2 * CELLS, 2 * CELLS, side, side).ok()?;
        let pressure =
            grid.sample(|x, y| if x.hypot(y) < half_width { at(x.hypot(y)) } else { 0.0 });
        Passing::area(&pressure, &grid, material.elastic().poisson_ratio)?
    } else {
        let h = half_width / STRIPS as f64;
        let place = |k: usize| (k as f64 + 0.5) * h - half_width;
        let pressure: Vec<f64> = (0..2 * STRIPS).map(|k| at(place(k))).collect();
        Passing::line(&pressure, h, out_of_plane(field.stress_state, material))?
    };
    Some((passing.carrying(step.figures.force), half_width))
}

/// The pressure at an abscissa, straight between the pairs \[MPa\].
fn pressure_at(step: &StepSolution, x: f64) -> f64 {
    let pairs = &step.field.pairs;
    let right = pairs.partition_point(|pair| pair.x <= x);
    let neighbours = (right.checked_sub(1).and_then(|left| pairs.get(left)), pairs.get(right));
    match neighbours {
        (Some(left), Some(right)) => {
            let part = (x - left.x) / (right.x - left.x);
            left.pressure + part * (right.pressure - left.pressure)
        }
        (Some(only), None) | (None, Some(only)) => only.pressure,
        (None, None) => 0.0,
    }
}

/// The stress out of the section over the sum of both in it.
fn out_of_plane(state: StressState, material: &Solid) -> f64 {
    if state == StressState::PlaneStress { 0.0 } else { material.elastic().poisson_ratio }
}
