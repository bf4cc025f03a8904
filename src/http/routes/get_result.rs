//! `GET /v1/jobs/{id}/result`: the report, complete or as far as a stopped job came.

use axum::extract::State;
use axum::response::Response;

use crate::http::job_path::JobPath;
use crate::http::{HttpState, Problem, ProblemType, wire};
use crate::jobs::{JobId, JobRecord};

/// The result of a job
///
/// Complete, or as far as a stopped job came; its `status` says which.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result", tag = "results", params(("id" = JobId, Path, description = "The job's id, as its receipt and its `Location` have it.")),
    responses((status = OK, description = "The result.", body = ref("#/components/schemas/Report"), content_type = "application/json", headers(("Content-Location" = String, description = "Address of the result.")))),
    extensions(("x-problems" = json!(["job-unfinished", "no-result"]))),
)]
pub(in crate::http) async fn get_result(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
) -> Result<Response, Problem> {
    if let Some(json) = state.jobs.report(id).await? {
        return Ok(wire::report(id, json));
    }
    Err(no_result(&state.jobs.get(id).await?))
}

/// The answer to a client that has waited for the end of a job.
pub(super) async fn finished(state: &HttpState, record: &JobRecord) -> Result<Response, Problem> {
    match (state.jobs.report(record.id).await?, &record.failure) {
        (Some(json), _) => Ok(wire::report(record.id, json)),
        (None, Some(failure)) => Err(failure.into()),
        (None, None) => Err(no_result(record)),
    }
}

/// Why this job has no report.
pub(super) fn no_result(record: &JobRecord) -> Problem {
    let kind = if record.state.is_finished() { ProblemType::NoResult } else { ProblemType::JobUnfinished };
    let problem = Problem::new(kind, format!("the job is {}", record.state));
    match &record.failure {
        Some(failure) => Problem::new(kind, format!("the job failed: {}", failure.detail))
            .with_errors(failure.errors.clone()),
        None => problem,
    }
}
