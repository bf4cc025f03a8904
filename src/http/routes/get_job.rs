//! `GET /v1/jobs/{id}[?wait=s]`: where a job stands, at once or when it has finished.

use axum::Json;
use axum::extract::State;

use crate::http::job_path::{JobPath, Wait};
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};

pub(in crate::http) async fn get_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    Wait(patience): Wait,
) -> Result<Json<JobDocument>, Problem> {
    Ok(Json(state.desk.wait(id, patience).await?.into()))
}
