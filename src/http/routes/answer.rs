//! Answers to clients that wait for a job.

use axum::http::header::{CONTENT_LOCATION, LOCATION};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};

use crate::http::access::Caller;
use crate::http::prefix::Prefix;
use crate::http::query::{Granted, Selection};
use crate::http::result_body::{SentResult, no_result};
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem, ProblemType};
use crate::jobs::JobRecord;

const REPLAYED: HeaderName = HeaderName::from_static("idempotency-replayed");
const APPLIED: HeaderName = HeaderName::from_static("preference-applied");

/// Answers with the job, and with its result inside if it has one.
pub(super) async fn with_result(
    state: &HttpState,
    caller: Caller,
    job: JobDocument,
    selection: Selection,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    match state.jobs.result(job.id).await? {
        Some(head) if job.done => {
            let result = SentResult { state: state.clone(), caller, id: job.id, head, selection };
            result.inside(&job, headers)
        }
        _ => Ok(job.into_response()),
    }
}

/// Answers a submission that waited for its job. A finished job without a result is an error.
pub(super) async fn finished(
    state: &HttpState,
    caller: Caller,
    record: JobRecord,
    prefix: &Prefix,
    selection: Selection,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    if record.state.is_finished() && !record.has_report {
        return Err(record.failure.as_ref().map_or_else(|| no_result(&record), Problem::from));
    }
    let job = JobDocument::of(state, record, prefix).await?;
    let (done, address) = (job.done, job.links.job.clone());
    Ok(addressed(with_result(state, caller, job, selection, headers).await?, done, &address))
}

/// Answers a submission.
pub(super) fn submitted(job: JobDocument) -> Response {
    let (done, address) = (job.done, job.links.job.clone());
    addressed(job.into_response(), done, &address)
}

/// Answers a client that has waited for a job. If the store stops answering, the answer is the job
/// as it was accepted: an error would make the client submit it twice.
pub(super) fn unless_out_of_reach(
    answer: Result<Response, Problem>,
    known: JobDocument,
) -> Result<Response, Problem> {
    match answer {
        Err(problem) if problem.kind() == ProblemType::StoreUnavailable && !known.done => {
            Ok(submitted(known))
        }
        answer => answer,
    }
}

/// Answers 200 if the job is done, else 202, with its URL.
fn addressed(mut response: Response, done: bool, address: &str) -> Response {
    let header = if done { CONTENT_LOCATION } else { LOCATION };
    if !done {
        *response.status_mut() = StatusCode::ACCEPTED;
    }
    let address = HeaderValue::try_from(address).ok();
    response.headers_mut().extend(address.map(|address| (header, address)));
    response
}

/// Marks an answer whose job was submitted before.
pub(super) fn mark_replayed(response: &mut Response, replayed: bool) {
    if replayed {
        response.headers_mut().insert(REPLAYED, HeaderValue::from_static("true"));
    }
}

/// Adds the granted wait to an answer.
pub(super) fn apply_preference(response: &mut Response, wait: Option<Granted>) {
    let Some(wait) = wait.filter(|wait| wait.preferred) else { return };
    let applied = HeaderValue::try_from(format!("wait={}", wait.timeout.as_secs()));
    response.headers_mut().extend(applied.ok().map(|applied| (APPLIED, applied)));
}
