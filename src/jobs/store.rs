//! The only door to storage.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;
use jiff::Timestamp;
use thiserror::Error;

use super::{
    Deflated, FieldsPart, IterationRecord, JobId, JobRecord, JobState, KeyId, NewJob, Outcome,
    ResultHead, StepResult, TraceParent, Turn, WorkerId,
};

/// Keeps jobs, hands them out and remembers how they ended.
///
/// Every change is one atomic step, and every step that alters a job is announced on the store's
/// [`JobNotifier`](super::JobNotifier) *after* it can be read. The store stamps all times, so that
/// several processes sharing one store share one clock. Implementations are checked by one suite,
/// `tests/store_contract`.
///
/// # Errors
/// Of every method: [`StoreError::Unavailable`] where the storage does not answer,
/// [`StoreError::NotFound`] of a job that there is not; further ones as each says.
#[async_trait]
pub trait JobStore: Send + Sync + 'static {
    /// Takes in a job, durably as far as the store is durable, and queues it behind those of its
    /// priority. A job with an idempotency key that is known already is not taken in: the job that
    /// came with the key is returned. The turn of its key ends when others may be taken in.
    ///
    /// # Errors
    /// [`StoreError::QueueFull`], [`StoreError::QuotaExceeded`], [`StoreError::KeyReused`],
    /// [`StoreError::KeyEnded`], [`StoreError::DiskFull`]; nothing is kept then.
    async fn enqueue(&self, job: NewJob, turn: Turn) -> Result<Enqueued, StoreError>;

    /// Takes in several jobs, each as [`JobStore::enqueue`] does, all in one step: of each, in
    /// order, what became of it. One that is refused leaves nothing behind and does not touch the
    /// others.
    ///
    /// # Errors
    /// [`StoreError::DiskFull`], [`StoreError::Damaged`], [`StoreError::Unavailable`]; none is
    /// kept then.
    async fn enqueue_all(
        &self,
        jobs: Vec<NewJob>,
        turn: Turn,
    ) -> Result<Vec<Result<Enqueued, StoreError>>, StoreError>;

    /// What is known about a job.
    async fn get(&self, id: JobId) -> Result<JobRecord, StoreError>;

    /// A page of the iterations of the latest attempt behind the first `after`, in order, about
    /// [`HISTORY_PAGE`]; empty where there are no more.
    async fn history(&self, id: JobId, after: usize) -> Result<Vec<IterationRecord>, StoreError>;

    /// The job as it was submitted (JSON).
    async fn request(&self, id: JobId) -> Result<Bytes, StoreError>;

    /// The result without its steps, if the job has one.
    async fn result(&self, id: JobId) -> Result<Option<ResultHead>, StoreError>;

    /// The report of a step of the result, counted from 0, without its fields.
    ///
    /// # Errors
    /// [`StoreError::NotFound`] without such a step.
    async fn step(&self, id: JobId, step: usize) -> Result<Deflated, StoreError>;

    /// The part of the fields of a step, counted from 0, that has this byte of them, or else the
    /// last before it; `None` of a job that did not ask for them.
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

    /// Hands out up to `request.places` jobs, one after the other: the key that holds the fewest
    /// places has the next one, and among equals the key that has spent the least solver time
    /// within the last minute. Of a key, jobs that have lost their worker go first, then the
    /// highest priority, then the oldest. A key that holds as many places of the worker as it may,
    /// or has as many jobs running as it may, is passed over.
    ///
    /// Every place has memory of its own. Jobs that need more share the rest of the worker's
    /// memory; the first that does not fit holds up those behind it, so that large jobs are not
    /// overtaken for ever by other large ones.
    ///
    /// A job whose worker was lost `max_attempts` times fails, or is cancelled if that was asked,
    /// instead of being handed out. One that was lost `max_attempts - 1` times is handed out by
    /// itself and only to a worker that does nothing else ([`ClaimRequest::exclusive`]): no job is
    /// given up because of its neighbour's fault.
    async fn claim(&self, request: &ClaimRequest) -> Result<Claims, StoreError>;

    /// Extends leases of one worker by `lease` from now and tells of each whether it is still
    /// held, in the given order.
    async fn heartbeat(
        &self,
        leases: &[Lease],
        lease: Duration,
    ) -> Result<Vec<LeaseStatus>, StoreError>;

    /// Appends iterations to the history of a leased job.
    ///
    /// # Errors
    /// [`StoreError::LeaseLost`]; nothing is written then.
    async fn record_progress(
        &self,
        lease: &Lease,
        records: &[IterationRecord],
    ) -> Result<(), StoreError>;

    /// Keeps the results of further steps of a leased job, in order. Where they begin with number
    /// 0, those that were kept before are removed.
    ///
    /// # Errors
    /// [`StoreError::LeaseLost`]; nothing is written then.
    async fn record_steps(&self, lease: &Lease, steps: &[StepResult]) -> Result<(), StoreError>;

    /// Ends a leased job; `records` are its last iterations, `steps` its last steps. Steps of a
    /// job that ends without a report are removed.
    ///
    /// # Errors
    /// [`StoreError::LeaseLost`]; nothing is written then.
    async fn finish(
        &self,
        lease: &Lease,
        records: &[IterationRecord],
        steps: &[StepResult],
        outcome: Outcome,
    ) -> Result<(), StoreError>;

    /// Gives leased jobs back to the queue, as if they had not been taken up; one that was to stop
    /// is cancelled. Leases that are lost already are passed over.
    async fn release(&self, leases: &[Lease]) -> Result<(), StoreError>;

    /// Asks a job to stop: a queued one is cancelled at once, a running one is marked, a finished
    /// one is left. Returns the job as it is afterwards.
    async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError>;

    /// One page of jobs, in the order of their submission.
    async fn list(&self, filter: &JobFilter) -> Result<JobPage, StoreError>;

    /// Removes a finished job.
    ///
    /// # Errors
    /// [`StoreError::NotFound`], [`StoreError::Unfinished`].
    async fn delete(&self, id: JobId) -> Result<(), StoreError>;

    /// How many jobs are in each state; states without jobs may be missing.
    async fn counts(&self) -> Result<Counts, StoreError>;

    /// Removes finished jobs, and forgotten idempotency keys, that are older than allowed, a
    /// bounded number at a time. Returns how many jobs it removed.
    async fn sweep(&self, retention: &Retention) -> Result<usize, StoreError>;

    /// Returns once everything that was acknowledged survives a loss of power. Jobs that are not
    /// interactive need no such call.
    async fn sync(&self) -> Result<(), StoreError>;

    /// Looks for damage in the store's own file, and in every job if `jobs`; returns one line for
    /// each damage found.
    async fn check(&self, jobs: bool) -> Result<Vec<String>, StoreError>;

    /// Writes a consistent copy of everything to a new file. `false` if the store has means of its
    /// own for that.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`], [`StoreError::DiskFull`].
    async fn backup(&self, file: &Path) -> Result<bool, StoreError>;

    /// Shows that the store can be written to and has room for another job.
    ///
    /// # Errors
    /// [`StoreError::Unavailable`], [`StoreError::DiskFull`].
    async fn ping(&self) -> Result<(), StoreError>;

    /// Ends all connections, so that a store in a file has everything in it; nothing can be asked
    /// any more.
    async fn close(&self);
}

/// Iterations that are written, and read, at a time.
pub const HISTORY_PAGE: usize = 256;

/// Most jobs one [`JobStore::sweep`] removes.
pub const SWEEP: usize = 500;

/// How long finished jobs are kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Retention {
    /// Those with a result.
    pub succeeded: Duration,
    /// Those without: failed, cancelled, timed out.
    pub failed: Duration,
    /// Bytes of results above which the jobs that finished first are removed before their time.
    pub stored_bytes: Option<u64>,
}

impl Retention {
    /// When a job is removed; `None` until it has finished.
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

/// What became of a job that was handed in.
#[derive(Debug, Clone, PartialEq)]
pub struct Enqueued {
    /// The job.
    pub job: JobRecord,
    /// It is not new: it came with the same idempotency key before.
    pub replayed: bool,
}

/// Jobs in each state.
pub type Counts = BTreeMap<JobState, usize>;

/// A worker asking for jobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClaimRequest {
    /// Who asks.
    pub owner: WorkerId,
    /// How many places are free.
    pub places: usize,
    /// How many places of the worker a key may hold.
    pub places_of_key: usize,
    /// Memory \[bytes\] that each place has of its own.
    pub memory_of_place: u64,
    /// Whether the worker does nothing else, and may be given a job that must run by itself.
    pub exclusive: bool,
    /// Memory \[bytes\] beside it that the jobs may need in all, by their estimates.
    pub free_memory: u64,
    /// Memory \[bytes\] of the idle worker. Jobs that need more are left to others.
    pub memory: u64,
    /// How long the jobs are his without a heartbeat.
    pub lease: Duration,
    /// How often a job's worker may be lost.
    pub max_attempts: u32,
}

/// What a worker is handed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Claims {
    /// The jobs, in the order of the queue.
    pub jobs: Vec<Claim>,
    /// A job waits for a worker that does nothing else.
    pub exclusive_pending: bool,
}

/// The right to write to a running job. It is lost for good when another worker takes the job up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Lease {
    /// The job.
    pub job: JobId,
    /// Whose it is.
    pub owner: WorkerId,
    /// Which attempt, counted from 1.
    pub attempt: u32,
}

/// A job handed out.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// The right to it.
    pub lease: Lease,
    /// It must run by itself.
    pub exclusive: bool,
    /// Memory \[bytes\] it is estimated to need.
    pub memory: u64,
    /// The job as it was submitted (JSON).
    pub request: Bytes,
    /// The trace that its submission belongs to.
    pub trace: Option<TraceParent>,
}

/// What a heartbeat learns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeaseStatus {
    /// Extended.
    Held {
        /// Somebody asked the job to stop.
        cancel_requested: bool,
    },
    /// The job is another's, or gone.
    Lost,
}

/// Which jobs to list.
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
    /// Only jobs handed in under this key.
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
    /// In the order that was asked for.
    pub jobs: Vec<JobRecord>,
    /// Where the next page starts; `None` on the last.
    pub next: Option<JobId>,
}

/// Why a store did not do as it was asked.
#[derive(Debug, Error)]
pub enum StoreError {
    /// No job of that name, or it has been removed since.
    #[error("there is no such job")]
    NotFound,
    /// As many jobs wait as may wait.
    #[error("the queue is full ({queued} jobs waiting)")]
    QueueFull {
        /// Jobs waiting.
        queued: usize,
    },
    /// The API key has as much as it may.
    #[error("{quota}")]
    QuotaExceeded {
        /// Of what.
        quota: Quota,
    },
    /// The idempotency key came with another body before.
    #[error("the idempotency key was used with another body before")]
    KeyReused,
    /// The API key was revoked, or has expired, since the request began.
    #[error("the API key is no longer good")]
    KeyEnded,
    /// Another worker owns the job, or nobody does any more.
    #[error("the job's lease is lost")]
    LeaseLost,
    /// The job is still queued or running.
    #[error("the job is {0}")]
    Unfinished(JobState),
    /// The disk is full, or has less room left than is reserved for jobs that are accepted
    /// already.
    #[error("the disk is full")]
    DiskFull,
    /// What is stored cannot be read, now or later.
    #[error("what is stored is damaged")]
    Damaged(#[source] Box<dyn std::error::Error + Send + Sync>),
    /// The storage does not answer.
    #[error("storage is unavailable")]
    Unavailable(#[source] Box<dyn std::error::Error + Send + Sync>),
}

/// What an API key has as much of as it may.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Quota {
    /// Jobs waiting.
    #[error("this API key may have {limit} jobs waiting, and has them")]
    Queued {
        /// How many it may have.
        limit: u32,
    },
    /// Results.
    #[error(
        "the results of this API key may take {limit} bytes; they take {used}, and that of this \
         job may take {needed} more"
    )]
    Stored {
        /// How many bytes they may take.
        limit: u64,
        /// Bytes they take, those that unfinished jobs are estimated to take included.
        used: u64,
        /// Bytes that the result of the job is estimated to take.
        needed: u64,
    },
    /// Priority.
    #[error("jobs of this API key may have priority {limit} at most")]
    Priority {
        /// The highest it may ask for.
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
    /// Whether the storage is at fault, and not the request.
    pub const fn is_of_storage(&self) -> bool {
        matches!(self, Self::DiskFull | Self::Damaged(_) | Self::Unavailable(_))
    }

    /// Wraps whatever made the storage fail.
    pub fn unavailable(source: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self::Unavailable(source.into())
    }

    /// Wraps whatever is wrong with what is stored.
    pub fn damaged(source: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Self {
        Self::Damaged(source.into())
    }
}
