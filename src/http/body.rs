//! Bodies of submissions: JSON, of bounded size, received in bounded time.

use std::io::Read as _;
use std::time::Duration;

use axum::body::{Body, Bytes};
use axum::extract::{FromRequest, Request};
use axum::http::header::{CONTENT_ENCODING, CONTENT_LENGTH, CONTENT_TYPE, EXPECT};
use axum::http::{HeaderMap, HeaderValue};
use flate2::read::MultiGzDecoder;
use http_body_util::BodyExt;
use tokio::time::timeout;

use super::HttpState;
use super::access::Caller;
use super::bodies::HeldBody;
use super::problem::Problem;
use super::problem_type::ProblemType;
use crate::jobs::{KeyId, Turn};

/// Time and bytes for which a refused body is read and discarded: a client that is still sending
/// then receives the answer instead of a broken connection.
const DISCARD_TIME: Duration = Duration::from_secs(5);
const DISCARD_BYTES: usize = 256 << 20;

/// Bytes that are inflated at once.
const PIECE: usize = 16 << 10;

/// The extractor for the body of a submission.
#[derive(Debug)]
pub(super) struct JobBody(pub(super) Bytes);

impl FromRequest<HttpState> for JobBody {
    type Rejection = Problem;

    async fn from_request(request: Request, state: &HttpState) -> Result<Self, Problem> {
        let (parts, mut body) = request.into_parts();
        let read = async {
            check_content_type(&parts.headers)?;
            let is_compressed = is_compressed(&parts.headers)?;
            check_declared_length(&parts.headers, state.settings.max_body_bytes)?;
            let key = parts.extensions.get::<Caller>().and_then(|caller| caller.key());
            let held = read(&mut body, state, key).await?;
            let held = if is_compressed { inflate(held, state)? } else { held };
            Ok(Bytes::from_owner(held))
        };
        match read.await {
            Ok(text) => Ok(Self(text)),
            Err(problem) => {
                // A client that sent `Expect: 100-continue` has not sent its body yet; reading it
                // would answer 100.
                if !parts.headers.contains_key(EXPECT) {
                    tokio::spawn(timeout(DISCARD_TIME, discard(body)));
                }
                Err(problem)
            }
        }
    }
}

fn check_content_type(headers: &HeaderMap) -> Result<(), Problem> {
    let declared =
        headers.get(CONTENT_TYPE).and_then(|value| value.to_str().ok()).unwrap_or_default();
    let essence = declared.split(';').next().unwrap_or_default().trim().to_ascii_lowercase();
    if essence == "application/json"
        || (essence.starts_with("application/") && essence.ends_with("+json"))
    {
        return Ok(());
    }
    let found = if essence.is_empty() { "nothing".to_owned() } else { format!("{essence:?}") };
    let detail = format!("Content-Type must be application/json; it says {found}");
    Err(Problem::new(ProblemType::UnsupportedMediaType, detail))
}

/// Returns whether the body is compressed by gzip, the one coding that is taken.
fn is_compressed(headers: &HeaderMap) -> Result<bool, Problem> {
    let mut codings = headers.get_all(CONTENT_ENCODING).iter().map(HeaderValue::as_bytes);
    match (codings.next(), codings.next()) {
        (None, _) => Ok(false),
        (Some(coding), None) if coding.eq_ignore_ascii_case(b"identity") => Ok(false),
        (Some(coding), None) if coding.eq_ignore_ascii_case(b"gzip") => Ok(true),
        _ => {
            let detail = "the body may be compressed by gzip, once, and by nothing else";
            Err(Problem::new(ProblemType::UnsupportedMediaType, detail))
        }
    }
}

/// Inflates a body piece by piece: a few bytes can expand without limit, and what they expand to
/// counts as the body.
fn inflate(packed: HeldBody, state: &HttpState) -> Result<HeldBody, Problem> {
    let limit = state.settings.max_body_bytes;
    let mut inflated = HeldBody { text: Vec::new(), room: None, turn: Turn::free() };
    let (mut decoder, mut piece) = (MultiGzDecoder::new(&packed.text[..]), [0; PIECE]);
    loop {
        let broken = |error| {
            Problem::new(ProblemType::InvalidJson, format!("the body is no gzip: {error}"))
        };
        let length = decoder.read(&mut piece).map_err(broken)?;
        if length == 0 {
            break;
        }
        if inflated.text.len() + length > limit {
            return Err(too_large(limit));
        }
        state.bodies.extend(&mut inflated, &piece[..length])?;
    }
    drop(decoder);
    inflated.turn = packed.turn;
    Ok(inflated)
}

fn check_declared_length(headers: &HeaderMap, limit: usize) -> Result<(), Problem> {
    let declared =
        headers.get(CONTENT_LENGTH).and_then(|value| value.to_str().ok()?.parse::<u64>().ok());
    if declared.is_some_and(|length| length > limit as u64) {
        Err(too_large(limit))
    } else {
        Ok(())
    }
}

/// Reads a body. Received bytes count towards the limit of all bodies together.
async fn read(
    body: &mut Body,
    state: &HttpState,
    key: Option<KeyId>,
) -> Result<HeldBody, Problem> {
    let settings = &state.settings;
    let limit = settings.max_body_bytes;
    let read = async {
        let mut held = state.bodies.open(key)?;
        while let Some(frame) = body.frame().await {
            let broken = |error| {
                Problem::new(
                    ProblemType::InvalidJson,
                    format!("the body could not be read: {error}"),
                )
            };
            let Ok(data) = frame.map_err(broken)?.into_data() else { continue };
            if held.text.len() + data.len() > limit {
                return Err(too_large(limit));
            }
            state.bodies.extend(&mut held, &data)?;
        }
        held.text.shrink_to_fit();
        Ok(held)
    };
    timeout(settings.body_timeout, read).await.unwrap_or_else(|_| {
        let seconds = settings.body_timeout.as_secs();
        Err(Problem::new(
            ProblemType::BodyTimeout,
            format!("the body took longer than {seconds} s"),
        ))
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
    use super::*;

    #[test]
    fn json_in_all_its_names_is_accepted_and_nothing_else() {
        let verdict = |name: &'static str| {
            check_content_type(&HeaderMap::from_iter([(
                CONTENT_TYPE,
                HeaderValue::from_static(name),
            )]))
            .is_ok()
        };
        for name in
            ["application/json", "Application/JSON; charset=utf-8", "application/vnd.brinell+json"]
        {
            assert!(verdict(name), "{name}");
        }
        for name in ["", "text/plain", "application/x-www-form-urlencoded", "text/json"] {
            assert!(!verdict(name), "{name}");
        }
        assert!(check_content_type(&HeaderMap::new()).is_err());
    }
}
