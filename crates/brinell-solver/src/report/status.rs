//! Words of the status of a solve.

use crate::job::Named;
use crate::solver::SolveStatus;

impl Named for SolveStatus {
    const ALL: &'static [Self] =
        &[Self::Converged, Self::NotConverged, Self::Cancelled, Self::TimedOut];

    fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NotConverged => "not_converged",
            Self::Cancelled => "cancelled",
            Self::TimedOut => "timed_out",
        }
    }
}
