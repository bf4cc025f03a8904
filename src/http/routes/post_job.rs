//! `POST /v1/jobs`: queue a job.

use axum::extract::State;
use axum::response::Response;

use crate::http::body::JobBody;
use crate::http::{HttpState, Problem, wire};
use crate::jobs::Submission;

pub(in crate::http) async fn post_job(
    State(state): State<HttpState>,
    JobBody(text): JobBody,
) -> Result<Response, Problem> {
    let enqueued = state.desk.submit(Submission { request: text, ..Submission::default() }).await?;
    Ok(wire::accepted(&enqueued.job))
}
