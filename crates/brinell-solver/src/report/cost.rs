//! What a job costs: the part that all engines have in common.

use serde::Serialize;

use crate::inputs;
use crate::job::{Job, Load};
use crate::solver::method::increments::Increments;

/// What a job will cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Estimate))]
pub struct JobEstimate {
    /// Equations of both bodies.
    pub equations: usize,
    /// Peak memory \[bytes\], the fields of a step while they are handed over included.
    pub bytes: u64,
    /// The result of all steps as it is kept \[bytes\].
    pub result_bytes: u64,
}

/// Bytes that every job takes: the heap of a thread, in pages of 2 MiB, and buffers of the load
/// steps that are being written to the result.
pub(super) const SOLVER_BYTES: u64 = 56 << 20;
/// Copies of the fields while a load step is written, encoded and stored.
pub(super) const FIELD_COPIES: u64 = 6;
/// Bytes of the compressed report of a load step without fields and contact nodes.
pub(super) const STEP_BYTES: u64 = 8 << 10;
/// Bytes of an increment and its iterations in the report.
pub(super) const REPORTED_INCREMENT_BYTES: u64 = 1024;
/// Increments that the solver chooses itself: in total up to the largest load, and for each load.
const CHOSEN_INCREMENTS: [u64; 2] = [32, 2];

/// Returns the number of load steps of a job.
pub(super) fn steps_of(job: &Job) -> u64 {
    match &job.load {
        Load::Forces(sweep) | Load::Approaches(sweep) => sweep.iter().count() as u64,
        Load::History(history) => history.iter().count() as u64,
        // One load step under the force and one after its removal.
        Load::Target(target) if target.figure.is_permanent() => 2,
        Load::Rolling(_) | Load::Onset | Load::Target(_) => 1,
    }
}

/// Returns the most increments of one load of a history, and those of all `steps`.
pub(super) fn increments_of(job: &Job, steps: u64) -> [u64; 2] {
    let [to_largest, of_load] = match inputs::increments(job) {
        Increments::Given(of_load) => [0, of_load.into()],
        Increments::Chosen(times) => CHOSEN_INCREMENTS.map(|n| n * u64::from(times)),
    };
    [to_largest + of_load, to_largest + of_load * steps]
}
