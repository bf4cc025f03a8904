//! `GET /openapi.json`: this interface, for programs.

use std::sync::LazyLock;

use axum::Extension;
use axum::body::Bytes;
use axum::http::HeaderMap;
use axum::http::header::{CONTENT_ENCODING, CONTENT_TYPE, VARY};
use axum::response::{IntoResponse, Response};

use serde_json::json;

use crate::http::negotiation::takes_gzip;
use crate::http::openapi;
use crate::http::prefix::Prefix;
use crate::http::result_body::CodingChosen;
use crate::jobs::{Deflated, GzipStream};

/// This interface as an OpenAPI 3.1 document
#[utoipa::path(
    get, path = "/openapi.json", tag = "service",
    responses((status = OK, description = "The document.", body = serde_json::Value)),
)]
pub(in crate::http) async fn get_openapi(prefix: Prefix, headers: HeaderMap) -> Response {
    let about = [(CONTENT_TYPE, "application/json"), (VARY, "accept-encoding")];
    if let Some(server) = prefix.server() {
        let mut document = openapi::document();
        document["servers"] = json!([{"url": server}]);
        return (about, document.to_string()).into_response();
    }
    match takes_gzip(&headers).then(|| COMPRESSED.clone()).flatten() {
        Some(text) => {
            (about, [(CONTENT_ENCODING, "gzip")], Extension(CodingChosen), text).into_response()
        }
        None => (about, openapi::text()).into_response(),
    }
}

/// The document as most clients take it, compressed once; `None` if that fails.
static COMPRESSED: LazyLock<Option<Bytes>> = LazyLock::new(|| {
    let text = Deflated::compress(openapi::text().as_bytes()).ok()?;
    let (mut gzip, begin) = GzipStream::begin();
    let text = gzip.append(&text);
    Some([begin, text, gzip.end()].concat().into())
});
