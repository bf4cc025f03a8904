//! The headers `Prefer` and `Idempotency-Key` of a submission.

use axum::extract::FromRequestParts;
use axum::http::HeaderMap;
use axum::http::request::Parts;

use super::HttpState;
use super::parameters::parameters;
use super::problem::Problem;
use super::problem_type::ProblemType;

/// Longest idempotency key.
const MAX_KEY: usize = 255;

/// Pattern of the header with an idempotency key.
const PATTERN: &str = r#"^("[!-~]{1,255}"|[!-~]{1,255})$"#;

/// Parses `Prefer: wait=N` (RFC 7240): the seconds that the client would wait for the result.
/// Unknown preferences are ignored, as the RFC requires.
pub(super) fn preferred_wait(headers: &HeaderMap) -> Option<u64> {
    let lines = headers.get_all("prefer").iter().filter_map(|line| line.to_str().ok());
    let mut preferences = lines.flat_map(|line| line.split(','));
    preferences.find_map(|preference| {
        let (name, value) = preference.split(';').next()?.split_once('=')?;
        let value = value.trim().trim_matches('"').parse().ok()?;
        name.trim().eq_ignore_ascii_case("wait").then_some(value)
    })
}

/// `Prefer`, which [`preferred_wait`] reads.
pub(super) enum Prefer {}

parameters! { "header", Prefer {
    /// `wait=N`: as `?wait=N`, which goes before it (RFC 7240). What is not understood is ignored.
    "Prefer": {"type": "string"}, "wait=10";
}}

parameters! { "header", IdempotencyKey {
    /// The client's name for this submission, in visible ASCII characters without spaces, bare or
    /// in quotes. The same body under the same key is the same job; another body is refused.
    "Idempotency-Key": {"type": "string", "pattern": PATTERN}, "press-7";
}}

/// `Idempotency-Key` of several jobs.
pub(super) enum KeyOfBatch {}

parameters! { "header", KeyOfBatch {
    #[doc = "The client's name for this submission, in visible ASCII characters without spaces, \
             bare or in quotes; each job has it with its place in the list. The same body under \
             the same key is the same job; another body is refused."]
    "Idempotency-Key": {"type": "string", "pattern": PATTERN}, "press-7";
}}

/// `Idempotency-Key`: the client's name for this submission, bare or in quotes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct IdempotencyKey(pub(super) Option<String>);

impl FromRequestParts<HttpState> for IdempotencyKey {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, _: &HttpState) -> Result<Self, Problem> {
        idempotency_key(&parts.headers).map(Self)
    }
}

/// Returns whether a text can be an idempotency key.
pub(super) fn is_idempotency_key(text: &str) -> bool {
    (1..=MAX_KEY).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_graphic())
}

fn idempotency_key(headers: &HeaderMap) -> Result<Option<String>, Problem> {
    let mut lines = headers.get_all("idempotency-key").iter();
    let Some(line) = lines.next() else { return Ok(None) };
    let key = line.to_str().unwrap_or_default().trim();
    let key = key.strip_prefix('"').and_then(|key| key.strip_suffix('"')).unwrap_or(key);
    if is_idempotency_key(key) && lines.next().is_none() {
        return Ok(Some(key.to_owned()));
    }
    let detail = format!(
        "Idempotency-Key must come once and have 1 to {MAX_KEY} visible ASCII characters without \
         spaces"
    );
    Err(Problem::new(ProblemType::InvalidHeader, detail))
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderValue;

    use super::*;

    fn headers(name: &'static str, values: &[&str]) -> HeaderMap {
        let mut headers = HeaderMap::new();
        for value in values {
            headers.append(name, HeaderValue::from_bytes(value.as_bytes()).unwrap());
        }
        headers
    }

    #[test]
    fn waits_are_found_among_other_preferences() {
        for (values, wait) in [
            (vec!["wait=10"], Some(10)),
            (vec!["respond-async, wait=5"], Some(5)),
            (vec!["respond-async", "Wait = \"7\"; x=y"], Some(7)),
            (vec!["wait=soon"], None),
            (vec!["return=minimal"], None),
            (vec![], None),
        ] {
            assert_eq!(preferred_wait(&headers("prefer", &values)), wait, "{values:?}");
        }
    }

    #[test]
    fn keys_are_short_and_visible() {
        let key = |values: &[&str]| idempotency_key(&headers("idempotency-key", values)).ok();
        assert_eq!(key(&[]), Some(None));
        assert_eq!(key(&["press-7"]), Some(Some("press-7".to_owned())));
        assert_eq!(key(&["\"press-7\""]), Some(Some("press-7".to_owned())));
        for bad in [&[""][..], &["two words"], &["é"], &["a", "b"], &["x".repeat(256).as_str()]] {
            assert_eq!(key(bad), None, "{bad:?}");
        }
    }
}
