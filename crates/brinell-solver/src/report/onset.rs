//! Where and under which force a contact first yields.

use serde::{Deserialize, Serialize};

use super::units::UnitConverter;
use crate::contact::ContactLoad;
use crate::job::{Job, Load};
use crate::solver::{Problem, StepSolution, highest_utilization};

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
    /// x of the middle of the first element to yield; a symmetric contact has its mirror image as well \[length\].
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

/// The onset that a job asked for; `None` for any other job.
pub(super) fn onset(job: &Job, step: &StepSolution, write: UnitConverter) -> Option<YieldOnsetReport> {
    if job.load != Load::Onset {
        return None;
    }
    let first = highest_utilization(step, &Problem::of(job))?;
    let solution = step.bodies.get(first.body)?.as_ref()?;
    let [x, depth] = solution.mesh.frame.place(first.position);
    // The force that was prescribed; the nodal ones add up to it but for rounding.
    let force = match step.load {
        ContactLoad::Force(force) => force,
        ContactLoad::Approach(_) => step.force(),
    };
    Some(YieldOnsetReport {
        force: write.force(force),
        approach: write.length(step.approach),
        peak_pressure: write.stress(step.peak_pressure),
        body: if first.body == 0 { Side::Upper } else { Side::Lower },
        position: write.length(x),
        depth: write.length(depth),
    })
}
