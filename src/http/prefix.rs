//! The path under which a proxy serves this service.

use std::convert::Infallible;

use axum::extract::FromRequestParts;
use axum::http::HeaderMap;
use axum::http::request::Parts;

/// The path under which a proxy serves this service, from `X-Forwarded-Prefix`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Prefix(String);

impl Prefix {
    /// The path; empty without a prefix.
    pub(super) fn path(&self) -> &str {
        &self.0
    }

    /// The prefix, if there is one.
    pub(super) fn server(&self) -> Option<&str> {
        Some(self.0.as_str()).filter(|path| !path.is_empty())
    }

    /// Parses the header, `/press` for `/press/`; ignores a value that is no plain path.
    pub(super) fn of(headers: &HeaderMap) -> Self {
        let text = headers
            .get("x-forwarded-prefix")
            .and_then(|prefix| prefix.to_str().ok())
            .unwrap_or_default();
        let path = text.trim_end_matches('/');
        let is_plain =
            path.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte));
        // Browsers read `//` as the start of a host name and resolve dot segments.
        let mut segments = path.split('/');
        let is_path = segments.next() == Some("")
            && segments.all(|segment| !["", ".", ".."].contains(&segment))
            && path.len() <= 200;
        Self(if is_plain && is_path { path.to_owned() } else { String::new() })
    }
}

impl<S: Sync> FromRequestParts<S> for Prefix {
    type Rejection = Infallible;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Infallible> {
        Ok(Self::of(&parts.headers))
    }
}

#[cfg(test)]
mod tests {
    use axum::http::{HeaderName, HeaderValue};

    use super::*;

    #[test]
    fn a_prefix_is_a_plain_path() {
        let prefix = |text: &'static str| {
            Prefix::of(&HeaderMap::from_iter([(
                HeaderName::from_static("x-forwarded-prefix"),
                HeaderValue::from_static(text),
            )]))
            .0
        };
        assert_eq!(prefix("/press"), "/press");
        assert_eq!(prefix("/a/b/"), "/a/b");
        for bad in [
            "",
            "/",
            "press",
            "//elsewhere.example",
            "/a b",
            "/a\"b",
            "/a?b",
            "/..",
            "/a/../b",
            "/.",
            "/a//b",
            "/%2e",
        ] {
            assert_eq!(prefix(bad), "", "{bad}");
        }
    }
}
