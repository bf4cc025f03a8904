//! Operations on jobs for the layers above: submit, query, wait, cancel, remove.

use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex as StdMutex, MutexGuard, PoisonError};
use std::thread::available_parallelism;
use std::time::Duration;

use bytes::Bytes;
use thiserror::Error;
use tokio::sync::Mutex;
use tokio::time::{Instant, sleep, timeout_at};

use sha2::{Digest, Sha256};
use tokio_util::sync::CancellationToken;
use tracing::Instrument;
use uuid::Uuid;

use super::words::{words, words_of};
use super::{
    About, ApiKey, Callback, Clock as _, ClosedForm, DeliveryStore, Enqueued, FieldsReader,
    Idempotency, JobId, JobNotifier, JobRecord, JobSolver, JobStore, KeyId, KeyStore, NewJob,
    ResultHead, StoreError, Subscription, SystemClock, Threads, TraceParent, Turns, read_token,
};
use crate::telemetry::AUDIT;
use brinell_solver::job::tensile::{TensileTest, TestedCurve};
use brinell_solver::job::{Job, JobError};
use brinell_solver::report::JobEstimate;

/// Longest time between two queries of a request that waits, or of a stream of events. Changes are
/// announced, so the time matters only when an announcement of another process is lost.
pub const POLL_INTERVAL: Duration = Duration::from_secs(1);

/// Time between two checks of the API key of a long request.
const KEY_INTERVAL: Duration = Duration::from_secs(5);

/// Jobs that are checked at the same time for each core, each on a thread of its own. Every check
/// takes memory: 32 of them ended a service with 512 MiB.
const CHECKS_OF_CORE: usize = 2;

/// Time between two signs of life that the store is asked for, and time without one after which
/// the process had better be started anew.
const WATCH_INTERVAL: Duration = Duration::from_secs(10);
const SILENCE: Duration = Duration::from_mins(1);

/// Digits at the end of an id by which people know a job.
const SHORT: usize = 8;

/// Pieces of results that are decoded at the same time.
const DECODERS: usize = 4;

/// Shortest time between two writes of the readiness check.
const PING_INTERVAL: Duration = Duration::from_secs(1);

/// Bounds on what is taken in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubmissionLimits {
    /// Largest allowed estimate of a job's memory \[bytes\].
    pub job_bytes: u64,
    /// Largest allowed estimate of a job's result \[bytes\].
    pub result_bytes: u64,
}

/// A submission.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Submission {
    /// Its text.
    pub request: Bytes,
    /// Larger goes first.
    pub priority: i16,
    /// The API key it comes under.
    pub submitter: Option<KeyId>,
    /// The idempotency key, if the client may repeat the submission.
    pub idempotency_key: Option<String>,
    /// The client waits for the answer.
    pub interactive: bool,
    /// Where its end is to be announced.
    pub callback_url: Option<String>,
    /// Its trace.
    pub trace: Option<TraceParent>,
}

/// An error that keeps a job from being accepted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Rejection {
    /// Its text is not a job.
    #[error(transparent)]
    Invalid(#[from] JobError),
    /// The job would need more memory than allowed.
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
    /// The result would be larger than allowed.
    #[error(
        "the result of the job would take about {} MiB; a result may take {} MiB at most",
        .estimate.result_bytes >> 20, .limit >> 20
    )]
    ResultTooLarge {
        /// What it would need.
        estimate: JobEstimate,
        /// What it may \[bytes\].
        limit: u64,
    },
}

/// An error of a submission.
#[derive(Debug, Error)]
pub enum SubmitError {
    /// The job itself is at fault.
    #[error(transparent)]
    Rejected(#[from] Rejection),
    /// The service is shutting down.
    #[error("the service is shutting down")]
    Closed,
    /// The store is full or does not answer.
    #[error(transparent)]
    Store(#[from] StoreError),
}

/// Submits, queries and cancels jobs.
pub struct JobService {
    pub(super) store: Arc<dyn JobStore>,
    notifier: Arc<JobNotifier>,
    solver: Arc<dyn JobSolver>,
    keys: Arc<dyn KeyStore>,
    deliveries: Arc<dyn DeliveryStore>,
    limits: SubmissionLimits,
    closed: CancellationToken,
    waits_end: CancellationToken,
    /// Threads that decode and write large pieces of results; a key may hold half of them.
    pub decoders: Threads,
    /// Threads that check and estimate jobs, one job of a key at a time.
    checks: Threads,
    /// Turns of submissions, cancels and removals: each takes a connection to the store and locks
    /// the row of its key.
    submissions: Turns,
    /// Whether the file of the store is damaged.
    damaged: AtomicBool,
    /// When the store last gave a sign of life.
    answered_at: StdMutex<Instant>,
    /// Time until which the last readiness check holds.
    healthy_until: Mutex<Option<Instant>>,
}

/// Logs a submission.
fn log_queued(enqueued: &Enqueued, key: Option<KeyId>) {
    let Enqueued { job, replayed } = enqueued;
    tracing::info!(target: AUDIT, job = %job.id, key = key.map(display), replayed, "queued");
}

/// Runs a change of the store to its end, even if the client hangs up meanwhile: every commit is
/// announced.
async fn to_its_end<T: Send + 'static>(
    change: impl Future<Output = Result<T, StoreError>> + Send + 'static,
) -> Result<T, StoreError> {
    match tokio::spawn(change.in_current_span()).await {
        Ok(ended) => ended,
        Err(error) => match error.try_into_panic() {
            Ok(panic) => resume_unwind(panic),
            Err(error) => Err(StoreError::unavailable(error)),
        },
    }
}

/// Checks a job and estimates its cost.
fn check(
    solver: &dyn JobSolver,
    limits: SubmissionLimits,
    request: &[u8],
) -> Result<(Job, JobEstimate), Rejection> {
    let job = Job::from_json(request)?;
    let estimate = solver.estimate(&job).map_err(JobError::Fields)?;
    if estimate.bytes > limits.job_bytes {
        return Err(Rejection::TooLarge { estimate, limit: limits.job_bytes });
    }
    if estimate.result_bytes > limits.result_bytes {
        return Err(Rejection::ResultTooLarge { estimate, limit: limits.result_bytes });
    }
    Ok((job, estimate))
}

/// Makes the record of an accepted job for the store.
fn new_job(
    solver: &dyn JobSolver,
    limits: SubmissionLimits,
    submission: Submission,
) -> Result<NewJob, Rejection> {
    let (job, estimate) = check(solver, limits, &submission.request)?;
    let digest = Sha256::digest(&submission.request).into();
    let id = JobId::generate();
    let about = About::of(&job);
    let mut all = words_of(&submission.request);
    all.extend(words(&about.description));
    // People know a job by the last group of its id.
    all.extend(
        id.to_string().rsplit('-').next().map(|last| last[last.len() - SHORT..].to_owned()),
    );
    Ok(NewJob {
        id,
        words: all,
        request: submission.request,
        about: Some(about),
        tags: job.tags,
        priority: submission.priority,
        memory: estimate.bytes,
        result_bytes: estimate.result_bytes,
        submitter: submission.submitter,
        idempotency: submission.idempotency_key.map(|key| Idempotency { key, digest }),
        interactive: submission.interactive,
        callback_url: submission.callback_url,
        trace: submission.trace,
    })
}

#[expect(clippy::missing_errors_doc, reason = "a `StoreError` is that of the store")]
impl JobService {
    /// Makes a service on `store`, whose changes `notifier` announces.
    pub fn new(
        store: Arc<dyn JobStore>,
        notifier: Arc<JobNotifier>,
        solver: Arc<dyn JobSolver>,
        keys: Arc<dyn KeyStore>,
        deliveries: Arc<dyn DeliveryStore>,
        limits: SubmissionLimits,
    ) -> Self {
        let cores = available_parallelism().map_or(1, NonZeroUsize::get);
        Self {
            answered_at: StdMutex::new(Instant::now()),
            store,
            notifier,
            solver,
            keys,
            deliveries,
            limits,
            closed: CancellationToken::new(),
            waits_end: CancellationToken::new(),
            decoders: Threads::new(DECODERS, DECODERS / 2),
            checks: Threads::new(CHECKS_OF_CORE * cores, 1),
            submissions: Turns::new(1),
            damaged: AtomicBool::new(false),
            healthy_until: Mutex::new(None),
        }
    }

    /// Checks a job without queueing it, and estimates its cost.
    ///
    /// # Errors
    /// [`Rejection`] with every fault.
    pub async fn validate(
        &self,
        request: Bytes,
        key: Option<KeyId>,
    ) -> Result<JobEstimate, Rejection> {
        let (solver, limits) = (Arc::clone(&self.solver), self.limits);
        Ok(self.checks.run(key, move || check(solver.as_ref(), limits, &request)).await?.1)
    }

    /// Waits for a turn of the key while the service accepts jobs.
    async fn unless_closed<T>(&self, turn: impl Future<Output = T>) -> Result<T, SubmitError> {
        tokio::select! {
            biased;
            () = self.closed.cancelled() => Err(SubmitError::Closed),
            turn = turn => Ok(turn),
        }
    }

    /// Returns the API key of a token, if the key is valid.
    pub async fn authenticate(&self, token: &str) -> Result<Option<ApiKey>, StoreError> {
        let Some((id, secret)) = read_token(token) else { return Ok(None) };
        let keys = self.keys.keys(Some(id)).await?;
        Ok(keys.into_iter().find(|key| key.accepts(secret, SystemClock.now())))
    }

    /// Returns once an API key is no longer valid.
    pub async fn key_ends(&self, key: KeyId) {
        loop {
            sleep(KEY_INTERVAL).await;
            // A store that fails to answer for a moment invalidates no key.
            if let Ok(keys) = self.keys.keys(Some(key)).await
                && !keys.iter().any(|key| key.is_good(SystemClock.now()))
            {
                return;
            }
        }
    }

    /// Evaluates the closed form for a job.
    ///
    /// # Errors
    /// [`Rejection`] with every fault, also where the theory does not apply.
    pub async fn closed_form(
        &self,
        request: Bytes,
        key: Option<KeyId>,
    ) -> Result<ClosedForm, Rejection> {
        let closed_form = move || {
            let job = Job::from_json(&request)?;
            Ok(ClosedForm::of(&job).map_err(JobError::Fields)?)
        };
        self.checks.run(key, closed_form).await
    }

    /// Computes the hardening curve of a tensile test.
    ///
    /// # Errors
    /// [`Rejection`] with every fault, also where the record gives no curve.
    pub async fn hardening_curve(
        &self,
        request: Bytes,
        key: Option<KeyId>,
    ) -> Result<TestedCurve, Rejection> {
        self.checks.run(key, move || Ok(TensileTest::solve(&request)?)).await
    }

    /// Checks a job and queues it.
    ///
    /// # Errors
    /// [`SubmitError`]; nothing is queued then.
    pub async fn submit(&self, submission: Submission) -> Result<Enqueued, SubmitError> {
        Ok(self.submit_with(submission, |_| ()).await?.0)
    }

    /// Submits a job as [`Self::submit`] does. The value that `attend` makes of the queued job is
    /// dropped if the caller's future was dropped.
    pub(super) async fn submit_with<T: Send + 'static>(
        &self,
        submission: Submission,
        attend: impl FnOnce(&Enqueued) -> T + Send + 'static,
    ) -> Result<(Enqueued, T), SubmitError> {
        let key = submission.submitter;
        let (solver, limits) = (Arc::clone(&self.solver), self.limits);
        let checked = self.checks.run(key, move || new_job(solver.as_ref(), limits, submission));
        let job = self.unless_closed(checked).await??;
        let turn = self.unless_closed(self.submissions.take(key)).await?;
        let store = Arc::clone(&self.store);
        let enqueue = async move {
            let enqueued = store.enqueue(job, turn).await?;
            log_queued(&enqueued, key);
            let attended = attend(&enqueued);
            Ok((enqueued, attended))
        };
        Ok(to_its_end(enqueue).await?)
    }

    /// Checks several jobs and queues the valid ones in one transaction; returns one outcome for
    /// each job, in order.
    ///
    /// # Errors
    /// [`SubmitError::Closed`] and errors of the store; nothing is queued then.
    pub async fn submit_all(
        &self,
        submissions: Vec<Submission>,
    ) -> Result<Vec<Result<Enqueued, SubmitError>>, SubmitError> {
        let first = submissions.first().and_then(|submission| submission.submitter);
        let (solver, limits) = (Arc::clone(&self.solver), self.limits);
        let check = move || {
            let new_job = |submission| new_job(solver.as_ref(), limits, submission);
            submissions.into_iter().map(new_job).collect::<Vec<_>>()
        };
        let checked = self.unless_closed(self.checks.run(first, check)).await?;
        let jobs: Vec<NewJob> = checked.iter().flatten().cloned().collect();
        let submitters: Vec<Option<KeyId>> = jobs.iter().map(|job| job.submitter).collect();
        let turn = self.unless_closed(self.submissions.take(first)).await?;
        let store = Arc::clone(&self.store);
        let enqueue = async move {
            let taken = store.enqueue_all(jobs, turn).await?;
            for (taken, key) in taken.iter().zip(submitters) {
                if let Ok(enqueued) = taken {
                    log_queued(enqueued, key);
                }
            }
            Ok(taken)
        };
        let mut taken = to_its_end(enqueue).await?.into_iter();
        let of = |job: Result<NewJob, Rejection>| -> Result<Enqueued, SubmitError> {
            job?;
            let missing =
                || StoreError::unavailable("the store told of fewer jobs than it was given");
            Ok(taken.next().unwrap_or_else(|| Err(missing()))?)
        };
        Ok(checked.into_iter().map(of).collect())
    }

    /// Returns the store, for plain queries.
    pub fn store(&self) -> &dyn JobStore {
        self.store.as_ref()
    }

    /// What is known about a job.
    pub async fn get(&self, id: JobId) -> Result<JobRecord, StoreError> {
        self.store.get(id).await
    }

    /// Returns the record of a job once it has finished, `timeout` has elapsed or
    /// [`JobService::end_waits`] was called.
    pub async fn wait(&self, id: JobId, timeout: Duration) -> Result<JobRecord, StoreError> {
        let mut subscription = self.subscribe(id);
        let deadline = Instant::now() + timeout;
        loop {
            let record = self.store.get(id).await?;
            if record.state.is_finished()
                || Instant::now() >= deadline
                || self.waits_end.is_cancelled()
            {
                return Ok(record);
            }
            let poll = deadline.min(Instant::now() + POLL_INTERVAL);
            tokio::select! {
                _ = timeout_at(poll, subscription.finished()) => {}
                () = self.waits_end.cancelled() => {}
            }
        }
    }

    /// Subscribes to a job.
    pub fn subscribe(&self, id: JobId) -> Subscription {
        self.notifier.subscribe(id)
    }

    /// The result without its steps, if there is one. Results of older programs have another form
    /// and count as none: their jobs are solved again.
    pub async fn result(&self, id: JobId) -> Result<Option<ResultHead>, StoreError> {
        Ok(self.store.result(id).await?.filter(ResultHead::has_rows))
    }

    /// Opens the fields of a step (counted from 0) in double precision; `None` if the job did not
    /// ask for fields.
    pub async fn fields(
        &self,
        id: JobId,
        step: usize,
    ) -> Result<Option<FieldsReader<Arc<dyn JobStore>>>, StoreError> {
        FieldsReader::open(Arc::clone(&self.store), id, step).await
    }

    /// The announcement of a job's end, if it has one.
    pub async fn callback(&self, id: JobId) -> Result<Option<Callback>, StoreError> {
        self.deliveries.callback(id).await
    }

    /// Asks a job to stop, in the name of a key.
    pub async fn cancel(&self, id: JobId, key: Option<KeyId>) -> Result<JobRecord, StoreError> {
        let (store, turn) = (Arc::clone(&self.store), self.submissions.take(key).await);
        to_its_end(async move {
            let _turn = turn;
            let record = store.cancel(id).await?;
            let state = record.state;
            tracing::info!(
                target: AUDIT, job = %id, key = key.map(display), %state, "asked to stop"
            );
            Ok(record)
        })
        .await
    }

    /// Removes a finished job, in the name of a key.
    pub async fn delete(&self, id: JobId, key: Option<KeyId>) -> Result<(), StoreError> {
        let (store, turn) = (Arc::clone(&self.store), self.submissions.take(key).await);
        to_its_end(async move {
            let _turn = turn;
            store.delete(id).await?;
            tracing::info!(target: AUDIT, job = %id, key = key.map(display), "removed");
            Ok(())
        })
        .await
    }

    /// Checks that the store accepts writes. Clients without a key may call this, so it writes at
    /// most once a second.
    pub async fn ping(&self) -> Result<(), StoreError> {
        if self.damaged.load(Ordering::Relaxed) {
            return Err(StoreError::damaged("the check at the start found damage"));
        }
        let mut healthy_until = self.healthy_until.lock().await;
        if healthy_until.is_none_or(|until| until <= Instant::now()) {
            *healthy_until = None;
            self.store.ping().await?;
            *healthy_until = Some(Instant::now() + PING_INTERVAL);
        }
        Ok(())
    }

    /// Asks the store for signs of life, for ever.
    pub async fn watch_store(&self) {
        loop {
            if !matches!(
                self.store.get(JobId::from(Uuid::nil())).await,
                Err(StoreError::Unavailable(_))
            ) {
                *self.answered_at() = Instant::now();
            }
            sleep(WATCH_INTERVAL).await;
        }
    }

    /// Whether the store has given a sign of life within the last minute, as far as it is
    /// watched.
    pub fn is_store_alive(&self) -> bool {
        self.answered_at().elapsed() < SILENCE
    }

    fn answered_at(&self) -> MutexGuard<'_, Instant> {
        self.answered_at.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Checks the file of the store for damage. With damage, the service is not ready from then
    /// on.
    pub async fn check_store(&self) {
        match self.store.check(false).await {
            Ok(found) if found.is_empty() => tracing::info!("the store is sound"),
            Ok(found) => {
                self.damaged.store(true, Ordering::Relaxed);
                tracing::error!(?found, "the store is damaged");
            }
            Err(error) => {
                tracing::error!(
                    error = &error as &dyn std::error::Error,
                    "the store cannot be checked"
                );
            }
        }
    }

    /// Bounds on what is taken in.
    pub const fn limits(&self) -> SubmissionLimits {
        self.limits
    }

    /// Rejects further submissions; queries are still answered.
    pub fn close(&self) {
        self.closed.cancel();
    }

    /// Closes the store, after which every call fails.
    pub async fn close_store(&self) {
        self.store.close().await;
    }

    /// Ends all waits; each returns the present state of its job.
    pub fn end_waits(&self) {
        self.waits_end.cancel();
    }

    /// Whether the service has been closed.
    pub fn is_closed(&self) -> bool {
        self.closed.is_cancelled()
    }
}
