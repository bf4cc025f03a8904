//! `POST /v1/hertz`: the closed form for a job, without a mesh: Hertz's contact and the onset of yield.

use axum::Json;
use axum::extract::State;

use crate::http::body::JobBody;
use crate::http::{HttpState, Problem};
use crate::jobs::ClosedForm;

pub(in crate::http) async fn post_hertz(
    State(state): State<HttpState>,
    JobBody(text): JobBody,
) -> Result<Json<ClosedForm>, Problem> {
    Ok(Json(state.desk.closed_form(&text)?))
}
