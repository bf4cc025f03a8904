//! The running jobs of a worker, and the heartbeat that extends their leases.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::time::{Instant, sleep};

use super::WorkerState;
use super::observer::StopFlag;
use crate::jobs::{Lease, LeaseStatus};

/// Pause behind a heartbeat that the store did not answer.
const RETRY: Duration = Duration::from_secs(1);

/// Leases of the running jobs, each with the flag that stops its solve. Without a flag, the solve
/// has ended and its outcome is being written.
#[derive(Debug, Default)]
pub(super) struct Running(Mutex<HashMap<Lease, Option<StopFlag>>>);

impl Running {
    pub(super) fn add(&self, lease: Lease, stop: StopFlag) {
        self.lock().insert(lease, Some(stop));
    }

    pub(super) fn remove(&self, lease: &Lease) {
        self.lock().remove(lease);
    }

    /// Marks a solve as ended; the worker keeps its lease.
    pub(super) fn settle(&self, lease: &Lease) {
        self.lock().insert(*lease, None);
    }

    /// Stops a solve; `false` if it has ended.
    pub(super) fn stop(&self, lease: &Lease) -> bool {
        let lock = self.lock();
        let Some(Some(stop)) = lock.get(lease) else { return false };
        stop.raise();
        true
    }

    pub(super) fn stop_all(&self) {
        self.lock().values().flatten().for_each(StopFlag::raise);
    }

    pub(super) fn leases(&self) -> Vec<Lease> {
        self.lock().keys().copied().collect()
    }

    fn lock(&self) -> MutexGuard<'_, HashMap<Lease, Option<StopFlag>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// When the store last failed to answer. Workers that were all cut off from it come back at
/// different moments; who is first leaves the others time to extend their leases.
#[derive(Debug, Default)]
pub(super) struct Outage(Mutex<Option<Instant>>);

impl Outage {
    /// Records that the store does not answer.
    pub(super) fn begin(&self) {
        *self.lock() = Some(Instant::now());
    }

    /// Whether the store has answered for so long.
    pub(super) fn is_over(&self, grace: Duration) -> bool {
        self.lock().is_none_or(|at| at.elapsed() >= grace)
    }

    fn lock(&self) -> MutexGuard<'_, Option<Instant>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl WorkerState {
    /// Extends all leases periodically and stops the solves that were cancelled or whose lease is
    /// lost.
    pub(super) async fn beat(self: Arc<Self>) {
        let mut pause = self.settings.lease / 3;
        loop {
            sleep(pause).await;
            pause = self.settings.lease / 3;
            let leases = self.running.leases();
            if leases.is_empty() {
                continue;
            }
            match self.store.heartbeat(&leases, self.settings.lease).await {
                Ok(statuses) => {
                    for (lease, status) in leases.iter().zip(statuses) {
                        self.apply_status(lease, status);
                    }
                }
                Err(error) => {
                    self.outage.begin();
                    pause = pause.min(RETRY);
                    tracing::error!(
                        error = &error as &dyn std::error::Error,
                        "cannot extend leases"
                    );
                }
            }
        }
    }

    fn apply_status(&self, lease: &Lease, status: LeaseStatus) {
        match status {
            LeaseStatus::Held { cancel_requested: false } => {}
            LeaseStatus::Held { cancel_requested: true } => {
                self.running.stop(lease);
            }
            LeaseStatus::Lost => {
                if self.running.stop(lease) {
                    tracing::warn!(job = %lease.job, attempt = lease.attempt, "lease lost");
                }
            }
        }
    }
}
