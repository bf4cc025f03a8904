//! `POST /v1/batch/submit`: queue several jobs in one step.

use axum::Json;
use axum::extract::State;

use crate::http::access::Caller;
use crate::http::batch::{BatchAnswer, BatchItem, BatchOfJobs, read_jobs};
use crate::http::body::JobBody;
use crate::http::preference::{IdempotencyKey, KeyOfBatch};
use crate::http::prefix::Prefix;
use crate::http::request_log::Trace;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::Submission;

/// Queue several jobs
///
/// Each is checked, counted and answered as it would be by itself: one that is refused does not
/// touch the others. All that are accepted are queued in one step, in this order. The header
/// `Idempotency-Key` names all of them: the same request again is answered with the same jobs.
#[utoipa::path(
    post, path = "/v1/batch/submit", tag = "jobs",
    params(KeyOfBatch),
    request_body(
        content = BatchOfJobs, content_type = "application/json",
        description = "The jobs, 100 at most.",
    ),
    responses((status = OK, description = "What became of each job.", body = BatchAnswer)),
    extensions(("x-problems" = json!([
        "invalid-header", "invalid-batch", "insufficient-storage", "shutting-down"
    ]))),
)]
pub(in crate::http) async fn batch_submit(
    State(state): State<HttpState>,
    IdempotencyKey(idempotency_key): IdempotencyKey,
    Trace(trace): Trace,
    prefix: Prefix,
    caller: Caller,
    JobBody(text): JobBody,
) -> Result<Json<BatchAnswer>, Problem> {
    let mut items = Vec::new();
    let mut submissions = Vec::new();
    for (place, read) in read_jobs(&text, &state.callbacks)?.into_iter().enumerate() {
        let refused = state.rates.take(caller.key()).err();
        let is_refused = refused.is_some();
        items.push(refused.map(|problem| BatchItem::refused(None, problem)));
        if is_refused {
            continue;
        }
        // No key of a client has a space.
        let derived = || idempotency_key.as_ref().map(|key| format!("{key} {place}"));
        submissions.push(Submission {
            request: read.job,
            priority: read.priority,
            submitter: caller.key(),
            idempotency_key: read.idempotency_key.or_else(derived),
            interactive: false,
            callback_url: read.callback_url,
            trace,
        });
    }
    let mut taken = state.jobs.submit_all(submissions).await?.into_iter();
    let mut answered = Vec::with_capacity(items.len());
    for item in items {
        let item = match item {
            Some(refused) => refused,
            None => match taken.next() {
                Some(Ok(enqueued)) => {
                    let job = JobDocument::taken_in(&state, enqueued.job, &prefix).await;
                    BatchItem::submitted(job, enqueued.replayed)
                }
                Some(Err(error)) => BatchItem::refused(None, error.into()),
                None => continue,
            },
        };
        answered.push(item);
    }
    Ok(Json(BatchAnswer::of(answered)))
}
