//! The largest plastic strain: whether it is independent of the mesh, and whether the hardening
//! curve of the material is accurate enough for it.

use super::findings::Finding;
use crate::job::{Body, Hardening, Job, Load, TargetFigure};
use crate::solver::StepSolution;

/// Plastic strain below which a bilinear curve represents a real material badly.
const SMALL_STRAIN: f64 = 0.01;

/// Returns the findings on plastic strain.
pub(super) fn findings(job: &Job, step: &StepSolution) -> Vec<Finding> {
    let bodies = [0, 1].map(|side| {
        step.field.bodies[side]
            .as_deref()
            .is_some_and(|body| body.bounded_plastic_strain().is_none())
    });
    let unbounded = bodies.contains(&true).then_some(Finding::UnboundedStrain { bodies });
    let at_ends = step.field.bodies.each_ref().map(|body| {
        body.as_ref().filter(|body| body.bounded_plastic_strain().is_some()).and_then(|body| {
            let (inside, most) = (body.strain_inside(), body.max_plastic_strain());
            (most > inside).then_some(most)
        })
    });
    let at_ends = at_ends.into_iter().flatten().reduce(f64::max);
    let at_ends = at_ends.map(|strain| Finding::StrainAtEnds { strain });
    let strain = step
        .field
        .bodies
        .iter()
        .flatten()
        .map(|body| body.max_plastic_strain())
        .fold(0.0, f64::max);
    unbounded.into_iter().chain(at_ends).chain(bilinear_curve(job, strain)).collect()
}

/// Returns the finding on a small permanent deformation that is computed with a bilinear curve.
pub(super) fn bilinear_curve(job: &Job, strain: f64) -> Option<Finding> {
    let is_permanent = match &job.load {
        Load::Target(target) => {
            target.figure.is_permanent() || target.figure == TargetFigure::MaxPlasticStrain
        }
        _ => false,
    };
    let mut materials = job.bodies().into_iter().filter_map(Body::deformable);
    let has_bilinear =
        materials.any(|material| matches!(material.plasticity, Some(Hardening::Bilinear(_))));
    (is_permanent && has_bilinear && strain < SMALL_STRAIN).then_some(Finding::BilinearCurve)
}
