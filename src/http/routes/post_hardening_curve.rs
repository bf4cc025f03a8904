//! `POST /v1/hardening-curves`: the hardening curve of a tensile test.

use axum::Json;
use axum::extract::State;
use brinell_solver::job::tensile::TestedCurve;

use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::{HttpState, Problem};

/// The hardening curve of a tensile test
///
/// Fits the first slope, removes the toe and the elastic part, converts to true stress, leaves out
/// unloading and what lies beyond necking, and fits noise by a curve that never falls. Nothing is
/// stored.
#[utoipa::path(
    post, path = "/v1/hardening-curves", tag = "theory",
    request_body(
        content = ref("#/components/schemas/TensileTest"), content_type = "application/json",
        description = "The record of the test.",
    ),
    responses((status = OK, description = "The curve, for the law `table`.", body = TestedCurve)),
    extensions(("x-problems" = json!(["invalid-job"]))),
)]
pub(in crate::http) async fn post_hardening_curve(
    State(state): State<HttpState>,
    caller: Caller,
    JobBody(text): JobBody,
) -> Result<Json<TestedCurve>, Problem> {
    Ok(Json(state.jobs.hardening_curve(text, caller.key()).await?))
}
