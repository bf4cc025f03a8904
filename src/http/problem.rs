//! Errors as `application/problem+json` (RFC 9457).

use axum::http::header::{CONTENT_TYPE, RETRY_AFTER, WWW_AUTHENTICATE};
use axum::http::{HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use serde_json::{Map, Value};

use super::problem_type::ProblemType;
use crate::jobs::{FailureKind, FieldError, JobError, JobFailure, Rejection, StoreError, SubmitError};

/// Seconds after which a refused client may try again: about the time a few ordinary jobs take.
const RETRY_AFTER_SECONDS: u16 = 2;

/// An error as the client sees it.
#[derive(Debug, Clone, Serialize)]
pub struct Problem {
    #[serde(rename = "type")]
    uri: String,
    title: &'static str,
    status: u16,
    detail: String,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    errors: Vec<FieldError>,
    #[serde(flatten)]
    extensions: Map<String, Value>,
    #[serde(skip)]
    kind: ProblemType,
    #[serde(skip)]
    retry_after: u16,
}

impl Problem {
    /// An error of this kind; `detail` is about this occurrence.
    pub fn new(kind: ProblemType, detail: impl Into<String>) -> Self {
        Self {
            uri: kind.uri(),
            title: kind.title(),
            status: kind.status().as_u16(),
            detail: detail.into(),
            errors: Vec::new(),
            extensions: Map::new(),
            kind,
            retry_after: RETRY_AFTER_SECONDS,
        }
    }

    /// The same with faults at fields.
    #[must_use]
    pub fn with_errors(mut self, errors: Vec<FieldError>) -> Self {
        self.errors = errors;
        self
    }

    /// The same with a member of its kind's own.
    #[must_use]
    pub fn with(mut self, member: &str, value: impl Into<Value>) -> Self {
        self.extensions.insert(member.to_owned(), value.into());
        self
    }

    /// The same, to be tried again after so many seconds.
    #[must_use]
    pub const fn retry_after(mut self, seconds: u16) -> Self {
        self.retry_after = seconds;
        self
    }

    /// The kind of error.
    pub const fn kind(&self) -> ProblemType {
        self.kind
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let status = self.kind.status();
        let body = serde_json::to_vec(&self).unwrap_or_default();
        let mut response = (status, body).into_response();
        let headers = response.headers_mut();
        headers.insert(CONTENT_TYPE, HeaderValue::from_static("application/problem+json"));
        if status == StatusCode::UNAUTHORIZED {
            headers.insert(WWW_AUTHENTICATE, HeaderValue::from_static("Bearer"));
        }
        if matches!(
            status,
            StatusCode::TOO_MANY_REQUESTS
                | StatusCode::SERVICE_UNAVAILABLE
                | StatusCode::INSUFFICIENT_STORAGE
        ) {
            headers.insert(RETRY_AFTER, HeaderValue::from(self.retry_after));
        }
        response
    }
}

impl From<Rejection> for Problem {
    fn from(rejection: Rejection) -> Self {
        let detail = rejection.to_string();
        match rejection {
            Rejection::Invalid(JobError::Syntax { line, column, .. }) => {
                Self::new(ProblemType::InvalidJson, detail).with("line", line).with("column", column)
            }
            Rejection::Invalid(JobError::Fields(errors)) => {
                Self::new(ProblemType::InvalidJob, detail).with_errors(errors)
            }
            Rejection::TooLarge { estimate, limit } | Rejection::ResultTooLarge { estimate, limit } => {
                let estimate = serde_json::to_value(estimate).unwrap_or_default();
                Self::new(ProblemType::JobTooLarge, detail)
                    .with("estimate", estimate)
                    .with("limit_bytes", limit)
            }
        }
    }
}

impl From<SubmitError> for Problem {
    fn from(error: SubmitError) -> Self {
        match error {
            SubmitError::Rejected(rejection) => rejection.into(),
            SubmitError::Closed => Self::new(ProblemType::ShuttingDown, error.to_string()),
            SubmitError::Store(error) => error.into(),
        }
    }
}

impl From<StoreError> for Problem {
    fn from(error: StoreError) -> Self {
        let kind = match &error {
            StoreError::NotFound => ProblemType::JobNotFound,
            StoreError::QueueFull { .. } => ProblemType::QueueFull,
            StoreError::QuotaExceeded { .. } => ProblemType::QuotaExceeded,
            StoreError::KeyReused => ProblemType::IdempotencyKeyReused,
            StoreError::Unfinished(_) => ProblemType::JobUnfinished,
            StoreError::LeaseLost => ProblemType::Internal,
            StoreError::DiskFull => {
                tracing::error!("the disk is full");
                ProblemType::InsufficientStorage
            }
            StoreError::Unavailable(source) => {
                tracing::error!(
                    error = source.as_ref() as &dyn std::error::Error,
                    "the store does not answer"
                );
                ProblemType::StoreUnavailable
            }
        };
        Self::new(kind, error.to_string())
    }
}

impl From<&JobFailure> for Problem {
    fn from(failure: &JobFailure) -> Self {
        let kind = match failure.kind {
            FailureKind::Input => ProblemType::InvalidJob,
            FailureKind::Solver => ProblemType::SolveFailed,
            FailureKind::Internal => ProblemType::Internal,
        };
        Self::new(kind, failure.detail.clone()).with_errors(failure.errors.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::jobs::JobEstimate;

    #[test]
    fn a_job_too_large_comes_with_its_estimate() {
        let estimate = JobEstimate { equations: 5_000_000, bytes: 8 << 30, result_bytes: 100_000, work: 1 };
        let problem = Problem::from(Rejection::TooLarge { estimate, limit: 4 << 30 });
        insta::assert_json_snapshot!(problem, @r#"
        {
          "type": "/problems/job-too-large",
          "title": "The job is too large",
          "status": 422,
          "detail": "the job has 5000000 equations and needs about 8192 MiB; a job may need 4096 MiB at most",
          "estimate": {
            "bytes": 8589934592,
            "equations": 5000000,
            "result_bytes": 100000
          },
          "limit_bytes": 4294967296
        }
        "#);
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = ProblemType::ALL.iter().map(|kind| kind.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ProblemType::ALL.len());
    }
}
