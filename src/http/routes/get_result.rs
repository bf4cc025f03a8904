//! `GET /v1/jobs/{id}/result`: the report, complete or as far as a stopped job came, or the parts
//! of it that are wanted.

use axum::extract::State;
use axum::http::header::VARY;
use axum::http::{HeaderMap, HeaderValue};
use axum::response::Response;

use crate::http::access::Caller;
use crate::http::export_file::export_file;
use crate::http::job_path::JobPath;
use crate::http::negotiation::prefers_csv;
use crate::http::query::Selection;
use crate::http::result_body::{SentResult, no_result};
use crate::http::{HttpState, Problem};
use crate::jobs::{Export, JobId};
use brinell_solver::report::Report;

/// The result of a job
///
/// Complete, or as far as a stopped job came; its `status` says which. It is sent step by step as
/// it is read. Where only some parts are wanted, the others are left out or empty. With `Accept:
/// text/csv` one row of figures for each step, as `summary.csv`.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/result", tag = "results", params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        Selection,
    ),
    responses(
        (status = OK, description = "The result.", content(
            (Report = "application/json"),
            (String = "text/csv"),
        ), headers(
            ("ETag" = String, description = "Name of these bytes, for `If-None-Match`; of JSON."),
            ("Vary" = String, description = "`accept`: the answer is in the form that the client \
                                             accepts."),
        )),
        (status = NOT_MODIFIED, description = "The client has these bytes already."),
    ),
    extensions(("x-problems" = json!(["job-unfinished", "no-result", "step-not-found"]))),
)]
pub(in crate::http) async fn get_result(
    State(state): State<HttpState>,
    caller: Caller,
    JobPath(id): JobPath,
    selection: Selection,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    if prefers_csv(&headers) {
        return summary(&state, caller, id, selection.step).await;
    }
    match state.jobs.result(id).await? {
        Some(head) => SentResult { state, caller, id, head, selection }.alone(&headers),
        None => Err(no_result(&state.jobs.get(id).await?)),
    }
}

/// The rows of all steps, or of one.
async fn summary(
    state: &HttpState,
    caller: Caller,
    id: JobId,
    step: Option<usize>,
) -> Result<Response, Problem> {
    let mut response = export_file(state, caller, id, Export::SummaryCsv, step).await?;
    response.headers_mut().insert(VARY, HeaderValue::from_static("accept, accept-encoding"));
    Ok(response)
}
