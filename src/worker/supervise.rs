//! The supervisor of one running job: an async task.

use std::sync::Arc;
use std::time::Duration;

use tokio::sync::mpsc::{self, Receiver, UnboundedReceiver, unbounded_channel};
use tokio::time::{Instant, sleep, sleep_until};
use tracing::Instrument;
use tracing::field::Empty;

use super::attempt::attempt;
use super::heartbeat::RETRY;
use super::message::Message;
use super::observer::{JobObserver, StopFlag};
use super::slots::Slot;
use super::state::WorkerState;
use super::thread;
use crate::jobs::{
    Claim, IterationRecord, JobFailure, JobRecord, JobState, Lease, NumberedIteration, Outcome,
    StepResult, StoreError, metrics,
};
use crate::telemetry;

/// Most messages taken at once.
const BATCH: usize = 64;

/// Size \[bytes\] above which the results of steps are written at once. Smaller results wait for
/// further steps or for the end of the job, so that a job of one step is written once.
const LARGE_STEP: usize = 256 << 10;

/// Time between two writes of progress. A job that ends sooner is written once, with its result.
const PROGRESS_INTERVAL: Duration = Duration::from_millis(100);

/// First and longest pause between attempts to write an outcome to a store that does not answer.
/// The attempts go on until the job's time is over once more: while the store is away, nobody else
/// takes the job either.
const FIRST_RETRY: Duration = Duration::from_millis(100);
const LONGEST_RETRY: Duration = Duration::from_secs(5);

/// The channels of a solver thread.
struct SolveChannels {
    messages: UnboundedReceiver<Message>,
    steps: Receiver<StepResult>,
}

/// The end of a solve.
struct SolveEnd {
    /// Results of steps not written yet.
    steps: Vec<StepResult>,
    /// Iterations not written yet.
    records: Vec<NumberedIteration>,
    /// Number of all iterations.
    iterations: usize,
    /// Its outcome.
    outcome: Outcome,
}

/// Adds iterations to write, numbered from the `count` of those before.
fn keep_iterations(
    records: &mut Vec<NumberedIteration>,
    count: &mut usize,
    more: Vec<IterationRecord>,
) {
    records
        .extend((*count..).zip(more).map(|(number, record)| NumberedIteration { number, record }));
    *count = records.last().map_or(*count, |last| last.number + 1);
}

/// Adds a step to write, and drops the steps that it replaces.
fn keep_step(steps: &mut Vec<StepResult>, step: StepResult) {
    steps.retain(|kept| kept.number < step.number);
    steps.push(step);
}

/// Returns how long a job waited for its first attempt; `None` for a later attempt.
fn wait_of(record: &JobRecord) -> Option<Duration> {
    let started = record.started_at.filter(|_| record.attempts == 1)?;
    started.duration_since(record.created_at).try_into().ok()
}

impl WorkerState {
    /// Runs one job from its claim to its stored outcome.
    pub(super) async fn supervise(self: Arc<Self>, claim: Claim, slot: Slot, stop: StopFlag) {
        let span = tracing::info_span!("attempt", trace_id = Empty);
        telemetry::adopt(&span, claim.trace);
        self.see_through(claim, slot, stop).instrument(span).await;
    }

    async fn see_through(self: Arc<Self>, claim: Claim, mut slot: Slot, stop: StopFlag) {
        let lease = claim.lease;
        tracing::info!(job = %lease.job, attempt = lease.attempt, "started");
        let started = Instant::now();
        let channels = self.start_solve(claim, stop.clone());
        let SolveEnd { steps, records, iterations, outcome } =
            self.follow(&lease, channels, &stop, started, &mut slot).await;
        let time = started.elapsed();
        self.running.settle(&lease);
        let state = outcome.state();
        let stopped_by_shutdown = state == JobState::Cancelled && self.halt.is_cancelled();
        metrics::attempted((!stopped_by_shutdown).then_some(state), time, iterations);
        let written = if stopped_by_shutdown {
            self.store.release(&[lease]).await
        } else {
            self.write_outcome(&lease, &records, &steps, outcome).await
        };
        self.running.remove(&lease);
        // A claim counts the job until its end is stored.
        drop(slot);
        match written {
            Ok(()) if stopped_by_shutdown => tracing::info!(job = %lease.job, "given back"),
            Ok(()) => tracing::info!(job = %lease.job, %state, "finished"),
            Err(error) => {
                let error = &error as &dyn std::error::Error;
                tracing::error!(job = %lease.job, %state, error, "outcome lost");
            }
        }
    }

    fn start_solve(&self, claim: Claim, stop: StopFlag) -> SolveChannels {
        let (sender, messages) = unbounded_channel();
        let (step_sender, steps) = mpsc::channel(1);
        let solver = Arc::clone(&self.solver);
        let timeout = self.settings.job_timeout;
        let job = claim.lease.job;
        let memory = self.memory.of_job(claim.memory.max(self.settings.memory_of_place));
        let started = thread::start(job, move || {
            let mut observer = JobObserver::start(timeout, memory, stop, sender.clone());
            let outcome = attempt(
                claim.lease.job,
                solver.as_ref(),
                &claim.request,
                &mut observer,
                &step_sender,
            );
            let _ = sender.send(Message::Done(observer.take_pending(), outcome));
        });
        if let Err(error) = started {
            // The channels are closed: the job fails.
            tracing::error!(%job, %error, "no thread for a job");
        }
        SolveChannels { messages, steps }
    }

    /// Forwards progress to the store and requests to stop to the solver, until the solve ends.
    async fn follow(
        &self,
        lease: &Lease,
        channels: SolveChannels,
        stop: &StopFlag,
        started: Instant,
        slot: &mut Slot,
    ) -> SolveEnd {
        let SolveChannels { mut messages, steps: mut received } = channels;
        let mut subscription = self.notifier.subscribe(lease.job);
        if let Ok(record) = self.store.get(lease.job).await {
            // The subscription does not see a cancellation that came between claim and
            // subscription.
            if record.cancel_requested {
                stop.raise();
            }
            if let Some(waited) = wait_of(&record) {
                metrics::waited(waited);
            }
        }
        let mut iterations = 0;
        let mut batch = Vec::with_capacity(BATCH);
        let mut records = Vec::new();
        let mut latest = None;
        let mut steps = Vec::new();
        let mut unwritten = None;
        let mut write_at = Instant::now() + PROGRESS_INTERVAL;
        let (mut has_place, mut long_at) = (true, started + thread::LONG);
        loop {
            tokio::select! {
                count = messages.recv_many(&mut batch, BATCH) => {
                    if count == 0 {
                        let failure = JobFailure::internal("the solver thread is gone");
                        let outcome = Outcome::Failed(failure);
                        return SolveEnd { steps, records, iterations, outcome };
                    }
                    for message in batch.drain(..) {
                        match message {
                            Message::Iterations(more) => {
                                keep_iterations(&mut records, &mut iterations, more);
                                latest = records.last().map(|last| last.record.clone());
                            }
                            Message::Preliminary(record) => latest = Some(record),
                            Message::Done(last, outcome) => {
                                keep_iterations(&mut records, &mut iterations, last);
                                // The solver sent these steps before its last message.
                                while let Ok(step) = received.try_recv() {
                                    keep_step(&mut steps, step);
                                }
                                let outcome = unwritten.map_or(outcome, Outcome::Failed);
                                return SolveEnd { steps, records, iterations, outcome };
                            }
                        }
                    }
                }
                Some(step) = received.recv() => {
                    keep_step(&mut steps, step);
                    if steps.len() > 1 || steps.iter().any(|step| step.bytes() >= LARGE_STEP) {
                        let written = self.write_steps(lease, &mut steps, stop, started).await;
                        unwritten = unwritten.or(written.err());
                    }
                }
                () = sleep_until(write_at), if latest.is_some() => {
                    self.write_progress(lease, &mut records, &mut latest, stop).await;
                    write_at = Instant::now() + PROGRESS_INTERVAL;
                }
                () = sleep_until(long_at), if has_place => {
                    has_place = slot.give_place_back();
                    long_at = Instant::now() + RETRY;
                }
                signal = subscription.changed() => if signal.cancel_requested { stop.raise() },
            }
        }
    }

    /// Writes iterations; keeps them for the next write if the store fails.
    async fn write_progress(
        &self,
        lease: &Lease,
        records: &mut Vec<NumberedIteration>,
        latest: &mut Option<IterationRecord>,
        stop: &StopFlag,
    ) {
        let Some(last) = latest else { return };
        match self.store.record_progress(lease, records, last).await {
            Ok(()) => {
                records.clear();
                *latest = None;
            }
            Err(StoreError::LeaseLost | StoreError::NotFound) => stop.raise(),
            Err(error) => {
                let error = &error as &dyn std::error::Error;
                tracing::warn!(job = %lease.job, error, "progress not written yet");
            }
        }
    }

    /// Writes the results of steps while the solve waits. If the solve must stop first, the steps
    /// are written with the outcome.
    ///
    /// # Errors
    /// The error of the store if it fails until the job's deadline; the solve must stop then.
    async fn write_steps(
        &self,
        lease: &Lease,
        steps: &mut Vec<StepResult>,
        stop: &StopFlag,
        started: Instant,
    ) -> Result<(), JobFailure> {
        while !stop.is_raised() {
            let Err(error) = self.store.record_steps(lease, steps).await else {
                steps.clear();
                break;
            };
            let is_late = started.elapsed() >= self.settings.job_timeout;
            if is_late || matches!(error, StoreError::LeaseLost | StoreError::NotFound) {
                steps.clear();
                stop.raise();
                return Err(JobFailure::internal(format!(
                    "results of steps could not be stored: {error}"
                )));
            }
            tracing::warn!(
                job = %lease.job,
                error = &error as &dyn std::error::Error,
                "steps not written yet"
            );
            sleep(RETRY).await;
        }
        Ok(())
    }

    /// Returns whether the store holds the outcome of this attempt.
    async fn is_written(&self, lease: &Lease, outcome: &Outcome) -> bool {
        let record = self.store.get(lease.job).await;
        record.is_ok_and(|record| {
            record.attempts == lease.attempt && record.state == outcome.state()
        })
    }

    async fn write_outcome(
        &self,
        lease: &Lease,
        records: &[NumberedIteration],
        steps: &[StepResult],
        outcome: Outcome,
    ) -> Result<(), StoreError> {
        let (begin, mut pause) = (Instant::now(), FIRST_RETRY);
        loop {
            match self.store.finish(lease, records, steps, outcome.clone()).await {
                // The connection may have broken after the commit and before the acknowledgement.
                Err(StoreError::LeaseLost)
                    if pause > FIRST_RETRY && self.is_written(lease, &outcome).await =>
                {
                    return Ok(());
                }
                Err(error @ (StoreError::Unavailable(_) | StoreError::DiskFull))
                    if begin.elapsed() < self.settings.job_timeout =>
                {
                    let error = &error as &dyn std::error::Error;
                    tracing::warn!(job = %lease.job, error, "retrying");
                }
                answer => return answer,
            }
            sleep(pause).await;
            pause = (2 * pause).min(LONGEST_RETRY);
        }
    }
}
