//! The trace that a submission belongs to (W3C Trace Context, level 1), carried from the request
//! through the queue to the worker.

use std::fmt;
use std::str::FromStr;

use uuid::Uuid;

/// A `traceparent`: which trace, and which span of it comes before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TraceParent {
    /// The trace, not zero.
    pub trace_id: u128,
    /// The span, not zero.
    pub span_id: u64,
    /// Whether the caller records it.
    pub sampled: bool,
}

impl TraceParent {
    /// Continues the trace with a new span.
    #[must_use]
    pub fn child(self) -> Self {
        let (_, random) = Uuid::new_v4().as_u64_pair();
        Self { span_id: random.max(1), ..self }
    }

    /// Returns the trace id in hexadecimal.
    pub fn trace(&self) -> String {
        format!("{:032x}", self.trace_id)
    }
}

/// An error for a header that is no trace context.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotATrace;

impl FromStr for TraceParent {
    type Err = NotATrace;

    /// Parses the header. A newer version may have further fields behind the flags.
    fn from_str(text: &str) -> Result<Self, NotATrace> {
        let is_lower_hex =
            |part: &str| part.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'));
        let mut parts = text.split('-');
        let mut next = |length: usize| {
            parts.next().filter(|part| part.len() == length && is_lower_hex(part)).ok_or(NotATrace)
        };
        let (version, trace, span, flags) = (next(2)?, next(32)?, next(16)?, next(2)?);
        if version == "ff" || (version == "00" && parts.next().is_some()) {
            return Err(NotATrace);
        }
        let trace_id = u128::from_str_radix(trace, 16).map_err(|_| NotATrace)?;
        let span_id = u64::from_str_radix(span, 16).map_err(|_| NotATrace)?;
        let flags = u8::from_str_radix(flags, 16).map_err(|_| NotATrace)?;
        if trace_id == 0 || span_id == 0 {
            return Err(NotATrace);
        }
        Ok(Self { trace_id, span_id, sampled: flags & 1 == 1 })
    }
}

impl fmt::Display for TraceParent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "00-{:032x}-{:016x}-{:02x}", self.trace_id, self.span_id, u8::from(self.sampled))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXAMPLE: &str = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";

    #[test]
    fn the_example_of_the_standard_is_read_and_written() {
        let parent: TraceParent = EXAMPLE.parse().unwrap();
        assert!(parent.sampled && parent.trace() == "4bf92f3577b34da6a3ce929d0e0e4736");
        assert_eq!(parent.to_string(), EXAMPLE);
        let child = parent.child();
        assert!(child.trace_id == parent.trace_id && child.span_id != parent.span_id);
        let newer = format!("cc{}-what", &EXAMPLE[2..]);
        assert_eq!(newer.parse(), Ok(parent));
    }

    #[test]
    fn other_texts_are_no_traces() {
        for text in [
            "",
            "00",
            "00-00000000000000000000000000000000-00f067aa0ba902b7-01",
            "00-4bf92f3577b34da6a3ce929d0e0e4736-0000000000000000-01",
            "ff-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01",
            "00-4BF92F3577B34DA6A3CE929D0E0E4736-00f067aa0ba902b7-01",
            "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01-x",
            "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-é",
            "00-+bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01",
        ] {
            assert_eq!(text.parse::<TraceParent>(), Err(NotATrace), "{text}");
        }
    }
}
