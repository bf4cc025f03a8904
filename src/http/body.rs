//! A job's text as it comes in: declared as JSON, of bounded size, in bounded time.

use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::extract::{FromRequest, Request};
use axum::http::HeaderMap;
use axum::http::header::{CONTENT_ENCODING, CONTENT_LENGTH, CONTENT_TYPE, EXPECT};
use http_body_util::BodyExt;
use tokio::time::timeout;

use super::HttpState;
use super::access::Caller;
use super::problem::Problem;
use super::problem_type::ProblemType;
use crate::jobs::KeyId;

/// How long, and how much of, a refused body is read and thrown away, so that a client still sending sees the
/// answer instead of a broken connection.
const DISCARD_TIME: Duration = Duration::from_secs(5);
const DISCARD_BYTES: usize = 256 << 20;

/// The body of a request that carries a job.
#[derive(Debug)]
pub(super) struct JobBody(pub(super) Bytes);

impl FromRequest<HttpState> for JobBody {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &HttpState) -> Result<Self, Problem> {
        let (parts, mut body) = request.into_parts();
        let read = async {
            check_content_type(&parts.headers)?;
            check_not_compressed(&parts.headers)?;
            check_declared_length(&parts.headers, state.settings.max_body_bytes)?;
            let key = parts.extensions.get::<Caller>().and_then(|caller| caller.key());
            read(&mut body, state, key).await
        };
        match read.await {
            Ok(text) => Ok(Self(text)),
            Err(problem) => {
                // A client that asked first is answered instead of being told to go on.
                if !parts.headers.contains_key(EXPECT) {
                    tokio::spawn(timeout(DISCARD_TIME, discard(body)));
                }
                Err(problem)
            }
        }
    }
}

fn check_content_type(headers: &HeaderMap) -> Result<(), Problem> {
    let declared = headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or_default();
    let essence = declared.split(';').next().unwrap_or_default().trim().to_ascii_lowercase();
    if essence == "application/json" || (essence.starts_with("application/") && essence.ends_with("+json")) {
        return Ok(());
    }
    let found = if essence.is_empty() { "nothing".to_owned() } else { format!("{essence:?}") };
    let detail = format!("Content-Type must be application/json; it says {found}");
    Err(Problem::new(ProblemType::UnsupportedMediaType, detail))
}

/// Nothing is unpacked here: a few compressed bytes can become any number.
fn check_not_compressed(headers: &HeaderMap) -> Result<(), Problem> {
    let codings = headers.get_all(CONTENT_ENCODING).iter();
    if codings.into_iter().all(|coding| coding.as_bytes().eq_ignore_ascii_case(b"identity")) {
        return Ok(());
    }
    Err(Problem::new(ProblemType::UnsupportedMediaType, "the body must not be compressed"))
}

fn check_declared_length(headers: &HeaderMap, limit: usize) -> Result<(), Problem> {
    let declared = headers.get(CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse::<u64>().ok());
    if declared.is_some_and(|length| length > limit as u64) { Err(too_large(limit)) } else { Ok(()) }
}

/// Reads a body. What has arrived counts towards the bytes that all bodies may take.
async fn read(body: &mut Body, state: &HttpState, key: Option<KeyId>) -> Result<Bytes, Problem> {
    let settings = &state.settings;
    let limit = settings.max_body_bytes;
    let read = async {
        let mut held = state.bodies.open(key);
        while let Some(frame) = body.frame().await {
            let broken = |error| {
                Problem::new(ProblemType::InvalidJson, format!("the body could not be read: {error}"))
            };
            let Ok(data) = frame.map_err(broken)?.into_data() else { continue };
            if held.len() + data.len() > limit {
                return Err(too_large(limit));
            }
            if !held.extend(&data) {
                let detail = "too much of other bodies is held at this moment";
                return Err(Problem::new(ProblemType::TooManyBodies, detail));
            }
        }
        Ok(held.finish())
    };
    timeout(settings.body_timeout, read).await.unwrap_or_else(|_| {
        let seconds = settings.body_timeout.as_secs();
        Err(Problem::new(ProblemType::BodyTimeout, format!("the body took longer than {seconds} s")))
    })
}

async fn discard(mut body: Body) {
    let mut discarded = 0;
    while let Some(Ok(frame)) = body.frame().await {
        discarded += frame.data_ref().map_or(0, Bytes::len);
        if discarded > DISCARD_BYTES {
            return;
        }
    }
}

fn too_large(limit: usize) -> Problem {
    Problem::new(ProblemType::BodyTooLarge, format!("the body may have {limit} bytes at most"))
        .with_limit(limit as u64)
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderValue;

    use super::*;

    #[test]
    fn json_in_all_its_names_is_accepted_and_nothing_else() {
        let verdict = |name: &'static str| {
            check_content_type(&HeaderMap::from_iter([(CONTENT_TYPE, HeaderValue::from_static(name))]))
                .is_ok()
        };
        for name in ["application/json", "Application/JSON; charset=utf-8", "application/vnd.brinell+json"] {
            assert!(verdict(name), "{name}");
        }
        for name in ["", "text/plain", "application/x-www-form-urlencoded", "text/json"] {
            assert!(!verdict(name), "{name}");
        }
        assert!(check_content_type(&HeaderMap::new()).is_err());
    }
}
