//! Findings on strength that varies with depth.

use std::sync::Arc;

use super::findings::{CasePlace, Finding};
use crate::analytical::von_mises;
use crate::fem::assembly::GaussPoint;
use crate::job::{Body, Job, MeshSettings};
use crate::material::HardeningLaw;
use crate::solver::{BodySolution, StepSolution};

/// Ratio of largest to smallest strength within one element above which the mesh is called coarse.
pub(super) const COARSE_RATIO: f64 = 1.1;
/// Stress over strength below which a change of strength within an element is harmless.
pub(super) const IDLE: f64 = 0.5;

/// Returns the findings on strength.
pub(super) fn findings(job: &Job, step: &StepSolution) -> Vec<Finding> {
    let mut findings: Vec<Finding> = by_hardness(job).into_iter().collect();
    let utilized = step.field.bodies.iter().flatten().filter_map(initial_utilization);
    let ratio = utilized.max_by(f64::total_cmp).filter(|ratio| *ratio > 1.0);
    findings.extend(ratio.map(|ratio| Finding::InitialYield { ratio }));
    let coarse = [0, 1].map(|side| step.field.bodies[side].as_deref().and_then(coarsest));
    if let Some((ratio, place)) =
        coarse.iter().flatten().max_by(|a, b| a.0.total_cmp(&b.0)).copied()
    {
        let elements = f64::from(job.mesh.elements_per_half_width);
        findings.push(Finding::CoarseCase {
            change: ratio - 1.0,
            place: CasePlace::Element(place),
            wanted: wanted(elements, ratio, MeshSettings::MAX_ELEMENTS_PER_HALF_WIDTH),
            bodies: coarse.map(|found| found.is_some()),
        });
    }
    findings
}

/// Returns the density at which the strength changes little within an element, if it changes by
/// `ratio` at the density `asked`.
pub(super) fn wanted(asked: f64, ratio: f64, most: u32) -> f64 {
    (asked * ratio.ln() / COARSE_RATIO.ln()).ceil().min(f64::from(most))
}

/// Returns the finding on a yield stress that follows from hardness.
pub(super) fn by_hardness(job: &Job) -> Option<Finding> {
    let rule = |body: &Body| body.deformable()?.over_depth.as_ref()?.rule();
    job.bodies().into_iter().find_map(rule).map(|_| Finding::YieldByHardness)
}

/// Returns the largest ratio of von Mises stress to yield stress before the load.
fn initial_utilization(body: &Arc<BodySolution>) -> Option<f64> {
    let limit = body.model.hardening().map(HardeningLaw::nominal_yield_stress)?;
    let at_rest = body.at_rest()?;
    let ratios = at_rest.stress.points.iter().map(|points| {
        let mean = GaussPoint::mean(points);
        von_mises(mean.stress) / (limit * body.model.strength(mean.position))
    });
    ratios.max_by(f64::total_cmp)
}

/// Returns the largest ratio of strengths within a stressed element, and the middle of that
/// element.
fn coarsest(body: &BodySolution) -> Option<(f64, [f64; 2])> {
    if !body.model.varies_in_strength() {
        return None;
    }
    let limit = body.model.hardening().map(HardeningLaw::nominal_yield_stress)?;
    let strength: Vec<f64> =
        body.mesh.nodes.iter().map(|&node| body.model.strength(node)).collect();
    let mut worst = (COARSE_RATIO, None);
    for (nodes, points) in body.mesh.elements.iter().zip(&body.stress.points) {
        let (least, greatest) = nodes
            .iter()
            .map(|&node| strength[node as usize])
            .fold((f64::INFINITY, 0.0), |(least, greatest), s| {
                (f64::min(least, s), f64::max(greatest, s))
            });
        if greatest > worst.0 * least {
            let mean = GaussPoint::mean(points);
            if von_mises(mean.stress) > IDLE * limit * least {
                worst = (greatest / least, Some(mean.position));
            }
        }
    }
    Some((worst.0, worst.1?))
}
