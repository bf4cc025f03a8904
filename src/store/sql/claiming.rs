//! Statements that hand jobs out. They run in one transaction; what they read stays locked until its end, and what
//! another worker has locked is passed over.

use bytes::Bytes;
use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{count, damaged, failure_json, unpack};
use crate::jobs::{Claim, ClaimRequest, Claims, JobFailure, JobId, JobState, Lease, StoreError};
use crate::store::StoreLimits;

/// The part of its key's share that jobs that somebody waits for get while others of the key wait too.
const INTERACTIVE_PART: f64 = 0.75;

/// The head of a flow's queue: flow, whether it is interactive, whether the other flow of its key has jobs waiting, its virtual
/// time; job, memory, losses so far less one, work; whether the job gives way to those of other keys.
type Head = (i64, bool, bool, f64, Uuid, i64, i32, i64, bool);

/// What is free for jobs from the heads of the queues.
#[derive(Debug, Clone, Copy)]
pub(in crate::store) struct Room {
    slots: usize,
    free: u64,
    /// Memory that a job may need at most.
    memory: i64,
    /// Only short jobs, beside those that hold the solvers.
    beside: bool,
}

const SERVED: &str = "UPDATE flows SET virtual_time = $2 WHERE id = $1";
const CLOCK: &str = "UPDATE scheduler SET virtual_time = $1";

/// A job that might be handed out: name, estimated memory, losses so far, estimated work.
type Candidate = (Uuid, i64, i32, i64);

/// How a job is handed out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Place {
    Solver,
    Exclusive,
    Beside {
        /// It shares what the long jobs of its key have of the processor.
        gives_way: bool,
    },
}

const END: &str =
    "UPDATE jobs SET state = $2, failure = $3, finished_at = $4, owner = NULL, leased_until = NULL
     WHERE id = $1";
/// Removes what an attempt has left.
pub(super) const FORGET: [&str; 3] = [
    "DELETE FROM iterations WHERE job = $1",
    "DELETE FROM result_steps WHERE job = $1",
    "DELETE FROM field_parts WHERE job = $1",
];
macro_rules! lease_job {
    ($with:literal) => {
        concat!(
            $with,
            "UPDATE jobs SET state = 'running', owner = $2, leased_until = $3, started_at = $4,
                 losses = $5, attempts = attempts + 1, iterations = 0, latest = NULL,
                 steps = 0, stored_bytes = 0
             WHERE id = $1 RETURNING attempts, traceparent, (SELECT r.body FROM requests r WHERE r.job = jobs.id)"
        )
    };
}

const LEASE_JOB: &str = lease_job!("");
/// The same for the head of a queue, with what is written of its flow. Each statement is a way to the server and back; SQLite
/// has neither such ways nor statements that write within others.
const LEASE_HEAD: &str = lease_job!(
    "WITH served AS (UPDATE flows SET virtual_time = $7 WHERE id = $6), clock AS (UPDATE scheduler SET virtual_time = $8) "
);

/// What a flow is charged for a job.
#[derive(Debug, Clone, Copy)]
pub(in crate::store) struct Charge {
    flow: i64,
    /// Virtual time of the flow before the job, which is that of the queue from then on.
    begin: f64,
    /// And after it.
    end: f64,
}

/// Handing out.
pub(in crate::store) trait Claiming: Send {
    /// Waits for the turn of this worker; whether the lease of a job has run out.
    fn take_turn(&mut self, now: i64) -> impl Future<Output = Result<bool, StoreError>> + Send;
    /// Ends the jobs whose lease ran out and that nobody takes up again.
    fn expire(
        &mut self,
        max_attempts: u32,
        now: i64,
    ) -> impl Future<Output = Result<Vec<JobId>, StoreError>> + Send;
    /// Hands out the jobs whose lease ran out, if there are `lost` ones, and heads of queues.
    fn claim(
        &mut self,
        request: &ClaimRequest,
        limits: StoreLimits,
        lost: bool,
        now: i64,
    ) -> impl Future<Output = Result<Claims, StoreError>> + Send;
    /// Hands out the jobs whose lease ran out; whether others may be handed out with them.
    fn claim_lost(
        &mut self,
        request: &ClaimRequest,
        now: i64,
    ) -> impl Future<Output = Result<(Claims, bool), StoreError>> + Send;
    /// Hands out heads of queues for as long as there is room.
    fn claim_heads(
        &mut self,
        room: Room,
        request: &ClaimRequest,
        limits: StoreLimits,
        now: i64,
    ) -> impl Future<Output = Result<Vec<Claim>, StoreError>> + Send;
    fn lease_job(
        &mut self,
        job: Candidate,
        place: Place,
        charge: Option<Charge>,
        request: &ClaimRequest,
        now: i64,
    ) -> impl Future<Output = Result<Claim, StoreError>> + Send;
    fn charge(&mut self, charge: Charge) -> impl Future<Output = Result<(), StoreError>> + Send;
}

/// The text of a job. Without one, the job fails where it is read; the queue behind it goes on.
fn readable_text(id: JobId, packed: Option<Vec<u8>>) -> Bytes {
    let text = packed.map_or_else(|| Err(damaged("no text")), unpack);
    text.unwrap_or_else(|error| {
        tracing::error!(job = %id, error = &error as &dyn std::error::Error, "the text of a job is damaged");
        Bytes::new()
    })
}

/// The part of the share of its key that a flow has.
fn part_of_share(interactive: bool, shares: bool) -> f64 {
    match (shares, interactive) {
        (false, _) => 1.0,
        (true, true) => INTERACTIVE_PART,
        (true, false) => 1.0 - INTERACTIVE_PART,
    }
}

/// The moment a lease that begins now runs out.
pub(super) fn until(now: i64, lease: std::time::Duration) -> i64 {
    now.saturating_add(i64::try_from(lease.as_micros()).unwrap_or(i64::MAX))
}

macro_rules! claiming {
    ($database:ty, $connection:ty, $lock:literal, $turn:literal, $head:expr, $short_head:expr, $charges_with_lease:literal) => {
        impl Claiming for $connection {
            async fn take_turn(&mut self, now: i64) -> Result<bool, StoreError> {
                let turn = sqlx::query_scalar::<$database, bool>(concat!(
                    "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND leased_until <= $1) FROM scheduler",
                    $turn
                ));
                Ok(turn.bind(now).fetch_optional(self).await?.unwrap_or(false))
            }

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

            async fn claim(
                &mut self,
                request: &ClaimRequest,
                limits: StoreLimits,
                lost: bool,
                now: i64,
            ) -> Result<Claims, StoreError> {
                let (mut claims, all) =
                    if lost { self.claim_lost(request, now).await? } else { (Claims::default(), true) };
                if !all {
                    return Ok(claims);
                }
                let taken: u64 = claims.jobs.iter().map(|claim| claim.memory).sum();
                let solvers = Room {
                    slots: request.slots - claims.jobs.len(),
                    free: request.free_memory.saturating_sub(taken),
                    memory: i64::try_from(request.memory).unwrap_or(i64::MAX),
                    beside: false,
                };
                claims.jobs.extend(self.claim_heads(solvers, request, limits, now).await?);
                let beside = Room {
                    slots: request.short_slots,
                    free: request.short_memory,
                    memory: i64::try_from(request.short_memory).unwrap_or(i64::MAX),
                    beside: true,
                };
                claims.jobs.extend(self.claim_heads(beside, request, limits, now).await?);
                Ok(claims)
            }

            async fn claim_lost(&mut self, request: &ClaimRequest, now: i64) -> Result<(Claims, bool), StoreError> {
                let memory = i64::try_from(request.memory).unwrap_or(i64::MAX);
                let slots = i64::try_from(request.slots).unwrap_or(i64::MAX);
                let lost = sqlx::query_as::<$database, Candidate>(concat!(
                    "SELECT id, memory, losses, work FROM jobs WHERE state = 'running' AND leased_until <= $1
                       AND memory <= $2 ORDER BY losses, id LIMIT $3",
                    $lock
                ));
                let lost = lost.bind(now).bind(memory).bind(slots.saturating_add(1)).fetch_all(&mut *self).await?;
                let (exclusive, candidates): (Vec<Candidate>, Vec<Candidate>) = lost
                    .into_iter()
                    .partition(|(_, _, losses, _)| i64::from(*losses) + 2 >= i64::from(request.max_attempts));
                if let (Some(job), true) = (exclusive.first(), request.exclusive) {
                    let jobs = vec![self.lease_job(*job, Place::Exclusive, None, request, now).await?];
                    return Ok((Claims { jobs, exclusive_pending: false }, false));
                }
                let mut claims = Claims { jobs: Vec::new(), exclusive_pending: !exclusive.is_empty() };
                let mut free = request.free_memory;
                for job in candidates.into_iter().take(request.slots) {
                    let Some(rest) = free.checked_sub(count(job.1)?) else { return Ok((claims, false)) };
                    free = rest;
                    claims.jobs.push(self.lease_job(job, Place::Solver, None, request, now).await?);
                }
                Ok((claims, true))
            }

            async fn claim_heads(
                &mut self,
                room: Room,
                request: &ClaimRequest,
                limits: StoreLimits,
                now: i64,
            ) -> Result<Vec<Claim>, StoreError> {
                let Room { slots, mut free, memory, beside } = room;
                let select = if beside { $short_head } else { $head };
                let short_by_key = i64::try_from(request.short_by_key).unwrap_or(i64::MAX);
                let running_by_key = limits.by_key.running.map_or(i64::MAX, i64::from);
                let mut claims = Vec::new();
                while claims.len() < slots {
                    let head = sqlx::query_as::<$database, Head>(select).bind(memory).bind(running_by_key);
                    let mut head = head.bind(Uuid::nil());
                    if beside {
                        head = head.bind(request.owner.uuid()).bind(short_by_key);
                    }
                    let head = head.fetch_optional(&mut *self).await?;
                    let Some((flow, interactive, shares, time, id, memory, losses, work, gives_way)) = head else {
                        break;
                    };
                    let Some(rest) = free.checked_sub(count(memory)?) else { break };
                    free = rest;
                    let place = if beside { Place::Beside { gives_way } } else { Place::Solver };
                    let end = time + work as f64 / part_of_share(interactive, shares);
                    let charge = Some(Charge { flow, begin: time, end });
                    claims.push(self.lease_job((id, memory, losses, work), place, charge, request, now).await?);
                }
                Ok(claims)
            }

            async fn lease_job(
                &mut self,
                job: Candidate,
                place: Place,
                charge: Option<Charge>,
                request: &ClaimRequest,
                now: i64,
            ) -> Result<Claim, StoreError> {
                let (id, memory, losses, work) = job;
                let together = charge.filter(|_| $charges_with_lease);
                let statement = if together.is_some() { LEASE_HEAD } else { LEASE_JOB };
                let mut leased = sqlx::query_as::<$database, (i32, Option<String>, Option<Vec<u8>>)>(statement)
                    .bind(id)
                    .bind(request.owner.uuid())
                    .bind(until(now, request.lease))
                    .bind(now)
                    .bind(losses.saturating_add(1));
                if let Some(charge) = together {
                    leased = leased.bind(charge.flow).bind(charge.end).bind(charge.begin);
                }
                let (attempt, trace, text) = leased.fetch_one(&mut *self).await?;
                if let (None, Some(charge)) = (together, charge) {
                    self.charge(charge).await?;
                }
                if attempt > 1 {
                    for forget in FORGET {
                        sqlx::query::<$database>(forget).bind(id).execute(&mut *self).await?;
                    }
                }
                let lease = Lease { job: JobId::from(id), owner: request.owner, attempt: count(attempt)? };
                Ok(Claim {
                    lease,
                    exclusive: place == Place::Exclusive,
                    beside: matches!(place, Place::Beside { .. }),
                    gives_way: matches!(place, Place::Beside { gives_way: true }),
                    work: count(work)?,
                    memory: count(memory)?,
                    request: readable_text(JobId::from(id), text),
                    trace: trace.and_then(|text| text.parse().ok()),
                })
            }

            async fn charge(&mut self, charge: Charge) -> Result<(), StoreError> {
                let served = sqlx::query::<$database>(SERVED).bind(charge.flow).bind(charge.end);
                served.execute(&mut *self).await?;
                sqlx::query::<$database>(CLOCK).bind(charge.begin).execute(self).await?;
                Ok(())
            }
        }
    };
}

/// The job that goes next: the first of the flow whose virtual time is the least. A flow that has had nothing to do does not
/// make up for it: its time is that of the job handed out last. A key with as many jobs running as it may is passed over.
///
/// Of two workers' jobs the one's own count: a key for which this worker (`$4`) solves long jobs has `$5` places for short ones, which share the
/// processor with its long ones, so that others find a place at once. Those without a key are not one client.
///
/// SQLite joins crossed tables as they are written: flows are few and the head of each is looked up. Left to itself it goes through all that wait.
macro_rules! head_of_queue {
    ($which:literal, $gives_way:literal, $places:literal, $lock:literal) => {
        concat!(
            "SELECT f.id, f.interactive,
                 EXISTS (SELECT 1 FROM flows g CROSS JOIN jobs w
                     WHERE g.submitter = f.submitter AND g.id <> f.id AND w.flow = g.id AND w.state = 'queued'),
                 CASE WHEN f.virtual_time > s.virtual_time THEN f.virtual_time ELSE s.virtual_time END,
                 j.id, j.memory, j.losses - 1, j.work, ",
            $gives_way,
            " FROM scheduler s CROSS JOIN flows f CROSS JOIN jobs j
             WHERE j.id = (SELECT q.id FROM jobs q WHERE q.state = 'queued' AND q.flow = f.id AND q.memory <= $1",
            $which,
            "    ORDER BY q.priority DESC, q.id LIMIT 1) AND j.state = 'queued'
                 AND (f.submitter = $3
                     OR (SELECT count(*) FROM jobs r JOIN flows g ON g.id = r.flow WHERE r.state = 'running' AND g.submitter = f.submitter)
                         < coalesce((SELECT k.max_running FROM api_keys k WHERE k.id = f.submitter), $2))",
            $places,
            " ORDER BY 4, j.id LIMIT 1",
            $lock
        )
    };
}

macro_rules! short_head_of_queue {
    ($lock:literal) => {
        head_of_queue!(
            " AND q.short",
            "f.submitter <> $3 AND EXISTS (SELECT 1 FROM jobs r JOIN flows g ON g.id = r.flow
                 WHERE r.state = 'running' AND r.owner = $4 AND g.submitter = f.submitter AND NOT r.short)",
            " AND (f.submitter = $3 OR NOT EXISTS (SELECT count(*) FROM jobs r JOIN flows g ON g.id = r.flow
                 WHERE r.state = 'running' AND r.owner = $4 AND g.submitter = f.submitter
                 HAVING count(*) FILTER (WHERE NOT r.short) > 0 AND count(*) FILTER (WHERE r.short) >= $5))",
            $lock
        )
    };
}

/// Of SQLite, of any job and of a short one.
pub(in crate::store) const SQLITE_HEADS: [&str; 2] =
    [head_of_queue!("", "FALSE", "", ""), short_head_of_queue!("")];

claiming!(Sqlite, SqliteConnection, "", "", SQLITE_HEADS[0], SQLITE_HEADS[1], false);
// Claims of several workers take turns on the one row of `scheduler`; a job that is just being cancelled is passed over.
claiming!(
    Postgres,
    PgConnection,
    " FOR UPDATE SKIP LOCKED",
    " FOR UPDATE",
    head_of_queue!("", "FALSE", "", " FOR UPDATE OF j SKIP LOCKED"),
    short_head_of_queue!(" FOR UPDATE OF j SKIP LOCKED"),
    true
);
