//! `GET /v1/jobs/{id}/result`: the report, complete or as far as a stopped job came.

use axum::extract::State;
use axum::http::HeaderMap;
use axum::http::header::ACCEPT_ENCODING;
use axum::response::Response;

use crate::http::job_path::JobPath;
use crate::http::query::{ResultQuery, ResultSelection};
use crate::http::result_body::{self, ResultParts};
use crate::http::{HttpState, Problem, ProblemType};
use crate::jobs::{JobId, JobRecord};

/// The result of a job
///
/// Complete, or as far as a stopped job came; its `status` says which. It is sent step by step as it is read.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result", tag = "results", params(("id" = JobId, Path, description = "The job's id, as its receipt and its `Location` have it."), ResultQuery),
    responses(
        (status = OK, description = "The result.", body = ref("#/components/schemas/Report"), content_type = "application/json", headers(
            ("Content-Location" = String, description = "Address of the result."),
            ("ETag" = String, description = "Name of these bytes, for `If-None-Match`."),
        )),
        (status = NOT_MODIFIED, description = "The client has these bytes already."),
    ),
    extensions(("x-problems" = json!(["invalid-query", "job-unfinished", "no-result"]))),
)]
pub(in crate::http) async fn get_result(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    ResultSelection(parts): ResultSelection,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    match state.jobs.result(id).await? {
        Some(head) => result_body::result(&state, id, head, parts, &headers).await,
        None => Err(no_result(&state.jobs.get(id).await?)),
    }
}

/// The answer to a client that has waited for the end of a job.
pub(super) async fn finished(
    state: &HttpState,
    record: &JobRecord,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    match (state.jobs.result(record.id).await?, &record.failure) {
        (Some(head), _) => {
            // The request is not one for the result: what the client has of that does not matter.
            let mut accepted = HeaderMap::new();
            accepted.extend(
                headers.get_all(ACCEPT_ENCODING).iter().map(|value| (ACCEPT_ENCODING, value.clone())),
            );
            result_body::result(state, record.id, head, ResultParts::default(), &accepted).await
        }
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
