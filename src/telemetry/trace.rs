//! Traces of requests and jobs across processes.

use tracing::Span;

use crate::jobs::TraceParent;

/// Makes a span part of the trace of its caller, and says how what follows from it refers to it.
pub fn adopt(_: &Span, caller: Option<TraceParent>) -> Option<TraceParent> {
    // Nothing records spans here: what follows refers to the caller's.
    caller
}
