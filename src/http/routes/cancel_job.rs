//! `POST /v1/jobs/{id}/cancel`: ask a job to stop. Asking twice, or too late, is no error.

use axum::extract::State;

use crate::http::access::Caller;
use crate::http::job_path::JobPath;
use crate::http::prefix::Prefix;
use crate::http::wire::JobDocument;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Ask a job to stop
///
/// A queued job is cancelled at once, a running one stops within one iteration and keeps what it
/// has. Asking twice, or too late, is no error.
#[utoipa::path(
    post, path = "/v1/jobs/{id}/cancel", tag = "jobs",
    params(("id" = JobId, Path, description = "The job's id, as its `Location` has it.")),
    responses((status = OK, description = "The job as it is now.", body = JobDocument, headers(
        ("Retry-After" = u32, description = "Seconds after which to ask again; until the job is \
                                             done."),
    ))),
)]
pub(in crate::http) async fn cancel_job(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    prefix: Prefix,
    caller: Caller,
) -> Result<JobDocument, Problem> {
    Ok(JobDocument::of(&state, state.jobs.cancel(id, caller.key()).await?, &prefix).await?)
}
