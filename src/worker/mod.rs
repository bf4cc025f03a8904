//! Solves queued jobs on threads of their own, never on the async runtime's.
//!
//! [`Worker`] claims as many jobs as it has free places. Each job has a supervisor, an async task
//! that forwards progress to the store and requests to stop to the solver. The solver thread calls
//! only its observer, which measures the job's time. A panic ends one job. One task sends the
//! heartbeats of all leases.

mod attempt;
mod heartbeat;
mod memory;
mod message;
mod observer;
mod running;
mod slots;
mod state;
mod supervise;
mod thread;

use std::sync::Arc;
use std::time::Duration;

use tokio::time::{Instant, sleep, timeout};
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use crate::jobs::{
    Claim, ClaimRequest, Claims, JobNotifier, JobSolver, JobStore, StoreError, WorkerId,
};
use memory::WorkerMemory;
pub use running::Pulse;
use running::{Outage, Running};
use slots::{Memory, Reservation, Slots};
pub use state::WorkerSettings;
use state::WorkerState;

/// Time that solves have to stop once the grace time is over.
pub const STOP_TIMEOUT: Duration = Duration::from_secs(2);

/// A running pool of solvers.
pub struct Worker {
    state: Arc<WorkerState>,
    heartbeat: tokio::task::JoinHandle<()>,
}

impl Worker {
    /// Starts claiming jobs. Needs a Tokio runtime.
    pub fn start(
        store: Arc<dyn JobStore>,
        notifier: Arc<JobNotifier>,
        solver: Arc<dyn JobSolver>,
        settings: WorkerSettings,
    ) -> Self {
        let memory = Memory { shared: settings.memory, of_place: settings.memory_of_place };
        let state = Arc::new(WorkerState {
            id: WorkerId::generate(),
            settings,
            store,
            notifier,
            solver,
            slots: Arc::new(Slots::new(settings.slots, memory)),
            running: Running::default(),
            outage: Outage::default(),
            pulse: Pulse::new(),
            memory: WorkerMemory::new(
                settings.memory + settings.memory_of_place * (settings.slots as u64 + 1),
            ),
            tasks: TaskTracker::new(),
            drain: CancellationToken::new(),
            halt: CancellationToken::new(),
        });
        state.tasks.spawn(Arc::clone(&state).claim_jobs());
        let heartbeat = tokio::spawn(Arc::clone(&state).beat());
        Self { state, heartbeat }
    }

    /// Returns the worker's signs of life.
    pub fn pulse(&self) -> Pulse {
        self.state.pulse.clone()
    }

    /// Finishes the running jobs, and the queued ones if the settings say so, then stops. Jobs
    /// still running after `grace` are stopped and return to the queue. Returns whether all jobs
    /// were finished.
    pub async fn drain(self, grace: Duration) -> bool {
        self.state.drain.cancel();
        self.state.tasks.close();
        let finished = timeout(grace, self.state.tasks.wait()).await.is_ok();
        if !finished {
            self.state.halt.cancel();
            self.state.running.stop_all();
            if timeout(STOP_TIMEOUT, self.state.tasks.wait()).await.is_err() {
                self.state.release_all().await;
            }
        }
        self.heartbeat.abort();
        finished
    }
}

impl WorkerState {
    async fn claim_jobs(self: Arc<Self>) {
        let mut has_failed = false;
        let mut look_at = Instant::now();
        loop {
            let reservation = tokio::select! {
                reservation = self.slots.take() => reservation,
                () = self.halt.cancelled() => return,
            };
            if self.drain.is_cancelled() && !self.settings.empties_queue {
                return;
            }
            let now = Instant::now();
            let expires = now >= look_at && self.outage.is_over(self.settings.lease / 2);
            look_at = if expires { now + self.settings.poll } else { look_at };
            let request = self.request(&reservation, expires);
            let claimed = if has_failed {
                self.claim_again(&request).await
            } else {
                self.store.claim(&request).await
            };
            has_failed = claimed.is_err();
            match claimed {
                Ok(claims) => {
                    self.slots.set_large_pending(claims.large_pending);
                    if claims.jobs.is_empty() {
                        drop(reservation);
                        if self.drain.is_cancelled() {
                            return;
                        }
                        self.idle().await;
                        continue;
                    }
                    self.start(claims.jobs, reservation);
                }
                Err(error) => {
                    self.outage.begin();
                    tracing::error!(error = &error as &dyn std::error::Error, "cannot claim jobs");
                    drop(reservation);
                    tokio::select! {
                        () = sleep(self.settings.poll) => {}
                        () = self.drain.cancelled() => return,
                    }
                }
            }
        }
    }

    /// Claims after a claim that was not answered, whose jobs nobody would solve.
    async fn claim_again(&self, request: &ClaimRequest) -> Result<Claims, StoreError> {
        let known: Vec<_> = self.running.leases().iter().map(|lease| lease.job).collect();
        self.store.give_back(self.id, &known).await?;
        self.store.claim(request).await
    }

    fn request(&self, reservation: &Reservation, expires: bool) -> ClaimRequest {
        let memory = self.slots.memory();
        ClaimRequest {
            owner: self.id,
            places: reservation.len(),
            places_of_key: self.settings.slots,
            memory_of_place: memory.of_place,
            free_memory: self.slots.free_memory(),
            memory: memory.shared,
            lease: self.settings.lease,
            max_attempts: self.settings.max_attempts,
            expires,
        }
    }

    fn start(self: &Arc<Self>, claims: Vec<Claim>, mut reservation: Reservation) {
        for claim in claims {
            if let Some(slot) = reservation.assign(&self.slots, &claim) {
                let stop = self.running.add(claim.lease);
                self.tasks.spawn(Arc::clone(self).supervise(claim, slot, stop));
            }
        }
    }

    async fn idle(&self) {
        tokio::select! {
            () = self.notifier.work() => {}
            () = self.slots.freed() => {}
            () = sleep(self.settings.poll) => {}
            () = self.drain.cancelled() => {}
        }
    }

    /// Returns the jobs to the queue whose solves do not stop.
    async fn release_all(&self) {
        let leases = self.running.leases();
        tracing::warn!(jobs = leases.len(), "solves left running at the end of the grace time");
        if let Err(error) = self.store.release(&leases).await {
            tracing::error!(error = &error as &dyn std::error::Error, "cannot give jobs back");
        }
    }
}
