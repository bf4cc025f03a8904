//! `POST /v1/jobs`: queue a job.
//!
//! `Prefer: wait=N` answers 200 with the result if there is one within N seconds, `Preference-Applied` says so.
//! `Idempotency-Key` makes the submission repeatable: the same body under the same key is the same job.

use axum::extract::State;
use axum::http::{HeaderName, HeaderValue};
use axum::response::{IntoResponse, Response};

use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::preference::{IdempotencyKey, PreferWait};
use crate::http::query::Priority;
use crate::http::{HttpState, Problem, wire};
use crate::jobs::Submission;

use super::get_result::finished;

const REPLAYED: HeaderName = HeaderName::from_static("idempotency-replayed");
const APPLIED: HeaderName = HeaderName::from_static("preference-applied");

pub(in crate::http) async fn post_job(
    State(state): State<HttpState>,
    PreferWait(patience): PreferWait,
    IdempotencyKey(idempotency_key): IdempotencyKey,
    Priority(priority): Priority,
    caller: Caller,
    JobBody(request): JobBody,
) -> Result<Response, Problem> {
    state.rates.take(caller.key())?;
    let submission =
        Submission { request, priority, submitter: caller.key(), idempotency_key, ephemeral: false };
    let enqueued = state.desk.submit(submission).await?;
    let mut record = enqueued.job;
    if let Some(patience) = patience {
        record = state.desk.wait(record.id, patience).await?;
    }
    let mut response = if patience.is_some() && record.state.is_finished() {
        finished(&state, &record).await.unwrap_or_else(IntoResponse::into_response)
    } else {
        wire::accepted(&record)
    };
    let headers = response.headers_mut();
    if enqueued.replayed {
        headers.insert(REPLAYED, HeaderValue::from_static("true"));
    }
    if let Some(patience) = patience {
        let applied = HeaderValue::try_from(format!("wait={}", patience.as_secs()));
        headers.extend(applied.ok().map(|applied| (APPLIED, applied)));
    }
    Ok(response)
}
