//! The web page: the files under `web/`, which a release build contains.
//!
//! The first document names every file below `web/DIGEST/`, where the digest is that of the whole
//! folder: browsers keep these for good, and a reload asks for the document alone. Under their plain
//! names, and under the digest of another version, files are asked for anew each time; a strong
//! `ETag` of the content allows the answer 304. Modules are sent [`joined`] as `page.js`, without
//! their comments, whose lines stay as empty ones; a worker imports its own. Each file is compressed
//! once. The page loads nothing from other origins, and its `Content-Security-Policy` forbids it;
//! charts become pictures by way of a `data:` address.

use std::borrow::Cow;
use std::sync::{Mutex, PoisonError};

use axum::extract::rejection::PathRejection;
use axum::extract::{Path, State};
use axum::http::HeaderMap;
use axum::response::Response;
use bytes::Bytes;
use rust_embed::{EmbeddedFile, RustEmbed};

use super::HttpState;
use super::joined::joined;
use super::prefix::Prefix;
use super::problem::Problem;
use super::problem_type::ProblemType;
use super::static_file::{Sent, answer, media_type};

#[derive(RustEmbed)]
#[folder = "web/"]
struct Web;

pub(super) const POLICY: &str = "default-src 'self'; img-src 'self' data:; object-src 'none'; \
                                 base-uri 'none'; form-action 'self'; frame-ancestors 'none'";

/// Digest of the folder in the last document that was sent.
static NAMED: Mutex<Option<String>> = Mutex::new(None);

/// How long a file that never changes is kept.
const FOR_GOOD: &str = "public, max-age=31536000, immutable";

/// All modules of the page as one.
const WHOLE: &str = "page.js";

/// Modules that are none of it: of a worker, and of the reference.
const APART: [&str; 2] = ["api/result-worker.js", "docs/docs.js"];

/// The link to the interface, and that to the guide, which stands behind it where there is one.
const API: &str = r#"<a class="button" href="docs/">API</a>"#;
const GUIDE: &str = r#"<a class="button" href="guide/">Guide</a>"#;

/// Length of the digest in an address.
const DIGITS: usize = 16;

/// `GET /`: with the digest of the folder in every address, with the address for people and with a
/// link to the guide, where there are such.
pub(super) async fn index(
    State(state): State<HttpState>,
    prefix: Prefix,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let file = Web::get("index.html").ok_or_else(nothing)?;
    let folder = folder();
    let named = name_of(folder);
    let mut text =
        String::from_utf8_lossy(&file.data).replace("\"web/", &format!("\"web/{named}/"));
    if let Some(origin) = state.settings.public_origin.as_ref().and_then(|one| one.to_str().ok()) {
        let link =
            format!("<link rel=\"canonical\" href=\"{origin}{}/\">\n</head>", prefix.path());
        text = text.replacen("</head>", &link, 1);
    }
    if !state.guide.is_empty() {
        text = text.replacen(API, &format!("{API}\n    {GUIDE}"), 1);
    }
    let digest = fnv(folder, text.as_bytes());
    *NAMED.lock().unwrap_or_else(PoisonError::into_inner) = Some(named);
    let data = text.into_bytes().into();
    answer(Sent { path: "index.html", data, digest, kept: "no-cache", policy: POLICY }, &headers)
}

/// `GET /web/{path}`.
pub(super) async fn file(
    path: Result<Path<String>, PathRejection>,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let given = path.as_ref().map_or("", |Path(path)| path);
    let (digest, path) = match given.split_once('/') {
        Some((first, rest)) if is_digest(first) => (Some(first), rest),
        _ => (None, given),
    };
    // A process that has sent no document yet answers for one that another process has sent.
    let mut named = NAMED.lock().unwrap_or_else(PoisonError::into_inner);
    let is_current =
        digest.is_some_and(|digest| digest == named.get_or_insert_with(|| name_of(folder())));
    drop(named);
    let kept = if is_current { FOR_GOOD } else { "no-cache" };
    if path == WHOLE {
        let digest = folder();
        let sent = Sent { path, data: whole().into(), digest: !digest, kept, policy: POLICY };
        return answer(sent, &headers);
    }
    let file = Web::get(path).ok_or_else(nothing)?;
    let digest = digest_of(&file);
    let is_module = media_type(path).starts_with("text/javascript");
    let data = match file.data {
        data if is_module => bare(&data).into(),
        Cow::Borrowed(data) => Bytes::from_static(data),
        Cow::Owned(data) => data.into(),
    };
    answer(Sent { path, data, digest, kept, policy: POLICY }, &headers)
}

fn name_of(folder: u128) -> String {
    format!("{:016x}", folder >> 64)
}

/// All modules of the page, joined.
fn whole() -> Vec<u8> {
    let mut paths: Vec<_> = Web::iter().filter(|path| path.ends_with(".js")).collect();
    paths.retain(|path| !APART.contains(&&**path));
    paths.sort_unstable();
    let text = |path: &str| Web::get(path).map(|file| bare(&file.data)).unwrap_or_default();
    let modules: Vec<_> = paths
        .iter()
        .map(|path| (path.to_string(), String::from_utf8_lossy(&text(path)).into_owned()))
        .collect();
    joined(&modules).into_bytes()
}

fn nothing() -> Problem {
    Problem::new(ProblemType::NotFound, "the page has no such file")
}

fn is_digest(part: &str) -> bool {
    part.len() == DIGITS && part.bytes().all(|one| one.is_ascii_hexdigit())
}

fn digest_of(file: &EmbeddedFile) -> u128 {
    file.metadata.sha256_hash().first_chunk().copied().map_or(0, u128::from_be_bytes)
}

/// Digest of all files and their names: an FNV hash of theirs, which are SHA-256.
fn folder() -> u128 {
    let mut names: Vec<_> = Web::iter().collect();
    names.sort_unstable();
    names.iter().fold(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d, |sum, name| {
        let content = Web::get(name).map_or(0, |file| digest_of(&file));
        fnv(fnv(sum, name.as_bytes()), &content.to_be_bytes())
    })
}

fn fnv(sum: u128, bytes: &[u8]) -> u128 {
    bytes.iter().fold(sum, |sum, byte| {
        (sum ^ u128::from(*byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b)
    })
}

/// Beginning of a type within a line, and the end of every comment.
const TYPE: &[u8] = b"/** @";
const END: &[u8] = b"*/";

/// A module without the comments that stand on lines of their own, and without types within a line.
/// The formatter puts every other comment at the beginning of a line, and no text of the page has a
/// line that begins like one, or holds the beginning of a type.
fn bare(module: &[u8]) -> Vec<u8> {
    let mut sent = Vec::with_capacity(module.len());
    let mut within = false;
    for line in module.split(|&byte| byte == b'\n') {
        let text = line.trim_ascii();
        let begins = text.starts_with(b"/**");
        let ends = text.ends_with(b"*/");
        let plain = !within && !text.starts_with(b"//") && !(begins && (ends || !has_end(text)));
        within = (within || (begins && !has_end(text))) && !ends;
        if plain {
            extend_without_types(&mut sent, line);
        }
        sent.push(b'\n');
    }
    sent
}

/// Appends a line without its types: `/** @type {any} */ (a)` is sent as `(a)`.
fn extend_without_types(sent: &mut Vec<u8>, mut line: &[u8]) {
    while let Some(begin) = place_of(line, TYPE) {
        let Some(length) = place_of(&line[begin..], END) else { break };
        sent.extend_from_slice(&line[..begin]);
        let rest = &line[begin + length + END.len()..];
        line = rest.strip_prefix(b" ").unwrap_or(rest);
    }
    sent.extend_from_slice(line);
}

fn has_end(text: &[u8]) -> bool {
    place_of(text, END).is_some()
}

fn place_of(text: &[u8], part: &[u8]) -> Option<usize> {
    text.windows(part.len()).position(|one| one == part)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_of_modules_are_empty_lines() {
        let module =
            "/** A. */\nconst a = /** @type {any} */ (1); // b\n  // c\n/**\n * d\n */\nf();";
        let sent = "\nconst a = (1); // b\n\n\n\n\nf();\n";
        assert_eq!(String::from_utf8(bare(module.as_bytes())).unwrap(), sent);
    }
}
