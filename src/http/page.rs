//! The web page: the files under `web/`, which a release build contains.
//!
//! Files keep their names between versions, so browsers revalidate them each time; a strong `ETag`
//! of the content allows the answer 304. Each file is compressed once. The page loads nothing from
//! other origins, and its `Content-Security-Policy` forbids it.

use std::collections::HashMap;
use std::io::{self, Write};
use std::sync::{LazyLock, Mutex, PoisonError};

use axum::extract::Path;
use axum::extract::rejection::PathRejection;
use axum::http::header::{
    CACHE_CONTROL, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE, ETAG, REFERRER_POLICY,
    VARY, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::{HeaderMap, HeaderName, StatusCode};
use axum::response::{IntoResponse, Response};
use bytes::Bytes;
use flate2::Compression;
use flate2::write::GzEncoder;
use rust_embed::{EmbeddedFile, RustEmbed};

use super::negotiation::takes_gzip;
use super::problem::Problem;
use super::problem_type::ProblemType;
use super::result_body::is_known;

#[derive(RustEmbed)]
#[folder = "web/"]
struct Web;

pub(super) const POLICY: &str = "default-src 'self'; object-src 'none'; base-uri 'none'; \
                                 form-action 'self'; frame-ancestors 'none'";

/// Compressed files by digest: in a debug build, files change while the program runs.
static COMPRESSED: LazyLock<Mutex<HashMap<[u8; 32], Bytes>>> = LazyLock::new(Mutex::default);

/// `GET /`.
pub(super) async fn index(headers: HeaderMap) -> Result<Response, Problem> {
    answer("index.html", &headers)
}

/// `GET /web/{path}`.
pub(super) async fn file(
    path: Result<Path<String>, PathRejection>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    answer(path.as_ref().map_or("", |Path(path)| path), &headers)
}

fn answer(path: &str, headers: &HeaderMap) -> Result<Response, Problem> {
    let nothing = || Problem::new(ProblemType::NotFound, "the page has no such file");
    let file = Web::get(path).ok_or_else(nothing)?;
    let gzip = takes_gzip(headers);
    let tag = tag(&file, gzip);
    let common: [(HeaderName, &str); 7] = [
        (ETAG, &tag),
        (CACHE_CONTROL, "no-cache"),
        (VARY, "accept-encoding"),
        (CONTENT_SECURITY_POLICY, POLICY),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (REFERRER_POLICY, "no-referrer"),
        (CONTENT_TYPE, media_type(path)),
    ];
    if is_known(&tag, headers) {
        return Ok((StatusCode::NOT_MODIFIED, common).into_response());
    }
    if !gzip {
        return Ok((common, file.data.into_owned()).into_response());
    }
    let body = compressed(&file)
        .map_err(|error| Problem::new(ProblemType::Internal, error.to_string()))?;
    Ok((common, [(CONTENT_ENCODING, "gzip")], body).into_response())
}

fn media_type(path: &str) -> &'static str {
    match path.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("svg") => "image/svg+xml",
        _ => "text/plain; charset=utf-8",
    }
}

/// A strong tag identifies bytes, so the compressed file has its own tag.
fn tag(file: &EmbeddedFile, gzip: bool) -> String {
    let digest = file.metadata.sha256_hash().first_chunk().copied().map_or(0, u128::from_be_bytes);
    let coding = if gzip { "-gzip" } else { "" };
    format!("\"{digest:032x}{coding}\"")
}

fn compressed(file: &EmbeddedFile) -> io::Result<Bytes> {
    let digest = file.metadata.sha256_hash();
    let known = || COMPRESSED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(body) = known().get(&digest) {
        return Ok(body.clone());
    }
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&file.data)?;
    let body = Bytes::from(encoder.finish()?);
    known().insert(digest, body.clone());
    Ok(body)
}
