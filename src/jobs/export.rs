//! Stored results in the forms that other programs read. Only the steps that a form shows are read, and fields only where it
//! shows them.

use thiserror::Error;

use super::{JobId, JobService, ResultHead, StoreError};
use brinell_solver::job::Job;
use brinell_solver::report::export::{Export, ExportError};
use brinell_solver::report::{Report, StepReport};

/// Why a result does not have a form.
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

#[expect(clippy::needless_pass_by_value, reason = "the shape that map_err takes")]
fn unreadable(error: impl ToString) -> ExportFailure {
    ExportFailure::Unreadable(error.to_string())
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
        let head = self.result(id).await?.ok_or(ExportFailure::NoResult)?;
        let request = self.request(id).await?;
        let _decoder = self.decoder().await;
        let (report, step) = self.read_report(id, &head, form, step).await?;
        // Megabytes of fields take their time: not on a thread that others wait for.
        let written = tokio::task::spawn_blocking(move || {
            let job = Job::from_json(&request).map_err(unreadable)?;
            Ok(form.write(&job, &report, step)?)
        });
        written.await.unwrap_or_else(|error| Err(unreadable(error)))
    }

    /// The report with the steps that a form shows, and the place in it of the step that is wanted.
    async fn read_report(
        &self,
        id: JobId,
        head: &ResultHead,
        form: Export,
        step: Option<usize>,
    ) -> Result<(Report, Option<usize>), ExportFailure> {
        let mut report: Report = serde_json::from_slice(&head.report).map_err(unreadable)?;
        let Some(last) = head.steps.checked_sub(1) else { return Ok((report, step)) };
        let wanted = step.unwrap_or(last);
        if wanted > last {
            return Err(ExportError::NoStep(wanted).into());
        }
        let with_fields = form == Export::FieldVtu;
        let shown = if form.shows_one_step() && !with_fields { wanted..wanted + 1 } else { 0..head.steps };
        let first = shown.start;
        for number in shown {
            let text = self.step(id, number).await?.text().map_err(unreadable)?;
            let mut step: StepReport = serde_json::from_slice(&text).map_err(unreadable)?;
            if with_fields
                && number == wanted
                && let Some(fields) = self.fields(id, number).await?
            {
                step.fields = Some(fields.whole().await?.decode().map_err(unreadable)?);
            }
            report.steps.push(step);
        }
        Ok((report, Some(wanted - first)))
    }
}
