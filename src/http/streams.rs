//! Limits on event streams, each of which holds a connection for as long as its client likes. One
//! key may open a quarter of them. Only a few streams read from the store at a time, so that other
//! requests find a connection to the database.

use std::sync::Arc;

use metrics::gauge;
use tokio::sync::{OwnedSemaphorePermit, Semaphore, SemaphorePermit};

use super::problem::Problem;
use super::problem_type::ProblemType;
use crate::jobs::{KeyId, Turn, Turns};

/// Open event streams.
pub const EVENT_STREAMS: &str = "brinell_event_streams";

/// Streams that read from the store at a time; SQLite has four readers.
const READING: usize = 2;

/// Places for streams.
#[derive(Debug)]
pub(super) struct EventStreamLimit {
    permits: Arc<Semaphore>,
    reading: Semaphore,
    keys: Turns,
}

impl EventStreamLimit {
    /// Allows at most `most` streams at a time.
    pub(super) fn new(most: usize) -> Self {
        let permits = Arc::new(Semaphore::new(most.min(Semaphore::MAX_PERMITS)));
        Self { permits, reading: Semaphore::new(READING), keys: Turns::new(most.div_ceil(4)) }
    }

    /// Waits for a stream's turn to read from the store.
    pub(super) async fn turn(&self) -> Option<SemaphorePermit<'_>> {
        self.reading.acquire().await.ok()
    }

    /// Takes a place, if there is one.
    pub(super) fn open(&self, key: Option<KeyId>) -> Result<StreamPermit, Problem> {
        let of_key = self.keys.try_take(key);
        let permit = Arc::clone(&self.permits).try_acquire_owned().ok();
        let (of_key, permit) = of_key.zip(permit).ok_or_else(|| {
            let detail =
                "as many event streams are open as may be; ask /v1/jobs/{id}?wait=30 instead";
            Problem::new(ProblemType::TooManyStreams, detail)
        })?;
        gauge!(EVENT_STREAMS).increment(1.0);
        Ok(StreamPermit { _permit: permit, _of_key: of_key })
    }
}

/// A stream's place, free again when it is dropped.
#[derive(Debug)]
pub(super) struct StreamPermit {
    _permit: OwnedSemaphorePermit,
    _of_key: Turn,
}

impl Drop for StreamPermit {
    fn drop(&mut self) {
        gauge!(EVENT_STREAMS).decrement(1.0);
    }
}
