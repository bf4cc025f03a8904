//! `GET /livez` and `GET /readyz`, for whatever keeps the service running.

use axum::Json;
use axum::extract::State;

use crate::http::wire::Health;
use crate::http::{HttpState, Problem, ProblemType};

/// The process answers, and so has its store within the last minute
#[utoipa::path(
    get, path = "/livez", tag = "service",
    responses((status = OK, description = "`alive`.", body = Health)),
    extensions(("x-problems" = json!(["store-unavailable"]))),
)]
pub(in crate::http) async fn livez(
    State(state): State<HttpState>,
) -> Result<Json<Health>, Problem> {
    if state.jobs.is_store_alive() {
        return Ok(Json(Health { status: "alive" }));
    }
    let detail = "the store has not answered for a minute";
    Err(Problem::new(ProblemType::StoreUnavailable, detail))
}

/// The service takes jobs
///
/// It is not shutting down, its store is not damaged, can be written to and has room for another
/// job. A full queue is no reason to be taken out of service.
#[utoipa::path(
    get, path = "/readyz", tag = "service",
    responses((status = OK, description = "`ready`.", body = Health)),
    extensions(("x-problems" = json!([
        "shutting-down", "store-unavailable", "damaged-record", "insufficient-storage"
    ]))),
)]
pub(in crate::http) async fn readyz(
    State(state): State<HttpState>,
) -> Result<Json<Health>, Problem> {
    if state.jobs.is_closed() {
        return Err(Problem::new(ProblemType::ShuttingDown, "the service is shutting down"));
    }
    state.jobs.ping().await?;
    Ok(Json(Health { status: "ready" }))
}
