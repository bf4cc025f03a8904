//! Couplings and outcomes by the names that jobs and reports give them.

use crate::job::{self, Named};
use crate::solver::SolveStatus;
use crate::solver::method::couplings::{Accelerated, Coupling, SecantStiffness, Strong, Weak};

/// The coupling that a job names.
pub(crate) fn coupling(name: job::Coupling) -> &'static dyn Coupling {
    match name {
        job::Coupling::Strong => &Strong,
        job::Coupling::Accelerated => &Accelerated,
        job::Coupling::Weak => &Weak,
        job::Coupling::SecantStiffness => &SecantStiffness,
    }
}

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
