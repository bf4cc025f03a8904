//! How a solve can end, as the store keeps it.

use bytes::Bytes;
use serde::{Deserialize, Serialize};

use super::JobState;
use brinell_solver::job::FieldError;
use brinell_solver::solver::{Interrupt, SolveStatus};

/// Whose fault a failure is.
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
    /// For a person.
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

    /// The solver's own words.
    pub fn solver(detail: impl Into<String>) -> Self {
        Self { kind: FailureKind::Solver, detail: detail.into(), errors: Vec::new() }
    }

    /// The job took its workers with it, or had bad luck that often.
    pub fn lost(times: u32) -> Self {
        Self::internal(format!("the worker was lost {times} times while solving this job"))
    }

    /// A fault of the program, told without its innards.
    pub fn internal(detail: impl Into<String>) -> Self {
        Self { kind: FailureKind::Internal, detail: detail.into(), errors: Vec::new() }
    }
}

/// What a worker brings back.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// A report, complete or as far as it came.
    Reported {
        /// How the solve ended.
        status: SolveStatus,
        /// The report without the steps, which are recorded as they are finished (JSON).
        report: Bytes,
    },
    /// Stopped before there was anything to report.
    Interrupted(Interrupt),
    /// No report.
    Failed(JobFailure),
}

impl Outcome {
    /// The state of a job that ended like this.
    pub fn state(&self) -> JobState {
        match self {
            Self::Reported { status, .. } => (*status).into(),
            Self::Interrupted(Interrupt::Cancelled) => JobState::Cancelled,
            Self::Interrupted(Interrupt::TimedOut) => JobState::TimedOut,
            Self::Failed(_) => JobState::Failed,
        }
    }
}
