//! `GET /v1/jobs/{id}/fields/{step}`: mesh and nodal fields of a step as arrays of numbers.

use axum::body::Bytes;
use axum::extract::{Path, State};
use axum::http::HeaderMap;
use axum::response::Response;
use tokio::task::spawn_blocking;

use crate::http::job_path::JobPath;
use crate::http::result_body::no_result;
use crate::http::{HttpState, Problem, ProblemType, result_body};
use crate::jobs::{JobId, StoreError};
use brinell_solver::report::FieldArrays;

/// Mesh and nodal fields of a step, as arrays of numbers
///
/// In single precision, little-endian, behind a header of JSON that lists the arrays: docs/results.md has the layout. A
/// fifth of the size of the same fields in the result, and read without parsing.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/fields/{step}", tag = "results",
    params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        ("step" = usize, Path, description = "The step, counted from 1.", minimum = 1, example = 1),
        ("Range" = Option<String>, Header, description = "One range of bytes (RFC 9110).", example = "bytes=0-1023"),
    ),
    responses(
        (status = OK, description = "The arrays.", body = Vec<u8>, content_type = "application/octet-stream", headers(
            ("ETag" = String, description = "Name of these bytes, for `If-None-Match` and `If-Range`."),
        )),
        (status = PARTIAL_CONTENT, description = "The range that was asked for.", body = Vec<u8>, content_type = "application/octet-stream"),
        (status = NOT_MODIFIED, description = "The client has these bytes already."),
        (status = RANGE_NOT_SATISFIABLE, description = "The range begins behind the end."),
    ),
    extensions(("x-problems" = json!(["step-not-found", "job-unfinished", "no-result", "not-in-result"]))),
)]
pub(in crate::http) async fn get_fields(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    Path((_, step)): Path<(String, String)>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let no_step = || Problem::new(ProblemType::StepNotFound, format!("the result has no step {step}"));
    let number = step.parse::<usize>().ok().and_then(|step| step.checked_sub(1)).ok_or_else(no_step)?;
    let Some(head) = state.jobs.result(id).await? else { return Err(no_result(&state.jobs.get(id).await?)) };
    if number >= head.steps {
        return Err(no_step());
    }
    let _decoder = state.jobs.decoder().await;
    let Some(fields) = state.jobs.fields(id, number).await? else {
        let detail = "the result has no mesh fields; solve the job with \"output\": {\"fields\": true}";
        return Err(Problem::new(ProblemType::NotInResult, detail));
    };
    let convert = move || FieldArrays::read(fields).and_then(|arrays| arrays.single_precision());
    let converted = spawn_blocking(convert).await.map_err(StoreError::unavailable)?;
    let arrays = Bytes::from(converted.map_err(StoreError::unavailable)?);
    let tag = format!("\"{id}-{}-{step}-f32\"", head.attempt);
    Ok(result_body::bytes(&tag, "application/octet-stream", arrays, &headers))
}
