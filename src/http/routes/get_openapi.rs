//! `GET /openapi.json`: this interface, for programs.

use axum::http::HeaderName;
use axum::http::header::CONTENT_TYPE;

use crate::http::openapi;

/// This interface as an OpenAPI 3.1 document
#[utoipa::path(
    get, path = "/openapi.json", tag = "service",
    responses((status = OK, description = "The document.", body = serde_json::Value)),
)]
pub(in crate::http) async fn get_openapi() -> ([(HeaderName, &'static str); 1], &'static str) {
    ([(CONTENT_TYPE, "application/json")], openapi::text())
}
