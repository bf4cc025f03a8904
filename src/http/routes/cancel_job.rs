//! `POST /v1/jobs/{id}/cancel`: ask a job to stop. Asking twice, or too late, is no error.

use axum::Json;
use axum::extract::State;

use crate::http::job_path::JobPath;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Ask a job to stop
///
/// A queued job is cancelled at once, a running one stops within one iteration and keeps what it has. Asking twice,
/// or too late, is no error.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/cancel", tag = "jobs", params(("id" = JobId, Path, description = "The job's id, as its receipt and its `Location` have it.")),
    responses((status = OK, description = "The job as it is now.", body = JobDocument)),
)]
pub(in crate::http) async fn cancel_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
) -> Result<Json<JobDocument>, Problem> {
    Ok(Json(state.jobs.cancel(id).await?.into()))
}
