//! Records of jobs.

use std::collections::{BTreeMap, BTreeSet};

use bytes::Bytes;
use jiff::Timestamp;

use super::{About, IterationRecord, JobFailure, JobId, JobState, KeyId, TraceParent};

/// A checked job, ready for the store: its text parses and its cost is allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct NewJob {
    /// Its name.
    pub id: JobId,
    /// The job as it was submitted (JSON).
    pub request: Bytes,
    /// What a list says of it.
    pub about: Option<About>,
    /// Labels to search by.
    pub tags: BTreeMap<String, String>,
    /// Words to search by.
    pub words: BTreeSet<String>,
    /// Larger goes first.
    pub priority: i16,
    /// Estimated memory \[bytes\] of the solve.
    pub memory: u64,
    /// Estimated bytes of its result in the store.
    pub result_bytes: u64,
    /// The API key it came under.
    pub submitter: Option<KeyId>,
    /// The idempotency key of the submission.
    pub idempotency: Option<Idempotency>,
    /// Whether a client waits for the result on an open connection. The job survives a crash of
    /// the process like any other, but is not synced to the disk before it is acknowledged
    /// ([`JobStore::sync`](super::JobStore::sync)).
    pub interactive: bool,
    /// Where its end is announced.
    pub callback_url: Option<String>,
    /// The trace that its submission belongs to.
    pub trace: Option<TraceParent>,
}

impl NewJob {
    /// Makes a job with a new id, ordinary priority and no labels.
    pub fn new(request: Bytes) -> Self {
        Self {
            id: JobId::generate(),
            request,
            about: None,
            tags: BTreeMap::new(),
            words: BTreeSet::new(),
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

/// An idempotency key: the client's name for one submission. Two API keys may use the same name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Idempotency {
    /// The client's name.
    pub key: String,
    /// Digest of the submission: the same name with another digest is an error.
    pub digest: [u8; 32],
}

/// The record of a job without its large parts: [`JobStore`](super::JobStore) returns request,
/// history and report by methods of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct JobRecord {
    /// Its name.
    pub id: JobId,
    /// Its state.
    pub state: JobState,
    /// What a list says of it; `None` of jobs taken in before version 0.3.
    pub about: Option<About>,
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
    /// Number of attempts.
    pub attempts: u32,
    /// Number of queued jobs of the same key in front of it, while it is queued.
    pub queue_position: Option<usize>,
    /// Whether a client asked it to stop.
    pub cancel_requested: bool,
    /// Iterations of the latest attempt so far.
    pub iterations: usize,
    /// The latest of them; without any, that of a preliminary solve.
    pub latest: Option<IterationRecord>,
    /// Whether there is a report to fetch.
    pub has_report: bool,
    /// Why it failed.
    pub failure: Option<JobFailure>,
    /// Whether its end is announced.
    pub has_callback: bool,
}

/// An iteration of an attempt, as a worker writes it.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberedIteration {
    /// Its number in the attempt, counted from 0.
    pub number: usize,
    /// What the solver says of it.
    pub record: IterationRecord,
}
