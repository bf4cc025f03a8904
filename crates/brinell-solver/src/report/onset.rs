//! The onset of yield: position and force.

use serde::{Deserialize, Serialize};

use super::mesh_effects::{peak_is_next_to_end, peak_is_unbounded};
use super::units::{UnitConverter, rounded};
use crate::contact::ContactLoad;
use crate::job::{Job, Load, Shape, Units};
use crate::solver::{
    EDGE_UTILIZATION, Problem, StepSolution, at_narrow_edge, highest_utilization,
};

/// The onset of yield, found numerically for the job's own shapes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = YieldOnset))]
pub struct YieldOnsetReport {
    /// Force P_Y \[force >= 0\].
    pub force: f64,
    /// Approach under it \[length\].
    pub approach: f64,
    /// Peak pressure under it \[stress >= 0\].
    pub peak_pressure: f64,
    /// Which body yields first; of two alike, the lower one.
    pub body: Side,
    /// x of the middle of the first element to yield; a symmetric contact has its mirror image as
    /// well \[length\].
    pub position: f64,
    /// Depth of that middle \[length\].
    pub depth: f64,
}

/// One of the two bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The upper body.
    Upper,
    /// The lower body.
    Lower,
}

/// Largest relative error at which the closed form gives the onset at a rounded edge.
const KNOWN: f64 = 0.15;

/// Returns the remark `onset_unknown`: the reason why elastic bodies yield under a smaller force
/// than the mesh of a load step shows. Returns `None` if the mesh resolves the onset, or if a body
/// has yielded.
pub(super) fn why_unknown(job: &Job, step: &StepSolution) -> Option<String> {
    if step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0) {
        return None;
    }
    let unknown = if job.load == Load::Onset {
        "The force under which yield begins is not known"
    } else {
        "That no body yields holds for this mesh only"
    };
    if let Some(edge) = &step.rounded_edge {
        let is_sought = job.load == Load::Onset;
        if is_sought && step.onset_error.is_some_and(|error| error <= KNOWN) {
            return None;
        }
        let used = at_narrow_edge(step, &Problem::of(job))?.ratio;
        if !is_sought && used <= 1.0 {
            return None;
        }
        let onset = step.force() / used.powf(EDGE_UTILIZATION.recip());
        return Some(format!(
            "{unknown}. The contact ends within {:.2e} mm on the rounded edges, which elements of \
             {:.2e} mm leave out; in closed form elastic bodies yield there under {} {}.",
            edge.elastic.width(),
            step.spacing,
            rounded(onset),
            job.analysis.force().symbol(Units::MmNMpa),
        ));
    }
    // Elements that resolve the edge of a punch find the peak pressure on the edge.
    let is_punch =
        [&job.upper, &job.lower].iter().any(|body| matches!(body.shape, Shape::Punch(_)));
    let can_yield = || Problem::of(job).bodies.iter().any(|body| body.yield_stress().is_some());
    if !is_punch && peak_is_next_to_end(step) && can_yield() {
        return Some(format!(
            "{unknown}. The largest pressure is at x = {} mm, next to an end of the contact, \
             where it rises within elements of {:.2e} mm: finer ones find more of it, and yield \
             under a smaller force.",
            rounded(step.peak_position),
            step.spacing
        ));
    }
    let is_at_corner = job.load == Load::Onset && peak_is_unbounded(step);
    let x = step.loaded_corners.first().filter(|_| is_at_corner)?;
    Some(format!(
        "{unknown}. A sharp corner carries pressure at x = {} mm, where elastic stress has no \
         bound: the force falls with the size of the elements.",
        rounded(*x)
    ))
}

/// Returns whether the job asks for an onset that the mesh does not resolve.
pub(super) fn is_onset_unknown(job: &Job, step: &StepSolution) -> bool {
    job.load == Load::Onset && why_unknown(job, step).is_some()
}

/// Returns the onset of yield for a job that asks for it, or `None` if the mesh does not resolve
/// it.
pub(super) fn onset(
    job: &Job,
    step: &StepSolution,
    write: UnitConverter,
) -> Option<YieldOnsetReport> {
    if job.load != Load::Onset || is_onset_unknown(job, step) {
        return None;
    }
    let problem = Problem::of(job);
    let first = highest_utilization(step, &problem)?;
    let solution = step.bodies.get(first.body)?.as_ref()?;
    let [x, depth] = solution.mesh.frame.place(first.position);
    // The prescribed force. The sum of the nodal forces differs from it by rounding.
    let force = match step.load {
        ContactLoad::Force(force) => force,
        ContactLoad::Approach(_) => step.force(),
    };
    let at_edge = at_narrow_edge(step, &problem).filter(|edge| edge.ratio >= first.ratio);
    let peak_pressure = match step.rounded_edge.filter(|_| at_edge.is_some()) {
        Some(edge) => edge.elastic.peak_pressure(),
        None => step.peak_pressure,
    };
    Some(YieldOnsetReport {
        force: write.force(force),
        approach: write.length(step.approach),
        peak_pressure: write.stress(peak_pressure),
        body: if first.body == 0 { Side::Upper } else { Side::Lower },
        position: write.length(x),
        depth: write.length(depth),
    })
}
