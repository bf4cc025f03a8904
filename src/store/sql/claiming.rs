//! Statements that hand jobs out. They run in one transaction; what they read stays locked until its end, and what
//! another worker has locked is passed over.

use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{count, failure_json, unpack};
use crate::jobs::{Claim, ClaimRequest, Claims, JobFailure, JobId, JobState, Lease, StoreError};

/// A job that might be handed out: name, estimated memory, losses so far.
type Candidate = (Uuid, i64, i32);

const END: &str =
    "UPDATE jobs SET state = $2, failure = $3, finished_at = $4, owner = NULL, leased_until = NULL
     WHERE id = $1";
/// Removes what an attempt has left.
pub(super) const FORGET: [&str; 3] = [
    "DELETE FROM iterations WHERE job = $1",
    "DELETE FROM result_steps WHERE job = $1",
    "DELETE FROM result_fields WHERE job = $1",
];
const LEASE_JOB: &str = "UPDATE jobs SET state = 'running', owner = $2, leased_until = $3, started_at = $4,
         losses = $5, attempts = attempts + 1, iterations = 0, latest = NULL,
         steps = 0, stored_bytes = 0
     WHERE id = $1 RETURNING attempts";
const REQUEST: &str = "SELECT body FROM requests WHERE job = $1";

/// Handing out.
pub(in crate::store) trait Claiming: Send {
    /// Ends the jobs whose lease ran out and that nobody takes up again.
    fn expire(
        &mut self,
        max_attempts: u32,
        now: i64,
    ) -> impl Future<Output = Result<Vec<JobId>, StoreError>> + Send;
    fn claim(
        &mut self,
        request: &ClaimRequest,
        now: i64,
    ) -> impl Future<Output = Result<Claims, StoreError>> + Send;
    fn lease_job(
        &mut self,
        job: Candidate,
        exclusive: bool,
        request: &ClaimRequest,
        now: i64,
    ) -> impl Future<Output = Result<Claim, StoreError>> + Send;
}

/// The moment a lease that begins now runs out.
pub(super) fn until(now: i64, lease: std::time::Duration) -> i64 {
    now.saturating_add(i64::try_from(lease.as_micros()).unwrap_or(i64::MAX))
}

macro_rules! claiming {
    ($database:ty, $connection:ty, $lock:literal) => {
        impl Claiming for $connection {
            async fn expire(&mut self, max_attempts: u32, now: i64) -> Result<Vec<JobId>, StoreError> {
                let lost = sqlx::query_as::<$database, (Uuid, i32, bool)>(concat!(
                    "SELECT id, losses, cancel_requested FROM jobs WHERE state = 'running' AND leased_until <= $1
                       AND (cancel_requested OR losses + 1 >= $2)",
                    $lock
                ));
                let max_attempts = i32::try_from(max_attempts).unwrap_or(i32::MAX);
                let lost = lost.bind(now).bind(max_attempts).fetch_all(&mut *self).await?;
                let mut ended = Vec::with_capacity(lost.len());
                for (id, losses, cancelled) in lost {
                    let (state, failure) = if cancelled {
                        (JobState::Cancelled, None)
                    } else {
                        let failure = JobFailure::lost(count(losses.saturating_add(1))?);
                        (JobState::Failed, Some(failure_json(&failure)?))
                    };
                    let end = sqlx::query::<$database>(END).bind(id).bind(state.name()).bind(failure);
                    end.bind(now).execute(&mut *self).await?;
                    ended.push(JobId::from(id));
                }
                Ok(ended)
            }

            async fn claim(&mut self, request: &ClaimRequest, now: i64) -> Result<Claims, StoreError> {
                let memory = i64::try_from(request.memory).unwrap_or(i64::MAX);
                let slots = i64::try_from(request.slots).unwrap_or(i64::MAX);
                let lost = sqlx::query_as::<$database, Candidate>(concat!(
                    "SELECT id, memory, losses FROM jobs WHERE state = 'running' AND leased_until <= $1
                       AND memory <= $2 ORDER BY losses, id LIMIT $3",
                    $lock
                ));
                let lost = lost.bind(now).bind(memory).bind(slots.saturating_add(1)).fetch_all(&mut *self).await?;
                let (exclusive, mut candidates): (Vec<Candidate>, Vec<Candidate>) = lost
                    .into_iter()
                    .partition(|(_, _, losses)| i64::from(*losses) + 2 >= i64::from(request.max_attempts));
                if let (Some(job), true) = (exclusive.first(), request.exclusive) {
                    let jobs = vec![self.lease_job(*job, true, request, now).await?];
                    return Ok(Claims { jobs, exclusive_pending: false });
                }
                let queued = sqlx::query_as::<$database, Candidate>(concat!(
                    "SELECT id, memory, losses - 1 FROM jobs WHERE state = 'queued' AND memory <= $1
                     ORDER BY priority DESC, id LIMIT $2",
                    $lock
                ));
                candidates.extend(queued.bind(memory).bind(slots).fetch_all(&mut *self).await?);
                let mut claims = Claims { jobs: Vec::new(), exclusive_pending: !exclusive.is_empty() };
                let mut free = request.free_memory;
                for job in candidates.into_iter().take(request.slots) {
                    let Some(rest) = free.checked_sub(count(job.1)?) else { break };
                    free = rest;
                    claims.jobs.push(self.lease_job(job, false, request, now).await?);
                }
                Ok(claims)
            }

            async fn lease_job(
                &mut self,
                job: Candidate,
                exclusive: bool,
                request: &ClaimRequest,
                now: i64,
            ) -> Result<Claim, StoreError> {
                let (id, memory, losses) = job;
                let attempt = sqlx::query_scalar::<$database, i32>(LEASE_JOB)
                    .bind(id)
                    .bind(request.owner.uuid())
                    .bind(until(now, request.lease))
                    .bind(now)
                    .bind(losses.saturating_add(1))
                    .fetch_one(&mut *self)
                    .await?;
                if attempt > 1 {
                    for forget in FORGET {
                        sqlx::query::<$database>(forget).bind(id).execute(&mut *self).await?;
                    }
                }
                let text = sqlx::query_scalar::<$database, Vec<u8>>(REQUEST).bind(id);
                let text = text.fetch_one(&mut *self).await?;
                let lease = Lease { job: JobId::from(id), owner: request.owner, attempt: count(attempt)? };
                Ok(Claim { lease, exclusive, memory: count(memory)?, request: unpack(text)? })
            }
        }
    };
}

claiming!(Sqlite, SqliteConnection, "");
claiming!(Postgres, PgConnection, " FOR UPDATE SKIP LOCKED");
