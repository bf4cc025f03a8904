//! Statements of a worker that holds a lease. Each names owner and attempt in its condition, so
//! that a lost lease changes nothing. Only the end of a job needs a transaction.

use std::time::Duration;

use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, QueryBuilder, Sqlite, SqliteConnection};

use super::claiming::{FORGET, SETTLE, until};
use super::codec::{failure_json, pack, pack_records, to_json};
use crate::jobs::{
    FIELDS_PART, HISTORY_PAGE, IterationRecord, JobId, Lease, LeaseStatus, Outcome, StepResult,
    StoreError,
};

const PROGRESS: &str = "UPDATE jobs SET iterations = iterations + $4, latest = $5
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'";
/// Ends a job; without a report, its steps no longer count.
const FINISH: &str = "UPDATE jobs SET state = $4, finished_at = $5, has_report = $6, failure = $7,
         iterations = iterations + $8, latest = coalesce($9, latest),
         steps = CASE WHEN $6 THEN coalesce($10, steps) ELSE 0 END,
         stored_bytes = CASE WHEN NOT $6 THEN 0 WHEN $12 THEN $11 ELSE stored_bytes + $11 END,
         owner = NULL, leased_until = NULL
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'";
const REPORT: &str = "INSERT INTO reports (job, body) VALUES ($1, $2)";
const RELEASE: &str = "UPDATE jobs SET
         state = CASE WHEN cancel_requested THEN 'cancelled' ELSE 'queued' END,
         finished_at = CASE WHEN cancel_requested THEN $4 END,
         started_at = CASE WHEN cancel_requested THEN started_at END,
         owner = NULL, leased_until = NULL,
         iterations = CASE WHEN cancel_requested THEN iterations ELSE 0 END,
         latest = CASE WHEN cancel_requested THEN latest END, steps = 0, stored_bytes = 0
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'
     RETURNING cancel_requested";
const STEPS: &str = "UPDATE jobs SET steps = coalesce($4, steps),
         stored_bytes = CASE WHEN $6 THEN $5 WHEN $4 <= steps THEN stored_bytes
             ELSE stored_bytes + $5 END
     WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'";
const HAS_STEPS: &str = "SELECT EXISTS (SELECT 1 FROM result_steps WHERE job = $1)";

/// Inserts a row of a job if the lease holds. A repeated write, after its acknowledgement was
/// lost, changes nothing. The row of the job is not locked against its heartbeat.
macro_rules! insert {
    ($table:literal, $key:literal, $values:literal, $update:literal, $share:literal) => {
        concat!(
            "INSERT INTO ",
            $table,
            " SELECT id, ",
            $values,
            " FROM jobs WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'",
            $share,
            " ON CONFLICT (",
            $key,
            ") DO UPDATE SET ",
            $update
        )
    };
}

/// Changes by the holder of a lease.
pub(in crate::store) trait Leasing: Send {
    /// Extends the leases of one worker.
    fn heartbeat(
        &mut self,
        leases: &[Lease],
        lease: Duration,
        now: Option<i64>,
    ) -> impl Future<Output = Result<Vec<LeaseStatus>, StoreError>> + Send;
    fn record_progress(
        &mut self,
        lease: &Lease,
        records: &[IterationRecord],
        latest: &IterationRecord,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Appends iterations, without counting them.
    fn append_records(
        &mut self,
        lease: &Lease,
        records: &[IterationRecord],
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Writes results of steps, part by part, without counting them; removes all earlier steps if
    /// these begin anew.
    fn append_steps(
        &mut self,
        lease: &Lease,
        steps: &[StepResult],
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Counts steps that are written.
    fn count_steps(
        &mut self,
        lease: &Lease,
        steps: &[StepResult],
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Ends a job; `records` and `steps` are written, but not counted yet.
    fn finish(
        &mut self,
        lease: &Lease,
        records: &[IterationRecord],
        steps: &[StepResult],
        outcome: &Outcome,
        now: i64,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn forget_steps(&mut self, job: JobId) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Returns a job to the queue. The result is `Some(true)` if the job was cancelled instead,
    /// `None` if the lease was lost.
    fn release(
        &mut self,
        lease: &Lease,
        now: i64,
    ) -> impl Future<Output = Result<Option<bool>, StoreError>> + Send;
}

fn number_of<T>(items: &[T]) -> i32 {
    i32::try_from(items.len()).unwrap_or(i32::MAX)
}

/// An error if a statement has met no job, whose lease is lost then.
fn held(rows: u64) -> Result<(), StoreError> {
    if rows == 0 { Err(StoreError::LeaseLost) } else { Ok(()) }
}

/// Returns the number of steps of the job with these (`None` without any), the bytes of these, and
/// whether they replace all earlier ones.
fn sum_up(steps: &[StepResult]) -> (Option<i32>, i64, bool) {
    let bytes =
        i64::try_from(steps.iter().map(StepResult::bytes).sum::<usize>()).unwrap_or(i64::MAX);
    let count = steps.last().map(|last| i32::try_from(last.number + 1).unwrap_or(i32::MAX));
    (count, bytes, steps.first().is_some_and(|first| first.number == 0))
}

macro_rules! fenced {
    ($query:expr, $lease:expr) => {{
        let lease: &Lease = $lease;
        let attempt = i32::try_from(lease.attempt).unwrap_or(i32::MAX);
        $query.bind(lease.job.uuid()).bind(lease.owner.uuid()).bind(attempt)
    }};
}

macro_rules! leasing {
    ($database:ty, $connection:ty, $now:literal, $lock:literal, $share:literal) => {
        impl Leasing for $connection {
            async fn heartbeat(
                &mut self,
                leases: &[Lease],
                lease: Duration,
                now: Option<i64>,
            ) -> Result<Vec<LeaseStatus>, StoreError> {
                let Some(first) = leases.first() else { return Ok(Vec::new()) };
                let ours = |before: &str, query: &mut QueryBuilder<$database>| {
                    query
                        .push(before)
                        .push_bind(first.owner.uuid())
                        .push(" AND state = 'running' AND id IN (");
                    let mut among = query.separated(", ");
                    for lease in leases {
                        among.push_bind(lease.job.uuid());
                    }
                    query.push(")");
                };
                let mut beat = QueryBuilder::new("UPDATE jobs SET leased_until = ");
                beat.push("coalesce(").push_bind(now).push(concat!(", ", $now, ") + "));
                beat.push_bind(until(0, lease)).push(" WHERE id IN (");
                ours("SELECT id FROM jobs WHERE owner = ", &mut beat);
                beat.push($lock).push(")").build().execute(&mut *self).await?;
                let mut look = QueryBuilder::new("");
                ours("SELECT id, attempts, cancel_requested FROM jobs WHERE owner = ", &mut look);
                let rows: Vec<(Uuid, i32, bool)> = look.build_query_as().fetch_all(self).await?;
                let status_of = |lease: &Lease| {
                    let row = rows.iter().find(|(id, attempts, _)| {
                        *id == lease.job.uuid() && u32::try_from(*attempts) == Ok(lease.attempt)
                    });
                    row.map_or(LeaseStatus::Lost, |(.., cancel_requested)| LeaseStatus::Held {
                        cancel_requested: *cancel_requested,
                    })
                };
                Ok(leases.iter().map(status_of).collect())
            }

            async fn record_progress(
                &mut self,
                lease: &Lease,
                records: &[IterationRecord],
                latest: &IterationRecord,
            ) -> Result<(), StoreError> {
                self.append_records(lease, records).await?;
                let progress = fenced!(sqlx::query::<$database>(PROGRESS), lease);
                let progress = progress.bind(number_of(records)).bind(to_json(latest)?);
                held(progress.execute(self).await?.rows_affected())
            }

            async fn append_records(
                &mut self,
                lease: &Lease,
                records: &[IterationRecord],
            ) -> Result<(), StoreError> {
                let mut first = 0;
                for page in records.chunks(HISTORY_PAGE) {
                    let append = sqlx::query::<$database>(insert!(
                        "iterations (job, first, last, records)",
                        "job, first",
                        "iterations + $4, iterations + $5, $6",
                        "last = excluded.last, records = excluded.records",
                        $share
                    ));
                    let last = first + number_of(page);
                    let append = fenced!(append, lease).bind(first).bind(last);
                    let append = append.bind(pack_records(page)?).execute(&mut *self).await?;
                    held(append.rows_affected())?;
                    first = last;
                }
                Ok(())
            }

            async fn append_steps(
                &mut self,
                lease: &Lease,
                steps: &[StepResult],
            ) -> Result<(), StoreError> {
                let has_steps = sqlx::query_scalar::<$database, bool>(HAS_STEPS);
                if steps.first().is_some_and(|first| first.number == 0)
                    && has_steps.bind(lease.job.uuid()).fetch_one(&mut *self).await?
                {
                    self.count_steps(lease, &[]).await?;
                    self.forget_steps(lease.job).await?;
                }
                for step in steps {
                    let number = i32::try_from(step.number).unwrap_or(i32::MAX);
                    let fields = step.fields.as_deref().unwrap_or_default();
                    for (part, first) in
                        fields.chunks(FIELDS_PART).zip((0_i64..).step_by(FIELDS_PART))
                    {
                        let insert = sqlx::query::<$database>(insert!(
                            "field_parts (job, step, first, body)",
                            "job, step, first",
                            "$4, $5, $6",
                            "body = excluded.body",
                            $share
                        ));
                        let insert = fenced!(insert, lease).bind(number).bind(first).bind(part);
                        held(insert.execute(&mut *self).await?.rows_affected())?;
                    }
                    // Fields are found through this row, which is therefore the last one.
                    let insert = sqlx::query::<$database>(insert!(
                        "result_steps (job, step, body)",
                        "job, step",
                        "$4, $5",
                        "body = excluded.body",
                        $share
                    ));
                    let report = step.report.clone().into_bytes();
                    let insert = fenced!(insert, lease).bind(number).bind(&report[..]);
                    held(insert.execute(&mut *self).await?.rows_affected())?;
                }
                Ok(())
            }

            async fn count_steps(
                &mut self,
                lease: &Lease,
                steps: &[StepResult],
            ) -> Result<(), StoreError> {
                let (count, bytes, begin_anew) = sum_up(steps);
                let recorded = fenced!(sqlx::query::<$database>(STEPS), lease);
                let recorded = recorded.bind(count).bind(bytes).bind(begin_anew);
                held(recorded.execute(self).await?.rows_affected())
            }

            async fn finish(
                &mut self,
                lease: &Lease,
                records: &[IterationRecord],
                steps: &[StepResult],
                outcome: &Outcome,
                now: i64,
            ) -> Result<(), StoreError> {
                let (report, failure) = match outcome {
                    Outcome::Reported { report, .. } => (Some(report), None),
                    Outcome::Failed(failure) => (None, Some(failure_json(failure)?)),
                    Outcome::Interrupted(_) => (None, None),
                };
                let (count, bytes, begin_anew) = sum_up(steps);
                let finish = fenced!(sqlx::query::<$database>(FINISH), lease);
                let finish = finish
                    .bind(outcome.state().name())
                    .bind(now)
                    .bind(report.is_some())
                    .bind(failure);
                let finish =
                    finish.bind(number_of(records)).bind(records.last().map(to_json).transpose()?);
                let finish = finish.bind(count).bind(bytes).bind(begin_anew);
                held(finish.execute(&mut *self).await?.rows_affected())?;
                if let Some(report) = report {
                    let report = sqlx::query::<$database>(REPORT)
                        .bind(lease.job.uuid())
                        .bind(pack(report)?);
                    report.execute(&mut *self).await?;
                } else {
                    self.forget_steps(lease.job).await?;
                }
                // The row of the key is locked last, for as short as can be.
                let settle = sqlx::query::<$database>(SETTLE).bind(lease.job.uuid()).bind(now);
                settle.execute(self).await?;
                Ok(())
            }

            async fn forget_steps(&mut self, job: JobId) -> Result<(), StoreError> {
                let [_, steps, fields] = FORGET;
                for statement in [steps, fields] {
                    sqlx::query::<$database>(statement)
                        .bind(job.uuid())
                        .execute(&mut *self)
                        .await?;
                }
                Ok(())
            }

            async fn release(
                &mut self,
                lease: &Lease,
                now: i64,
            ) -> Result<Option<bool>, StoreError> {
                let release = fenced!(sqlx::query_scalar::<$database, bool>(RELEASE), lease);
                let cancelled = release.bind(now).fetch_optional(&mut *self).await?;
                let forgotten = match cancelled {
                    Some(false) => &FORGET[..],
                    Some(true) => &FORGET[1..],
                    None => &[],
                };
                for forget in forgotten {
                    sqlx::query::<$database>(*forget)
                        .bind(lease.job.uuid())
                        .execute(&mut *self)
                        .await?;
                }
                Ok(cancelled)
            }
        }
    };
}

leasing!(Sqlite, SqliteConnection, "0", "", "");
// SKIP LOCKED passes over a row that another transaction changes; the next heartbeat renews it.
leasing!(
    Postgres,
    PgConnection,
    "(extract(epoch FROM clock_timestamp()) * 1000000)::bigint",
    " FOR NO KEY UPDATE SKIP LOCKED",
    " FOR KEY SHARE"
);
