//! What is known about one job.

use std::collections::BTreeMap;

use bytes::Bytes;
use jiff::Timestamp;

use super::{IterationRecord, JobFailure, JobId, JobState, KeyId, TraceParent};

/// A job on its way into the store. It has been checked: its text parses and its cost is allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct NewJob {
    /// Its name.
    pub id: JobId,
    /// The job as it was submitted (JSON).
    pub request: Bytes,
    /// Labels to search by.
    pub tags: BTreeMap<String, String>,
    /// Larger goes first.
    pub priority: i16,
    /// Memory \[bytes\] it is estimated to need.
    pub memory: u64,
    /// Bytes its result is estimated to take in the store.
    pub result_bytes: u64,
    /// The API key it came under.
    pub submitter: Option<KeyId>,
    /// What makes a repeated submission recognisable.
    pub idempotency: Option<Idempotency>,
    /// Somebody waits for the answer on an open connection. The job survives the end of the
    /// process like any other, but is not synced to the disk before it is acknowledged
    /// ([`JobStore::sync`](super::JobStore::sync)).
    pub interactive: bool,
    /// Where its end is announced.
    pub callback_url: Option<String>,
    /// The trace that its submission belongs to.
    pub trace: Option<TraceParent>,
}

impl NewJob {
    /// A job of ordinary priority without labels, under a new name.
    pub fn new(request: Bytes) -> Self {
        Self {
            id: JobId::generate(),
            request,
            tags: BTreeMap::new(),
            priority: 0,
            memory: 0,
            result_bytes: 0,
            submitter: None,
            idempotency: None,
            interactive: false,
            callback_url: None,
            trace: None,
        }
    }
}

/// A client's name for one submission. Names of different API keys do not meet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Idempotency {
    /// The client's name.
    pub key: String,
    /// Digest of what was submitted: the same name with another digest is a mistake.
    pub digest: [u8; 32],
}

/// What is known about one job, without the bulky parts (request, history, report), which have
/// doors of their own in [`JobStore`](super::JobStore).
#[derive(Debug, Clone, PartialEq)]
pub struct JobRecord {
    /// Its name.
    pub id: JobId,
    /// Where it stands.
    pub state: JobState,
    /// Labels.
    pub tags: BTreeMap<String, String>,
    /// Larger goes first.
    pub priority: i16,
    /// The API key it came under.
    pub submitter: Option<KeyId>,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// When its latest attempt began.
    pub started_at: Option<Timestamp>,
    /// When it reached its final state.
    pub finished_at: Option<Timestamp>,
    /// How often a worker took it up.
    pub attempts: u32,
    /// Jobs of the same key that will be taken up before it, while it is queued.
    pub queue_position: Option<usize>,
    /// Whether somebody asked it to stop.
    pub cancel_requested: bool,
    /// Iterations of the latest attempt so far.
    pub iterations: usize,
    /// The latest of them.
    pub latest: Option<IterationRecord>,
    /// Whether there is a report to fetch.
    pub has_report: bool,
    /// Why it failed.
    pub failure: Option<JobFailure>,
    /// Whether its end is announced.
    pub has_callback: bool,
}
