//! The trait through which all code reaches the storage.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;
use jiff::Timestamp;
use thiserror::Error;
use tokio::time::error::Elapsed;

use super::{
    Deflated, FieldsPart, IterationRecord, JobId, JobRecord, JobState, KeyId, NewJob,
    NumberedIteration, Outcome, ResultHead, StepResult, TraceParent, Turn, WorkerId,
};

/// Stores jobs, hands them to workers and keeps their results.
///
/// Every change is atomic. A change of a job is announced on the store's
/// [`JobNotifier`](super::JobNotifier) *after* it can be read. All times come from the store's
/// clock, so that processes that share a store share a clock. One suite, `tests/store_contract`,
/// checks all implementations.
///
/// # Errors
/// Every method: [`StoreError::Unavailable`] if the storage does not answer,
/// [`StoreError::NotFound`] if the job does not exist. Each method lists its further errors.
#[async_trait]
pub trait JobStore: Send + Sync + 'static {
    /// Stores a job and queues it behind the jobs of its priority. If its idempotency key is known
    /// already, the method stores nothing and returns the job that came with the key. `turn` is
    /// dropped as soon as the key's next submission may begin.
    ///
    /// # Errors
    /// [`StoreError::QueueFull`], [`StoreError::QuotaExceeded`], [`StoreError::KeyReused`],
    /// [`StoreError::KeyEnded`], [`StoreError::DiskFull`]; the job is not stored then.
    async fn enqueue(&self, job: NewJob, turn: Turn) -> Result<Enqueued, StoreError>;

    /// Stores several jobs in one transaction, each as [`JobStore::enqueue`] does, and returns one
    /// outcome for each job, in order. A refused job does not affect the others.
    ///
    /// # Errors
    /// [`StoreError::DiskFull`], [`StoreError::Damaged`], [`StoreError::Unavailable`]; no job is
    /// stored then.
    async fn enqueue_all(
        &self,
        jobs: Vec<NewJob>,
        turn: Turn,
    ) -> Result<Vec<Result<Enqueued, StoreError>>, StoreError>;

    /// Returns the record of a job.
    async fn get(&self, id: JobId) -> Result<JobRecord, StoreError>;

    /// Returns a page of about [`HISTORY_PAGE`] iterations of the latest attempt, in order,
    /// without its first `after` iterations; empty behind the last one.
    async fn history(&self, id: JobId, after: usize)
    -> Result<Vec<NumberedIteration>, StoreError>;

    /// The job as it was submitted (JSON).
    async fn request(&self, id: JobId) -> Result<Bytes, StoreError>;

    /// Returns the result without its steps, if the job has one.
    async fn result(&self, id: JobId) -> Result<Option<ResultHead>, StoreError>;

    /// Returns the report of a step (counted from 0) without its fields.
    ///
    /// # Errors
    /// [`StoreError::NotFound`] without such a step.
    async fn step(&self, id: JobId, step: usize) -> Result<Deflated, StoreError>;

    /// Returns the part of the fields of a step (counted from 0) that contains the given byte, or
    /// the last part before it; `None` if the job did not ask for fields.
    /// [`FieldsReader`](super::FieldsReader) puts parts together.
    ///
    /// # Errors
    /// [`StoreError::NotFound`] without such a step.
    async fn fields(
        &self,
        id: JobId,
        step: usize,
        at: usize,
    ) -> Result<Option<FieldsPart>, StoreError>;

    /// Leases up to `request.places` jobs to a worker, one after the other. The next job comes
    /// from the key that holds the fewest places; among equal keys, from the key that has spent
    /// the least solver time within the last minute. Of one key, jobs that have lost their worker
    /// go first, then the highest priority, then the oldest job. A key at its limit of places on
    /// the worker, or of running jobs, is passed over.
    ///
    /// Every place has memory of its own. Jobs that need more share the rest of the worker's
    /// memory. The first large job that does not fit blocks the large jobs behind it, so that they
    /// cannot overtake it for ever.
    ///
    /// A job whose worker was lost `max_attempts` times fails, or is cancelled if a client asked
    /// for that. Of the jobs whose worker was lost `max_attempts - 1` times a worker runs one at a
    /// time: no job fails because the neighbour that it was lost with crashes the worker again.
    async fn claim(&self, request: &ClaimRequest) -> Result<Claims, StoreError>;

    /// Returns the jobs to the queue that a worker has leased and does not know of: the answer to
    /// its claim was lost. The attempt does not count as a loss.
    async fn give_back(&self, owner: WorkerId, known: &[JobId]) -> Result<(), StoreError>;

    /// Extends leases of one worker to `lease` from now and returns for each, in the given order,
    /// whether the worker still holds it. Also without leases, the answer is a sign of life of the
    /// store.
    async fn heartbeat(
        &self,
        leases: &[Lease],
        lease: Duration,
    ) -> Result<Vec<LeaseStatus>, StoreError>;

    /// Writes iterations into the history of a leased job; a repeated write changes nothing.
    /// `latest` is the last of them, or of a preliminary solve that the history does not list.
    ///
    /// # Errors
    /// [`StoreError::LeaseLost`]; nothing is written then.
    async fn record_progress(
        &self,
        lease: &Lease,
        records: &[NumberedIteration],
        latest: &IterationRecord,
    ) -> Result<(), StoreError>;

    /// Stores the results of further steps of a leased job, in order. Results that begin with step
    /// 0 replace all earlier ones.
    ///
    /// # Errors
    /// [`StoreError::LeaseLost`]; nothing is written then.
    async fn record_steps(&self, lease: &Lease, steps: &[StepResult]) -> Result<(), StoreError>;

    /// Ends a leased job; `records` are its last iterations, `steps` its last steps. A job that
    /// ends without a report loses its steps.
    ///
    /// # Errors
    /// [`StoreError::LeaseLost`]; nothing is written then.
    async fn finish(
        &self,
        lease: &Lease,
        records: &[NumberedIteration],
        steps: &[StepResult],
        outcome: Outcome,
    ) -> Result<(), StoreError>;

    /// Returns leased jobs to the queue without counting the attempt; cancels the jobs that were
    /// asked to stop. Lost leases are ignored.
    async fn release(&self, leases: &[Lease]) -> Result<(), StoreError>;

    /// Asks a job to stop: a queued job is cancelled at once, a running job is marked, a finished
    /// job stays as it is. Returns the job afterwards.
    async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError>;

    /// Returns a page of jobs in the order of their submission.
    async fn list(&self, filter: &JobFilter) -> Result<JobPage, StoreError>;

    /// Removes a finished job.
    ///
    /// # Errors
    /// [`StoreError::NotFound`], [`StoreError::Unfinished`].
    async fn delete(&self, id: JobId) -> Result<(), StoreError>;

    /// Returns the number of jobs that are queued and running; a state without jobs is missing.
    async fn counts(&self) -> Result<Counts, StoreError>;

    /// Removes finished jobs and idempotency keys that are older than `retention` allows, a
    /// bounded number of them. Returns the number of removed jobs.
    async fn sweep(&self, retention: &Retention) -> Result<usize, StoreError>;

    /// Returns once every acknowledged change survives a loss of power. Only interactive jobs need
    /// this call; the others are synced before they are acknowledged.
    async fn sync(&self) -> Result<(), StoreError>;

    /// Checks the store's own file for damage, and every job if `jobs`; returns one line for each
    /// fault.
    async fn check(&self, jobs: bool) -> Result<Vec<String>, StoreError>;

    /// Writes a consistent copy of the store to a new file. Returns `false` where the database
    /// server makes its own backups.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`], [`StoreError::DiskFull`].
    async fn backup(&self, file: &Path) -> Result<bool, StoreError>;

    /// Checks that the store accepts writes and has room for another job.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`], [`StoreError::DiskFull`].
    async fn ping(&self) -> Result<(), StoreError>;

    /// Closes all connections, after which a store's file is complete and every call fails.
    async fn close(&self);
}

/// Most iterations in one row, which is written and read at once.
pub const HISTORY_PAGE: usize = 256;

/// Most jobs one [`JobStore::sweep`] removes.
pub const SWEEP: usize = 200;

/// How long finished jobs are kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Retention {
    /// Jobs with a result.
    pub succeeded: Duration,
    /// Jobs without a result: failed, cancelled, timed out.
    pub failed: Duration,
    /// Bytes of all results above which the oldest results are removed early.
    pub stored_bytes: Option<u64>,
}

impl Retention {
    /// Returns when a job is removed; `None` until it has finished.
    pub fn expires_at(&self, job: &JobRecord) -> Option<Timestamp> {
        let kept = match job.state {
            JobState::Succeeded | JobState::NotConverged => self.succeeded,
            _ => self.failed,
        };
        job.finished_at?.checked_add(kept).ok()
    }
}

impl Default for Retention {
    fn default() -> Self {
        Self {
            succeeded: Duration::from_hours(168),
            failed: Duration::from_hours(72),
            stored_bytes: None,
        }
    }
}

/// The outcome of a submission.
#[derive(Debug, Clone, PartialEq)]
pub struct Enqueued {
    /// The job.
    pub job: JobRecord,
    /// Whether the job was submitted with the same idempotency key before.
    pub replayed: bool,
}

/// Jobs in each state.
pub type Counts = BTreeMap<JobState, usize>;

/// A worker's request for jobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClaimRequest {
    /// Id of the worker.
    pub owner: WorkerId,
    /// Number of free places.
    pub places: usize,
    /// Most places of the worker that one key may hold.
    pub places_of_key: usize,
    /// Memory \[bytes\] that each place has of its own.
    pub memory_of_place: u64,
    /// Memory \[bytes\] that large jobs share, counted by their estimates.
    pub free_memory: u64,
    /// Memory \[bytes\] of the idle worker. Larger jobs are left to other workers.
    pub memory: u64,
    /// Duration of a lease without a heartbeat.
    pub lease: Duration,
    /// Number of lost workers after which a job fails.
    pub max_attempts: u32,
    /// Whether to look for jobs whose lease has expired, and to take them over.
    pub expires: bool,
}

/// The jobs leased by one claim.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Claims {
    /// The jobs, in the order of the queue.
    pub jobs: Vec<Claim>,
    /// Whether a job waits for memory.
    pub large_pending: bool,
}

/// The right of a worker to write to a running job. It ends when the job is leased again.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Lease {
    /// The job.
    pub job: JobId,
    /// Id of the worker.
    pub owner: WorkerId,
    /// Number of the attempt, counted from 1.
    pub attempt: u32,
}

/// A leased job.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// The lease.
    pub lease: Lease,
    /// Estimated memory \[bytes\] of the job.
    pub memory: u64,
    /// The job as it was submitted (JSON).
    pub request: Bytes,
    /// The trace of its submission.
    pub trace: Option<TraceParent>,
}

/// The answer to a heartbeat for one lease.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeaseStatus {
    /// The lease is extended.
    Held {
        /// Whether a client asked the job to stop.
        cancel_requested: bool,
    },
    /// Another worker holds the job, or it is removed.
    Lost,
}

/// A filter for lists of jobs.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct JobFilter {
    /// Only these jobs; all if empty.
    pub ids: Vec<JobId>,
    /// Only jobs in one of these states; in any if empty.
    pub states: Vec<JobState>,
    /// Only jobs with all of these labels.
    pub tags: Vec<(String, String)>,
    /// Only jobs accepted at this time or later.
    pub since: Option<Timestamp>,
    /// Only jobs accepted before this time.
    pub until: Option<Timestamp>,
    /// Only jobs submitted under this key.
    pub submitter: Option<KeyId>,
    /// The oldest first, instead of the newest.
    pub oldest_first: bool,
    /// Only jobs that come after this one in the order: the previous page's [`JobPage::next`].
    pub cursor: Option<JobId>,
    /// Most jobs on the page.
    pub limit: usize,
}

/// One page of a list.
#[derive(Debug, Clone, PartialEq)]
pub struct JobPage {
    /// The jobs in the requested order.
    pub jobs: Vec<JobRecord>,
    /// Id after which the next page starts; `None` on the last page.
    pub next: Option<JobId>,
}

/// An error of a store.
#[derive(Debug, Error)]
pub enum StoreError {
    /// The job does not exist, or was removed.
    #[error("there is no such job")]
    NotFound,
    /// The queue has reached its longest length.
    #[error("the queue is full ({queued} jobs waiting)")]
    QueueFull {
        /// Jobs waiting.
        queued: usize,
    },
    /// A limit of the API key is reached.
    #[error("{quota}")]
    QuotaExceeded {
        /// Which limit.
        quota: Quota,
    },
    /// The idempotency key belongs to a submission with another body.
    #[error("the idempotency key was used with another body before")]
    KeyReused,
    /// The API key was revoked, or has expired, since the request began.
    #[error("the API key is no longer good")]
    KeyEnded,
    /// The worker no longer holds the lease.
    #[error("the job's lease is lost")]
    LeaseLost,
    /// The job is still queued or running.
    #[error("the job is {0}")]
    Unfinished(JobState),
    /// The disk is full, or its free space is reserved for the results of accepted jobs.
    #[error("the disk is full")]
    DiskFull,
    /// A stored row is damaged: a retry fails as well.
    #[error("what is stored is damaged")]
    Damaged(#[source] Box<dyn std::error::Error + Send + Sync>),
    /// The storage does not answer.
    #[error("storage is unavailable")]
    Unavailable(#[source] Box<dyn std::error::Error + Send + Sync>),
}

/// A limit of an API key that a submission exceeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Quota {
    /// Jobs waiting.
    #[error("this API key may have {limit} jobs waiting, and has them")]
    Queued {
        /// The limit.
        limit: u32,
    },
    /// Results.
    #[error(
        "the results of this API key may take {limit} bytes; they take {used}, and that of this \
         job may take {needed} more"
    )]
    Stored {
        /// The limit \[bytes\].
        limit: u64,
        /// Bytes of the key's results, with the estimates of its unfinished jobs.
        used: u64,
        /// Estimated bytes of the job's result.
        needed: u64,
    },
    /// Priority.
    #[error("jobs of this API key may have priority {limit} at most")]
    Priority {
        /// The highest allowed priority.
        limit: i16,
    },
}

impl Quota {
    /// Names of all quotas.
    pub const NAMES: [&str; 3] = ["queued_jobs", "stored_bytes", "priority"];

    /// The name used in the wire format.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Queued { .. } => "queued_jobs",
            Self::Stored { .. } => "stored_bytes",
            Self::Priority { .. } => "priority",
        }
    }
}

impl StoreError {
    /// Wraps the cause of a failure of the storage.
    pub fn unavailable(source: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self::Unavailable(source.into())
    }

    /// The failure of a call that is not answered in time.
    pub fn silent(_: Elapsed) -> Self {
        Self::unavailable("the database does not answer")
    }

    /// Wraps the description of a damaged row.
    pub fn damaged(source: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self::Damaged(source.into())
    }
}
