//! The async side of one running job.

use std::sync::Arc;
use std::time::Duration;

use tokio::sync::OwnedSemaphorePermit;
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};
use tokio::time::sleep;

use super::Crew;
use super::attempt::attempt;
use super::observer::{JobObserver, StopFlag};
use crate::jobs::{Claim, IterationRecord, JobFailure, Lease, Outcome, StoreError};

/// Most messages taken at once: a fast solve's iterations are written in bunches.
const BUNCH: usize = 64;

/// Waits between tries to write an outcome to a store that does not answer. After the last, the lease runs out
/// and the job is taken up again.
const RETRIES: [Duration; 4] =
    [Duration::from_millis(100), Duration::from_millis(500), Duration::from_secs(2), Duration::from_secs(5)];

/// What a solver thread tells its supervisor; `Done` is the last word. Iterations are bounded by the job's own
/// limit, so the channel need not be.
pub(super) enum Message {
    /// An iteration was made.
    Iteration(IterationRecord),
    /// The solve has ended.
    Done(Outcome),
}

impl Crew {
    /// Sees one job through. `permit` is its solver.
    pub(super) async fn supervise(self: Arc<Self>, claim: Claim, permit: OwnedSemaphorePermit) {
        let lease = claim.lease;
        tracing::info!(job = %lease.job, attempt = lease.attempt, "started");
        let stop = StopFlag::default();
        self.running.add(lease, stop.clone());
        let messages = self.start_solve(claim, stop.clone());
        let outcome = self.follow(&lease, messages, &stop).await;
        self.running.remove(&lease);
        drop(permit);
        let state = outcome.state();
        match self.write_outcome(&lease, outcome).await {
            Ok(()) => tracing::info!(job = %lease.job, %state, "finished"),
            Err(error) => {
                let error = &error as &dyn std::error::Error;
                tracing::error!(job = %lease.job, %state, error, "outcome lost");
            }
        }
    }

    fn start_solve(&self, claim: Claim, stop: StopFlag) -> UnboundedReceiver<Message> {
        let (sender, messages) = unbounded_channel();
        let solver = Arc::clone(&self.solver);
        let timeout = self.settings.job_timeout;
        self.pool.run(move || {
            let mut observer = JobObserver::start(timeout, stop, sender.clone());
            let outcome = attempt(claim.lease.job, solver.as_ref(), &claim.request, &mut observer);
            let _ = sender.send(Message::Done(outcome));
        });
        messages
    }

    /// Forwards progress to the store and the wish to stop to the solver, until the solve ends.
    async fn follow(
        &self,
        lease: &Lease,
        mut messages: UnboundedReceiver<Message>,
        stop: &StopFlag,
    ) -> Outcome {
        let mut watch = self.hub.watch(lease.job);
        // Whoever asked between the claim and the watch was not heard.
        if self.store.get(lease.job).await.is_ok_and(|record| record.cancel_requested) {
            stop.raise();
        }
        let mut bunch = Vec::with_capacity(BUNCH);
        loop {
            tokio::select! {
                count = messages.recv_many(&mut bunch, BUNCH) => {
                    if count == 0 {
                        return Outcome::Failed(JobFailure::internal("the solver thread is gone"));
                    }
                    if let Some(outcome) = self.take_messages(lease, &mut bunch, stop).await {
                        return outcome;
                    }
                }
                signal = watch.changed() => if signal.cancel_requested { stop.raise() },
            }
        }
    }

    async fn take_messages(
        &self,
        lease: &Lease,
        bunch: &mut Vec<Message>,
        stop: &StopFlag,
    ) -> Option<Outcome> {
        let (mut records, mut outcome) = (Vec::with_capacity(bunch.len()), None);
        for message in bunch.drain(..) {
            match message {
                Message::Iteration(record) => records.push(record),
                Message::Done(done) => outcome = Some(done),
            }
        }
        if !records.is_empty() {
            match self.store.record_progress(lease, &records).await {
                Ok(()) => {}
                Err(StoreError::LeaseLost | StoreError::NotFound) => stop.raise(),
                Err(error) => {
                    let error = &error as &dyn std::error::Error;
                    tracing::warn!(job = %lease.job, error, "progress lost");
                }
            }
        }
        outcome
    }

    async fn write_outcome(&self, lease: &Lease, outcome: Outcome) -> Result<(), StoreError> {
        for wait in RETRIES {
            match self.store.finish(lease, outcome.clone()).await {
                Err(StoreError::Unavailable(error)) => {
                    tracing::warn!(job = %lease.job, error = error.as_ref() as &dyn std::error::Error, "retrying");
                    sleep(wait).await;
                }
                answer => return answer,
            }
        }
        self.store.finish(lease, outcome).await
    }
}
