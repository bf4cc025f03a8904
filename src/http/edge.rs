//! Layers for every request: check of the `Host` header, request id, and security headers of the
//! answer.

use axum::extract::{Request, State};
use axum::http::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HOST, HeaderMap, HeaderName,
    HeaderValue, ORIGIN, X_CONTENT_TYPE_OPTIONS,
};
use axum::http::uri::Authority;
use axum::middleware::Next;
use axum::response::Response;

use super::HttpState;
use super::access::HARMLESS;
use super::listen::HEAD_BYTES;
use super::problem::Problem;
use super::problem_type::ProblemType;

/// Longest `x-request-id` that is taken over from a client.
const REQUEST_ID: usize = 128;

/// Policy of answers with data: a browser must not run, embed or frame them.
const DATA_POLICY: &str = "default-src 'none'; frame-ancestors 'none'";

/// Drops an `x-request-id` that is too long or not printable: the service then generates one.
pub(super) async fn drop_unusable_request_id(mut request: Request, next: Next) -> Response {
    let id = request.headers().get("x-request-id");
    if id
        .is_some_and(|id| id.len() > REQUEST_ID || !id.as_bytes().iter().all(u8::is_ascii_graphic))
    {
        request.headers_mut().remove("x-request-id");
    }
    next.run(request).await
}

/// Refuses requests whose head is too large, and requests with a missing or foreign `Host`.
pub(super) async fn check_host(
    State(state): State<HttpState>,
    request: Request,
    next: Next,
) -> Result<Response, Problem> {
    if head_bytes(&request) > HEAD_BYTES {
        let detail = format!("the head of a request may have {HEAD_BYTES} bytes at most");
        return Err(Problem::new(ProblemType::HeadTooLarge, detail));
    }
    let mut hosts = request.headers().get_all(HOST).iter();
    let (Some(host), None) = (hosts.next(), hosts.next()) else {
        return Err(Problem::new(ProblemType::InvalidHeader, "Host must come once"));
    };
    // A request line with a full URL, as for a proxy, names a host as well.
    let is_allowed = |host: &str| state.hosts.allow(host);
    let addressed = request.uri().authority().map(Authority::as_str);
    if !host.to_str().is_ok_and(is_allowed) || !addressed.is_none_or(is_allowed) {
        let detail = "this service does not answer under this name; --allowed-host adds one";
        return Err(Problem::new(ProblemType::UnknownHost, detail));
    }
    let changes = !request.method().is_safe() && !HARMLESS.contains(&request.uri().path());
    if changes && !is_from_here(request.headers(), host, &state.settings.cors_origins) {
        let detail = "a page of another origin asks for a change; --cors-origin allows one";
        return Err(Problem::new(ProblemType::Forbidden, detail));
    }
    Ok(next.run(request).await)
}

/// Returns whether a request comes from no web page, from a page of this service or from an
/// allowed origin. A browser lets every page send requests to loopback, and sends those of forms
/// and images without a preflight request.
fn is_from_here(headers: &HeaderMap, host: &HeaderValue, allowed: &[HeaderValue]) -> bool {
    let origin = headers.get(ORIGIN);
    if allowed.iter().any(|allowed| allowed == "*" || Some(allowed) == origin) {
        return true;
    }
    if let Some(site) = headers.get("sec-fetch-site") {
        return site == "same-origin" || site == "none";
    }
    let Some(origin) = origin else { return true };
    let forwarded = headers.get("x-forwarded-host");
    let authority = origin
        .to_str()
        .ok()
        .and_then(|origin| origin.split_once("://"))
        .map(|(_, host)| host.as_bytes());
    [Some(host), forwarded].into_iter().flatten().any(|host| Some(host.as_bytes()) == authority)
}

/// Returns the approximate size \[bytes\] of a head: its URL and its header lines.
fn head_bytes(request: &Request) -> usize {
    let address = request.uri().path_and_query().map_or(0, |path| path.as_str().len());
    request
        .headers()
        .iter()
        .fold(address, |sum, (name, value)| sum + name.as_str().len() + value.len() + 4)
}

/// Adds the common headers to an answer, except those that it has already.
pub(super) async fn guard_response(request: Request, next: Next) -> Response {
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    let mut set = |name: HeaderName, value: &'static str| {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    };
    set(X_CONTENT_TYPE_OPTIONS, "nosniff");
    set(CACHE_CONTROL, "no-store");
    set(CONTENT_SECURITY_POLICY, DATA_POLICY);
    if headers.get(CONTENT_TYPE).is_some_and(|kind| kind.as_bytes() == b"image/svg+xml") {
        // A browser may show a figure by itself; the figure contains its styles.
        headers.insert(CONTENT_SECURITY_POLICY, HeaderValue::from_static(FIGURE_POLICY));
    }
    response
}

/// Policy of figures: they may use styles of their own and nothing else.
const FIGURE_POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; frame-ancestors 'self'";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_of_elsewhere_change_nothing() {
        let verdict = |headers: &[(&'static str, &'static str)], allowed: &[HeaderValue]| {
            let pairs = headers.iter();
            let headers = pairs.map(|(name, value)| {
                (HeaderName::from_static(name), HeaderValue::from_static(value))
            });
            is_from_here(&headers.collect(), &HeaderValue::from_static("localhost:8080"), allowed)
        };
        let (here, evil) =
            (("origin", "http://localhost:8080"), ("origin", "https://evil.example"));
        for good in [
            &[][..],
            &[here],
            &[evil, ("sec-fetch-site", "same-origin")],
            &[("sec-fetch-site", "none")],
        ] {
            assert!(verdict(good, &[]), "{good:?}");
        }
        assert!(verdict(
            &[("origin", "https://press.example"), ("x-forwarded-host", "press.example")],
            &[]
        ));
        for bad in [
            &[evil][..],
            &[("origin", "null")],
            &[("sec-fetch-site", "cross-site")],
            &[("origin", "http://localhost:80")],
            &[here, ("sec-fetch-site", "same-site")],
        ] {
            assert!(!verdict(bad, &[]), "{bad:?}");
        }
        for allowed in ["*", "https://evil.example"] {
            assert!(verdict(
                &[evil, ("sec-fetch-site", "cross-site")],
                &[HeaderValue::from_static(allowed)]
            ));
        }
    }
}
