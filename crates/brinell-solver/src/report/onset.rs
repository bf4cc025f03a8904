//! The onset of yield: position and force.

use super::findings::{Finding, OnsetUnknown};
use super::known::Onset;
use super::mesh_effects::{peak_is_next_to_end, peak_is_unbounded};
use crate::contact::ContactLoad;
use crate::job::{Job, Load, Shape};
use crate::solver::{
    EDGE_UTILIZATION, Problem, StepSolution, at_narrow_edge, highest_utilization,
};

/// Largest relative error at which the closed form gives the onset at a rounded edge.
const KNOWN: f64 = 0.15;

/// Returns the reason why elastic bodies yield under a smaller force than the mesh of a load step
/// shows. Returns `None` if the mesh resolves the onset, or if a body has yielded.
pub(super) fn why_unknown(job: &Job, problem: &Problem, step: &StepSolution) -> Option<Finding> {
    if step.field.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0) {
        return None;
    }
    let is_sought = job.load == Load::Onset;
    let cause = cause((job, problem), step, is_sought)?;
    Some(Finding::OnsetUnknown { cause, is_sought })
}

fn cause(
    (job, problem): (&Job, &Problem),
    step: &StepSolution,
    is_sought: bool,
) -> Option<OnsetUnknown> {
    let spacing = step.field.spacing;
    if let Some(edge) = &step.field.rounded_edge {
        if is_sought && step.search.force_error.is_some_and(|error| error <= KNOWN) {
            return None;
        }
        let used = at_narrow_edge(step, problem)?.ratio;
        if !is_sought && used <= 1.0 {
            return None;
        }
        let force = step.figures.force / used.powf(EDGE_UTILIZATION.recip());
        return Some(OnsetUnknown::AtEdge { width: edge.elastic.width(), spacing, force });
    }
    // Elements that resolve the edge of a punch find the peak pressure on the edge.
    let is_punch = job.bodies().iter().any(|body| matches!(body.shape, Shape::Punch(_)));
    let can_yield = || problem.bodies.iter().any(|body| body.yield_stress().is_some());
    if !is_punch && peak_is_next_to_end(step) && can_yield() {
        return Some(OnsetUnknown::NextToEnd { x: step.field.peak_position, spacing });
    }
    let x = *step.field.loaded_corners.first().filter(|_| is_sought && peak_is_unbounded(step))?;
    Some(OnsetUnknown::AtCorner { x })
}

/// Returns the onset of yield for a job that asks for it, or `None` if the mesh does not resolve
/// it.
pub(super) fn onset(
    (job, problem): (&Job, &Problem),
    step: &StepSolution,
    findings: &[Finding],
) -> Option<Onset> {
    let is_unknown =
        findings.iter().any(|finding| matches!(finding, Finding::OnsetUnknown { .. }));
    if job.load != Load::Onset || is_unknown {
        return None;
    }
    let first = highest_utilization(step, problem)?;
    let solution = step.field.bodies.get(first.body)?.as_ref()?;
    let [x, depth] = solution.mesh.frame.place(first.position);
    // The prescribed force. The sum of the nodal forces differs from it by rounding.
    let force = match step.load {
        ContactLoad::Force(force) => force,
        ContactLoad::Approach(_) => step.figures.force,
    };
    let at_edge = at_narrow_edge(step, problem).filter(|edge| edge.ratio >= first.ratio);
    let closed_edge = step.field.rounded_edge.filter(|_| at_edge.is_some());
    let closed_peak = closed_edge.map(|edge| edge.elastic.peak_pressure());
    Some(Onset { force, closed_peak, side: first.body, position: x, depth })
}
