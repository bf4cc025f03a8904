//! What is wrong with a job, field by field.

use std::fmt;

use serde::Serialize;
use thiserror::Error;

/// One fault in a job, located by its JSON pointer (RFC 6901); `""` is the whole document.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FieldError {
    /// Where, e.g. `/lower/material/poisson_ratio`.
    pub pointer: String,
    /// What is wrong and what would be right, e.g. `must be at least 0 and less than 0.5, got 0.5`.
    pub detail: String,
}

impl FieldError {
    /// A fault at a place.
    pub fn new(pointer: impl Into<String>, detail: impl Into<String>) -> Self {
        Self { pointer: pointer.into(), detail: detail.into() }
    }
}

impl fmt::Display for FieldError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pointer = if self.pointer.is_empty() { "(job)" } else { &self.pointer };
        write!(f, "{pointer}: {}", self.detail)
    }
}

/// Why a text is not a job.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum JobError {
    /// Not JSON at all.
    #[error("not valid JSON: {message} (line {line}, column {column})")]
    Syntax {
        /// What the parser met.
        message: String,
        /// One-based line.
        line: usize,
        /// One-based column.
        column: usize,
    },
    /// JSON, but not a job: every fault found, in document order.
    #[error("{} field{} at fault", .0.len(), if .0.len() == 1 { "" } else { "s" })]
    Fields(Vec<FieldError>),
}
