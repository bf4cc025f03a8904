//! Statements that only read.

use bytes::Bytes;
use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{JobRow, count, damaged, job_columns, job_record, state_named, unpack};
use crate::jobs::{
    Counts, Deflated, FieldsPart, HISTORY_PAGE, JobId, JobRecord, ResultHead, StoreError,
};

/// One job with its place in the queue.
const FIND: &str = concat!(
    "SELECT ",
    job_columns!(),
    ", CASE WHEN j.state = 'queued' THEN (SELECT count(*) FROM jobs q
       WHERE q.state = 'queued' AND q.account = j.account
       AND (q.priority > j.priority OR (q.priority = j.priority AND q.id < j.id))) END
     FROM jobs j WHERE j.id = $1"
);

const EXISTS: &str = "SELECT id FROM jobs WHERE id = $1";
const IDS_AFTER: &str = "SELECT id FROM jobs WHERE id > $1 ORDER BY id LIMIT $2";
const HISTORY: &str = "SELECT first, records FROM iterations WHERE job = $1 AND last > $2 AND \
                       first < $2 + $3 ORDER BY first";
const REQUEST: &str =
    "SELECT r.body FROM jobs j LEFT JOIN requests r ON r.job = j.id WHERE j.id = $1";
const RESULT: &str = "SELECT r.body, j.steps, j.attempts,
     EXISTS (SELECT 1 FROM field_parts f WHERE f.job = j.id)
     FROM jobs j LEFT JOIN reports r ON r.job = j.id WHERE j.id = $1";
const STEP: &str = "SELECT body FROM result_steps WHERE job = $1 AND step = $2";
const FIELDS: &str = "SELECT f.first, f.body FROM result_steps s
     LEFT JOIN field_parts f ON f.job = s.job AND f.step = s.step
         AND f.first = (SELECT max(p.first) FROM field_parts p
             WHERE p.job = s.job AND p.step = s.step AND p.first <= $3)
     WHERE s.job = $1 AND s.step = $2";
const HEALTH_ROWS: &str = "SELECT count(*) FROM health";
const WITHOUT_ACCOUNT: &str = "SELECT id FROM jobs WHERE state = 'queued'
     AND NOT EXISTS (SELECT 1 FROM accounts a WHERE a.id = jobs.account) ORDER BY id";
const COUNTS: &str =
    "SELECT state, count(*) FROM jobs WHERE state IN ('queued', 'running') GROUP BY state";

type ResultRow = (Option<Vec<u8>>, i32, i32, bool);

/// A row of iterations: the number of the first, counted from 0, and the compressed records.
pub(super) type PackedRecords = (i32, Vec<u8>);

/// Queries on a connection.
pub(in crate::store) trait Reading: Send {
    fn find(&mut self, id: JobId) -> impl Future<Output = Result<JobRecord, StoreError>> + Send;
    fn history(
        &mut self,
        id: JobId,
        after: usize,
    ) -> impl Future<Output = Result<Vec<PackedRecords>, StoreError>> + Send;
    fn request(&mut self, id: JobId) -> impl Future<Output = Result<Bytes, StoreError>> + Send;
    fn result(
        &mut self,
        id: JobId,
    ) -> impl Future<Output = Result<Option<ResultHead>, StoreError>> + Send;
    fn step(
        &mut self,
        id: JobId,
        step: usize,
    ) -> impl Future<Output = Result<Deflated, StoreError>> + Send;
    fn fields(
        &mut self,
        id: JobId,
        step: usize,
        at: usize,
    ) -> impl Future<Output = Result<Option<FieldsPart>, StoreError>> + Send;
    /// Returns the ids of the jobs after `id`, in order.
    fn ids_after(
        &mut self,
        id: JobId,
        limit: i64,
    ) -> impl Future<Output = Result<Vec<JobId>, StoreError>> + Send;
    /// Checks the tables that concern all jobs; returns one line for each fault.
    fn check_tables(&mut self) -> impl Future<Output = Result<Vec<String>, StoreError>> + Send;
    fn counts(&mut self) -> impl Future<Output = Result<Counts, StoreError>> + Send;
}

// Both databases run the same statements, with different types of sqlx: a generic function would
// need a page of trait bounds, a macro needs none.
macro_rules! reading {
    ($database:ty, $connection:ty) => {
        impl Reading for $connection {
            async fn find(&mut self, id: JobId) -> Result<JobRecord, StoreError> {
                let row = sqlx::query_as::<$database, JobRow>(FIND).bind(id.uuid());
                row.fetch_optional(self).await?.map_or(Err(StoreError::NotFound), job_record)
            }

            async fn history(
                &mut self,
                id: JobId,
                after: usize,
            ) -> Result<Vec<PackedRecords>, StoreError> {
                let found = sqlx::query_scalar::<$database, Uuid>(EXISTS).bind(id.uuid());
                found.fetch_optional(&mut *self).await?.ok_or(StoreError::NotFound)?;
                let [after, page] = [after, HISTORY_PAGE]
                    .map(|count| i32::try_from(count).unwrap_or(i32::MAX / 2));
                let rows = sqlx::query_as::<$database, PackedRecords>(HISTORY).bind(id.uuid());
                Ok(rows.bind(after).bind(page).fetch_all(self).await?)
            }

            async fn request(&mut self, id: JobId) -> Result<Bytes, StoreError> {
                let row =
                    sqlx::query_scalar::<$database, Option<Vec<u8>>>(REQUEST).bind(id.uuid());
                let packed = row.fetch_optional(self).await?.ok_or(StoreError::NotFound)?;
                unpack(packed.ok_or_else(|| damaged("no text"))?)
            }

            async fn result(&mut self, id: JobId) -> Result<Option<ResultHead>, StoreError> {
                let row = sqlx::query_as::<$database, ResultRow>(RESULT).bind(id.uuid());
                let row = row.fetch_optional(self).await?.ok_or(StoreError::NotFound)?;
                let (body, steps, attempts, has_fields) = row;
                let Some(report) = body.map(unpack).transpose()? else { return Ok(None) };
                let (steps, attempt) = (count(steps)?, count(attempts)?);
                Ok(Some(ResultHead { report, steps, has_fields, attempt }))
            }

            async fn step(&mut self, id: JobId, step: usize) -> Result<Deflated, StoreError> {
                let step = i32::try_from(step).unwrap_or(i32::MAX);
                let row =
                    sqlx::query_scalar::<$database, Vec<u8>>(STEP).bind(id.uuid()).bind(step);
                let body = row.fetch_optional(self).await?.ok_or(StoreError::NotFound)?;
                Deflated::from_bytes(body.into()).ok_or_else(|| damaged("a step"))
            }

            async fn fields(
                &mut self,
                id: JobId,
                step: usize,
                at: usize,
            ) -> Result<Option<FieldsPart>, StoreError> {
                let step = i32::try_from(step).unwrap_or(i32::MAX);
                let row = sqlx::query_as::<$database, (Option<i64>, Option<Vec<u8>>)>(FIELDS)
                    .bind(id.uuid());
                let row = row.bind(step).bind(i64::try_from(at).unwrap_or(i64::MAX));
                let (first, body) = row.fetch_optional(self).await?.ok_or(StoreError::NotFound)?;
                let Some((first, body)) = first.zip(body) else { return Ok(None) };
                Ok(Some(FieldsPart { first: count(first)?, bytes: body.into() }))
            }

            async fn ids_after(
                &mut self,
                id: JobId,
                limit: i64,
            ) -> Result<Vec<JobId>, StoreError> {
                let ids =
                    sqlx::query_scalar::<$database, Uuid>(IDS_AFTER).bind(id.uuid()).bind(limit);
                Ok(ids.fetch_all(self).await?.into_iter().map(JobId::from).collect())
            }

            async fn check_tables(&mut self) -> Result<Vec<String>, StoreError> {
                let mut found = Vec::new();
                let rows = sqlx::query_scalar::<$database, i64>(HEALTH_ROWS)
                    .fetch_one(&mut *self)
                    .await?;
                if rows != 1 {
                    found.push(format!("table health: {rows} rows instead of one"));
                }
                let lost =
                    sqlx::query_scalar::<$database, Uuid>(WITHOUT_ACCOUNT).fetch_all(self).await?;
                let line =
                    |id| format!("job {}: it is queued where nobody looks", JobId::from(id));
                found.extend(lost.into_iter().map(line));
                Ok(found)
            }

            async fn counts(&mut self) -> Result<Counts, StoreError> {
                let rows =
                    sqlx::query_as::<$database, (String, i64)>(COUNTS).fetch_all(self).await?;
                rows.into_iter()
                    .map(|(state, jobs)| Ok((state_named(&state)?, count(jobs)?)))
                    .collect()
            }
        }
    };
}

reading!(Sqlite, SqliteConnection);
reading!(Postgres, PgConnection);
