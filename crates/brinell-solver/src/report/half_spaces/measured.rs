//! Figures of contacts in three dimensions that only answers and verdict have.

use super::findings::reaches_rim;
use crate::job::{Job, Load};
use crate::material::fatigue::largest_principal;
use crate::report::answers::{Largest, Measured};
use crate::report::findings::Finding;
use crate::report::measured::{case_depth, largest_in};
use crate::solver::half_spaces::{
    EllipticReference, HalfSpaceBody, HalfSpaceProblem, HalfSpaceStep, SurfaceMap, von_mises,
};

/// Measures what the report of a load step does not have.
pub(super) fn measured(
    job: &Job,
    problem: &HalfSpaceProblem,
    reference: &EllipticReference,
    step: &HalfSpaceStep,
    findings: &[Finding],
) -> Measured {
    let radius = reference.effective_radius();
    let is_smooth = problem.heights.is_none();
    let at_rest = Measured {
        effective_radius: Some(radius).filter(|radius| is_smooth && radius.is_finite()),
        points: "cells",
        ..Measured::default()
    };
    if step.status.is_stopped() {
        return at_rest;
    }
    let (force, bodies) = (step.figures.force, &step.field.bodies);
    let core = largest_in(bodies, |side, body| core(job, side, body));
    if force <= 0.0 {
        return Measured { core, tension: largest_in(bodies, tension), ..at_rest };
    }
    let is_sought = job.load == Load::Onset;
    let closed = || {
        let used = reference.utilization(force).filter(|_| is_smooth)?;
        let (value, depth, side) = used;
        Some(Largest { value, side, place: [0.0, 0.0, depth] })
    };
    let is_elastic = bodies.iter().flatten().all(|body| body.largest_strain.is_none());
    let at_end = findings.iter().any(|finding| {
        matches!(finding, Finding::RollerEnd { .. } | Finding::Kinks | Finding::SurfaceEnd)
    });
    let of_field = || {
        let found = problem.highest_utilization(step).filter(|_| is_elastic && is_smooth)?;
        Some(Largest { value: found.ratio, side: found.side, place: found.position })
    };
    let first_yield = if is_sought { Some(force) } else { reference.onset_force() };
    let closed = closed();
    Measured {
        is_of_field: closed.is_none(),
        utilization: closed.or_else(of_field).filter(|_| !at_end),
        first_yield: first_yield.filter(|_| is_smooth && (is_sought || !at_end)),
        core,
        bearable: super::spots::unbearable(problem, step),
        inside_rim: if is_smooth { None } else { inside_rim(&step.field.surface) },
        ..at_rest
    }
}

/// Returns the largest value of all cells in layers from a depth on \[mm\].
fn largest_below(
    (side, body): (usize, &HalfSpaceBody),
    from: f64,
    value: impl Fn([f64; 6], f64) -> f64,
) -> Option<Largest> {
    let (n_cells, ny) = (body.grid.n_cells(), body.grid.ny());
    let layers = (0..body.layers.len()).filter(|layer| body.layers.middle(*layer) >= from);
    let cells = layers.flat_map(|layer| (0..n_cells).map(move |cell| (layer, cell)));
    let values = cells.map(|(layer, cell)| {
        let stress = std::array::from_fn(|k| body.stress.component(layer, k)[cell]);
        (value(stress, body.layers.middle(layer)), layer, cell)
    });
    let (value, layer, cell) = values.max_by(|a, b| a.0.total_cmp(&b.0))?;
    let place = [body.grid.x(cell / ny), body.grid.y(cell % ny), body.layers.middle(layer)];
    Some(Largest { value, side, place })
}

/// Returns the largest principal stress of all cells.
fn tension(side: usize, body: &HalfSpaceBody) -> Option<Largest> {
    largest_below((side, body), 0.0, |stress, _| largest_principal(&stress))
}

/// Returns the largest von Mises stress over the yield stress below a hardened case.
fn core(job: &Job, side: usize, body: &HalfSpaceBody) -> Option<Largest> {
    let material = job.bodies()[side].deformable()?;
    let limit = material.hardening_law()?.nominal_yield_stress();
    let strength = material.strength()?;
    largest_below((side, body), case_depth(job, side)?, |stress, depth| {
        von_mises(stress) / (limit * strength.factor(depth))
    })
}

/// Returns the largest pressure of a cell beside the rim of heights, and its place, where the
/// contact reaches the rim.
fn inside_rim(map: &SurfaceMap) -> Option<(f64, [f64; 2])> {
    if !reaches_rim(map) {
        return None;
    }
    let (nx, ny) = (map.grid.nx(), map.grid.ny());
    let inside = (1..nx - 1).flat_map(|i| (1..ny - 1).map(move |j| (i, j)));
    let most = inside.map(|(i, j)| (map.pressure[i * ny + j], [map.grid.x(i), map.grid.y(j)]));
    most.max_by(|a, b| a.0.total_cmp(&b.0))
}
