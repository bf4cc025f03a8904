//! `POST /v1/jobs/{id}/cancel`: ask a job to stop. Asking twice, or too late, is no error.

use axum::Json;
use axum::extract::State;

use crate::http::job_path::JobPath;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};

pub(in crate::http) async fn cancel_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
) -> Result<Json<JobDocument>, Problem> {
    Ok(Json(state.desk.cancel(id).await?.into()))
}
