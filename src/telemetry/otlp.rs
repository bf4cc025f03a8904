//! Export of spans to a collector by OTLP over HTTP (protobuf), on a thread of its own.

use std::fmt;
use std::sync::OnceLock;
use std::time::Duration;

use async_trait::async_trait;
use opentelemetry::Context;
use opentelemetry::trace::{
    SpanContext, SpanId, TraceContextExt, TraceFlags, TraceId, TraceState, TracerProvider,
};
use opentelemetry_http::{Bytes, HttpClient, HttpError, Request, Response};
use opentelemetry_otlp::{SpanExporter, WithExportConfig, WithHttpConfig};
use opentelemetry_sdk::Resource;
use opentelemetry_sdk::trace::SdkTracerProvider;
use tokio::runtime::{Builder, Runtime};
use tokio::time::timeout;
use tracing::{Span, Subscriber};
use tracing_opentelemetry::OpenTelemetrySpanExt;
use tracing_subscriber::Layer;
use tracing_subscriber::filter::Targets;
use tracing_subscriber::registry::LookupSpan;

use crate::jobs::TraceParent;
use crate::outgoing::{Client, Destination};

/// Timeout of a request to the collector.
const TIMEOUT: Duration = Duration::from_secs(10);

static PROVIDER: OnceLock<SdkTracerProvider> = OnceLock::new();

/// What records the spans of this program for the collector at an address
/// (`http://collector:4318`).
pub(super) fn layer<S>(
    collector: &Destination,
) -> Result<impl Layer<S>, Box<dyn std::error::Error>>
where
    S: Subscriber + for<'a> LookupSpan<'a>,
{
    let to = collector.below("/v1/traces");
    let endpoint = to.url();
    let runtime = Builder::new_current_thread().enable_all().build()?;
    let sender = Sender { client: Client::new(true, None)?, to, runtime };
    let exporter = SpanExporter::builder()
        .with_http()
        .with_http_client(sender)
        .with_endpoint(endpoint)
        .build()?;
    let resource = Resource::builder().with_service_name("brinell").build();
    let provider =
        SdkTracerProvider::builder().with_batch_exporter(exporter).with_resource(resource).build();
    let provider = PROVIDER.get_or_init(|| provider);
    let spans = tracing_opentelemetry::layer().with_tracer(provider.tracer("brinell"));
    Ok(spans.with_filter(Targets::new().with_target("brinell", tracing::Level::INFO)))
}

/// Sends the spans collected so far.
pub fn flush() {
    if let Some(Err(error)) = PROVIDER.get().map(SdkTracerProvider::shutdown) {
        tracing::warn!(%error, "the last spans were not sent");
    }
}

/// Makes a span a child of its caller's; how others refer to it, where it is recorded.
pub(super) fn follow(span: &Span, caller: Option<TraceParent>) -> Option<TraceParent> {
    if let Some(caller) = caller {
        let flags = if caller.sampled { TraceFlags::SAMPLED } else { TraceFlags::default() };
        let (trace, parent) = (TraceId::from(caller.trace_id), SpanId::from(caller.span_id));
        let remote = SpanContext::new(trace, parent, flags, true, TraceState::default());
        // Fails where no layer records spans.
        let _ = span.set_parent(Context::new().with_remote_span_context(remote));
    }
    let context = span.context();
    let own = context.span().span_context().clone();
    let recorded = TraceParent {
        trace_id: u128::from_be_bytes(own.trace_id().to_bytes()),
        span_id: u64::from_be_bytes(own.span_id().to_bytes()),
        sampled: own.is_sampled(),
    };
    if own.is_valid() { Some(recorded) } else { caller }
}

/// Sends requests for the exporter, whose thread has no runtime.
struct Sender {
    client: Client,
    to: Destination,
    runtime: Runtime,
}

impl fmt::Debug for Sender {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sender").field("to", &self.to).finish_non_exhaustive()
    }
}

#[async_trait]
impl HttpClient for Sender {
    async fn send_bytes(&self, request: Request<Bytes>) -> Result<Response<Bytes>, HttpError> {
        let (head, body) = request.into_parts();
        let sent =
            async { timeout(TIMEOUT, self.client.post(&self.to, head.headers, body)).await };
        let status = self.runtime.block_on(sent)??;
        Ok(Response::builder().status(status).body(Bytes::new())?)
    }
}
