//! A job whose client waits for its answer: it is cancelled when the client goes.

use std::sync::Arc;

use tokio::runtime::Handle;

use super::{JobId, JobService, KeyId};

/// Cancels its job when it is dropped, which is what happens when the client hangs up.
pub struct AttendedJob {
    jobs: Arc<JobService>,
    job: Option<JobId>,
    key: Option<KeyId>,
}

impl AttendedJob {
    /// A job that is cancelled in the name of a key; `None` is a job that goes on by itself.
    pub(super) fn new(jobs: Arc<JobService>, job: Option<JobId>, key: Option<KeyId>) -> Self {
        Self { jobs, job, key }
    }

    /// The client has its answer.
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
