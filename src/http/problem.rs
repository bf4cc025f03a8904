//! Errors as `application/problem+json` (RFC 9457).

use std::fmt::Write as _;

use axum::Extension;
use axum::body::Body;
use axum::extract::Request;
use axum::http::header::{CONTENT_LENGTH, CONTENT_TYPE, RETRY_AFTER, WWW_AUTHENTICATE};
use axum::http::{HeaderValue, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use brinell_solver::job::FaultCode;
use serde::Serialize;
use utoipa::ToSchema;

use super::prefix::Prefix;
use super::problem_type::ProblemType;
use crate::jobs::{
    FailureKind, FieldError, JobError, JobEstimate, JobFailure, Rejection, StoreError, SubmitError,
};

/// Seconds after which a refused client may try again: the time of a few ordinary jobs.
const RETRY_AFTER_SECONDS: u16 = 2;

/// An error, ready to be sent.
#[derive(Debug, Clone, Serialize)]
#[serde(transparent)]
pub struct Problem(Box<ProblemDocument>);

/// An error (RFC 9457).
#[derive(Debug, Clone, Serialize, ToSchema)]
#[schema(as = Problem)]
pub(super) struct ProblemDocument {
    /// The kind of error: a relative address that this service answers with an explanation. There
    /// may be more kinds in the future.
    #[serde(rename = "type")]
    uri: String,
    /// The kind in words, the same for every occurrence.
    #[schema(example = "The job is not valid")]
    title: &'static str,
    /// The HTTP status; of a job's `error`, the one that `POST /v1/solve` would have answered
    /// with.
    #[schema(minimum = 400, maximum = 599, example = 422)]
    status: u16,
    /// About this occurrence.
    #[schema(example = "3 fields at fault")]
    detail: String,
    /// This occurrence, by the id of its request as `X-Request-Id` has it: what to name to those
    /// who run the service.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(example = "/requests/7d5bf0b5-4d4e-4c3a-8f0e-0b8f7a1f4c55")]
    instance: Option<String>,
    /// Every fault, in the order of the document or of the query string.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(required = false)]
    errors: Vec<Fault>,
    /// Line of the body at which the JSON ends, from 1 (`invalid-json`).
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
    /// Column in that line (`invalid-json`).
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<usize>,
    /// What the job would cost (`job-too-large`).
    #[serde(skip_serializing_if = "Option::is_none")]
    estimate: Option<JobEstimate>,
    /// The limit (`body-too-large`, `job-too-large`) \[bytes\].
    #[serde(skip_serializing_if = "Option::is_none")]
    limit_bytes: Option<u64>,
    /// Which quota of the API key is used up (`quota-exceeded`).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(example = "queued_jobs")]
    quota: Option<&'static str>,
    #[serde(skip)]
    #[schema(ignore)]
    kind: ProblemType,
    #[serde(skip)]
    #[schema(ignore)]
    retry_after: u16,
}

/// One fault in a job or in a query string.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, ToSchema)]
pub struct Fault {
    /// JSON pointer of the field as a URI fragment (RFC 6901, section 6); `#` is the whole job.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(pattern = "^#(/.*)?$", example = "#/upper/material/poisson_ratio")]
    pointer: Option<String>,
    /// Name of the query parameter.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(example = "limit")]
    parameter: Option<String>,
    /// The kind of fault, for programs. There may be more in the future.
    #[schema(value_type = String)]
    code: FaultCode,
    /// What is wrong and what would be right.
    #[schema(example = "must be between 0 and 0.499999, got 0.5")]
    detail: String,
}

impl Fault {
    /// A fault of a query parameter.
    pub fn parameter(name: &str, code: FaultCode, detail: impl Into<String>) -> Self {
        Self { pointer: None, parameter: Some(name.to_owned()), code, detail: detail.into() }
    }
}

impl From<FieldError> for Fault {
    fn from(error: FieldError) -> Self {
        let pointer = format!("#{}", fragment(&error.pointer));
        let detail = cut(error.detail);
        Self { pointer: Some(pointer), parameter: None, code: error.code, detail }
    }
}

/// Most characters of a detail, which may repeat what the client has sent.
const DETAIL: usize = 500;

/// A text of bounded length.
fn cut(text: String) -> String {
    match text.char_indices().nth(DETAIL) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// A text as it is written in the fragment or a segment of a URI (RFC 3986, section 3.5).
fn fragment(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~!$&'()*+,;=:@/".contains(&byte) {
            written.push(char::from(byte));
        } else {
            let _ = write!(written, "%{byte:02X}");
        }
    }
    written
}

impl Problem {
    /// An error of this kind; `detail` is about this occurrence.
    pub fn new(kind: ProblemType, detail: impl Into<String>) -> Self {
        Self(Box::new(ProblemDocument {
            uri: kind.uri(),
            title: kind.title(),
            status: kind.status().as_u16(),
            detail: cut(detail.into()),
            instance: None,
            errors: Vec::new(),
            line: None,
            column: None,
            estimate: None,
            limit_bytes: None,
            quota: None,
            kind,
            retry_after: RETRY_AFTER_SECONDS,
        }))
    }

    /// A body that is no JSON.
    pub fn not_json(error: &serde_json::Error) -> Self {
        let (line, column) = (error.line(), error.column());
        let message = error.to_string();
        let message = message.split(" at line ").next().unwrap_or_default().to_owned();
        Rejection::Invalid(JobError::Syntax { message, line, column }).into()
    }

    /// The same with faults at fields.
    #[must_use]
    pub fn with_errors(self, errors: Vec<FieldError>) -> Self {
        self.with_faults(errors.into_iter().map(Fault::from).collect())
    }

    /// The same with faults.
    #[must_use]
    pub fn with_faults(mut self, faults: Vec<Fault>) -> Self {
        self.0.errors = faults;
        self
    }

    /// The same with the limit that was passed.
    #[must_use]
    pub fn with_limit(mut self, bytes: u64) -> Self {
        self.0.limit_bytes = Some(bytes);
        self
    }

    /// The same as the answer to a request.
    #[must_use]
    pub fn about_request(mut self, id: &str) -> Self {
        self.0.instance = Some(format!("/requests/{}", fragment(id)));
        self
    }

    /// The same for a client that reaches this service under a path of another site.
    #[must_use]
    pub(super) fn under(mut self, prefix: &Prefix) -> Self {
        if let Some(path) = prefix.server() {
            self.0.uri = format!("{path}{}", self.0.kind.uri());
        }
        self
    }

    /// The same, to be tried again after so many seconds.
    #[must_use]
    pub fn retry_after(mut self, seconds: u16) -> Self {
        self.0.retry_after = seconds;
        self
    }

    /// The kind of error.
    pub fn kind(&self) -> ProblemType {
        self.0.kind
    }
}

impl IntoResponse for Problem {
    fn into_response(self) -> Response {
        let (status, retry_after) = (self.0.kind.status(), self.0.retry_after);
        let body = serde_json::to_vec(&self).unwrap_or_default();
        let mut response = (status, Extension(self), body).into_response();
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
            headers.insert(RETRY_AFTER, HeaderValue::from(retry_after));
        }
        response
    }
}

/// The layer that names the request in every error that leaves.
pub(super) async fn name_request(request: Request, next: Next) -> Response {
    let id =
        request.headers().get("x-request-id").and_then(|id| id.to_str().ok()).map(str::to_owned);
    let prefix = Prefix::of(request.headers());
    let mut response = next.run(request).await;
    let problem = response.extensions_mut().remove::<Problem>();
    if let (Some(problem), Some(id)) = (problem, id)
        && let Ok(body) = serde_json::to_vec(&problem.under(&prefix).about_request(&id))
    {
        response.headers_mut().remove(CONTENT_LENGTH);
        *response.body_mut() = Body::from(body);
    }
    response
}

impl From<Rejection> for Problem {
    fn from(rejection: Rejection) -> Self {
        let detail = rejection.to_string();
        match rejection {
            Rejection::Invalid(JobError::Syntax { line, column, .. }) => {
                let mut problem = Self::new(ProblemType::InvalidJson, detail);
                (problem.0.line, problem.0.column) = (Some(line), Some(column));
                problem
            }
            Rejection::Invalid(JobError::Fields(errors)) => {
                Self::new(ProblemType::InvalidJob, detail).with_errors(errors)
            }
            Rejection::TooLarge { estimate, limit }
            | Rejection::ResultTooLarge { estimate, limit } => {
                let mut problem = Self::new(ProblemType::JobTooLarge, detail).with_limit(limit);
                problem.0.estimate = Some(estimate);
                problem
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
            StoreError::KeyEnded => ProblemType::Unauthorized,
            StoreError::Unfinished(_) => ProblemType::JobUnfinished,
            StoreError::LeaseLost => ProblemType::Internal,
            StoreError::DiskFull => {
                tracing::error!("the disk is full");
                ProblemType::InsufficientStorage
            }
            StoreError::Damaged(source) => {
                tracing::error!(
                    error = source.as_ref() as &dyn std::error::Error,
                    "what is stored is damaged"
                );
                ProblemType::Damaged
            }
            StoreError::Unavailable(source) => {
                tracing::error!(
                    error = source.as_ref() as &dyn std::error::Error,
                    "the store does not answer"
                );
                ProblemType::StoreUnavailable
            }
        };
        let mut problem = Self::new(kind, error.to_string());
        if let StoreError::QuotaExceeded { quota } = &error {
            problem.0.quota = Some(quota.name());
        }
        problem
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

    #[test]
    fn a_job_too_large_comes_with_its_estimate() {
        let estimate = JobEstimate { equations: 5_000_000, bytes: 8 << 30, result_bytes: 100_000 };
        let problem = Problem::from(Rejection::TooLarge { estimate, limit: 4 << 30 });
        insta::assert_json_snapshot!(problem, @r#"
        {
          "type": "/problems/job-too-large",
          "title": "The job is too large",
          "status": 422,
          "detail": "the job has 5000000 equations and needs about 8192 MiB; a job may need 4096 MiB at most",
          "estimate": {
            "equations": 5000000,
            "bytes": 8589934592,
            "result_bytes": 100000
          },
          "limit_bytes": 4294967296
        }
        "#);
    }

    #[test]
    fn details_do_not_repeat_all_that_a_client_has_sent() {
        let long = "é".repeat(100_000);
        let fault = Fault::from(FieldError::new("/surface", format!("the array says {long}")));
        assert_eq!(fault.detail.chars().count(), DETAIL + 1);
        assert_eq!(cut("short".to_owned()), "short");
    }

    #[test]
    fn pointers_are_fragments() {
        let fault = Fault::from(FieldError::new("/tags/a b~1é", "wrong"));
        assert_eq!(fault.pointer.as_deref(), Some("#/tags/a%20b~1%C3%A9"));
        assert_eq!(Fault::from(FieldError::new("", "wrong")).pointer.as_deref(), Some("#"));
    }

    #[test]
    fn names_are_unique() {
        let mut names: Vec<_> = ProblemType::ALL.iter().map(|kind| kind.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ProblemType::ALL.len());
    }
}
