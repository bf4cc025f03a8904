//! Metrics of jobs, under the names that Prometheus, dashboards and alerts use.

use std::time::Duration;

use metrics::{counter, gauge, histogram};

use super::{Counts, JobState};
use brinell_solver::job::Named;
use brinell_solver::solver::FactorCacheStats;

/// Jobs waiting, of all nodes that share the queue.
pub const QUEUE_DEPTH: &str = "brinell_queue_depth";
/// Jobs being solved, of all nodes that share the queue.
pub const JOBS_RUNNING: &str = "brinell_jobs_running";
/// Time \[s\] between acceptance and the first attempt.
pub const QUEUE_WAIT: &str = "brinell_queue_wait_seconds";
/// Time \[s\] of an attempt.
pub const SOLVE_DURATION: &str = "brinell_solve_duration_seconds";
/// Attempts by `outcome`: the final state of the job, or `released` if it returned to the queue.
pub const JOBS_TOTAL: &str = "brinell_jobs_total";
/// Iterations of an attempt.
pub const SOLVER_ITERATIONS: &str = "brinell_solver_iterations";
/// Lookups of bodies in the cache, by `outcome`: `hit` if an earlier job left the body, else
/// `miss`.
pub const FACTOR_CACHE_LOOKUPS: &str = "brinell_factor_cache_lookups_total";
/// Bytes of cached bodies and factors.
pub const FACTOR_CACHE_BYTES: &str = "brinell_factor_cache_bytes";

/// Records the state of the queue; `None` if the store does not answer.
pub fn queue(counts: Option<&Counts>) {
    let jobs = |state| {
        let of = |counts: &Counts| counts.get(&state).copied().unwrap_or(0) as f64;
        counts.map_or(f64::NAN, of)
    };
    gauge!(QUEUE_DEPTH).set(jobs(JobState::Queued));
    gauge!(JOBS_RUNNING).set(jobs(JobState::Running));
}

/// Records how long a job waited for its first attempt.
pub fn waited(time: Duration) {
    histogram!(QUEUE_WAIT).record(time);
}

/// Records an attempt that ended. A job that returned to the queue has no final state.
pub fn attempted(outcome: Option<JobState>, time: Duration, iterations: usize) {
    counter!(JOBS_TOTAL, "outcome" => outcome.map_or("released", Named::name)).increment(1);
    histogram!(SOLVE_DURATION).record(time);
    histogram!(SOLVER_ITERATIONS).record(iterations as f64);
}

/// Records size, hits and misses of the cache of bodies.
pub fn factor_cache(figures: FactorCacheStats) {
    counter!(FACTOR_CACHE_LOOKUPS, "outcome" => "hit").absolute(figures.hits);
    counter!(FACTOR_CACHE_LOOKUPS, "outcome" => "miss").absolute(figures.misses);
    gauge!(FACTOR_CACHE_BYTES).set(figures.bytes as f64);
}
