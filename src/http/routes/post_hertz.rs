//! `POST /v1/hertz`: the closed form for a job, without a mesh: Hertz's contact and the onset of
//! yield.

use axum::Json;
use axum::extract::State;

use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::{HttpState, Problem};
use crate::jobs::ClosedForm;

/// The closed form of a job, without a mesh
///
/// Hertz's contact and the onset of yield, for arcs that open away from the contact under a force
/// or forces.
#[utoipa::path(
    post, path = "/v1/hertz", tag = "theory",
    request_body(
        content = ref("#/components/schemas/ContactJob"), content_type = "application/json",
        description = "The job.",
    ),
    responses((status = OK, description = "Hertz's figures.", body = ClosedForm)),
    extensions(("x-problems" = json!(["invalid-job"]))),
)]
pub(in crate::http) async fn post_hertz(
    State(state): State<HttpState>,
    caller: Caller,
    JobBody(text): JobBody,
) -> Result<Json<ClosedForm>, Problem> {
    Ok(Json(state.jobs.closed_form(text, caller.key()).await?))
}
