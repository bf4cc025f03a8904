//! The running jobs of a worker, and when the store last answered it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::time::Instant;

use super::observer::StopFlag;
use crate::jobs::Lease;

/// Leases of the running jobs, each with the flag that stops its solve. Without a flag, the solve
/// has ended and its outcome is being written.
#[derive(Debug, Default)]
pub(super) struct Running(Mutex<HashMap<Lease, Option<StopFlag>>>);

impl Running {
    /// Adds a job whose solve begins; returns the flag that stops it.
    pub(super) fn add(&self, lease: Lease) -> StopFlag {
        let stop = StopFlag::default();
        self.lock().insert(lease, Some(stop.clone()));
        stop
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

/// Longest time between the ends of two heartbeats of a worker that lives, answered or not: twice
/// the longest time of a call.
const STILL: Duration = Duration::from_mins(2);

/// When heartbeats of a worker last came to an end.
#[derive(Debug, Clone)]
pub struct Pulse(Arc<Mutex<Beats>>);

#[derive(Debug, Clone, Copy)]
struct Beats {
    ended: Instant,
    answered: Instant,
}

impl Pulse {
    pub(super) fn new() -> Self {
        let now = Instant::now();
        Self(Arc::new(Mutex::new(Beats { ended: now, answered: now })))
    }

    /// Records the end of a heartbeat.
    pub(super) fn beat(&self, is_answered: bool) {
        let mut beats = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        beats.ended = Instant::now();
        if is_answered {
            beats.answered = beats.ended;
        }
    }

    fn beats(&self) -> Beats {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether the worker lives. A store that does not answer is no reason to end a worker: its
    /// solves go on.
    pub fn is_alive(&self) -> bool {
        self.beats().ended.elapsed() < STILL
    }

    /// Returns the time since the store last answered a heartbeat.
    pub fn age(&self) -> Duration {
        self.beats().answered.elapsed()
    }
}
