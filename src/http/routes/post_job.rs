//! `POST /v1/jobs`: queue a job.
//!
//! `Prefer: wait=N` answers 200 with the result if there is one within N seconds, `Preference-Applied` says so.
//! `Idempotency-Key` makes the submission repeatable: the same body under the same key is the same job.

use axum::extract::State;
use axum::http::{HeaderMap, HeaderName, HeaderValue};
use axum::response::{IntoResponse, Response};

use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::preference::{IdempotencyKey, PreferWait};
use crate::http::query::{Priority, PriorityQuery};
use crate::http::wire::Receipt;
use crate::http::{HttpState, Problem, wire};
use crate::jobs::Submission;

use super::get_result::finished;

const REPLAYED: HeaderName = HeaderName::from_static("idempotency-replayed");
const APPLIED: HeaderName = HeaderName::from_static("preference-applied");

/// Queue a job
///
/// The job is checked, its cost estimated, and what is accepted survives a crash. With `Prefer: wait=N` the result
/// comes at once if there is one within N seconds. With `Idempotency-Key` the submission may be repeated.
#[utoipa::path(
    post, path = "/v1/jobs", tag = "jobs",
    params(
        PriorityQuery,
        ("Prefer" = Option<String>, Header, description = "`wait=N`: the client would wait N seconds for the \
            result (RFC 7240). Cut at the service's limit; what is not understood is ignored.",
            example = "wait=10"),
        ("Idempotency-Key" = Option<String>, Header, description = "The client's name for this submission, in \
            visible ASCII characters without spaces, bare or in quotes. The same body under the same key is the \
            same job; another body is refused.", pattern = r#"^("[!-~]{1,255}"|[!-~]{1,255})$"#,
            example = "press-7"),
    ),
    request_body(content = ref("#/components/schemas/ContactJob"), content_type = "application/json", description = "The job."),
    responses(
        (status = OK, description = "The result, within the time the client would wait.", body = ref("#/components/schemas/Report"), content_type = "application/json", headers(
            ("Content-Location" = String, description = "Address of the result."),
            ("Preference-Applied" = String, description = "The wait that was granted, `wait=N`."),
            ("Idempotency-Replayed" = String, description = "`true` if the job was submitted before."),
        )),
        (status = ACCEPTED, description = "The job is queued, or was before.", body = Receipt, headers(
            ("Location" = String, description = "Address of the job."),
            ("Preference-Applied" = String, description = "The wait that was granted, `wait=N`."),
            ("Idempotency-Replayed" = String, description = "`true` if the job was submitted before."),
        )),
    ),
    extensions(("x-problems" = json!([
        "invalid-header", "invalid-job", "job-too-large", "idempotency-key-reused", "queue-full", "quota-exceeded", "too-many-jobs", "insufficient-storage",
        "shutting-down", "no-result", "solve-failed"
    ]))),
)]
pub(in crate::http) async fn post_job(
    State(state): State<HttpState>,
    PreferWait(timeout): PreferWait,
    IdempotencyKey(idempotency_key): IdempotencyKey,
    Priority(priority): Priority,
    caller: Caller,
    headers: HeaderMap,
    JobBody(request): JobBody,
) -> Result<Response, Problem> {
    state.rates.take(caller.key())?;
    let submission =
        Submission { request, priority, submitter: caller.key(), idempotency_key, interactive: false };
    let enqueued = state.jobs.submit(submission).await?;
    let mut record = enqueued.job;
    if let Some(timeout) = timeout {
        record = state.jobs.wait(record.id, timeout).await?;
    }
    let mut response = if timeout.is_some() && record.state.is_finished() {
        finished(&state, &record, &headers).await.unwrap_or_else(IntoResponse::into_response)
    } else {
        wire::accepted(&record)
    };
    let sent = response.headers_mut();
    if enqueued.replayed {
        sent.insert(REPLAYED, HeaderValue::from_static("true"));
    }
    if let Some(timeout) = timeout {
        let applied = HeaderValue::try_from(format!("wait={}", timeout.as_secs()));
        sent.extend(applied.ok().map(|applied| (APPLIED, applied)));
    }
    Ok(response)
}
