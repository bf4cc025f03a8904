//! Solver threads, each for one job.

use std::io;
use std::thread;
use std::time::Duration;

use crate::jobs::JobId;

/// Stack size \[bytes\] of a solver thread: some walks of elimination trees are recursive.
const STACK_BYTES: usize = 8 << 20;

/// Running time after which a job counts as long.
pub(super) const LONG: Duration = Duration::from_secs(2);

/// Nice value of long jobs: beside a long job, a short one gets six sevenths of a core.
#[cfg(target_os = "linux")]
const LONG_PRIORITY: i32 = 8;

/// Starts a thread for a job.
pub(super) fn start(job: JobId, solve: impl FnOnce() + Send + 'static) -> io::Result<()> {
    let name = format!("solver-{job}");
    thread::Builder::new().name(name).stack_size(STACK_BYTES).spawn(solve).map(drop)
}

/// Lowers the priority of this thread permanently. Only Linux has a nice value for each thread;
/// other systems would lower the whole process.
pub(super) fn give_way() {
    #[cfg(target_os = "linux")]
    if let Err(error) = rustix::process::setpriority_process(None, LONG_PRIORITY) {
        tracing::debug!(%error, "long jobs have the priority of others");
    }
}
