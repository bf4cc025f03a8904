//! The heartbeat that extends the leases of the running jobs.

use std::sync::Arc;
use std::time::Duration;

use tokio::time::sleep;

use super::state::WorkerState;
use crate::jobs::{Lease, LeaseStatus};

/// Pause behind a heartbeat or a write of results that the store did not answer, and before a long
/// job tries again to give its place back.
pub(super) const RETRY: Duration = Duration::from_secs(1);

impl WorkerState {
    /// Extends all leases periodically and stops the solves that were cancelled or whose lease is
    /// lost. An idle worker beats as well: its connection is there when a job comes.
    pub(super) async fn beat(self: Arc<Self>) {
        let mut pause = Duration::ZERO;
        loop {
            sleep(pause).await;
            pause = self.settings.lease / 3;
            let leases = self.running.leases();
            let answer = self.store.heartbeat(&leases, self.settings.lease).await;
            self.pulse.beat(answer.is_ok());
            match answer {
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
