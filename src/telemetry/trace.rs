//! Traces of requests and jobs across processes.

use tracing::Span;

#[cfg(feature = "otlp")]
use super::otlp::follow;
use crate::jobs::TraceParent;

/// Makes a span, which has an empty field `trace_id`, part of the trace of its caller, and says
/// how what follows from it refers to it.
pub fn adopt(span: &Span, caller: Option<TraceParent>) -> Option<TraceParent> {
    let trace = follow(span, caller);
    if let Some(trace) = trace {
        span.record("trace_id", trace.trace().as_str());
    }
    trace
}

/// Nothing records spans here: what follows refers to the caller's.
#[cfg(not(feature = "otlp"))]
const fn follow(_: &Span, caller: Option<TraceParent>) -> Option<TraceParent> {
    caller
}
