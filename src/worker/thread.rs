//! Threads that solve, each one job.

use std::io;
use std::thread;
use std::time::Duration;

use crate::jobs::JobId;

/// Elimination trees are walked recursively in places; a solve has room for it.
const STACK_BYTES: usize = 8 << 20;

/// A job that has run for so long is long.
pub(super) const LONG: Duration = Duration::from_secs(2);

/// Scheduling priority (nice value) of long jobs: others beside them get six parts in seven of a
/// core.
#[cfg(target_os = "linux")]
const LONG_PRIORITY: i32 = 8;

/// Starts a thread for a job.
pub(super) fn start(job: JobId, solve: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let name = format!("solver-{job}");
    thread::Builder::new().name(name).stack_size(STACK_BYTES).spawn(solve).map(drop)
}

/// Lowers the priority of this thread for good. Linux knows priorities of threads; elsewhere it
/// would be that of the process.
pub(super) fn give_way() {
    #[cfg(target_os = "linux")]
    if let Err(error) = rustix::process::setpriority_process(None, LONG_PRIORITY) {
        tracing::debug!(%error, "long jobs have the priority of others");
    }
}
