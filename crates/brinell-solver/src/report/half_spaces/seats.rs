//! Onset of yield below a concave surface.

use crate::inputs::along_axes;
use crate::job::{Body, Job};
use crate::solver::half_spaces::HalfSpaceStep;

/// Relative fall of the force at the onset of yield of a concave body for each half-width over its
/// radius, in place of a half-space: of one that is concave along its shorter semi-axis alone, as
/// the seat of a roller, and of others.
///
/// Elements in axisymmetry and plane strain, 40 over the half-width, balls and rollers of 5 mm in
/// seats of 6 and 10 mm: 1.36 to 1.50 at half-widths of 0.01 to 0.25 of the seat's radius, 2.14 to
/// 1.80 at 0.014 to 0.078.
const OF_ROLLER_SEAT: f64 = 2.2;
const OF_SEAT: f64 = 1.5;

/// Returns the relative error of the force at the onset of yield by the curvature of concave
/// bodies that yield: by the shorter semi-axis over the radius.
pub(super) fn error_of_onset(job: &Job, angle: f64, step: &HalfSpaceStep) -> f64 {
    let [a, b] = step.figures.semi_axes();
    let of_body = |body: &Body| {
        let yields = body.deformable().is_some_and(|material| material.plasticity.is_some());
        let curvatures = body.shape.curvatures().filter(|_| yields)?;
        let [across, along] = along_axes(curvatures, angle).map(|k| (-k).max(0.0));
        Some((OF_SEAT * across.max(along)).max(if along > 0.0 {
            0.0
        } else {
            OF_ROLLER_SEAT * across
        }))
    };
    let bodies = job.bodies().into_iter();
    a.min(b) * bodies.filter_map(of_body).fold(0.0, f64::max)
}
