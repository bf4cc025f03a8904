//! `GET /v1/jobs?status&tag&limit&cursor`: jobs, newest first, page by page.

use axum::Json;
use axum::extract::State;

use crate::http::access::Caller;
use crate::http::query::ListFilter;
use crate::http::wire::{JobDocument, JobList};
use crate::http::{HttpState, Problem};

pub(in crate::http) async fn list_jobs(
    State(state): State<HttpState>,
    caller: Caller,
    ListFilter(mut filter): ListFilter,
) -> Result<Json<JobList>, Problem> {
    filter.submitter = caller.confined_to();
    let page = state.desk.list(&filter).await?;
    let jobs = page.jobs.into_iter().map(JobDocument::from).collect();
    Ok(Json(JobList { jobs, next_cursor: page.next }))
}
