//! The states of a job.

use std::fmt;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use brinell_solver::solver::SolveStatus;

/// The state of a job. The first two are transient, the others are final.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, ToSchema,
)]
#[serde(rename_all = "snake_case")]
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
    /// Every state, in the order of a job's life.
    pub const ALL: [Self; 7] = [
        Self::Queued,
        Self::Running,
        Self::Succeeded,
        Self::NotConverged,
        Self::Failed,
        Self::Cancelled,
        Self::TimedOut,
    ];

    /// Returns whether the state is final.
    pub const fn is_finished(self) -> bool {
        !matches!(self, Self::Queued | Self::Running)
    }

    /// The state of that name.
    pub fn by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|state| state.name() == name)
    }

    /// The name used in the wire format.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Queued => "queued",
            Self::Running => "running",
            Self::Succeeded => "succeeded",
            Self::NotConverged => "not_converged",
            Self::Failed => "failed",
            Self::Cancelled => "cancelled",
            Self::TimedOut => "timed_out",
        }
    }
}

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
    use super::JobState;

    #[test]
    fn the_name_is_the_wire_name() {
        for state in JobState::ALL {
            assert_eq!(serde_json::to_value(state).unwrap(), state.name());
        }
    }
}
