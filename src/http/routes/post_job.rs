//! `POST /v1/jobs`: queue a job.
//!
//! With `?wait=N` or `Prefer: wait=N` the answer is 200 with the result inside if the job is done
//! within N seconds. `Idempotency-Key` makes the submission repeatable: the same body under the
//! same key is the same job.

use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::{IntoResponse, Response};

use super::answer::{apply_preference, finished, mark_replayed, submitted, unless_out_of_reach};
use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::preference::{IdempotencyKey, Prefer};
use crate::http::prefix::Prefix;
use crate::http::query::{SubmitQuery, Wait};
use crate::http::request_log::Trace;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::Submission;

/// Queue a job
///
/// The job is checked, its cost estimated, and what is accepted survives a crash. With `wait` the
/// answer comes when the job is done, with its result inside. With `Idempotency-Key` the
/// submission may be repeated.
#[utoipa::path(
    post, path = "/v1/jobs", tag = "jobs",
    params(
        SubmitQuery,
        Wait,
        Prefer,
        IdempotencyKey,
    ),
    request_body(
        content = ref("#/components/schemas/ContactJob"), content_type = "application/json",
        description = "The job.",
    ),
    responses(
        (
            status = OK,
            description = "The job is done: within the time the client would wait, and then its \
                result is inside; or it was submitted before.",
            body = JobDocument, content_type = "application/json",
            headers(
                ("Content-Location" = String, description = "Address of the job."),
                (
                    "Preference-Applied" = String,
                    description = "The wait that was granted, `wait=N`."
                ),
                (
                    "Idempotency-Replayed" = String,
                    description = "`true` if the job was submitted before."
                ),
            ),
        ),
        (
            status = ACCEPTED,
            description = "The job is queued, or was before.",
            body = JobDocument, content_type = "application/json",
            headers(
                ("Location" = String, description = "Address of the job."),
                ("Retry-After" = u32, description = "Seconds after which to ask for the job."),
                (
                    "Preference-Applied" = String,
                    description = "The wait that was granted, `wait=N`."
                ),
                (
                    "Idempotency-Replayed" = String,
                    description = "`true` if the job was submitted before."
                ),
            ),
        ),
    ),
    extensions(("x-problems" = json!([
        "invalid-header", "invalid-job", "job-too-large", "idempotency-key-reused",
        "queue-full", "quota-exceeded", "too-many-jobs", "insufficient-storage",
        "shutting-down", "no-result", "solve-failed"
    ]))),
)]
#[expect(clippy::too_many_arguments, reason = "each is taken out of the request by its type")]
pub(in crate::http) async fn post_job(
    State(state): State<HttpState>,
    IdempotencyKey(idempotency_key): IdempotencyKey,
    SubmitQuery { priority, wait, selection, callback_url }: SubmitQuery,
    Trace(trace): Trace,
    prefix: Prefix,
    caller: Caller,
    headers: HeaderMap,
    JobBody(request): JobBody,
) -> Result<Response, Problem> {
    state.rates.take(caller.key())?;
    let submission = Submission {
        request,
        priority,
        submitter: caller.key(),
        idempotency_key,
        interactive: false,
        callback_url,
        trace,
    };
    let enqueued = state.jobs.submit(submission).await?;
    let answer = if let Some(wait) = wait {
        let known = JobDocument::brief(enqueued.job.clone(), &state.settings.retention, &prefix);
        let waited = async {
            let record = state.jobs.wait(enqueued.job.id, wait.timeout).await?;
            finished(&state, caller, record, &prefix, selection, &headers).await
        };
        unless_out_of_reach(waited.await, known)
    } else {
        Ok(submitted(JobDocument::taken_in(&state, enqueued.job, &prefix).await))
    };
    let mut response = answer.unwrap_or_else(IntoResponse::into_response);
    mark_replayed(&mut response, enqueued.replayed);
    apply_preference(&mut response, wait);
    Ok(response)
}
