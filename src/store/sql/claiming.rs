//! Statements that claim queued jobs for a worker. A claim is one message; claims exclude each
//! other, so that each sees the places that the others have taken.

use bytes::Bytes;
use sqlx::types::Uuid;

use super::codec::{count, damaged, failure_json, unpack};
use super::message::{Messages, Value};
use crate::jobs::{Claim, ClaimRequest, JobFailure, JobId, Lease, StoreError};
use crate::store::StoreLimits;

/// Selects the next job: the first queued job of the key that holds the fewest places; among equal
/// keys, of the key that has spent the least solver time. A key may hold at most `$3` places of
/// one worker and `$4` places of all workers. Of the jobs that fail if their worker is lost once
/// more a worker runs one at a time.
pub(in crate::store) const NEXT: &str = "
    WITH heads AS MATERIALIZED (
        SELECT coalesce(r.places, 0) AS places,
            CASE WHEN $5 - a.settled_at < 60000000
                THEN a.spent * (60000000 - ($5 - a.settled_at)) / 60000000 ELSE 0 END AS spent,
            (SELECT q.id FROM jobs q
                WHERE q.account = a.id AND q.state = 'queued' AND q.memory <= $1
                    AND (q.losses < $6 OR NOT EXISTS (SELECT 1 FROM jobs l
                        WHERE l.state = 'running' AND l.owner = $2 AND l.losses >= $6))
                ORDER BY q.losses DESC, q.priority DESC, q.id LIMIT 1) AS id
        FROM accounts a LEFT JOIN (
            SELECT account, count(*) AS places, count(CASE WHEN owner = $2 THEN 1 END) AS here
            FROM jobs WHERE state = 'running' GROUP BY account) r ON r.account = a.id
        WHERE coalesce(r.here, 0) < $3 AND coalesce(r.places, 0)
            < coalesce((SELECT k.max_running FROM api_keys k WHERE k.id = a.id), $4))
    SELECT id FROM heads WHERE id IS NOT NULL ORDER BY places, spent, id LIMIT 1";

/// Leases the next job, if its memory is free: `$8` bytes are those of a place,
/// `$9` those that are left for large jobs.
fn lease_next() -> String {
    format!(
        "UPDATE jobs SET state = 'running', owner = $2, leased_until = $5 + $7, started_at = $5,
            attempts = attempts + 1, iterations = 0, latest = NULL, steps = 0, stored_bytes = 0
        WHERE id = ({NEXT}) AND state = 'queued' AND (memory <= $8 OR memory <= $9)
        RETURNING id, memory, attempts, traceparent,
            (SELECT body FROM requests WHERE job = jobs.id)"
    )
}

/// Queues the jobs again whose lease expired. Those that have lost their last worker fail, those
/// that a client asked to stop are cancelled. The locking clause of the database and a parenthesis
/// follow.
const EXPIRE: [&str; 2] = [
    "UPDATE jobs SET losses = losses + 1, owner = NULL, leased_until = NULL,
        steps = 0, stored_bytes = 0,
        state = CASE WHEN cancel_requested THEN 'cancelled'
            WHEN losses + 1 >= $2 THEN 'failed' ELSE 'queued' END,
        failure = CASE WHEN losses + 1 >= $2 AND NOT cancel_requested THEN $3 END,
        finished_at = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN $1 END,
        started_at = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN started_at END,
        iterations = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN iterations ELSE 0 END,
        latest = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN latest END
    WHERE id IN (SELECT id FROM jobs WHERE state = 'running' AND leased_until <= $1",
    ") RETURNING id, state <> 'queued'",
];

/// Removes what the attempts that [`EXPIRE`] has ended have left, and makes the announcements of
/// the jobs due that it has ended.
const AFTER_EXPIRE: [&str; 4] = [
    "DELETE FROM iterations WHERE job IN
        (SELECT id FROM jobs WHERE state = 'queued' AND losses > 0)",
    "DELETE FROM result_steps WHERE job IN
        (SELECT id FROM jobs WHERE state = 'queued' AND losses > 0
         UNION ALL SELECT id FROM jobs WHERE finished_at = $1 AND NOT has_report)",
    "DELETE FROM field_parts WHERE job IN
        (SELECT id FROM jobs WHERE state = 'queued' AND losses > 0
         UNION ALL SELECT id FROM jobs WHERE finished_at = $1 AND NOT has_report)",
    "UPDATE deliveries SET state = 'pending', due_at = $1
     WHERE state = 'waiting' AND job IN (SELECT id FROM jobs WHERE finished_at = $1)",
];

/// A leased job: id, estimated memory \[bytes\], number of the attempt, trace, text.
type LeasedRow = (Uuid, i64, i32, Option<String>, Option<Vec<u8>>);

/// The terms of a claim.
#[derive(Debug, Clone, Copy)]
pub(in crate::store) struct Terms {
    /// Memory \[bytes\] that the job may need at most.
    pub(super) largest: u64,
    /// Memory \[bytes\] left for jobs that need more than a place has.
    pub(super) shared: u64,
    request: ClaimRequest,
    running: Option<u32>,
    now: Option<i64>,
}

impl Terms {
    /// The terms of a claim whose memory is not used up. `now` is `None` where the clock of the
    /// database counts.
    pub(super) fn new(request: &ClaimRequest, limits: StoreLimits, now: Option<i64>) -> Self {
        Self {
            largest: request.memory.max(request.memory_of_place),
            shared: request.free_memory,
            request: *request,
            running: limits.by_key.running,
            now,
        }
    }

    /// The values `$1` to `$9`.
    fn values(&self) -> [Value<'static>; 9] {
        let request = &self.request;
        [
            Value::number(self.largest),
            Value::Id(request.owner.uuid()),
            Value::number(request.places_of_key),
            Value::number(self.running.map_or(i64::MAX, i64::from)),
            Value::Time(self.now),
            Value::number(request.max_attempts.saturating_sub(1).max(1)),
            Value::number(request.lease.as_micros()),
            Value::number(request.memory_of_place),
            Value::number(self.shared),
        ]
    }
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

/// Queues the jobs again whose lease expired. Ends, and returns, the jobs that have lost their
/// last worker or were cancelled.
pub(super) async fn expire<C: Messages>(
    line: &mut C,
    max_attempts: u32,
    now: Option<i64>,
) -> Result<Vec<JobId>, StoreError> {
    let [expire, ended] = EXPIRE;
    let failure = failure_json(&JobFailure::lost(max_attempts))?;
    let values = [Value::Time(now), Value::number(max_attempts), Value::Text(Some(&failure))];
    let mut message = C::message();
    // It passes over a job that its worker is writing to.
    message.push(&[expire, C::DIALECT.lock_free, ended].concat(), &values);
    for statement in AFTER_EXPIRE {
        message.push(statement, &values);
    }
    let mut ended = Vec::new();
    for row in line.send(message).await?.first().into_iter().flatten() {
        let (id, has_ended): (Uuid, bool) = C::columns(row)?;
        ended.extend(has_ended.then_some(JobId::from(id)));
    }
    Ok(ended)
}

/// Leases up to `places` jobs one by one, and takes the memory of the first from the terms if it is
/// a large one. The others may be small ones only.
pub(super) async fn lease<C: Messages>(
    line: &mut C,
    places: usize,
    terms: &mut Terms,
) -> Result<Vec<Claim>, StoreError> {
    let statement = lease_next();
    let mut message = C::message();
    message.push(C::DIALECT.one_claim, &[]);
    for place in 0..places {
        let shared = if place == 0 { terms.shared } else { 0 };
        message.push(&statement, &Terms { shared, ..*terms }.values());
    }
    let mut jobs = Vec::new();
    for row in line.send(message).await?.iter().skip(1).flatten() {
        let (id, memory, attempt, trace, text): LeasedRow = C::columns(row)?;
        let (id, memory) = (JobId::from(id), count(memory)?);
        if memory > terms.request.memory_of_place {
            terms.shared = terms.shared.saturating_sub(memory);
        }
        jobs.push(Claim {
            lease: Lease { job: id, owner: terms.request.owner, attempt: count(attempt)? },
            memory,
            request: readable_text(id, text),
            trace: trace.and_then(|text| text.parse().ok()),
        });
    }
    Ok(jobs)
}

/// Returns whether a job is next that has not been leased: it waits for its memory.
pub(super) async fn waits<C: Messages>(line: &mut C, terms: &Terms) -> Result<bool, StoreError> {
    let mut message = C::message();
    message.push(NEXT, &terms.values());
    Ok(line.send(message).await?.iter().any(|rows| !rows.is_empty()))
}
