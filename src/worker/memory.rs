//! Accounting of the memory of running solves, by the solver's own count, against their common
//! limit.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use brinell_solver::solver::Held;

/// Memory \[bytes\] of all solves of a worker.
#[derive(Debug)]
pub(super) struct WorkerMemory {
    limit: u64,
    held: AtomicU64,
}

/// Memory \[bytes\] of one solve.
#[derive(Debug)]
pub(super) struct JobMemory {
    all: Arc<WorkerMemory>,
    estimate: u64,
    bodies: u64,
    increments: u64,
}

impl WorkerMemory {
    /// Makes an account with a common limit.
    pub(super) fn new(limit: u64) -> Arc<Self> {
        Arc::new(Self { limit, held: AtomicU64::new(0) })
    }

    /// Opens the account of a job with the given estimate.
    pub(super) fn of_job(self: &Arc<Self>, estimate: u64) -> JobMemory {
        JobMemory { all: Arc::clone(self), estimate, bodies: 0, increments: 0 }
    }
}

impl JobMemory {
    /// Records the memory of one part of a solve; fails beyond the limit. A job within its
    /// estimate never fails because of other jobs.
    pub(super) fn hold(&mut self, part: Held, bytes: u64) -> Result<(), String> {
        let held = match part {
            Held::Bodies => &mut self.bodies,
            Held::Increments => &mut self.increments,
        };
        let change = bytes.wrapping_sub(std::mem::replace(held, bytes));
        let all = self.all.held.fetch_add(change, Ordering::Relaxed).wrapping_add(change);
        let (held, estimate, limit) = (self.held(), self.estimate, self.all.limit);
        if held <= estimate || all <= limit {
            return Ok(());
        }
        let [held, estimate, limit] = [held, estimate, limit].map(|bytes| bytes >> 20);
        Err(format!(
            "the job takes {held} MiB for bodies and increments, was estimated to need \
             {estimate}, and the solvers may take {limit} together"
        ))
    }

    fn held(&self) -> u64 {
        self.bodies.saturating_add(self.increments)
    }
}

impl Drop for JobMemory {
    fn drop(&mut self) {
        self.all.held.fetch_sub(self.held(), Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jobs_beyond_their_estimate_fail_where_memory_ends() {
        let all = WorkerMemory::new(100);
        let (mut honest, mut other) = (all.of_job(60), all.of_job(40));
        assert!(other.hold(Held::Bodies, 30).is_ok());
        assert!(
            other.hold(Held::Increments, 50).is_ok(),
            "more than estimated, but there is room"
        );
        assert!(honest.hold(Held::Bodies, 60).is_ok(), "within its estimate");
        assert!(other.hold(Held::Increments, 60).is_err());
        assert!(other.hold(Held::Increments, 5).is_ok());
        drop(other);
        assert_eq!(all.held.load(Ordering::Relaxed), 60);
        drop(honest);
        assert_eq!(all.held.load(Ordering::Relaxed), 0);
    }
}
