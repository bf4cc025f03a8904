//! How a solve can end, as the store keeps it.

use bytes::Bytes;
use serde::{Deserialize, Serialize};

use super::JobState;
use brinell_solver::job::FieldError;
use brinell_solver::solver::{Interrupt, SolveStatus};

/// The cause of a failure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FailureKind {
    /// The job asks for something physically impossible.
    Input,
    /// The solver gave up on a job that looked possible.
    Solver,
    /// The program is at fault; its log knows more than the reader is told.
    Internal,
}

/// Why a job has no result.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct JobFailure {
    /// Whose fault it is.
    pub kind: FailureKind,
    /// A sentence for a person.
    pub detail: String,
    /// Fields at fault, if the input is.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub errors: Vec<FieldError>,
}

impl JobFailure {
    /// The fields at fault.
    pub fn input(errors: Vec<FieldError>) -> Self {
        let detail = match errors.as_slice() {
            [one] => one.to_string(),
            many => format!("{} fields are at fault", many.len()),
        };
        Self { kind: FailureKind::Input, detail, errors }
    }

    /// Converts an error of the solver.
    pub fn solver(detail: impl Into<String>) -> Self {
        Self { kind: FailureKind::Solver, detail: detail.into(), errors: Vec::new() }
    }

    /// Returns the failure of a job whose worker was lost `times` times, by its own fault or not.
    pub fn lost(times: u32) -> Self {
        Self::internal(format!("the worker was lost {times} times while solving this job"))
    }

    /// Returns the failure for a fault of the program, without internal details.
    pub fn internal(detail: impl Into<String>) -> Self {
        Self { kind: FailureKind::Internal, detail: detail.into(), errors: Vec::new() }
    }
}

/// The outcome of an attempt.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// A report, complete or of the finished steps.
    Reported {
        /// How the solve ended.
        status: SolveStatus,
        /// The report without the steps, which are recorded as they are finished (JSON).
        report: Bytes,
    },
    /// The solve was stopped before its first report.
    Interrupted(Interrupt),
    /// No report.
    Failed(JobFailure),
}

impl Outcome {
    /// Returns the state of a job with this outcome.
    pub fn state(&self) -> JobState {
        match self {
            Self::Reported { status, .. } => (*status).into(),
            Self::Interrupted(Interrupt::Cancelled) => JobState::Cancelled,
            Self::Interrupted(Interrupt::TimedOut) => JobState::TimedOut,
            Self::Failed(_) => JobState::Failed,
        }
    }
}
