//! `POST /v1/validate`: check a job and estimate its cost without solving it.

use axum::Json;
use axum::extract::State;

use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::wire::Validation;
use crate::http::{HttpState, Problem};

/// Check a job and estimate its cost without solving it
#[utoipa::path(
    post, path = "/v1/validate", tag = "theory",
    request_body(
        content = ref("#/components/schemas/ContactJob"), content_type = "application/json",
        description = "The job.",
    ),
    responses((status = OK, description = "The job is in order.", body = Validation)),
    extensions(("x-problems" = json!(["invalid-job", "job-too-large"]))),
)]
pub(in crate::http) async fn post_validate(
    State(state): State<HttpState>,
    caller: Caller,
    JobBody(text): JobBody,
) -> Result<Json<Validation>, Problem> {
    let estimate = state.jobs.validate(text, caller.key()).await?;
    Ok(Json(Validation { valid: true, estimate }))
}
