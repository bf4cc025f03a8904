//! Statements that hand jobs out, in one transaction. Claims take turns, so that what one has read
//! another does not hand out.

use bytes::Bytes;
use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{count, damaged, failure_json, unpack};
use crate::jobs::{Claim, ClaimRequest, Claims, JobFailure, JobId, JobState, Lease, StoreError};
use crate::store::StoreLimits;

/// The job that goes next: of the key that holds the fewest places, and among equals of the one
/// that has spent the least solver time, the first that waits. A key holds so many places of a
/// worker (`$3`), and so many of all (`$4`).
///
/// SQLite joins crossed tables as they are written: keys are few, and the first job of each is
/// looked up.
pub(in crate::store) const NEXT: &str = "
    SELECT j.id, j.memory
    FROM accounts a CROSS JOIN jobs j
    WHERE j.id = (
            SELECT q.id FROM jobs q
            WHERE q.account = a.id AND q.state = 'queued' AND q.memory <= $1 AND q.losses < $6
            ORDER BY q.losses DESC, q.priority DESC, q.id LIMIT 1)
        AND (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id AND r.owner = $2) < $3
        AND (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id)
            < coalesce((SELECT k.max_running FROM api_keys k WHERE k.id = a.id), $4)
    ORDER BY
        (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id),
        CASE WHEN $5 - a.settled_at < 60000000 THEN a.spent * (60000000 - ($5 - a.settled_at)) / 60000000 ELSE 0 END,
        j.id
    LIMIT 1";

/// The job whose next loss is its last.
const LAST_CHANCE: &str = "SELECT id, memory FROM jobs
    WHERE state = 'queued' AND losses > 0 AND losses >= $1 AND memory <= $2 ORDER BY id LIMIT 1";

const LEASE: &str =
    "UPDATE jobs SET state = 'running', owner = $2, leased_until = $3, started_at = $4,
        attempts = attempts + 1, iterations = 0, latest = NULL, steps = 0, stored_bytes = 0
    WHERE id = $1 AND state = 'queued'
    RETURNING attempts, traceparent, (SELECT r.body FROM requests r WHERE r.job = jobs.id)";

/// Puts an attempt on the account of its key. What was spent before is forgotten bit by bit,
/// within a minute.
pub(super) const SETTLE: &str = "UPDATE accounts SET settled_at = $2,
        spent = $2 - (SELECT started_at FROM jobs WHERE id = $1)
            + CASE WHEN $2 - settled_at < 60000000 THEN spent * (60000000 - ($2 - settled_at)) / 60000000 ELSE 0 END
    WHERE id = (SELECT account FROM jobs WHERE id = $1)";

const END: &str =
    "UPDATE jobs SET state = $2, failure = $3, finished_at = $4, owner = NULL, leased_until = NULL
    WHERE id = $1";

/// Queues again what has lost its worker.
const REQUEUE: &str =
    "UPDATE jobs SET state = 'queued', losses = losses + 1, owner = NULL, leased_until = NULL,
        started_at = NULL, iterations = 0, latest = NULL, steps = 0, stored_bytes = 0
    WHERE id = $1";

/// Removes what an attempt has left.
pub(super) const FORGET: [&str; 3] = [
    "DELETE FROM iterations WHERE job = $1",
    "DELETE FROM result_steps WHERE job = $1",
    "DELETE FROM field_parts WHERE job = $1",
];

/// Name and estimated memory.
type Candidate = (Uuid, i64);

/// Places and memory that are free. Every place has memory of its own, which is enough for
/// ordinary jobs; larger ones share the rest, and the first of them that does not fit holds up the
/// large ones behind it.
struct Room {
    places: usize,
    memory_of_place: u64,
    shared: u64,
    /// Memory that the next job may need.
    largest: u64,
}

impl Room {
    /// Takes room for a job; `false` if it has to wait.
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

/// Handing out.
pub(in crate::store) trait Claiming: Send {
    /// Waits for the turn of this worker; whether a lease has run out, and whether a job has lost
    /// its worker before.
    fn take_turn(
        &mut self,
        now: i64,
    ) -> impl Future<Output = Result<(bool, bool), StoreError>> + Send;
    /// Queues the jobs again whose lease ran out; those that nobody takes up again end, and are
    /// returned.
    fn expire(
        &mut self,
        max_attempts: u32,
        now: i64,
    ) -> impl Future<Output = Result<Vec<JobId>, StoreError>> + Send;
    /// Hands out jobs for as long as there is room; `lost` if some have lost their worker.
    fn claim(
        &mut self,
        request: &ClaimRequest,
        limits: StoreLimits,
        lost: bool,
        now: i64,
    ) -> impl Future<Output = Result<Claims, StoreError>> + Send;
    /// Hands a job out; `None` if it has just been cancelled.
    fn lease(
        &mut self,
        job: Candidate,
        exclusive: bool,
        request: &ClaimRequest,
        now: i64,
    ) -> impl Future<Output = Result<Option<Claim>, StoreError>> + Send;
}

/// The text of a job. Without one, the job fails where it is read; the queue behind it goes on.
fn readable_text(id: JobId, packed: Option<Vec<u8>>) -> Bytes {
    let text = packed.map_or_else(|| Err(damaged("no text")), unpack);
    text.unwrap_or_else(|error| {
        tracing::error!(job = %id, error = &error as &dyn std::error::Error, "the text of a job is damaged");
        Bytes::new()
    })
}

/// The moment a lease that begins now runs out.
pub(super) fn until(now: i64, lease: std::time::Duration) -> i64 {
    now.saturating_add(i64::try_from(lease.as_micros()).unwrap_or(i64::MAX))
}

/// The largest integer of a database where a number is beyond it.
fn bound(number: impl TryInto<i64>) -> i64 {
    number.try_into().unwrap_or(i64::MAX)
}

// The statements are the same for every database, the types that carry them are not.
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

// Who writes to SQLite is alone.
claiming!(
    Sqlite,
    SqliteConnection,
    "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND leased_until <= $1),
        EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND losses > 0)",
    "SELECT id, losses, cancel_requested FROM jobs WHERE state = 'running' AND leased_until <= $1"
);
// The number of the lock is that of nothing else. A job that its worker is just writing to is
// passed over.
claiming!(
    Postgres,
    PgConnection,
    "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND leased_until <= $1),
        EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND losses > 0)
     FROM pg_advisory_xact_lock(4242002)",
    "SELECT id, losses, cancel_requested FROM jobs WHERE state = 'running' AND leased_until <= $1
     FOR UPDATE SKIP LOCKED"
);
