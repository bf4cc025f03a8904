//! `POST /v1/batch/cancel`: ask several jobs to stop.

use axum::Json;
use axum::extract::State;
use futures_util::{StreamExt, stream};

use crate::http::access::Caller;
use crate::http::batch::{BatchAnswer, BatchItem, BatchOfIds, read_ids};
use crate::http::body::JobBody;
use crate::http::job_path::check_seen;
use crate::http::prefix::Prefix;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Jobs that are stopped at the same time: they share one write to the disk.
const AT_ONCE: usize = 8;

/// Ask several jobs to stop
///
/// Each is stopped and answered as by its own `cancel`.
#[utoipa::path(
    post, path = "/v1/batch/cancel", tag = "jobs",
    request_body(
        content = BatchOfIds, content_type = "application/json",
        description = "The jobs, 100 at most.",
    ),
    responses((status = OK, description = "Each job as it is now.", body = BatchAnswer)),
    extensions(("x-problems" = json!(["invalid-batch"]))),
)]
pub(in crate::http) async fn batch_cancel(
    State(state): State<HttpState>,
    prefix: Prefix,
    caller: Caller,
    JobBody(text): JobBody,
) -> Result<Json<BatchAnswer>, Problem> {
    let cancelled = stream::iter(read_ids(&text)?).map(|id| cancel(&state, caller, &prefix, id));
    Ok(Json(BatchAnswer::of(cancelled.buffered(AT_ONCE).collect().await)))
}

async fn cancel(state: &HttpState, caller: Caller, prefix: &Prefix, id: JobId) -> BatchItem {
    let cancelled = async {
        check_seen(state, caller, id).await?;
        JobDocument::of(state, state.jobs.cancel(id, caller.key()).await?, prefix).await
    };
    cancelled
        .await
        .map_or_else(|error| BatchItem::refused(Some(id), error.into()), BatchItem::found)
}
