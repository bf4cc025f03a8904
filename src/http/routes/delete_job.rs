//! `DELETE /v1/jobs/{id}`: remove a finished job and its result.

use axum::extract::State;
use axum::http::StatusCode;

use crate::http::job_path::JobPath;
use crate::http::{HttpState, Problem};

pub(in crate::http) async fn delete_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
) -> Result<StatusCode, Problem> {
    state.desk.delete(id).await?;
    Ok(StatusCode::NO_CONTENT)
}
