//! Messages of a solver thread to its supervisor.

use crate::jobs::{IterationRecord, Outcome};

/// A message of a solver thread to its supervisor; `Done` is the last one. The job's limit of
/// iterations bounds their number, so the channel is unbounded.
pub(super) enum Message {
    /// Further iterations.
    Iterations(Vec<IterationRecord>),
    /// The latest iteration of a preliminary solve, before any other.
    Preliminary(IterationRecord),
    /// The solve has ended, after these last iterations.
    Done(Vec<IterationRecord>, Outcome),
}
