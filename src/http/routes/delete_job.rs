//! `DELETE /v1/jobs/{id}`: remove a finished job and its result.

use axum::extract::State;
use axum::http::StatusCode;

use crate::http::access::Caller;
use crate::http::job_path::JobPath;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Remove a finished job and its result
#[utoipa::path(
    delete, path = "/v1/jobs/{id}", tag = "jobs",
    params(("id" = JobId, Path, description = "The job's id, as its `Location` has it.")),
    responses((status = NO_CONTENT, description = "The job is gone.")),
    extensions(("x-problems" = json!(["job-unfinished"]))),
)]
pub(in crate::http) async fn delete_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    caller: Caller,
) -> Result<StatusCode, Problem> {
    state.jobs.delete(id, caller.key()).await?;
    Ok(StatusCode::NO_CONTENT)
}
