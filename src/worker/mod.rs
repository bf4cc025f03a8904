//! Solves queued jobs on threads of their own, never on the async runtime's.
//!
//! [`Worker`] claims as many jobs as it has free places. Each job has a supervisor, an async task
//! that forwards progress to the store and the wish to stop to the solver; the solver thread
//! itself only ever talks to its observer, which owns the job's clock. A panic ends one job. One
//! task beats the heart of all leases.

mod attempt;
mod memory;
mod message;
mod observer;
mod running;
mod slots;
mod supervise;
mod thread;

use std::sync::Arc;
use std::time::Duration;

use tokio::time::{sleep, timeout};
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use crate::jobs::{Claim, ClaimRequest, JobNotifier, JobSolver, JobStore, WorkerId};
use memory::WorkerMemory;
use running::Running;
use slots::{Memory, Reservation, Slots};

/// Time for solves to notice that they must stop, once the grace time is over.
pub const STOP_TIMEOUT: Duration = Duration::from_secs(2);

/// How a worker goes about its work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Jobs solved at the same time.
    pub slots: usize,
    /// Memory \[bytes\] that large ones may need together, by their estimates.
    pub memory: u64,
    /// Memory \[bytes\] beside it that each place has of its own.
    pub memory_of_place: u64,
    /// Longest time a job may be solved for.
    pub job_timeout: Duration,
    /// How long a job stays with a worker that gives no sign of life. Hearts beat three times as
    /// often.
    pub lease: Duration,
    /// Longest time between two looks into the queue; new jobs of this process are announced
    /// anyway.
    pub poll: Duration,
    /// How often a job is taken up before it is given up.
    pub max_attempts: u32,
    /// Whether to solve what is queued before stopping. A store that outlives the process needs no
    /// such care.
    pub empties_queue: bool,
}

/// A running pool of solvers.
pub struct Worker {
    state: Arc<WorkerState>,
    heartbeat: tokio::task::JoinHandle<()>,
}

/// What the worker's tasks share.
pub(crate) struct WorkerState {
    id: WorkerId,
    settings: WorkerSettings,
    store: Arc<dyn JobStore>,
    notifier: Arc<JobNotifier>,
    solver: Arc<dyn JobSolver>,
    slots: Arc<Slots>,
    running: Running,
    memory: Arc<WorkerMemory>,
    tasks: TaskTracker,
    drain: CancellationToken,
    halt: CancellationToken,
}

impl Worker {
    /// Begins to claim. Needs a Tokio runtime.
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

    /// Finishes what is running, and what is queued if so set, then stops. What is left after
    /// `grace` is stopped and goes back to the queue. Returns whether everything was finished.
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
        let mut exclusive_pending = false;
        loop {
            let reservation = tokio::select! {
                reservation = self.slots.take(), if !exclusive_pending => reservation,
                reservation = self.slots.take_all(), if exclusive_pending => reservation,
                () = self.halt.cancelled() => return,
            };
            if self.drain.is_cancelled() && !self.settings.empties_queue {
                return;
            }
            match self.store.claim(&self.request(&reservation)).await {
                Ok(claims) => {
                    exclusive_pending = claims.exclusive_pending && !reservation.all;
                    if claims.jobs.is_empty() && !exclusive_pending {
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
                    tracing::error!(error = &error as &dyn std::error::Error, "cannot claim jobs");
                    drop(reservation);
                    tokio::select! { () = sleep(self.settings.poll) => {}, () = self.drain.cancelled() => return }
                }
            }
        }
    }

    fn request(&self, reservation: &Reservation) -> ClaimRequest {
        let memory = self.slots.memory();
        ClaimRequest {
            owner: self.id,
            places: reservation.len(),
            places_of_key: self.settings.slots,
            memory_of_place: memory.of_place,
            exclusive: reservation.all,
            free_memory: self.slots.free_memory(),
            memory: memory.shared,
            lease: self.settings.lease,
            max_attempts: self.settings.max_attempts,
        }
    }

    fn start(self: &Arc<Self>, claims: Vec<Claim>, mut reservation: Reservation) {
        for claim in claims {
            if let Some(slot) = reservation.assign(&self.slots, &claim) {
                self.tasks.spawn(Arc::clone(self).supervise(claim, slot));
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

    /// Gives back what does not stop.
    async fn release_all(&self) {
        let leases = self.running.leases();
        tracing::warn!(jobs = leases.len(), "solves left running at the end of the grace time");
        if let Err(error) = self.store.release(&leases).await {
            tracing::error!(error = &error as &dyn std::error::Error, "cannot give jobs back");
        }
    }
}
