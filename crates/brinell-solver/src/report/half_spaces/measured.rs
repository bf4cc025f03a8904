//! Figures of contacts in three dimensions that only answers and verdict have.

use std::f64::consts::FRAC_PI_3;

use super::findings::reaches_rim;
use crate::job::{Deformable, Job, Load, Material};
use crate::report::answers::{Largest, Measured};
use crate::report::findings::Finding;
use crate::report::measured::case_depth;
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
    let force = step.figures.force;
    let core = largest_in(step, |side, body| core(job, side, body));
    if force <= 0.0 {
        return Measured { core, tension: largest_in(step, tension), ..at_rest };
    }
    let is_sought = job.load == Load::Onset;
    let closed = || {
        let used = reference.utilization(force).filter(|_| is_smooth)?;
        let (value, depth, side) = used;
        Some(Largest { value, side, place: [0.0, 0.0, depth] })
    };
    let is_elastic = step.field.bodies.iter().flatten().all(|body| body.largest_strain.is_none());
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

/// Returns the largest of both bodies; of two alike the lower one.
fn largest_in(
    step: &HalfSpaceStep,
    of: impl Fn(usize, &HalfSpaceBody) -> Option<Largest>,
) -> Option<Largest> {
    let bodies = step.field.bodies.iter().enumerate();
    let found = bodies.filter_map(|(side, body)| of(side, body.as_ref()?));
    found.max_by(|a, b| a.value.total_cmp(&b.value))
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
    largest_below((side, body), 0.0, |stress, _| largest_principal(stress))
}

/// Returns the largest principal stress, from the Lode angle.
fn largest_principal(stress: [f64; 6]) -> f64 {
    let [xx, yy, zz, xy, xz, yz] = stress;
    let mean = (xx + yy + zz) / 3.0;
    let equivalent = von_mises(stress);
    if equivalent == 0.0 {
        return mean;
    }
    let [x, y, z] = [xx - mean, yy - mean, zz - mean];
    let third = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
    let angle = (13.5 * third / equivalent.powi(3)).clamp(-1.0, 1.0).acos() / 3.0;
    debug_assert!((0.0..=FRAC_PI_3 + 1e-9).contains(&angle));
    mean + 2.0 / 3.0 * equivalent * angle.cos()
}

/// Returns the largest von Mises stress over the yield stress below a hardened case.
fn core(job: &Job, side: usize, body: &HalfSpaceBody) -> Option<Largest> {
    let material: &Deformable = match &[&job.upper, &job.lower][side].material {
        Material::Deformable(material) => material,
        Material::Rigid => return None,
    };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_principal_stress_follows_from_the_lode_angle() {
        for (stress, expected) in [
            ([300.0, 100.0, -500.0, 0.0, 0.0, 0.0], 300.0),
            ([0.0, 0.0, 0.0, 70.0, 0.0, 0.0], 70.0),
            ([-5.0, -5.0, -5.0, 0.0, 0.0, 0.0], -5.0),
            // Principal stresses 100, 40 and -150.
            ([40.0, -60.0, 10.0, 0.0, 0.0, 120.0], 100.0),
        ] {
            let found = largest_principal(stress);
            assert!((found - expected).abs() < 1e-6, "{stress:?} {found}");
        }
    }
}
