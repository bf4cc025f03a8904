//! Solves queued jobs on threads of their own, never on the async runtime's.
//!
//! [`Worker`] claims as many jobs as it has free solvers. Each job has a supervisor, an async task that forwards
//! progress to the store and the wish to stop to the solver; the solver thread itself only ever talks to its
//! observer, which owns the job's clock. A panic ends one job. One task beats the heart of all leases.

mod attempt;
mod observer;
mod pool;
mod running;
mod supervise;

use std::io;
use std::sync::Arc;
use std::time::Duration;

use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{sleep, timeout};
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use crate::jobs::{ClaimRequest, Hub, JobSolver, JobStore, WorkerId};
use pool::SolverPool;
use running::Running;

/// Time for solves to notice that they must stop, once the grace time is over.
const LAST_WORDS: Duration = Duration::from_secs(2);

/// How a worker goes about its work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Jobs solved at the same time.
    pub slots: usize,
    /// Longest time a job may be solved for.
    pub job_timeout: Duration,
    /// How long a job stays with a worker that gives no sign of life. Hearts beat three times as often.
    pub lease: Duration,
    /// Longest time between two looks into the queue; new jobs of this process are announced anyway.
    pub poll: Duration,
    /// How often a job is taken up before it is given up.
    pub max_attempts: u32,
}

/// A running pool of solvers.
pub struct Worker {
    crew: Arc<Crew>,
    heartbeat: tokio::task::JoinHandle<()>,
}

/// What the worker's tasks share.
pub(crate) struct Crew {
    id: WorkerId,
    settings: WorkerSettings,
    store: Arc<dyn JobStore>,
    hub: Arc<Hub>,
    solver: Arc<dyn JobSolver>,
    pool: SolverPool,
    free: Arc<Semaphore>,
    running: Running,
    tasks: TaskTracker,
    drain: CancellationToken,
    halt: CancellationToken,
}

impl Worker {
    /// Starts the solver threads and begins to claim. Needs a Tokio runtime.
    ///
    /// # Errors
    /// If a thread cannot be started.
    pub fn start(
        store: Arc<dyn JobStore>,
        hub: Arc<Hub>,
        solver: Arc<dyn JobSolver>,
        settings: WorkerSettings,
    ) -> io::Result<Self> {
        let crew = Arc::new(Crew {
            id: WorkerId::generate(),
            settings,
            store,
            hub,
            solver,
            pool: SolverPool::new(settings.slots)?,
            free: Arc::new(Semaphore::new(settings.slots)),
            running: Running::default(),
            tasks: TaskTracker::new(),
            drain: CancellationToken::new(),
            halt: CancellationToken::new(),
        });
        crew.tasks.spawn(Arc::clone(&crew).claim_jobs());
        let heartbeat = tokio::spawn(Arc::clone(&crew).beat());
        Ok(Self { crew, heartbeat })
    }

    /// Finishes what is queued and running, then stops. What is left after `grace` is cancelled. Returns
    /// whether everything was finished.
    pub async fn drain(self, grace: Duration) -> bool {
        self.crew.drain.cancel();
        self.crew.tasks.close();
        let finished = timeout(grace, self.crew.tasks.wait()).await.is_ok();
        if !finished {
            self.crew.halt.cancel();
            self.crew.running.stop_all();
            if timeout(LAST_WORDS, self.crew.tasks.wait()).await.is_err() {
                tracing::warn!("solves left running at the end of the grace time");
            }
        }
        self.heartbeat.abort();
        finished
    }
}

impl Crew {
    async fn claim_jobs(self: Arc<Self>) {
        loop {
            let permits = tokio::select! {
                permits = self.free_slots() => permits,
                () = self.halt.cancelled() => return,
            };
            let request = ClaimRequest {
                owner: self.id,
                slots: permits.len(),
                lease: self.settings.lease,
                max_attempts: self.settings.max_attempts,
            };
            match self.store.claim(&request).await {
                Ok(claims) if claims.is_empty() => {
                    drop(permits);
                    if self.drain.is_cancelled() {
                        return;
                    }
                    self.idle().await;
                }
                Ok(claims) => {
                    for (claim, permit) in claims.into_iter().zip(permits) {
                        self.tasks.spawn(Arc::clone(&self).supervise(claim, permit));
                    }
                }
                Err(error) => {
                    tracing::error!(error = &error as &dyn std::error::Error, "cannot claim jobs");
                    drop(permits);
                    tokio::select! { () = sleep(self.settings.poll) => {}, () = self.halt.cancelled() => return }
                }
            }
        }
    }

    /// Waits for a free solver and takes all that are free; none once the pool is closed.
    async fn free_slots(&self) -> Vec<OwnedSemaphorePermit> {
        let first = Arc::clone(&self.free).acquire_owned().await;
        let others = std::iter::from_fn(|| Arc::clone(&self.free).try_acquire_owned().ok());
        first.into_iter().chain(others).collect()
    }

    async fn idle(&self) {
        tokio::select! {
            () = self.hub.work() => {}
            () = sleep(self.settings.poll) => {}
            () = self.drain.cancelled() => {}
        }
    }
}
