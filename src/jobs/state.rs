//! The states of a job.

use std::fmt;

use serde::{Deserialize, Serialize};
use strum::{IntoStaticStr, VariantArray};
use utoipa::ToSchema;

use brinell_solver::job::Named;
use brinell_solver::solver::SolveStatus;

/// The state of a job, in the order of its life. The first two are transient, the others are final.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    ToSchema,
    IntoStaticStr,
    VariantArray,
)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum JobState {
    /// Accepted, waiting for a free solver.
    Queued,
    /// Being solved.
    Running,
    /// Solved: the result has converged and passed its checks.
    Succeeded,
    /// Solved as far as the iteration limit allows; the last state is the result.
    NotConverged,
    /// No result: the job turned out impossible, or the program is at fault.
    Failed,
    /// Stopped because somebody asked for it.
    Cancelled,
    /// Stopped at its deadline.
    TimedOut,
}

impl JobState {
    /// Returns whether the state is final.
    pub const fn is_finished(self) -> bool {
        !matches!(self, Self::Queued | Self::Running)
    }
}

impl Named for JobState {}

impl From<SolveStatus> for JobState {
    fn from(status: SolveStatus) -> Self {
        match status {
            SolveStatus::Converged => Self::Succeeded,
            SolveStatus::NotConverged => Self::NotConverged,
            SolveStatus::Cancelled => Self::Cancelled,
            SolveStatus::TimedOut => Self::TimedOut,
        }
    }
}

impl fmt::Display for JobState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_is_the_wire_name() {
        for state in JobState::ALL {
            assert_eq!(serde_json::to_value(state).unwrap(), state.name());
        }
    }
}
