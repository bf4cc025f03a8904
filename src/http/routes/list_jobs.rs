//! `GET /v1/jobs?status&tag&id&since&until&sort&limit&cursor`: jobs, page by page.

use axum::Json;
use axum::extract::State;

use crate::http::access::Caller;
use crate::http::prefix::Prefix;
use crate::http::query::ListFilter;
use crate::http::wire::{JobDocument, JobList};
use crate::http::{HttpState, Problem};

/// Jobs, page by page
///
/// With API keys, the jobs of the asking key; of an administrator's, all. Places in the queue are
/// told job by job only.
#[utoipa::path(
    get, path = "/v1/jobs", tag = "jobs", params(ListFilter),
    responses((status = OK, description = "A page of jobs.", body = JobList)),
)]
pub(in crate::http) async fn list_jobs(
    State(state): State<HttpState>,
    caller: Caller,
    prefix: Prefix,
    ListFilter(mut filter): ListFilter,
) -> Result<Json<JobList>, Problem> {
    filter.submitter = caller.confined_to();
    let page = state.jobs.store().list(&filter).await?;
    let jobs = page
        .jobs
        .into_iter()
        .map(|job| JobDocument::brief(job, &state.settings.retention, &prefix))
        .collect();
    Ok(Json(JobList { jobs, next_cursor: page.next }))
}
