//! A job whose client waits for the result: it is cancelled when the client hangs up.

use std::sync::Arc;

use tokio::runtime::Handle;

use super::{JobId, JobService, KeyId};

/// Cancels its job when it is dropped, as it is when the client hangs up.
pub struct AttendedJob {
    jobs: Arc<JobService>,
    job: Option<JobId>,
    key: Option<KeyId>,
}

impl AttendedJob {
    /// Guards a job, to be cancelled in the name of `key`; without a job, dropping does nothing.
    pub(super) fn new(jobs: Arc<JobService>, job: Option<JobId>, key: Option<KeyId>) -> Self {
        Self { jobs, job, key }
    }

    /// Disarms the guard: the client has its answer.
    pub fn release(mut self) {
        self.job = None;
    }
}

impl Drop for AttendedJob {
    fn drop(&mut self) {
        let (Some(id), Ok(runtime)) = (self.job, Handle::try_current()) else { return };
        let (jobs, key) = (Arc::clone(&self.jobs), self.key);
        runtime.spawn(async move {
            if let Err(error) = jobs.cancel(id, key).await {
                tracing::warn!(job = %id, %error, "cannot cancel the job of a client that hung \
                                                   up");
            }
        });
    }
}
