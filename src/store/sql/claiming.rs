//! Statements that claim queued jobs for a worker, in one transaction. Claims exclude each other:
//! a job that one claim has read cannot be handed out by another.

use bytes::Bytes;
use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{count, damaged, failure_json, unpack};
use crate::jobs::{Claim, ClaimRequest, Claims, JobFailure, JobId, JobState, Lease, StoreError};
use crate::store::StoreLimits;

/// Selects the next job: the first queued job of the key that holds the fewest places; among equal
/// keys, of the key that has spent the least solver time. A key may hold at most `$3` places of
/// one worker and `$4` places of all workers.
///
/// SQLite keeps the order of a cross join: it goes through the keys, which are few, and looks the
/// first job of each up in the index.
pub(in crate::store) const NEXT: &str = "
    SELECT j.id, j.memory
    FROM accounts a CROSS JOIN jobs j
    WHERE j.id = (
            SELECT q.id FROM jobs q
            WHERE q.account = a.id AND q.state = 'queued' AND q.memory <= $1 AND q.losses < $6
            ORDER BY q.losses DESC, q.priority DESC, q.id LIMIT 1)
        AND (SELECT count(*) FROM jobs r
            WHERE r.state = 'running' AND r.account = a.id AND r.owner = $2) < $3
        AND (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id)
            < coalesce((SELECT k.max_running FROM api_keys k WHERE k.id = a.id), $4)
    ORDER BY
        (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id),
        CASE WHEN $5 - a.settled_at < 60000000
            THEN a.spent * (60000000 - ($5 - a.settled_at)) / 60000000 ELSE 0 END,
        j.id
    LIMIT 1";

/// Selects the job that fails if its worker is lost once more.
const LAST_CHANCE: &str = "SELECT id, memory FROM jobs
    WHERE state = 'queued' AND losses > 0 AND losses >= $1 AND memory <= $2 ORDER BY id LIMIT 1";

const LEASE: &str =
    "UPDATE jobs SET state = 'running', owner = $2, leased_until = $3, started_at = $4,
        attempts = attempts + 1, iterations = 0, latest = NULL, steps = 0, stored_bytes = 0
    WHERE id = $1 AND state = 'queued'
    RETURNING attempts, traceparent, (SELECT r.body FROM requests r WHERE r.job = jobs.id)";

/// Charges the solver time of an attempt to its key. Time charged before decays to zero within a
/// minute.
pub(super) const SETTLE: &str = "UPDATE accounts SET settled_at = $2,
        spent = $2 - (SELECT started_at FROM jobs WHERE id = $1)
            + CASE WHEN $2 - settled_at < 60000000
                THEN spent * (60000000 - ($2 - settled_at)) / 60000000 ELSE 0 END
    WHERE id = (SELECT account FROM jobs WHERE id = $1)";

const END: &str =
    "UPDATE jobs SET state = $2, failure = $3, finished_at = $4, owner = NULL, leased_until = NULL
    WHERE id = $1";

/// Queues a job again whose worker was lost.
const REQUEUE: &str =
    "UPDATE jobs SET state = 'queued', losses = losses + 1, owner = NULL, leased_until = NULL,
        started_at = NULL, iterations = 0, latest = NULL, steps = 0, stored_bytes = 0
    WHERE id = $1";

/// Removes the iterations, steps and fields of an earlier attempt.
pub(super) const FORGET: [&str; 3] = [
    "DELETE FROM iterations WHERE job = $1",
    "DELETE FROM result_steps WHERE job = $1",
    "DELETE FROM field_parts WHERE job = $1",
];

/// Id and estimated memory \[bytes\] of a job.
type Candidate = (Uuid, i64);

/// Free places and free memory of a worker. Every place has memory of its own, enough for an
/// ordinary job. Larger jobs share the remaining memory; the first large job that does not fit
/// blocks the large jobs behind it.
struct Room {
    places: usize,
    memory_of_place: u64,
    shared: u64,
    /// Memory \[bytes\] that the next job may need.
    largest: u64,
}

impl Room {
    /// Reserves a place and memory for a job; returns `false` if the job has to wait.
    fn take(&mut self, memory: u64) -> bool {
        if memory > self.memory_of_place {
            let Some(rest) = self.shared.checked_sub(memory) else {
                self.largest = self.memory_of_place;
                return false;
            };
            self.shared = rest;
        }
        self.places -= 1;
        true
    }
}

/// Claims on a connection.
pub(in crate::store) trait Claiming: Send {
    /// Waits until no other claim runs. Returns whether a lease has expired, and whether a queued
    /// job has lost a worker before.
    fn take_turn(
        &mut self,
        now: i64,
    ) -> impl Future<Output = Result<(bool, bool), StoreError>> + Send;
    /// Queues the jobs again whose lease expired. Ends, and returns, the jobs that have lost their
    /// last worker or were cancelled.
    fn expire(
        &mut self,
        max_attempts: u32,
        now: i64,
    ) -> impl Future<Output = Result<Vec<JobId>, StoreError>> + Send;
    /// Claims jobs while places and memory are free. `lost`: some queued jobs have lost a worker.
    fn claim(
        &mut self,
        request: &ClaimRequest,
        limits: StoreLimits,
        lost: bool,
        now: i64,
    ) -> impl Future<Output = Result<Claims, StoreError>> + Send;
    /// Leases a job to the worker; returns `None` if it was cancelled meanwhile.
    fn lease(
        &mut self,
        job: Candidate,
        exclusive: bool,
        request: &ClaimRequest,
        now: i64,
    ) -> impl Future<Output = Result<Option<Claim>, StoreError>> + Send;
}

/// Returns the text of a job, empty where the row is damaged: the reader then fails this job, and
/// the jobs behind it go on.
fn readable_text(id: JobId, packed: Option<Vec<u8>>) -> Bytes {
    let text = packed.map_or_else(|| Err(damaged("no text")), unpack);
    text.unwrap_or_else(|error| {
        let error = &error as &dyn std::error::Error;
        tracing::error!(job = %id, error, "the text of a job is damaged");
        Bytes::new()
    })
}

/// Returns when a lease that begins now expires.
pub(super) fn until(now: i64, lease: std::time::Duration) -> i64 {
    now.saturating_add(i64::try_from(lease.as_micros()).unwrap_or(i64::MAX))
}

/// Converts a number to the database's integer, its largest one where the number is beyond it.
fn bound(number: impl TryInto<i64>) -> i64 {
    number.try_into().unwrap_or(i64::MAX)
}

// Both databases run the same statements, with different types of sqlx.
macro_rules! claiming {
    ($database:ty, $connection:ty, $turn:literal, $lost:literal) => {
        impl Claiming for $connection {
            async fn take_turn(&mut self, now: i64) -> Result<(bool, bool), StoreError> {
                Ok(sqlx::query_as::<$database, (bool, bool)>($turn)
                    .bind(now)
                    .fetch_one(self)
                    .await?)
            }

            async fn expire(
                &mut self,
                max_attempts: u32,
                now: i64,
            ) -> Result<Vec<JobId>, StoreError> {
                let lost = sqlx::query_as::<$database, (Uuid, i32, bool)>($lost).bind(now);
                let mut ended = Vec::new();
                for (id, losses, cancelled) in lost.fetch_all(&mut *self).await? {
                    let losses = count::<_, u32>(losses)?.saturating_add(1);
                    let (state, failure) = if cancelled {
                        (JobState::Cancelled, None)
                    } else if losses >= max_attempts {
                        (JobState::Failed, Some(failure_json(&JobFailure::lost(losses))?))
                    } else {
                        sqlx::query::<$database>(REQUEUE).bind(id).execute(&mut *self).await?;
                        continue;
                    };
                    let end =
                        sqlx::query::<$database>(END).bind(id).bind(state.name()).bind(failure);
                    end.bind(now).execute(&mut *self).await?;
                    ended.push(JobId::from(id));
                }
                Ok(ended)
            }

            async fn claim(
                &mut self,
                request: &ClaimRequest,
                limits: StoreLimits,
                lost: bool,
                now: i64,
            ) -> Result<Claims, StoreError> {
                let mut claims = Claims::default();
                let last_chance = bound(request.max_attempts.saturating_sub(1).max(1));
                if lost {
                    let alone =
                        sqlx::query_as::<$database, Candidate>(LAST_CHANCE).bind(last_chance);
                    let alone =
                        alone.bind(bound(request.memory)).fetch_optional(&mut *self).await?;
                    if let (Some(job), true) = (alone, request.exclusive) {
                        claims.jobs.extend(self.lease(job, true, request, now).await?);
                        return Ok(claims);
                    }
                    claims.exclusive_pending = alone.is_some();
                }
                let mut room = Room {
                    places: request.places,
                    memory_of_place: request.memory_of_place,
                    shared: request.free_memory,
                    largest: request.memory.max(request.memory_of_place),
                };
                while room.places > 0 {
                    let next = sqlx::query_as::<$database, Candidate>(NEXT)
                        .bind(bound(room.largest))
                        .bind(request.owner.uuid())
                        .bind(bound(request.places_of_key))
                        .bind(limits.by_key.running.map_or(i64::MAX, i64::from))
                        .bind(now)
                        .bind(last_chance);
                    let Some(job) = next.fetch_optional(&mut *self).await? else { break };
                    if room.take(count(job.1)?) {
                        claims.jobs.extend(self.lease(job, false, request, now).await?);
                    }
                }
                Ok(claims)
            }

            async fn lease(
                &mut self,
                (id, memory): Candidate,
                exclusive: bool,
                request: &ClaimRequest,
                now: i64,
            ) -> Result<Option<Claim>, StoreError> {
                let leased =
                    sqlx::query_as::<$database, (i32, Option<String>, Option<Vec<u8>>)>(LEASE)
                        .bind(id)
                        .bind(request.owner.uuid())
                        .bind(until(now, request.lease))
                        .bind(now);
                let Some((attempt, trace, text)) = leased.fetch_optional(&mut *self).await? else {
                    return Ok(None);
                };
                if attempt > 1 {
                    for forget in FORGET {
                        sqlx::query::<$database>(forget).bind(id).execute(&mut *self).await?;
                    }
                }
                let id = JobId::from(id);
                Ok(Some(Claim {
                    lease: Lease { job: id, owner: request.owner, attempt: count(attempt)? },
                    exclusive,
                    memory: count(memory)?,
                    request: readable_text(id, text),
                    trace: trace.and_then(|text| text.parse().ok()),
                }))
            }
        }
    };
}

// SQLite has one writer, which needs no lock.
claiming!(
    Sqlite,
    SqliteConnection,
    "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND leased_until <= $1),
        EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND losses > 0)",
    "SELECT id, losses, cancel_requested FROM jobs WHERE state = 'running' AND leased_until <= $1"
);
// No other lock has this number. SKIP LOCKED passes over a job that its worker is writing to.
claiming!(
    Postgres,
    PgConnection,
    "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND leased_until <= $1),
        EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND losses > 0)
     FROM pg_advisory_xact_lock(4242002)",
    "SELECT id, losses, cancel_requested FROM jobs WHERE state = 'running' AND leased_until <= $1
     FOR UPDATE SKIP LOCKED"
);
