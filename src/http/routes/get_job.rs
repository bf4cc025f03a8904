//! `GET /v1/jobs/{id}[?wait=s]`: where a job stands, at once or when it is done.

use axum::extract::State;
use axum::http::HeaderMap;
use axum::response::{IntoResponse, Response};

use super::answer::{apply_preference, with_result};
use crate::http::access::Caller;
use crate::http::job_path::JobPath;
use crate::http::preference::Prefer;
use crate::http::prefix::Prefix;
use crate::http::query::Wait;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Where a job stands
///
/// At once, or with `wait` when the job is done; then its result is inside, if it has one.
#[utoipa::path(
    get, path = "/v1/jobs/{id}", tag = "jobs", params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        Wait,
        Prefer,
    ),
    responses((status = OK, description = "The job.", body = JobDocument,
        content_type = "application/json", headers(
        ("Retry-After" = u32, description = "Seconds after which to ask again; until the job is \
                                             done."),
        ("Preference-Applied" = String, description = "The wait that was granted, `wait=N`."),
    ))),
)]
pub(in crate::http) async fn get_job(
    State(state): State<HttpState>,
    caller: Caller,
    JobPath(id): JobPath,
    prefix: Prefix,
    Wait { granted: wait, selection }: Wait,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let record = match wait {
        Some(wait) => state.jobs.wait(id, wait.timeout).await?,
        None => state.jobs.get(id).await?,
    };
    let job = JobDocument::of(&state, record, &prefix).await?;
    let mut response = if wait.is_some() {
        with_result(&state, caller, job, selection, &headers).await?
    } else {
        job.into_response()
    };
    apply_preference(&mut response, wait);
    Ok(response)
}
