//! `POST /v1/solve`: solve a job while the client waits.
//!
//! | ending | answer |
//! |---|---|
//! | a report, converged or not (see its `status`) | 200 with the job and its result |
//! | the wait is over | 202, as `POST /v1/jobs`; the job goes on |
//! | the job proved impossible | 422 |
//! | the solver or the program failed | 500 |
//! | the job was stopped before its first report | 409 |
//! | the client hung up | none; without `Idempotency-Key` the job is cancelled |

use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::{IntoResponse, Response};

use super::answer::{apply_preference, finished, mark_replayed};
use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::preference::{IdempotencyKey, Prefer};
use crate::http::prefix::Prefix;
use crate::http::query::Wait;
use crate::http::request_log::Trace;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::Submission;

/// Somebody waits: these jobs go before queued ones of ordinary priority.
const URGENT: i16 = 1;

/// Solve a job and wait for the result
///
/// Waits as long as the service allows, or as `wait` says if that is less. Past it the answer is
/// 202, as that of `POST /v1/jobs`, and the job goes on. A client that hangs up cancels its job,
/// unless it has an `Idempotency-Key` to ask again with.
#[utoipa::path(
    post, path = "/v1/solve", tag = "jobs",
    request_body(
        content = ref("#/components/schemas/ContactJob"), content_type = "application/json",
        description = "The job.",
    ),
    params(
        Wait,
        Prefer,
        IdempotencyKey,
    ),
    responses(
        (
            status = OK,
            description = "The job with its result, converged or not; its `status` says which.",
            body = JobDocument, content_type = "application/json",
            headers(
                (
                    "Content-Location" = String,
                    description = "Address of the job. A service that keeps its jobs in \
                        memory forgets it at a restart."
                ),
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
            description = "The time is over; the job goes on.",
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
pub(in crate::http) async fn post_solve(
    State(state): State<HttpState>,
    IdempotencyKey(idempotency_key): IdempotencyKey,
    Wait { granted: wait, selection }: Wait,
    Trace(trace): Trace,
    prefix: Prefix,
    caller: Caller,
    headers: HeaderMap,
    JobBody(text): JobBody,
) -> Result<Response, Problem> {
    state.rates.take(caller.key())?;
    let limit = state.settings.solve_limit;
    let timeout = wait.map_or(limit, |wait| wait.timeout.min(limit));
    let submission = Submission {
        request: text,
        priority: URGENT,
        submitter: caller.key(),
        interactive: true,
        idempotency_key,
        callback_url: None,
        trace,
    };
    let (enqueued, attended) = state.jobs.submit_attended(submission).await?;
    let id = enqueued.job.id;
    let record = state.jobs.wait(id, timeout).await?;
    if !record.state.is_finished() {
        state.jobs.store().sync().await?;
    }
    attended.release();
    let answer = finished(&state, caller, record, &prefix, selection, &headers).await;
    let mut response = answer.unwrap_or_else(IntoResponse::into_response);
    mark_replayed(&mut response, enqueued.replayed);
    apply_preference(&mut response, wait);
    Ok(response)
}
