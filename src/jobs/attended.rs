//! A job whose client waits for the result: it is cancelled when the client hangs up.

use std::sync::Arc;

use tokio::runtime::Handle;

use super::{Enqueued, JobId, JobService, KeyId, Submission, SubmitError};

/// Cancels its job when it is dropped, as it is when the client hangs up.
pub struct AttendedJob {
    jobs: Arc<JobService>,
    job: Option<JobId>,
    key: Option<KeyId>,
}

impl AttendedJob {
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

impl JobService {
    /// Checks a job and queues it for a client that waits for its result. Dropping the returned
    /// guard, or this future, cancels the job, unless it has an idempotency key: its client may
    /// repeat the request.
    ///
    /// # Errors
    /// [`SubmitError`]; nothing is queued then.
    pub async fn submit_attended(
        self: &Arc<Self>,
        submission: Submission,
    ) -> Result<(Enqueued, AttendedJob), SubmitError> {
        let (jobs, key) = (Arc::clone(self), submission.submitter);
        let may_come_again = submission.idempotency_key.is_some();
        let attend = move |enqueued: &Enqueued| {
            let job = Some(enqueued.job.id).filter(|_| !may_come_again);
            AttendedJob { jobs, job, key }
        };
        self.submit_with(submission, attend).await
    }
}
