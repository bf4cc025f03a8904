//! Stored results in the forms that other programs read.

use bytes::Bytes;
use thiserror::Error;

use super::{JobId, JobService, StoreError};
use brinell_solver::job::Job;
use brinell_solver::report::Report;
use brinell_solver::report::export::{Export, ExportError};

/// Why a result is not to be had in a form.
#[derive(Debug, Error)]
pub enum ExportFailure {
    /// The store has no such job, or does not answer.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The job has no result, or none yet.
    #[error("the job has no result")]
    NoResult,
    /// The result has no such form.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// What is stored cannot be read any more.
    #[error("the stored result cannot be read: {0}")]
    Unreadable(String),
}

impl JobService {
    /// The report of a job in another form; `step`, counted from 0, is the last one unless it is given.
    ///
    /// # Errors
    /// [`ExportFailure`].
    pub async fn export(
        &self,
        id: JobId,
        form: Export,
        step: Option<usize>,
    ) -> Result<String, ExportFailure> {
        let report = self.report(id).await?.ok_or(ExportFailure::NoResult)?;
        let request = self.request(id).await?;
        // Megabytes of fields take their time: not on a thread that others wait for.
        let written = tokio::task::spawn_blocking(move || write(&request, &report, form, step));
        written.await.unwrap_or_else(|error| Err(ExportFailure::Unreadable(error.to_string())))
    }
}

fn write(
    request: &Bytes,
    report: &Bytes,
    form: Export,
    step: Option<usize>,
) -> Result<String, ExportFailure> {
    let unreadable = |error: &dyn std::error::Error| ExportFailure::Unreadable(error.to_string());
    let job = Job::from_json(request).map_err(|error| unreadable(&error))?;
    let report: Report = serde_json::from_slice(report).map_err(|error| unreadable(&error))?;
    Ok(form.write(&job, &report, step)?)
}
