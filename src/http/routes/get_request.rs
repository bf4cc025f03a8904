//! `GET /v1/jobs/{id}/request`: the job as it was submitted, so that it can be looked at, changed
//! and sent again.

use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};

use crate::http::job_path::JobPath;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// A job as it was submitted
///
/// To the letter, so that it can be looked at, changed and sent again.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/request", tag = "jobs",
    params(("id" = JobId, Path, description = "The job's id, as its `Location` has it.")),
    responses((
        status = OK, description = "The job.", body = ref("#/components/schemas/ContactJob"),
        content_type = "application/json",
    )),
)]
pub(in crate::http) async fn get_request(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
) -> Result<Response, Problem> {
    let json = state.jobs.store().request(id).await?;
    Ok(([(CONTENT_TYPE, "application/json")], json).into_response())
}
