//! `GET /openapi.json`: this interface, for programs.

use std::sync::OnceLock;

use axum::Extension;
use axum::body::Bytes;
use axum::http::HeaderMap;
use axum::http::header::{CONTENT_ENCODING, CONTENT_TYPE, VARY};
use axum::response::{IntoResponse, Response};

use serde_json::{Value, json};

use crate::http::negotiation::takes_gzip;
use crate::http::prefix::Prefix;
use crate::http::result_body::CodingChosen;
use crate::jobs::{Deflated, GzipStream};

/// How to make the document: from all routes, this one among them.
#[derive(Clone, Copy)]
pub(in crate::http) struct Document {
    pub(in crate::http) value: fn() -> Value,
    pub(in crate::http) text: fn() -> &'static str,
}

/// This interface as an OpenAPI 3.1 document
#[utoipa::path(
    get, path = "/openapi.json", tag = "service",
    responses((status = OK, description = "The document.", body = serde_json::Value)),
)]
pub(in crate::http) async fn get_openapi(
    Extension(document): Extension<Document>,
    prefix: Prefix,
    headers: HeaderMap,
) -> Response {
    let about = [(CONTENT_TYPE, "application/json"), (VARY, "accept-encoding")];
    if let Some(server) = prefix.server() {
        let mut document = (document.value)();
        document["servers"] = json!([{"url": server}]);
        return (about, document.to_string()).into_response();
    }
    let text = (document.text)();
    match takes_gzip(&headers).then(|| compressed(text)).flatten() {
        Some(text) => {
            (about, [(CONTENT_ENCODING, "gzip")], Extension(CodingChosen), text).into_response()
        }
        None => (about, text).into_response(),
    }
}

/// The document as most clients take it, compressed once; `None` if that fails.
fn compressed(text: &str) -> Option<Bytes> {
    static COMPRESSED: OnceLock<Option<Bytes>> = OnceLock::new();
    let compress = || {
        let text = Deflated::compress(text.as_bytes()).ok()?;
        let (mut gzip, begin) = GzipStream::begin();
        let text = gzip.append(&text);
        Some([begin, text, gzip.end()].concat().into())
    };
    COMPRESSED.get_or_init(compress).clone()
}
