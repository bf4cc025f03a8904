//! The front desk: what may be asked of the job queue from outside.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use bytes::Bytes;
use thiserror::Error;
use tokio::time::{Instant, timeout_at};

use super::{Counts, Hub, IterationRecord, JobId, JobRecord, JobSolver, JobStore, NewJob, StoreError, Watch};
use crate::model::{Job, JobError};
use crate::results::JobEstimate;

/// Longest time between two looks at the store while waiting. Changes are announced, so this only matters when
/// an announcement from another process is lost.
const LOOK_AGAIN: Duration = Duration::from_secs(1);

/// Bounds on what is taken in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DeskLimits {
    /// Largest memory \[bytes\] a job may be estimated to need.
    pub job_bytes: u64,
}

/// Why a job is not taken in.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Refusal {
    /// Its text is not a job.
    #[error(transparent)]
    Invalid(#[from] JobError),
    /// It would need more memory than a job may.
    #[error(
        "the job has {} equations and needs about {} MiB; a job may need {} MiB at most",
        .estimate.equations, .estimate.bytes >> 20, .limit >> 20
    )]
    TooLarge {
        /// What it would need.
        estimate: JobEstimate,
        /// What it may \[bytes\].
        limit: u64,
    },
}

/// Why a job was not queued.
#[derive(Debug, Error)]
pub enum SubmitError {
    /// The job itself is at fault.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// The service is shutting down.
    #[error("the service is shutting down")]
    Closed,
    /// The store is full or does not answer.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// Takes jobs in, answers questions about them, and stops them.
pub struct Desk {
    store: Arc<dyn JobStore>,
    hub: Arc<Hub>,
    solver: Arc<dyn JobSolver>,
    limits: DeskLimits,
    closed: AtomicBool,
}

impl Desk {
    /// A desk in front of `store`, which announces on `hub`.
    pub fn new(
        store: Arc<dyn JobStore>,
        hub: Arc<Hub>,
        solver: Arc<dyn JobSolver>,
        limits: DeskLimits,
    ) -> Self {
        Self { store, hub, solver, limits, closed: AtomicBool::new(false) }
    }

    /// Checks a job without queueing it, and estimates its cost.
    ///
    /// # Errors
    /// [`Refusal`] with every fault.
    pub fn check(&self, request: &[u8]) -> Result<(Job, JobEstimate), Refusal> {
        let job = Job::from_json(request)?;
        let estimate = self.solver.estimate(&job).map_err(JobError::Fields)?;
        if estimate.bytes > self.limits.job_bytes {
            return Err(Refusal::TooLarge { estimate, limit: self.limits.job_bytes });
        }
        Ok((job, estimate))
    }

    /// Checks a job and queues it.
    ///
    /// # Errors
    /// [`SubmitError`]; nothing is queued then.
    pub async fn submit(&self, request: Bytes) -> Result<JobRecord, SubmitError> {
        if self.is_closed() {
            return Err(SubmitError::Closed);
        }
        let (job, _) = self.check(&request)?;
        let id = JobId::generate();
        let record = self.store.enqueue(NewJob { id, request, tags: job.tags }).await?;
        tracing::info!(job = %id, "queued");
        Ok(record)
    }

    /// What is known about a job.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn get(&self, id: JobId) -> Result<JobRecord, StoreError> {
        self.store.get(id).await
    }

    /// Like [`Desk::get`], once the job has finished or `patience` has run out.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn wait(&self, id: JobId, patience: Duration) -> Result<JobRecord, StoreError> {
        let mut watch = self.watch(id);
        let deadline = Instant::now() + patience;
        loop {
            let record = self.store.get(id).await?;
            if record.state.is_finished() || Instant::now() >= deadline {
                return Ok(record);
            }
            let _ = timeout_at(deadline.min(Instant::now() + LOOK_AGAIN), watch.finished()).await;
        }
    }

    /// Listens to a job.
    pub fn watch(&self, id: JobId) -> Watch {
        self.hub.watch(id)
    }

    /// Iterations of the latest attempt from the `after`-th on.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn history(&self, id: JobId, after: usize) -> Result<Vec<IterationRecord>, StoreError> {
        self.store.history(id, after).await
    }

    /// The report (JSON), if there is one.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn report(&self, id: JobId) -> Result<Option<Bytes>, StoreError> {
        self.store.report(id).await
    }

    /// Asks a job to stop.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let record = self.store.cancel(id).await?;
        tracing::info!(job = %id, state = %record.state, "asked to stop");
        Ok(record)
    }

    /// How many jobs are in each state; an answer shows that the store is there.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn counts(&self) -> Result<Counts, StoreError> {
        self.store.counts().await
    }

    /// Takes no more jobs in. Questions are still answered.
    pub fn close(&self) {
        self.closed.store(true, Ordering::Relaxed);
    }

    /// Whether the desk has been closed.
    pub fn is_closed(&self) -> bool {
        self.closed.load(Ordering::Relaxed)
    }
}
