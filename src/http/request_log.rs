//! Log and metrics of requests: one line and one sample for each request, with route, status,
//! duration and ids, never with its content.

use std::convert::Infallible;
use std::sync::Arc;
use std::time::Instant;

use axum::extract::{FromRequestParts, MatchedPath, Request, State};
use axum::http::request::Parts;
use axum::http::{HeaderMap, Method, StatusCode};
use axum::middleware::Next;
use axum::response::Response;
use metrics::histogram;
use tracing::field::{Empty, display};
use tracing::{Instrument, Span};

use super::access::Caller;
use super::client_address::{Network, Peer, client_address};
use crate::jobs::{JobId, KeyId, TraceParent};
use crate::telemetry;

/// Time \[s\] from the head of a request to the head of its answer, by method, route and status.
pub const REQUEST_DURATION: &str = "http_server_request_duration_seconds";

/// Routes that monitors poll; their requests are logged at level `debug`.
const PROBES: [&str; 3] = ["/livez", "/readyz", "/metrics"];

/// Longest part of an unknown address that is logged.
const PATH: usize = 100;

/// Id of a new job, which handlers put into the extensions of an answer.
#[derive(Debug, Clone, Copy)]
pub(super) struct JobIdExtension(pub(super) JobId);

/// The layer that logs requests.
pub(super) async fn log_request(
    State(proxies): State<Arc<[Network]>>,
    mut request: Request,
    next: Next,
) -> Response {
    let mut log = RequestLog::begin(&request, &proxies);
    request.extensions_mut().insert(log.trace);
    let span = log.span.clone();
    let response = next.run(request).instrument(span).await;
    log.status = Some(response.status());
    if let Some(JobIdExtension(id)) = response.extensions().get() {
        log.job = Some(id.to_string());
    }
    log.key = response.extensions().get::<Caller>().and_then(|caller| caller.key());
    response
}

/// One request. It is logged when dropped, so that a request whose client disconnects is logged
/// too.
struct RequestLog {
    started: Instant,
    span: Span,
    method: &'static str,
    route: Option<String>,
    path: String,
    job: Option<String>,
    key: Option<KeyId>,
    status: Option<StatusCode>,
    trace: Trace,
}

/// The trace that a request belongs to, with the span that stands for it here.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Trace(pub(super) Option<TraceParent>);

impl<S: Sync> FromRequestParts<S> for Trace {
    type Rejection = Infallible;

    async fn from_request_parts(parts: &mut Parts, _: &S) -> Result<Self, Infallible> {
        Ok(parts.extensions.get().copied().unwrap_or_default())
    }
}

/// The one `traceparent` of a request; what is none is ignored, as the standard asks.
fn trace_of(headers: &HeaderMap) -> Option<TraceParent> {
    let mut lines = headers.get_all("traceparent").iter();
    let line = lines.next().filter(|_| lines.next().is_none())?;
    line.to_str().ok()?.parse().ok()
}

impl RequestLog {
    fn begin(request: &Request, proxies: &[Network]) -> Self {
        let id = request
            .headers()
            .get("x-request-id")
            .and_then(|id| id.to_str().ok())
            .unwrap_or_default();
        let route = request.extensions().get::<MatchedPath>().map(|path| path.as_str().to_owned());
        let path = request.uri().path();
        let is_job = route.as_deref().is_some_and(|route| route.starts_with("/v1/jobs/{id}"));
        let job =
            path.split('/').nth(3).filter(|_| is_job).and_then(|id| id.parse::<JobId>().ok());
        let peer = request.extensions().get::<Peer>().copied();
        let client = client_address(peer, request.headers(), proxies).map(display);
        let span = tracing::info_span!("request", id, client, trace_id = Empty);
        let trace = Trace(telemetry::adopt(&span, trace_of(request.headers())));
        Self {
            trace,
            started: Instant::now(),
            span,
            method: name(request.method()),
            route,
            path: path.chars().take(PATH).collect(),
            job: job.map(|id| id.to_string()),
            key: None,
            status: None,
        }
    }
}

/// Returns the method if it is a standard one: arbitrary methods would create any number of
/// metrics.
fn name(method: &Method) -> &'static str {
    match *method {
        Method::GET => "GET",
        Method::HEAD => "HEAD",
        Method::POST => "POST",
        Method::PUT => "PUT",
        Method::PATCH => "PATCH",
        Method::DELETE => "DELETE",
        Method::OPTIONS => "OPTIONS",
        _ => "_OTHER",
    }
}

impl Drop for RequestLog {
    fn drop(&mut self) {
        let time = self.started.elapsed();
        let route = self.route.clone().unwrap_or_else(|| "none".to_owned());
        // 499, as nginx logs a client that hung up.
        let status = self.status.map_or(499, |status| status.as_u16());
        let (method, job, ms) = (self.method, self.job.as_deref(), time.as_secs_f64() * 1e3);
        histogram!(
            REQUEST_DURATION,
            "http_request_method" => method,
            "http_route" => route.clone(),
            "http_response_status_code" => status.to_string()
        )
        .record(time);
        let path = self.route.is_none().then_some(self.path.as_str());
        if PROBES.contains(&route.as_str()) {
            tracing::debug!(parent: &self.span, method, route, status, ms, "answered");
        } else {
            let key = self.key.map(display);
            tracing::info!(
                parent: &self.span, method, route, path, status, ms, job, key, "answered"
            );
        }
    }
}
