//! `GET /metrics`: what has been measured, for Prometheus. Not here if it has a port of its own.

use axum::extract::State;

use crate::http::metrics::Exposition;
use crate::http::{HttpState, Problem, ProblemType};

/// What has been measured, in Prometheus's text format
///
/// Not here where `--metrics-listen` gives it a port of its own. Needs an API key where keys are
/// needed.
#[utoipa::path(
    get, path = "/metrics", tag = "service",
    responses((status = OK, description = "The \
                                           figures.", body = String, content_type = "text/plain")),
    extensions(("x-problems" = json!(["not-found"]))),
)]
pub(in crate::http) async fn get_metrics(
    State(state): State<HttpState>,
) -> Result<Exposition, Problem> {
    let elsewhere = || Problem::new(ProblemType::NotFound, "metrics are on a port of their own");
    Ok(state.metrics.as_ref().ok_or_else(elsewhere)?.show().await)
}
