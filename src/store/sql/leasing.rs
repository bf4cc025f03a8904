//! Statements of those who hold a lease. Each is fenced on owner and attempt.

use std::time::Duration;

use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::claiming::{FORGET, until};
use super::codec::{failure_json, pack, pack_records, to_json};
use crate::jobs::{FIELDS_PART, IterationRecord, Lease, LeaseStatus, Outcome, StepResult, StoreError};

const BEAT: &str = "UPDATE jobs SET leased_until = $4
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running' RETURNING cancel_requested";
const PROGRESS: &str = "UPDATE jobs SET iterations = iterations + $4, latest = $5
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running' RETURNING iterations";
const APPEND: &str = "INSERT INTO iterations (job, first, last, records) VALUES ($1, $2, $3, $4)";
const FINISH: &str =
    "UPDATE jobs SET state = $4, finished_at = $5, has_report = $6, failure = $7, owner = NULL,
         leased_until = NULL
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'";
const REPORT: &str = "INSERT INTO reports (job, body) VALUES ($1, $2)";
const RELEASE: &str = "UPDATE jobs SET state = CASE WHEN cancel_requested THEN 'cancelled' ELSE 'queued' END,
         finished_at = CASE WHEN cancel_requested THEN $4 END,
         started_at = CASE WHEN cancel_requested THEN started_at END, owner = NULL, leased_until = NULL,
         iterations = CASE WHEN cancel_requested THEN iterations ELSE 0 END,
         latest = CASE WHEN cancel_requested THEN latest END,
         steps = CASE WHEN cancel_requested THEN steps ELSE 0 END,
         stored_bytes = CASE WHEN cancel_requested THEN stored_bytes ELSE 0 END
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running' RETURNING cancel_requested";
const STEPS: &str = "UPDATE jobs SET steps = steps + $4, stored_bytes = stored_bytes + $5
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running' RETURNING steps";
const STEP: &str = "INSERT INTO result_steps (job, step, body) VALUES ($1, $2, $3)";
const FIELDS: &str = "INSERT INTO field_parts (job, step, first, body) VALUES ($1, $2, $3, $4)";
const NO_STEPS: &str = "UPDATE jobs SET steps = 0, stored_bytes = 0 WHERE id = $1";

/// Changes by the holder of a lease.
pub(in crate::store) trait Leasing: Send {
    fn heartbeat(
        &mut self,
        leases: &[Lease],
        lease: Duration,
        now: i64,
    ) -> impl Future<Output = Result<Vec<LeaseStatus>, StoreError>> + Send;
    fn record_progress(
        &mut self,
        lease: &Lease,
        records: &[IterationRecord],
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn record_steps(
        &mut self,
        lease: &Lease,
        steps: &[StepResult],
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn finish(
        &mut self,
        lease: &Lease,
        outcome: &Outcome,
        now: i64,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Gives a job back; `Some(true)` if it was cancelled instead, `None` if the lease was lost.
    fn release(
        &mut self,
        lease: &Lease,
        now: i64,
    ) -> impl Future<Output = Result<Option<bool>, StoreError>> + Send;
}

macro_rules! fenced {
    ($query:expr, $lease:expr) => {{
        let lease: &Lease = $lease;
        let attempt = i32::try_from(lease.attempt).unwrap_or(i32::MAX);
        $query.bind(lease.job.uuid()).bind(lease.owner.uuid()).bind(attempt)
    }};
}

macro_rules! leasing {
    ($database:ty, $connection:ty) => {
        impl Leasing for $connection {
            async fn heartbeat(
                &mut self,
                leases: &[Lease],
                lease: Duration,
                now: i64,
            ) -> Result<Vec<LeaseStatus>, StoreError> {
                let mut statuses = Vec::with_capacity(leases.len());
                for held in leases {
                    let beat = fenced!(sqlx::query_scalar::<$database, bool>(BEAT), held);
                    let beat = beat.bind(until(now, lease)).fetch_optional(&mut *self).await?;
                    let held = |cancel_requested| LeaseStatus::Held { cancel_requested };
                    statuses.push(beat.map_or(LeaseStatus::Lost, held));
                }
                Ok(statuses)
            }

            async fn record_progress(
                &mut self,
                lease: &Lease,
                records: &[IterationRecord],
            ) -> Result<(), StoreError> {
                let Some(latest) = records.last() else { return Ok(()) };
                let more = i32::try_from(records.len()).unwrap_or(i32::MAX);
                let progress = fenced!(sqlx::query_scalar::<$database, i32>(PROGRESS), lease);
                let progress = progress.bind(more).bind(to_json(latest)?);
                let last = progress.fetch_optional(&mut *self).await?.ok_or(StoreError::LeaseLost)?;
                sqlx::query::<$database>(APPEND)
                    .bind(lease.job.uuid())
                    .bind(last.saturating_sub(more))
                    .bind(last)
                    .bind(pack_records(records)?)
                    .execute(self)
                    .await?;
                Ok(())
            }

            async fn record_steps(&mut self, lease: &Lease, steps: &[StepResult]) -> Result<(), StoreError> {
                if steps.is_empty() {
                    return Ok(());
                }
                let more = i32::try_from(steps.len()).unwrap_or(i32::MAX);
                let bytes: usize = steps.iter().map(StepResult::bytes).sum();
                let recorded = fenced!(sqlx::query_scalar::<$database, i32>(STEPS), lease);
                let recorded = recorded.bind(more).bind(i64::try_from(bytes).unwrap_or(i64::MAX));
                let last = recorded.fetch_optional(&mut *self).await?.ok_or(StoreError::LeaseLost)?;
                for (number, step) in (last.saturating_sub(more)..).zip(steps) {
                    let report = sqlx::query::<$database>(STEP).bind(lease.job.uuid()).bind(number);
                    report.bind(&step.report.clone().into_bytes()[..]).execute(&mut *self).await?;
                    let fields = step.fields.as_deref().unwrap_or_default();
                    for (part, first) in fields.chunks(FIELDS_PART).zip((0_i64..).step_by(FIELDS_PART)) {
                        let insert = sqlx::query::<$database>(FIELDS).bind(lease.job.uuid()).bind(number);
                        insert.bind(first).bind(part).execute(&mut *self).await?;
                    }
                }
                Ok(())
            }

            async fn finish(&mut self, lease: &Lease, outcome: &Outcome, now: i64) -> Result<(), StoreError> {
                let (report, failure) = match outcome {
                    Outcome::Reported { report, .. } => (Some(report), None),
                    Outcome::Failed(failure) => (None, Some(failure_json(failure)?)),
                    Outcome::Interrupted(_) => (None, None),
                };
                let finish = fenced!(sqlx::query::<$database>(FINISH), lease);
                let finish =
                    finish.bind(outcome.state().name()).bind(now).bind(report.is_some()).bind(failure);
                if finish.execute(&mut *self).await?.rows_affected() == 0 {
                    return Err(StoreError::LeaseLost);
                }
                if let Some(report) = report {
                    let report = sqlx::query::<$database>(REPORT).bind(lease.job.uuid()).bind(pack(report)?);
                    report.execute(self).await?;
                } else {
                    let [_, steps, fields] = FORGET;
                    for statement in [steps, fields, NO_STEPS] {
                        sqlx::query::<$database>(statement)
                            .bind(lease.job.uuid())
                            .execute(&mut *self)
                            .await?;
                    }
                }
                Ok(())
            }

            async fn release(&mut self, lease: &Lease, now: i64) -> Result<Option<bool>, StoreError> {
                let release = fenced!(sqlx::query_scalar::<$database, bool>(RELEASE), lease);
                let cancelled = release.bind(now).fetch_optional(&mut *self).await?;
                if cancelled == Some(false) {
                    for forget in FORGET {
                        sqlx::query::<$database>(forget).bind(lease.job.uuid()).execute(&mut *self).await?;
                    }
                }
                Ok(cancelled)
            }
        }
    };
}

leasing!(Sqlite, SqliteConnection);
leasing!(Postgres, PgConnection);
