//! `POST /v1/batch/fetch`: several jobs with their results.

use axum::extract::State;
use axum::response::Response;

use crate::http::access::Caller;
use crate::http::batch::{BatchAnswer, BatchOfIds, fetched, read_ids};
use crate::http::body::JobBody;
use crate::http::prefix::Prefix;
use crate::http::query::Selection;
use crate::http::{HttpState, Problem};

/// Several jobs with their results
///
/// Those that are done and have a result have it inside, or the parts of it that are wanted. The
/// answer is sent job by job as it is read. `GET /v1/jobs?id=` has the same jobs without results.
#[utoipa::path(
    post, path = "/v1/batch/fetch", tag = "results", params(Selection),
    request_body(
        content = BatchOfIds, content_type = "application/json",
        description = "The jobs, 100 at most.",
    ),
    responses((status = OK, description = "Each job as it is now.", body = BatchAnswer)),
    extensions(("x-problems" = json!(["invalid-batch"]))),
)]
pub(in crate::http) async fn batch_fetch(
    State(state): State<HttpState>,
    prefix: Prefix,
    caller: Caller,
    selection: Selection,
    JobBody(text): JobBody,
) -> Result<Response, Problem> {
    Ok(fetched(state, caller, prefix, selection, read_ids(&text)?))
}
