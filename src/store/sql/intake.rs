//! Statements that submit, cancel and remove jobs.

use std::collections::BTreeMap;

use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{count, damaged, pack, to_json};
use super::deliveries::Deliveries;
use super::keys::Keys;
use super::reading::Reading;
use crate::jobs::{
    Enqueued, Idempotency, JobId, JobRecord, JobState, KeyLimits, NewJob, Quota, Retention, SWEEP,
    StoreError,
};
use crate::store::StoreLimits;

const TAKE_NAME: &str =
    "INSERT INTO idempotency_keys (submitter, name, digest, job) VALUES ($1, $2, $3, $4)
     ON CONFLICT DO NOTHING";
const KNOWN: &str = "SELECT digest, job FROM idempotency_keys WHERE submitter = $1 AND name = $2";
const INSERT: &str = "INSERT INTO jobs (id, state, priority, memory, tags, submitter, created_at,
         reserved_bytes, account, traceparent)
     VALUES ($1, 'queued', $2, $3, $4, $5, $6, $7, $8, $9)";
const ACCOUNT: &str = "INSERT INTO accounts (id) VALUES ($1) ON CONFLICT DO NOTHING";
/// Selects the number of queued jobs, the number of queued jobs of one submitter, the bytes that
/// the submitter's results take or will take, and whether the submitter has an account.
const PLACES: &str = "SELECT (SELECT count(*) FROM jobs WHERE state = 'queued'),
         CASE WHEN $2 THEN (SELECT count(*) FROM jobs WHERE state = 'queued' AND account = $1)
             ELSE 0 END,
         CASE WHEN $3 THEN (SELECT CAST(coalesce(sum(
                 CASE WHEN finished_at IS NOT NULL OR stored_bytes > reserved_bytes
                     THEN stored_bytes ELSE reserved_bytes END), 0) AS BIGINT)
             FROM jobs WHERE submitter = $1) ELSE 0 END,
         EXISTS (SELECT 1 FROM accounts WHERE id = $1)";
const REQUEST: &str = "INSERT INTO requests (job, body) VALUES ($1, $2)";
const TAG: &str = "INSERT INTO job_tags (job, name, value) VALUES ($1, $2, $3)";
const CANCEL: &str = "UPDATE jobs SET cancel_requested = TRUE,
         finished_at = CASE WHEN state = 'queued' THEN $2 ELSE finished_at END,
         state = CASE WHEN state = 'queued' THEN 'cancelled' ELSE state END
     WHERE id = $1 AND state IN ('queued', 'running')";
const HEALTH: &str = "UPDATE health SET written_at = $1";
const DELETE: &str = "DELETE FROM jobs WHERE id = $1 AND state NOT IN ('queued', 'running')";
const SWEEP_OLD: &str =
    "DELETE FROM jobs WHERE id IN (SELECT id FROM jobs WHERE finished_at IS NOT NULL
         AND finished_at <= CASE WHEN state IN ('succeeded', 'not_converged') THEN $1 ELSE $2 END
     ORDER BY finished_at LIMIT $3)";

/// Jobs that concurrent, uncommitted transactions may be inserting: a batch on each connection of
/// several servers. Where the queue has less room than this, submissions are serialized so that
/// each counts the others' jobs.
const ON_THEIR_WAY: usize = 4000;

/// Commands about a savepoint of a transaction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Savepoint {
    /// Set the savepoint.
    Set,
    /// Keep the changes since the savepoint.
    Release,
    /// Undo the changes since the savepoint.
    RollBack,
}

impl Savepoint {
    const fn statement(self) -> &'static str {
        match self {
            Self::Set => "SAVEPOINT job",
            Self::Release => "RELEASE SAVEPOINT job",
            Self::RollBack => "ROLLBACK TO SAVEPOINT job",
        }
    }
}

/// Changes that clients ask for.
pub(in crate::store) trait Intake: Reading + Keys + Deliveries {
    fn enqueue(
        &mut self,
        job: NewJob,
        limits: StoreLimits,
        now: i64,
    ) -> impl Future<Output = Result<Enqueued, StoreError>> + Send;
    /// Sets, releases or rolls back to the savepoint.
    fn savepoint(
        &mut self,
        step: Savepoint,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Checks a job against the length of the queue and the limits of its key; returns whether its
    /// submitter has an account.
    fn check_places(
        &mut self,
        owner: Uuid,
        job: &NewJob,
        limits: StoreLimits,
        key: KeyLimits,
    ) -> impl Future<Output = Result<bool, StoreError>> + Send;
    fn label(
        &mut self,
        job: JobId,
        tags: BTreeMap<String, String>,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Returns the job that was submitted with this idempotency key before; without one, records
    /// the key for `job`.
    fn replay(
        &mut self,
        job: JobId,
        submitter: Uuid,
        name: &Idempotency,
    ) -> impl Future<Output = Result<Option<JobRecord>, StoreError>> + Send;
    fn cancel(
        &mut self,
        id: JobId,
        now: i64,
    ) -> impl Future<Output = Result<JobRecord, StoreError>> + Send;
    /// Writes one row to show that the database accepts writes.
    fn record_health(&mut self, now: i64) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn delete(&mut self, id: JobId) -> impl Future<Output = Result<(), StoreError>> + Send;
    /// Removes the jobs whose time is over, and those of `surplus`.
    fn sweep(
        &mut self,
        retention: &Retention,
        surplus: &[JobId],
        now: i64,
    ) -> impl Future<Output = Result<usize, StoreError>> + Send;
}

/// Returns the time before which a job must have finished to be removed.
fn cutoff(now: i64, keep: std::time::Duration) -> i64 {
    now.saturating_sub(i64::try_from(keep.as_micros()).unwrap_or(i64::MAX))
}

macro_rules! intake {
    ($database:ty, $connection:ty) => {
        impl Intake for $connection {
            async fn enqueue(
                &mut self,
                job: NewJob,
                limits: StoreLimits,
                now: i64,
            ) -> Result<Enqueued, StoreError> {
                let submitter = job.submitter.map(|key| key.uuid());
                // The lock comes before the idempotency key is recorded, so that a transaction
                // that waits for the key never blocks its owner.
                let limits_of_key = match job.submitter {
                    Some(key) => self.lock_key(key, now).await?.or(limits.by_key),
                    None => {
                        self.lock_intake().await?;
                        KeyLimits::default()
                    }
                };
                if let Some(name) = &job.idempotency
                    && let Some(job) =
                        self.replay(job.id, submitter.unwrap_or_default(), name).await?
                {
                    return Ok(Enqueued { job, replayed: true });
                }
                let owner = submitter.unwrap_or_default();
                if !self.check_places(owner, &job, limits, limits_of_key).await? {
                    sqlx::query::<$database>(ACCOUNT).bind(owner).execute(&mut *self).await?;
                }
                sqlx::query::<$database>(INSERT)
                    .bind(job.id.uuid())
                    .bind(i32::from(job.priority))
                    .bind(i64::try_from(job.memory).unwrap_or(i64::MAX))
                    .bind(to_json(&job.tags)?)
                    .bind(submitter)
                    .bind(now)
                    .bind(i64::try_from(job.result_bytes).unwrap_or(i64::MAX))
                    .bind(owner)
                    .bind(job.trace.map(|trace| trace.to_string()))
                    .execute(&mut *self)
                    .await?;
                let request = sqlx::query::<$database>(REQUEST)
                    .bind(job.id.uuid())
                    .bind(pack(&job.request)?);
                request.execute(&mut *self).await?;
                self.label(job.id, job.tags).await?;
                if let Some(url) = job.callback_url {
                    self.add_callback(job.id, url).await?;
                }
                Ok(Enqueued { job: self.find(job.id).await?, replayed: false })
            }

            async fn savepoint(&mut self, step: Savepoint) -> Result<(), StoreError> {
                sqlx::query::<$database>(step.statement()).execute(self).await?;
                Ok(())
            }

            async fn check_places(
                &mut self,
                owner: Uuid,
                job: &NewJob,
                limits: StoreLimits,
                key: KeyLimits,
            ) -> Result<bool, StoreError> {
                let (by_count, by_size) = (key.queued.is_some(), key.stored_bytes.is_some());
                let places = || {
                    let places = sqlx::query_as::<$database, (i64, i64, i64, bool)>(PLACES);
                    places.bind(owner).bind(by_count).bind(by_size)
                };
                let mut found = places().fetch_one(&mut *self).await?;
                let is_nearly_full = count::<_, usize>(found.0)?.saturating_add(ON_THEIR_WAY)
                    >= limits.queue_capacity;
                // A submission without a key already holds this lock.
                if is_nearly_full && job.submitter.is_some() {
                    self.lock_intake().await?;
                    found = places().fetch_one(&mut *self).await?;
                }
                let (queued, queued_by_key, used, has_account) = found;
                let queued: usize = count(queued)?;
                if queued >= limits.queue_capacity {
                    return Err(StoreError::QueueFull { queued });
                }
                let (queued_by_key, used, needed) =
                    (count::<_, u64>(queued_by_key)?, count(used)?, job.result_bytes);
                let is_low = |limit: &i16| !job.interactive && job.priority > *limit;
                let quota = if let Some(limit) = key.priority.filter(is_low) {
                    Quota::Priority { limit }
                } else if let Some(limit) =
                    key.queued.filter(|limit| queued_by_key >= u64::from(*limit))
                {
                    Quota::Queued { limit }
                } else if let Some(limit) =
                    key.stored_bytes.filter(|limit| needed.saturating_add(used) > *limit)
                {
                    Quota::Stored { limit, used, needed }
                } else {
                    return Ok(has_account);
                };
                Err(StoreError::QuotaExceeded { quota })
            }

            async fn label(
                &mut self,
                job: JobId,
                tags: BTreeMap<String, String>,
            ) -> Result<(), StoreError> {
                for (name, value) in tags {
                    let tag =
                        sqlx::query::<$database>(TAG).bind(job.uuid()).bind(name).bind(value);
                    tag.execute(&mut *self).await?;
                }
                Ok(())
            }

            async fn replay(
                &mut self,
                job: JobId,
                submitter: Uuid,
                name: &Idempotency,
            ) -> Result<Option<JobRecord>, StoreError> {
                let taken = sqlx::query::<$database>(TAKE_NAME)
                    .bind(submitter)
                    .bind(name.key.clone())
                    .bind(name.digest.to_vec())
                    .bind(job.uuid())
                    .execute(&mut *self)
                    .await?;
                if taken.rows_affected() == 1 {
                    return Ok(None);
                }
                let known = sqlx::query_as::<$database, (Vec<u8>, Uuid)>(KNOWN)
                    .bind(submitter)
                    .bind(name.key.clone())
                    .fetch_optional(&mut *self)
                    .await?;
                // Another transaction is removing the job: the client may retry.
                let gone =
                    || StoreError::unavailable("the job of this idempotency key is being removed");
                let (digest, first) = known.ok_or_else(gone)?;
                if digest != name.digest {
                    return Err(StoreError::KeyReused);
                }
                self.find(JobId::from(first)).await.map(Some)
            }

            async fn cancel(&mut self, id: JobId, now: i64) -> Result<JobRecord, StoreError> {
                sqlx::query::<$database>(CANCEL)
                    .bind(id.uuid())
                    .bind(now)
                    .execute(&mut *self)
                    .await?;
                self.find(id).await
            }

            async fn record_health(&mut self, now: i64) -> Result<(), StoreError> {
                let written = sqlx::query::<$database>(HEALTH).bind(now).execute(self).await?;
                if written.rows_affected() == 1 {
                    Ok(())
                } else {
                    Err(damaged("a table that has one row has none, or several"))
                }
            }

            async fn delete(&mut self, id: JobId) -> Result<(), StoreError> {
                let done =
                    sqlx::query::<$database>(DELETE).bind(id.uuid()).execute(&mut *self).await?;
                if done.rows_affected() == 1 {
                    return Ok(());
                }
                match self.find(id).await?.state {
                    state @ (JobState::Queued | JobState::Running) => {
                        Err(StoreError::Unfinished(state))
                    }
                    // The job finished between the two statements: the client may retry.
                    _ => Err(StoreError::Unfinished(JobState::Running)),
                }
            }

            async fn sweep(
                &mut self,
                retention: &Retention,
                surplus: &[JobId],
                now: i64,
            ) -> Result<usize, StoreError> {
                let done = sqlx::query::<$database>(SWEEP_OLD)
                    .bind(cutoff(now, retention.succeeded))
                    .bind(cutoff(now, retention.failed))
                    .bind(i64::try_from(SWEEP).unwrap_or(i64::MAX))
                    .execute(&mut *self)
                    .await?;
                let mut swept: usize = count(done.rows_affected())?;
                for job in surplus {
                    let done =
                        sqlx::query::<$database>(DELETE).bind(job.uuid()).execute(&mut *self);
                    swept += count::<_, usize>(done.await?.rows_affected())?;
                }
                Ok(swept)
            }
        }
    };
}

intake!(Sqlite, SqliteConnection);
intake!(Postgres, PgConnection);
