//! Negotiation of media type and content coding (RFC 9110, section 12.5), and of what a client
//! has already (section 13.1.2).

use axum::extract::Request;
use axum::http::header::{ACCEPT, ACCEPT_ENCODING, IF_NONE_MATCH};
use axum::http::{HeaderMap, HeaderName, HeaderValue};
use axum::middleware::Next;
use axum::response::Response;

/// Parses the items of a header, in lower case, with their weights. An invalid weight counts as 0.
fn weighted(headers: &HeaderMap, name: HeaderName) -> Vec<(String, f64)> {
    let lines = headers.get_all(name).iter().filter_map(|line| line.to_str().ok());
    let items = lines.flat_map(|line| line.split(','));
    let read = |item: &str| {
        let mut parts = item.split(';').map(str::trim);
        let name = parts.next().unwrap_or_default().to_ascii_lowercase();
        let weight = parts.find_map(|parameter| {
            let (key, value) = parameter.split_once('=')?;
            let weight = value.trim().parse().ok().filter(|weight| (0.0..=1.0).contains(weight));
            key.trim().eq_ignore_ascii_case("q").then(|| weight.unwrap_or(0.0))
        });
        (name, weight.unwrap_or(1.0))
    };
    items.map(read).collect()
}

/// The layer that reduces `Accept-Encoding` to gzip or nothing, so that all other layers agree. A
/// client that refuses every coding receives an uncompressed answer, not an error.
pub(super) async fn settle_coding(mut request: Request, next: Next) -> Response {
    let takes_gzip = takes_gzip(request.headers());
    request.headers_mut().remove(ACCEPT_ENCODING);
    if takes_gzip {
        request.headers_mut().insert(ACCEPT_ENCODING, HeaderValue::from_static("gzip"));
    }
    next.run(request).await
}

/// Returns whether a client accepts gzip.
pub(super) fn takes_gzip(headers: &HeaderMap) -> bool {
    let accepted = weighted(headers, ACCEPT_ENCODING);
    let find = |names: &[&str]| accepted.iter().find(|(name, _)| names.contains(&name.as_str()));
    find(&["gzip", "x-gzip"]).or_else(|| find(&["*"])).is_some_and(|(_, weight)| *weight > 0.0)
}

/// Returns whether a client prefers CSV to JSON: by a larger weight, or by naming CSV while JSON
/// matches only a wildcard.
pub(super) fn prefers_csv(headers: &HeaderMap) -> bool {
    let accepted = weighted(headers, ACCEPT);
    let preference = |group: &str, name: &str| {
        let fitting = accepted.iter().filter_map(|(range, weight)| {
            let exactness = [name, group, "*/*"].iter().position(|one| one == range)?;
            Some((exactness, *weight))
        });
        // The most specific range counts, whatever its weight.
        let (exactness, weight) =
            fitting.min_by(|a, b| a.0.cmp(&b.0)).unwrap_or((usize::MAX, 0.0));
        (weight, usize::MAX - exactness)
    };
    let (csv, json) =
        (preference("text/*", "text/csv"), preference("application/*", "application/json"));
    csv.0 > 0.0 && csv > json
}

/// Returns whether the client has the bytes of this tag already.
pub(super) fn is_known(tag: &str, headers: &HeaderMap) -> bool {
    let known = headers.get_all(IF_NONE_MATCH).iter().filter_map(|value| value.to_str().ok());
    known.flat_map(|list| list.split(',')).any(|one| {
        let one = one.trim();
        one == "*" || one.strip_prefix("W/").unwrap_or(one) == tag
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headers(name: &HeaderName, values: &[&'static str]) -> HeaderMap {
        values.iter().map(|value| (name.clone(), HeaderValue::from_static(value))).collect()
    }

    #[test]
    fn csv_is_sent_to_those_who_would_rather_have_it() {
        for (accepted, is_csv) in [
            (&["text/csv"][..], true),
            (&["Text/CSV; header=present"], true),
            (&["text/csv, */*;q=0.1"], true),
            (&["text/csv, */*"], true),
            (&["text/*"], true),
            (&["application/json;q=0.5", "text/csv;q=0.6"], true),
            (&[], false),
            (&["*/*"], false),
            (&["application/json, text/csv"], false),
            (&["text/csv, application/json"], false),
            (&["text/csv;q=0.5, application/json"], false),
            (&["text/csv;q=inf, application/json"], false),
            (&["text/csv;q=0"], false),
            (&["text/csv;q=much, */*"], false),
            (&["image/png", "", ";;,/"], false),
        ] {
            assert_eq!(prefers_csv(&headers(&ACCEPT, accepted)), is_csv, "{accepted:?}");
        }
    }

    #[test]
    fn gzip_is_sent_to_those_who_take_it() {
        for (accepted, takes) in [
            (&["gzip"][..], true),
            (&["br", "GZIP"], true),
            (&["gzip; q=0.5, *;q=0"], true),
            (&["x-gzip"], true),
            (&["*"], true),
            (&["br, *;q=0.1"], true),
            (&[], false),
            (&[""], false),
            (&["*;q=0"], false),
            (&["gzip;q=0, *"], false),
            (&["gzip ; q=0.000"], false),
            (&["gzip;q=NaN"], false),
            (&["deflate, br;q=1.0, identity"], false),
        ] {
            assert_eq!(takes_gzip(&headers(&ACCEPT_ENCODING, accepted)), takes, "{accepted:?}");
        }
    }
}
