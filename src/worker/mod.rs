//! Solves queued jobs on threads of their own, never on the async runtime's.
//!
//! [`Worker`] claims as many jobs as it has free solvers. Each job has a supervisor, an async task that forwards
//! progress to the store and the wish to stop to the solver; the solver thread itself only ever talks to its
//! observer, which owns the job's clock. A panic ends one job. One task beats the heart of all leases.

mod attempt;
mod observer;
mod pool;
mod running;
mod seats;
mod supervise;

use std::io;
use std::sync::Arc;
use std::time::Duration;

use tokio::time::{sleep, timeout};
use tokio_util::sync::CancellationToken;
use tokio_util::task::TaskTracker;

use crate::jobs::{Claim, ClaimRequest, Hub, JobSolver, JobStore, WorkerId};
use pool::SolverPool;
use running::Running;
use seats::{Seats, Taken};
use sparse_cholesky::Cores;

/// Time for solves to notice that they must stop, once the grace time is over.
const LAST_WORDS: Duration = Duration::from_secs(2);

/// How a worker goes about its work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct WorkerSettings {
    /// Jobs solved at the same time.
    pub slots: usize,
    /// Memory \[bytes\] they may need together, by their estimates.
    pub memory: u64,
    /// Longest time a job may be solved for.
    pub job_timeout: Duration,
    /// How long a job stays with a worker that gives no sign of life. Hearts beat three times as often.
    pub lease: Duration,
    /// Longest time between two looks into the queue; new jobs of this process are announced anyway.
    pub poll: Duration,
    /// How often a job is taken up before it is given up.
    pub max_attempts: u32,
    /// Whether to solve what is queued before stopping. A store that outlives the process needs no such care.
    pub empties_queue: bool,
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
    /// One for each solver of the pool; large jobs borrow those of solvers that have nothing to do.
    cores: Arc<Cores>,
    seats: Arc<Seats>,
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
            cores: Cores::new(settings.slots),
            seats: Arc::new(Seats::new(settings.slots, settings.memory)),
            running: Running::default(),
            tasks: TaskTracker::new(),
            drain: CancellationToken::new(),
            halt: CancellationToken::new(),
        });
        crew.tasks.spawn(Arc::clone(&crew).claim_jobs());
        let heartbeat = tokio::spawn(Arc::clone(&crew).beat());
        Ok(Self { crew, heartbeat })
    }

    /// Finishes what is running, and what is queued if so set, then stops. What is left after `grace` is stopped
    /// and goes back to the queue. Returns whether everything was finished.
    pub async fn drain(self, grace: Duration) -> bool {
        self.crew.drain.cancel();
        self.crew.tasks.close();
        let finished = timeout(grace, self.crew.tasks.wait()).await.is_ok();
        if !finished {
            self.crew.halt.cancel();
            self.crew.running.stop_all();
            if timeout(LAST_WORDS, self.crew.tasks.wait()).await.is_err() {
                self.crew.let_go().await;
            }
        }
        self.heartbeat.abort();
        finished
    }
}

impl Crew {
    async fn claim_jobs(self: Arc<Self>) {
        let mut lonely_waits = false;
        loop {
            let taken = tokio::select! {
                taken = self.seats.take(lonely_waits) => taken,
                () = self.halt.cancelled() => return,
            };
            if self.drain.is_cancelled() && !self.settings.empties_queue {
                return;
            }
            match self.store.claim(&self.request(&taken)).await {
                Ok(claims) => {
                    lonely_waits = claims.lonely_waits && !taken.all;
                    if claims.jobs.is_empty() && !lonely_waits {
                        drop(taken);
                        if self.drain.is_cancelled() {
                            return;
                        }
                        self.idle().await;
                        continue;
                    }
                    self.start(claims.jobs, taken);
                }
                Err(error) => {
                    tracing::error!(error = &error as &dyn std::error::Error, "cannot claim jobs");
                    drop(taken);
                    tokio::select! { () = sleep(self.settings.poll) => {}, () = self.drain.cancelled() => return }
                }
            }
        }
    }

    fn request(&self, taken: &Taken) -> ClaimRequest {
        ClaimRequest {
            owner: self.id,
            slots: taken.len(),
            alone: taken.all,
            free_memory: self.seats.free_memory(),
            memory: self.seats.memory(),
            lease: self.settings.lease,
            max_attempts: self.settings.max_attempts,
        }
    }

    fn start(self: &Arc<Self>, claims: Vec<Claim>, mut taken: Taken) {
        for claim in claims {
            if let Some(seat) = taken.seat(&self.seats, claim.alone, claim.memory) {
                self.tasks.spawn(Arc::clone(self).supervise(claim, seat));
            }
        }
    }

    async fn idle(&self) {
        tokio::select! {
            () = self.hub.work() => {}
            () = self.seats.freed() => {}
            () = sleep(self.settings.poll) => {}
            () = self.drain.cancelled() => {}
        }
    }

    /// Gives back what does not stop.
    async fn let_go(&self) {
        let leases = self.running.leases();
        tracing::warn!(jobs = leases.len(), "solves left running at the end of the grace time");
        if let Err(error) = self.store.release(&leases).await {
            tracing::error!(error = &error as &dyn std::error::Error, "cannot give jobs back");
        }
    }
}
