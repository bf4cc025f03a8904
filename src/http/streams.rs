//! A bound on event streams: each holds a connection for as long as its client likes.

use std::sync::Arc;

use metrics::gauge;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use super::problem::Problem;
use super::problem_type::ProblemType;

/// Event streams that are open.
pub const EVENT_STREAMS: &str = "brinell_event_streams";

/// Places for streams.
#[derive(Debug)]
pub(super) struct EventStreamLimit {
    permits: Arc<Semaphore>,
}

impl EventStreamLimit {
    /// At most so many at a time.
    pub(super) fn new(most: usize) -> Self {
        Self { permits: Arc::new(Semaphore::new(most.min(Semaphore::MAX_PERMITS))) }
    }

    /// Takes a place, if there is one.
    pub(super) fn open(&self) -> Result<StreamPermit, Problem> {
        let permit = Arc::clone(&self.permits).try_acquire_owned().map_err(|_| {
            let detail = "as many event streams are open as may be; ask /v1/jobs/{id}?wait=30 instead";
            Problem::new(ProblemType::TooManyStreams, detail)
        })?;
        gauge!(EVENT_STREAMS).increment(1.0);
        Ok(StreamPermit { _permit: permit })
    }
}

/// A stream's place, free again when it is dropped.
#[derive(Debug)]
pub(super) struct StreamPermit {
    _permit: OwnedSemaphorePermit,
}

impl Drop for StreamPermit {
    fn drop(&mut self) {
        gauge!(EVENT_STREAMS).decrement(1.0);
    }
}
