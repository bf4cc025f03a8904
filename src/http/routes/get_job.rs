//! `GET /v1/jobs/{id}[?wait=s]`: where a job stands, at once or when it has finished.

use axum::Json;
use axum::extract::State;

use crate::http::job_path::{JobPath, Wait, WaitQuery};
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Where a job stands
///
/// At once, or with `wait` when the job has finished.
#[utoipa::path(
    get, path = "/v1/jobs/{id}", tag = "jobs", params(("id" = JobId, Path, description = "The job's id, as its receipt and its `Location` have it."), WaitQuery),
    responses((status = OK, description = "The job.", body = JobDocument)),
)]
pub(in crate::http) async fn get_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    Wait(timeout): Wait,
) -> Result<Json<JobDocument>, Problem> {
    Ok(Json(state.jobs.wait(id, timeout).await?.into()))
}
