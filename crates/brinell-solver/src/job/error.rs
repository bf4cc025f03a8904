//! Faults of a job, field by field.

use std::fmt;

use serde::Serialize;
use strum::{IntoStaticStr, VariantArray};
use thiserror::Error;

use super::Named;

/// One fault in a job, located by its JSON pointer (RFC 6901); `""` is the whole document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FieldError {
    /// The faulty field, e.g. `/lower/material/poisson_ratio`.
    pub pointer: String,
    /// The kind of fault, for programs.
    pub code: FaultCode,
    /// The fault and the valid values, e.g. `must be between 0 and 0.499999, got 0.5`.
    pub detail: String,
}

/// The kinds of faults in a job. Later versions may add more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum FaultCode {
    /// A member is missing.
    Required,
    /// An unknown member.
    UnknownKey,
    /// A repeated key.
    DuplicateKey,
    /// A value of another type, e.g. a string for a number.
    WrongType,
    /// A number outside its range.
    OutOfRange,
    /// An unknown word.
    UnknownWord,
    /// A list or a text of an invalid length.
    WrongLength,
    /// A value that contradicts another one or that the format cannot hold.
    Inconsistent,
    /// A valid job whose contact is not solved.
    NotSolvable,
    /// A note that further faults are not listed.
    MoreFaults,
}

impl Named for FaultCode {}

impl FieldError {
    /// Returns the fault of a value that contradicts another one.
    pub fn new(pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self { pointer: pointer.into(), code: FaultCode::Inconsistent, detail: detail.into() }
    }

    /// Returns the fault of a valid job whose contact is not solved because of this field.
    pub fn not_solvable(pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self { pointer: pointer.into(), code: FaultCode::NotSolvable, detail: detail.into() }
    }
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pointer = if self.pointer.is_empty() { "(job)" } else { &self.pointer };
        write!(f, "{pointer}: {}", self.detail)
    }
}

/// The reason why a text is not a job.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum JobError {
    /// The text is not JSON.
    #[error("not valid JSON: {message} (line {line}, column {column})")]
    Syntax {
        /// The parser's message.
        message: String,
        /// One-based line.
        line: usize,
        /// One-based column.
        column: usize,
    },
    /// The text is JSON, but not a job: every fault, in document order.
    #[error("{} field{} at fault", .0.len(), if .0.len() == 1 { "" } else { "s" })]
    Fields(Vec<FieldError>),
}
