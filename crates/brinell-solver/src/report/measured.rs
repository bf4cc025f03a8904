//! Figures of contacts of finite elements that only answers and verdict have.

use std::sync::Arc;

use super::answers::{Largest, Measured};
use super::findings::Finding;
use crate::analytical::von_mises;
use crate::fem::assembly::GaussPoint;
use crate::job::{Job, Load, OverDepth};
use crate::material::HardeningLaw;
use crate::solver::{
    BodySolution, ElasticReference, Problem, StepSolution, elastic_utilization,
    highest_utilization,
};

/// Measures what the report of a load step does not have.
pub(super) fn measured(
    job: &Job,
    problem: &Problem,
    step: &StepSolution,
    reference: Option<&ElasticReference>,
    findings: &[Finding],
) -> Measured {
    let radius = reference.map(|reference| reference.effective_radius);
    let at_rest = Measured {
        effective_radius: radius.filter(|radius| radius.is_finite() && *radius > 0.0),
        points: "integration points",
        ..Measured::default()
    };
    if step.status.is_stopped() {
        return at_rest;
    }
    let core = largest_in(&step.field.bodies, |side, body| core(job, side, body));
    if step.figures.force <= 0.0 {
        let tension =
            largest_in(&step.field.bodies, tension).filter(|_| step.path.energy.is_some());
        return Measured { core, tension, ..at_rest };
    }
    let is_sought = job.load == Load::Onset;
    let is_unknown = findings.iter().any(|finding| {
        matches!(finding, Finding::OnsetUnknown { .. } | Finding::ElasticCorner { .. })
    });
    let is_half_space = !findings.contains(&Finding::NearSupport) && !is_sought;
    let reference = reference.filter(|_| is_half_space);
    let closed = reference.and_then(|_| elastic_utilization(problem, step.figures.force));
    let is_elastic = !step.field.bodies.iter().flatten().any(|body| body.has_yielded());
    let utilization = closed.or_else(|| {
        let found = highest_utilization(step, problem).filter(|_| is_elastic)?;
        let frame = step.field.bodies[found.body].as_ref()?.mesh.frame;
        let [x, depth] = frame.place(found.position);
        Some((found.ratio, [x, depth], found.body))
    });
    let first_yield = if is_sought {
        Some(step.figures.force)
    } else {
        reference.and_then(|reference| reference.yield_onset_force)
    };
    Measured {
        is_of_field: closed.is_none(),
        utilization: utilization
            .filter(|_| !is_unknown)
            .map(|(value, [x, depth], side)| Largest { value, side, place: [x, 0.0, depth] }),
        first_yield: first_yield.filter(|_| !is_unknown),
        core,
        ..at_rest
    }
}

/// Returns the largest of both bodies; of two alike the lower one.
pub(super) fn largest_in<B>(
    bodies: &[Option<Arc<B>>; 2],
    of: impl Fn(usize, &B) -> Option<Largest>,
) -> Option<Largest> {
    let found = bodies.iter().enumerate().filter_map(|(side, body)| of(side, body.as_ref()?));
    found.max_by(|a, b| a.value.total_cmp(&b.value))
}

/// Returns the largest principal stress of all Gauss points.
fn tension(side: usize, body: &BodySolution) -> Option<Largest> {
    let points = body.stress.points.iter().flatten();
    let most = points
        .map(|point| {
            let [x, y, z, xy] = point.stress;
            let in_plane = 0.5 * (x + y) + f64::hypot(0.5 * (x - y), xy);
            (in_plane.max(z), point.position)
        })
        .max_by(|a, b| a.0.total_cmp(&b.0));
    most.map(|(value, position)| {
        let [x, depth] = body.mesh.frame.place(position);
        Largest { value, side, place: [x, 0.0, depth] }
    })
}

/// Returns the depth of the hardened case of a body \[mm\].
pub(super) fn case_depth(job: &Job, side: usize) -> Option<f64> {
    match job.bodies()[side].deformable()?.over_depth.as_ref()? {
        OverDepth::Case(case) => Some(case.case_depth.get()),
        _ => None,
    }
}

/// Returns the largest von Mises stress over the yield stress below a hardened case, of the means
/// of elements.
fn core(job: &Job, side: usize, body: &BodySolution) -> Option<Largest> {
    let case = case_depth(job, side)?;
    let limit = body.model.hardening().map(HardeningLaw::nominal_yield_stress)?;
    let used = body.stress.points.iter().filter_map(|points| {
        let mean = GaussPoint::mean(points);
        let [x, depth] = body.mesh.frame.place(mean.position);
        let strength = limit * body.model.strength(mean.position);
        (depth >= case).then(|| Largest {
            value: von_mises(mean.stress) / strength,
            side,
            place: [x, 0.0, depth],
        })
    });
    used.max_by(|a, b| a.value.total_cmp(&b.value))
}
