//! `GET /livez` and `GET /readyz`, for whatever keeps the service running.

use axum::Json;
use axum::extract::State;
use serde_json::{Value, json};

use crate::http::{HttpState, Problem, ProblemType};

/// The process answers.
pub(in crate::http) async fn livez() -> Json<Value> {
    Json(json!({"status": "alive"}))
}

/// The service takes jobs: it is not shutting down and its store answers. A full queue is no reason to be
/// taken out of service.
pub(in crate::http) async fn readyz(State(state): State<HttpState>) -> Result<Json<Value>, Problem> {
    if state.desk.is_closed() {
        return Err(Problem::new(ProblemType::ShuttingDown, "the service is shutting down"));
    }
    state.desk.ping().await?;
    Ok(Json(json!({"status": "ready"})))
}
