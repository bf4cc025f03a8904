//! Stresses over depth below the middle of the contact, and below a peak pressure off the middle.

use super::SubsurfaceReport;
use crate::analytical::Stress;
use crate::fem::mesh::SurfaceFrame;
use crate::job::Quantity;
use crate::material::fatigue::largest_shear;
use crate::material::{HardeningLaw, Solid};
use crate::solver::half_spaces::{ColumnPoint, von_mises};
use crate::solver::{BodySolution, StepSolution, recovered, recovered_at_rest};
use crate::units::UnitConverter;

/// Returns whether the peak pressure lies off the middle and needs a profile of its own.
pub(super) fn is_beside_middle(step: &StepSolution) -> bool {
    (step.field.peak_position - step.field.middle).abs() > 0.5 * step.field.spacing
}

/// Returns the stresses along the normal to the surface at the abscissa `x` \[mm\], from the
/// surface to the support. The depths are the depths of the mesh nodes below the nearest candidate
/// node.
pub(super) fn profile(
    step: &StepSolution,
    body: &BodySolution,
    x: f64,
    write: UnitConverter,
) -> SubsurfaceReport {
    let mesh = &body.mesh;
    let mut recovery = recovered(step, body);
    let line = body.normal_line(x);
    let place = |node: u32| mesh.frame.place(mesh.nodes[node as usize]);
    let surface = line.first().map_or(0.0, |&node| place(node)[1]);
    let mut report =
        SubsurfaceReport { position: vec![write.length(x)], ..SubsurfaceReport::default() };
    let at_rest = body.at_rest();
    let mut recovery_at_rest = at_rest
        .as_ref()
        .map(|at_rest| recovered_at_rest(step.field.stress_state, step.field.symmetric, at_rest));
    let limit = body.model.hardening().map(HardeningLaw::nominal_yield_stress);
    let mut yield_stress: Vec<f64> = Vec::new();
    for node in line {
        let position = mesh.nodes[node as usize];
        // A node on the normal needs no interpolation. For a pin or a hole, the rays from the
        // centre are normals.
        let is_on_line = (place(node)[0] - x).abs() <= 1e-12 * mesh.zone.half_width()
            || mesh.frame != SurfaceFrame::Tangent;
        let values =
            if is_on_line { Some(recovery.node(node)) } else { recovery.at([x, position[1]]) };
        let Some([sigma_x, sigma_y, sigma_z, tau_xy, plastic_strain, _]) = values else {
            continue;
        };
        let stress =
            Stress { sigma_x, sigma_y, sigma_z, tau_xy }.along(mesh.frame.normal(position));
        let strength = body.model.strength(mesh.nodes[node as usize]);
        yield_stress.extend(limit.map(|limit| write.figure(Quantity::Stress, limit * strength)));
        if let Some(recovery) = &mut recovery_at_rest {
            let values =
                if is_on_line { Some(recovery.node(node)) } else { recovery.at([x, position[1]]) };
            let [sigma_x, sigma_y, sigma_z, tau_xy, ..] = values.unwrap_or_default();
            let stress =
                Stress { sigma_x, sigma_y, sigma_z, tau_xy }.along(mesh.frame.normal(position));
            for (column, value) in [
                (&mut report.initial_sigma_x, stress.sigma_x),
                (&mut report.initial_sigma_y, stress.sigma_y),
                (&mut report.initial_sigma_z, stress.sigma_z),
            ] {
                column.get_or_insert_default().push(write.figure(Quantity::Stress, value));
            }
        }
        report.depth.push(write.figure(Quantity::Length, place(node)[1] - surface));
        report.sigma_x.push(write.figure(Quantity::Stress, stress.sigma_x));
        report.sigma_y.push(write.figure(Quantity::Stress, stress.sigma_y));
        report.sigma_z.push(write.figure(Quantity::Stress, sigma_z));
        report.tau_max.push(write.figure(Quantity::Stress, stress.tau_max()));
        report.von_mises.push(write.figure(Quantity::Stress, stress.von_mises()));
        report.equivalent_plastic_strain.push(plastic_strain.max(0.0));
    }
    if body.model.varies_in_strength() && yield_stress.len() == report.depth.len() {
        let ratio = |(stress, limit): (&f64, &f64)| stress / limit;
        report.utilization = Some(report.von_mises.iter().zip(&yield_stress).map(ratio).collect());
        report.yield_stress = Some(yield_stress);
    }
    report
}

/// Returns the stresses over depth below a point of a half-space, of which a line has `[x]` and
/// not `[x, y]`. `orientation` is the angle from the x of the job \[rad\].
pub(super) fn below(
    material: Option<&Solid>,
    orientation: f64,
    position: Vec<f64>,
    points: &[ColumnPoint],
    write: UnitConverter,
) -> SubsurfaceReport {
    let column = |of: &dyn Fn(&ColumnPoint) -> f64| -> Vec<f64> {
        points.iter().map(|point| write.stress(of(point))).collect()
    };
    let [xx, yy, zz, xy, xz, yz] =
        std::array::from_fn(|k| column(&|point: &ColumnPoint| point.stress[k]));
    let hardening = material.and_then(|solid| solid.hardening_law().zip(solid.strength()));
    let limits = hardening.map(|(law, strength)| {
        let at = |point: &ColumnPoint| law.nominal_yield_stress() * strength.factor(point.depth);
        points.iter().map(at).collect::<Vec<f64>>()
    });
    let part = |(point, limit): (&ColumnPoint, &f64)| von_mises(point.stress) / limit;
    let initial = material.map(Solid::initial_stress).filter(|profile| !profile.is_empty());
    let (sine, cosine) = orientation.sin_cos();
    let before = |[of_x, of_y]: [f64; 2]| {
        let at = |point: &ColumnPoint| {
            let [x, y] = initial?.at(point.depth);
            Some(write.stress(of_x * x + of_y * y))
        };
        points.iter().map(at).collect::<Option<Vec<f64>>>().filter(|_| initial.is_some())
    };
    let is_whole = position.len() > 1;
    let whole = |stress: &Vec<f64>| is_whole.then(|| stress.clone());
    SubsurfaceReport {
        position,
        depth: points.iter().map(|point| write.length(point.depth)).collect(),
        sigma_xx: whole(&xx),
        sigma_yy: whole(&yy),
        sigma_zz: whole(&zz),
        sigma_xy: whole(&xy),
        sigma_xz: whole(&xz),
        sigma_yz: whole(&yz),
        sigma_x: xx,
        sigma_y: zz,
        sigma_z: yy,
        tau_max: column(&|point| largest_shear(&point.stress)),
        von_mises: column(&|point| von_mises(point.stress)),
        equivalent_plastic_strain: points
            .iter()
            .map(|point| point.equivalent_plastic_strain)
            .collect(),
        utilization: limits.as_ref().map(|limits| points.iter().zip(limits).map(part).collect()),
        yield_stress: limits
            .map(|limits| limits.iter().map(|limit| write.stress(*limit)).collect()),
        initial_sigma_x: before([cosine * cosine, sine * sine]),
        initial_sigma_y: before([0.0; 2]),
        initial_sigma_z: before([sine * sine, cosine * cosine]),
    }
}
