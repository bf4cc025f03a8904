//! Files of the page and of the guide as they are sent. Each is compressed once.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::{LazyLock, Mutex, PoisonError};

use axum::http::header::{
    CACHE_CONTROL, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE, ETAG, REFERRER_POLICY,
    VARY, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderMap, HeaderName, StatusCode};
use axum::response::{IntoResponse, Response};
use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;

use super::negotiation::{is_known, takes_gzip};
use super::problem::Problem;
use super::problem_type::ProblemType;

/// Compressed files by their tags: in a debug build, files change while the program runs.
static COMPRESSED: LazyLock<Mutex<HashMap<u128, Bytes>>> = LazyLock::new(Mutex::default);

/// A file as it is sent.
pub(super) struct Sent<'a> {
    pub(super) path: &'a str,
    pub(super) data: Bytes,
    /// Identifies the bytes.
    pub(super) digest: u128,
    pub(super) kept: &'static str,
    /// What the file may load and run.
    pub(super) policy: &'a str,
}

/// Answers with a file, or 304 to a client that has it.
pub(super) fn answer(file: Sent, headers: &HeaderMap) -> Result<Response, Problem> {
    let gzip = takes_gzip(headers);
    // A strong tag identifies bytes, so the compressed file has its own.
    let tag = format!("\"{:032x}{}\"", file.digest, if gzip { "-gzip" } else { "" });
    let common: [(HeaderName, &str); 7] = [
        (ETAG, &tag),
        (CACHE_CONTROL, file.kept),
        (VARY, "accept-encoding"),
        (CONTENT_SECURITY_POLICY, file.policy),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
        (CONTENT_TYPE, media_type(file.path)),
    ];
    if is_known(&tag, headers) {
        return Ok((StatusCode::NOT_MODIFIED, common).into_response());
    }
    if !gzip {
        return Ok((common, file.data).into_response());
    }
    let body = compressed(&file)
        .map_err(|error| Problem::new(ProblemType::Internal, error.to_string()))?;
    Ok((common, [(CONTENT_ENCODING, "gzip")], body).into_response())
}

/// Media type by the ending of a path.
pub(super) fn media_type(path: &str) -> &'static str {
    match path.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("json" | "ipynb") => "application/json",
        _ => "text/plain; charset=utf-8",
    }
}

fn compressed(file: &Sent) -> io::Result<Bytes> {
    let known = || COMPRESSED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(body) = known().get(&file.digest) {
        return Ok(body.clone());
    }
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&file.data)?;
    let body = Bytes::from(encoder.finish()?);
    known().insert(file.digest, body.clone());
    Ok(body)
}
