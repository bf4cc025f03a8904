//! From a solver thread to its supervisor.

use crate::jobs::{IterationRecord, Outcome};

/// What a solver thread tells its supervisor; `Done` is the last word. Iterations are bounded by
/// the job's own limit, so the channel need not be.
pub(super) enum Message {
    /// Iterations were made.
    Iterations(Vec<IterationRecord>),
    /// The solve has ended, after these last iterations.
    Done(Vec<IterationRecord>, Outcome),
}
