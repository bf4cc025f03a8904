//! The answer to a client that waits for a job.

use axum::http::header::{CONTENT_LOCATION, LOCATION};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};

use crate::http::query::Granted;
use crate::http::result_body::no_result;
use crate::http::wire::{JobDocument, Prefix};
use crate::http::{HttpState, Problem, result_body};
use crate::jobs::JobRecord;

const REPLAYED: HeaderName = HeaderName::from_static("idempotency-replayed");
const APPLIED: HeaderName = HeaderName::from_static("preference-applied");

/// The job with its result inside, if it is done and has one.
pub(super) async fn with_result(
    state: &HttpState,
    job: JobDocument,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    match state.jobs.result(job.id).await? {
        Some(head) if job.done => result_body::inside(state, &job, head, headers).await,
        _ => Ok(job.into_response()),
    }
}

/// The job that a client has waited for since it handed it in. One that is done and has no result is an error.
pub(super) async fn finished(
    state: &HttpState,
    record: JobRecord,
    prefix: &Prefix,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    if record.state.is_finished() && !record.has_report {
        return Err(record.failure.as_ref().map_or_else(|| no_result(&record), Problem::from));
    }
    let job = JobDocument::of(state, record, prefix).await?;
    let (done, address) = (job.done, job.links.job.clone());
    Ok(submitted(with_result(state, job, headers).await?, done, &address))
}

/// The answer to a client that hands a job in: 200 if it is done, else 202.
pub(super) fn submitted(mut response: Response, done: bool, address: &str) -> Response {
    let header = if done { CONTENT_LOCATION } else { LOCATION };
    if !done {
        *response.status_mut() = StatusCode::ACCEPTED;
    }
    let address = HeaderValue::try_from(address).ok();
    response.headers_mut().extend(address.map(|address| (header, address)));
    response
}

/// Tells a client that its job was handed in before.
pub(super) fn mark_replayed(response: &mut Response, replayed: bool) {
    if replayed {
        response.headers_mut().insert(REPLAYED, HeaderValue::from_static("true"));
    }
}

/// Says which wait was granted to a client that prefers one.
pub(super) fn apply_preference(response: &mut Response, wait: Option<Granted>) {
    let Some(wait) = wait.filter(|wait| wait.preferred) else { return };
    let applied = HeaderValue::try_from(format!("wait={}", wait.timeout.as_secs()));
    response.headers_mut().extend(applied.ok().map(|applied| (APPLIED, applied)));
}
