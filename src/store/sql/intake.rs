//! Statements that submit, cancel and remove jobs, in a transaction.

use std::collections::{BTreeMap, HashMap};

use sqlx::types::Uuid;

use super::codec::{count, damaged, pack, time, to_json};
use super::deliveries;
use super::keys::{SubmitterRow, limits_of};
use super::message::{Message, Messages, Value};
use super::reading::Reading;
use crate::jobs::{
    About, Enqueued, JobId, JobRecord, JobState, KeyId, KeyLimits, NewJob, Quota, Retention,
    SWEEP, StoreError, label_of,
};
use crate::store::StoreLimits;

const TAKE_NAME: &str =
    "INSERT INTO idempotency_keys (submitter, name, digest, job) VALUES ($1, $2, $3, $4)";
const KNOWN: &str = "SELECT digest, job FROM idempotency_keys WHERE submitter = $1 AND name = $2";
const INSERT: &str = "INSERT INTO jobs (id, state, priority, memory, tags, submitter, created_at,
         reserved_bytes, account, traceparent)
     VALUES ($1, 'queued', $2, $3, $4, $5, $6, $7, $8, $9)";
const ACCOUNT: &str = "INSERT INTO accounts (id) VALUES ($1) ON CONFLICT DO NOTHING";
const QUEUED: &str = "SELECT count(*) FROM jobs WHERE state = 'queued'";
const WAITING: &str = "SELECT priority, count(*) FROM jobs WHERE state = 'queued' AND account = $1
     GROUP BY priority";
/// Selects the bytes that a submitter's results take or will take.
const STORED: &str = "SELECT CAST(coalesce(sum(
         CASE WHEN finished_at IS NOT NULL OR stored_bytes > reserved_bytes
             THEN stored_bytes ELSE reserved_bytes END), 0) AS BIGINT)
     FROM jobs WHERE submitter = $1";
const REQUEST: &str = "INSERT INTO requests (job, body) VALUES ($1, $2)";
const TAG: &str = "INSERT INTO job_tags (job, name, value) VALUES ($1, $2, $3)";
const CANCEL: &str = "UPDATE jobs SET cancel_requested = TRUE,
         finished_at = CASE WHEN state = 'queued' THEN $2 ELSE finished_at END,
         state = CASE WHEN state = 'queued' THEN 'cancelled' ELSE state END
     WHERE id = $1 AND state IN ('queued', 'running')";
const HEALTH: &str = "UPDATE health SET written_at = $1 RETURNING written_at";
const DELETE: &str = "DELETE FROM jobs WHERE id IN $1 AND state NOT IN ('queued', 'running')
     RETURNING id";
/// Selects the jobs whose time is over.
const OLD: &str = "SELECT id, stored_bytes FROM jobs WHERE finished_at IS NOT NULL
         AND finished_at <= $1 - CASE WHEN state IN ('succeeded', 'not_converged') THEN $2 ELSE $3 END
     ORDER BY finished_at LIMIT $4";
/// Selects the oldest results of the key whose results take the most bytes, until all results
/// together fit the limit: a key with few results loses none.
const SURPLUS: &str = "SELECT id, stored_bytes FROM (
         SELECT id, finished_at, stored_bytes,
             sum(stored_bytes) OVER (ORDER BY finished_at, id) - stored_bytes AS older
         FROM jobs WHERE finished_at IS NOT NULL AND stored_bytes > 0 AND account = (
             SELECT account FROM jobs WHERE finished_at IS NOT NULL
             GROUP BY account ORDER BY sum(stored_bytes) DESC, account LIMIT 1)) AS oldest
     WHERE older < (SELECT sum(stored_bytes) FROM jobs WHERE finished_at IS NOT NULL) - $1
     ORDER BY finished_at LIMIT $2";

/// Jobs that concurrent, uncommitted transactions may be inserting: a batch on each connection of
/// several servers. Where the queue has less room than this, submissions are serialized so that
/// each counts the others' jobs.
const ON_THEIR_WAY: usize = 4000;

/// What is known of a submitter while its jobs are taken in.
struct Queue {
    limits: KeyLimits,
    has_account: bool,
    /// Bytes of its results, with the estimates of its unfinished jobs.
    used: u64,
    /// Its waiting jobs, by their priority.
    waiting: BTreeMap<i32, u64>,
    /// Digest and job of each idempotency key that has one.
    names: HashMap<String, (Vec<u8>, JobId)>,
}

impl Queue {
    /// Checks a job against the limits of its key.
    fn check(&self, job: &NewJob) -> Result<(), StoreError> {
        let limits = self.limits;
        let (queued, used, needed) =
            (self.waiting.values().sum::<u64>(), self.used, job.result_bytes);
        let is_low = |limit: &i16| !job.interactive && job.priority > *limit;
        let is_reached = |limit: &u32| queued >= u64::from(*limit);
        let exceeds = |limit: &u64| needed.saturating_add(used) > *limit;
        let priority = limits.priority.filter(is_low).map(|limit| Quota::Priority { limit });
        let of_queue = || limits.queued.filter(is_reached).map(|limit| Quota::Queued { limit });
        let of_room = || {
            let limit = limits.stored_bytes.filter(exceeds);
            limit.map(|limit| Quota::Stored { limit, used, needed })
        };
        let quota = priority.or_else(of_queue).or_else(of_room);
        quota.map_or(Ok(()), |quota| Err(StoreError::QuotaExceeded { quota }))
    }
}

/// What becomes of a job.
enum Decision {
    /// It is a new job.
    New,
    /// It came before, under the same idempotency key: as another job of these, or stored.
    Replayed(JobId),
    Refused(StoreError),
}

fn account_of(job: &NewJob) -> Uuid {
    job.submitter.map(KeyId::uuid).unwrap_or_default()
}

async fn lock_intake<C: Messages>(line: &mut C) -> Result<(), StoreError> {
    let mut message = C::part();
    message.push(C::DIALECT.one_intake, &[]);
    line.send(message).await.map(drop)
}

/// Locks the row of a key and returns its limits. Until the transaction ends, no other submission
/// under this key proceeds: jobs are counted, and idempotency keys recorded, one after the other. A
/// transaction that locks the row of a key locks it before it locks the intake, never after; one
/// without a key locks the intake first.
async fn lock<C: Messages>(
    line: &mut C,
    key: Option<KeyId>,
    by_key: KeyLimits,
    now: i64,
) -> Result<KeyLimits, StoreError> {
    let Some(key) = key else {
        lock_intake(line).await?;
        return Ok(KeyLimits::default());
    };
    let mut message = C::part();
    message.push(
        &[
            "SELECT max_queued, max_running, max_stored, max_priority, revoked_at IS NOT NULL,
                 expires_at FROM api_keys WHERE id = $1",
            C::DIALECT.lock,
        ]
        .concat(),
        &[Value::Id(key.uuid())],
    );
    let answers = line.send(message).await?;
    let row = answers.first().and_then(|rows| rows.first());
    let row = row.map(C::columns::<SubmitterRow>).transpose()?;
    Ok(row.map_or(Ok(KeyLimits::default()), |row| limits_of(row, now))?.or(by_key))
}

/// Reads the number of all waiting jobs, and what is known of a submitter.
async fn look<C: Messages>(
    line: &mut C,
    account: Uuid,
    limits: KeyLimits,
    jobs: &[NewJob],
) -> Result<(usize, Queue), StoreError> {
    let account = [Value::Id(account)];
    let mut message = C::part();
    message.push(QUEUED, &[]);
    message.push(WAITING, &account);
    message.push("SELECT count(*) FROM accounts WHERE id = $1", &account);
    if limits.stored_bytes.is_some() {
        message.push(STORED, &account);
    } else {
        message.push("SELECT CAST(0 AS BIGINT)", &[]);
    }
    let names: Vec<&str> =
        jobs.iter().filter_map(|job| Some(job.idempotency.as_ref()?.key.as_str())).collect();
    for name in &names {
        message.push(KNOWN, &[account[0], Value::Text(Some(name))]);
    }
    let mut answers = line.send(message).await?.into_iter();
    let mut next = || answers.next().unwrap_or_default();
    let number = |rows: Vec<C::Row>| {
        let number = rows.first().map(C::columns::<(i64,)>).transpose()?;
        number.map_or_else(|| Err(damaged("no count")), |(number,)| count::<_, u64>(number))
    };
    let queued = number(next())?;
    let mut waiting = BTreeMap::new();
    for row in next() {
        let (priority, jobs): (i32, i64) = C::columns(&row)?;
        waiting.insert(priority, count(jobs)?);
    }
    let has_account = number(next())? > 0;
    let used = number(next())?;
    let mut known = HashMap::new();
    for name in names {
        for row in next() {
            let (digest, job): (Vec<u8>, Uuid) = C::columns(&row)?;
            known.insert(name.to_owned(), (digest, JobId::from(job)));
        }
    }
    Ok((count(queued)?, Queue { limits, has_account, used, waiting, names: known }))
}

/// Decides what becomes of a job, and counts it if it is taken in.
fn decide(job: &NewJob, queue: &mut Queue, queued: &mut usize, capacity: usize) -> Decision {
    if let Some(name) = &job.idempotency
        && let Some((digest, first)) = queue.names.get(&name.key)
    {
        return if *digest == name.digest {
            Decision::Replayed(*first)
        } else {
            Decision::Refused(StoreError::KeyReused)
        };
    }
    if *queued >= capacity {
        return Decision::Refused(StoreError::QueueFull { queued: *queued });
    }
    if let Err(refused) = queue.check(job) {
        return Decision::Refused(refused);
    }
    *queued += 1;
    *queue.waiting.entry(i32::from(job.priority)).or_default() += 1;
    queue.used = queue.used.saturating_add(job.result_bytes);
    if let Some(name) = &job.idempotency {
        queue.names.insert(name.key.clone(), (name.digest.to_vec(), job.id));
    }
    Decision::New
}

/// Appends the statements that insert a job.
fn push_job(message: &mut Message, job: &NewJob, now: i64) -> Result<(), StoreError> {
    let (id, account) = (Value::Id(job.id.uuid()), Value::Id(account_of(job)));
    let kept: BTreeMap<_, _> =
        job.tags.clone().into_iter().chain(job.about.iter().flat_map(About::labels)).collect();
    let (tags, trace) = (to_json(&kept)?, job.trace.map(|trace| trace.to_string()));
    let values = [
        id,
        Value::number(job.priority),
        Value::number(job.memory),
        Value::Text(Some(&tags)),
        job.submitter.map_or(Value::Number(None), |key| Value::Id(key.uuid())),
        Value::Number(Some(now)),
        Value::number(job.result_bytes),
        account,
        Value::Text(trace.as_deref()),
    ];
    message.push(INSERT, &values);
    message.push(REQUEST, &[id, Value::Bytes(&pack(&job.request)?)]);
    let words: Vec<_> = job.words.iter().map(|word| label_of(word)).collect();
    let words = words.iter().map(|(name, value)| (name, value));
    for (name, value) in job.tags.iter().chain(words) {
        message.push(TAG, &[id, Value::Text(Some(name)), Value::Text(Some(value))]);
    }
    if let Some(name) = &job.idempotency {
        let (key, digest) = (Value::Text(Some(&name.key)), Value::Bytes(&name.digest));
        message.push(TAKE_NAME, &[account, key, digest, id]);
    }
    if let Some(url) = &job.callback_url {
        let values = [id, Value::Id(Uuid::now_v7()), Value::Text(Some(url))];
        message.push(deliveries::ADD, &values);
    }
    Ok(())
}

/// Takes jobs in: returns one outcome for each, in order. Their number does not matter for the
/// number of messages.
pub(super) async fn enqueue_all<C: Messages + Reading>(
    line: &mut C,
    jobs: Vec<NewJob>,
    limits: StoreLimits,
    now: i64,
) -> Result<Vec<Result<Enqueued, StoreError>>, StoreError> {
    let (mut queues, mut queued) = (HashMap::<Uuid, Queue>::new(), 0);
    let mut ended = Vec::new();
    for job in &jobs {
        let account = account_of(job);
        if queues.contains_key(&account) || ended.contains(&account) {
            continue;
        }
        let of_key = match lock(line, job.submitter, limits.by_key, now).await {
            Err(StoreError::KeyEnded) => {
                ended.push(account);
                continue;
            }
            of_key => of_key?,
        };
        let mut known = look(line, account, of_key, &jobs).await?;
        // A submission without a key already holds this lock.
        let is_nearly_full = known.0.saturating_add(ON_THEIR_WAY) >= limits.queue_capacity;
        if is_nearly_full && job.submitter.is_some() {
            lock_intake(line).await?;
            known = look(line, account, of_key, &jobs).await?;
        }
        queued = known.0;
        queues.insert(account, known.1);
    }
    let mut message = C::part();
    for (account, _) in queues.iter().filter(|(_, queue)| !queue.has_account) {
        message.push(ACCOUNT, &[Value::Id(*account)]);
    }
    let mut decisions = Vec::with_capacity(jobs.len());
    for job in &jobs {
        let decision = match queues.get_mut(&account_of(job)) {
            Some(queue) => decide(job, queue, &mut queued, limits.queue_capacity),
            None => Decision::Refused(StoreError::KeyEnded),
        };
        if matches!(decision, Decision::New) {
            push_job(&mut message, job, now)?;
        }
        decisions.push(decision);
    }
    line.send(message).await?;
    let mut ahead = Places::of(&queues, &jobs, &decisions);
    let mut taken = Vec::with_capacity(jobs.len());
    for (job, decision) in jobs.into_iter().zip(decisions) {
        taken.push(match decision {
            Decision::New => {
                let place = ahead.next(&job);
                Ok(Enqueued { job: record(job, place, now)?, replayed: false })
            }
            Decision::Replayed(first) => {
                Ok(Enqueued { job: line.find(first).await?, replayed: true })
            }
            Decision::Refused(error) => Err(error),
        });
    }
    Ok(taken)
}

/// Waiting jobs before the next new job, by account and priority.
struct Places(HashMap<Uuid, BTreeMap<i32, u64>>);

impl Places {
    /// The places once all new jobs are in the queue.
    fn of(queues: &HashMap<Uuid, Queue>, jobs: &[NewJob], decisions: &[Decision]) -> Self {
        let mut places: HashMap<_, _> =
            queues.iter().map(|(account, queue)| (*account, queue.waiting.clone())).collect();
        for (job, _) in jobs.iter().zip(decisions).filter(|(_, it)| matches!(it, Decision::New)) {
            if let Some(waiting) = places.get_mut(&account_of(job)) {
                *waiting.entry(i32::from(job.priority)).or_default() -= 1;
            }
        }
        Self(places)
    }

    /// Returns the number of jobs before a new one; the next of its priority is behind it.
    fn next(&mut self, job: &NewJob) -> u64 {
        let priority = i32::from(job.priority);
        let Some(waiting) = self.0.get_mut(&account_of(job)) else { return 0 };
        let ahead = waiting.range(priority..).map(|(_, jobs)| jobs).sum();
        *waiting.entry(priority).or_default() += 1;
        ahead
    }
}

/// The record of a new job.
fn record(job: NewJob, place: u64, now: i64) -> Result<JobRecord, StoreError> {
    Ok(JobRecord {
        id: job.id,
        state: JobState::Queued,
        about: job.about,
        tags: job.tags,
        priority: job.priority,
        submitter: job.submitter,
        created_at: time(now)?,
        started_at: None,
        finished_at: None,
        attempts: 0,
        queue_position: Some(count(place)?),
        cancel_requested: false,
        iterations: 0,
        latest: None,
        has_report: false,
        failure: None,
        has_callback: job.callback_url.is_some(),
    })
}

pub(super) async fn cancel<C: Messages + Reading>(
    line: &mut C,
    id: JobId,
    now: i64,
) -> Result<JobRecord, StoreError> {
    let mut message = C::part();
    message.push(CANCEL, &[Value::Id(id.uuid()), Value::Number(Some(now))]);
    line.send(message).await?;
    line.find(id).await
}

/// Writes one row to show that the database accepts writes.
pub(super) async fn record_health<C: Messages>(line: &mut C, now: i64) -> Result<(), StoreError> {
    let mut message = C::part();
    message.push(HEALTH, &[Value::Number(Some(now))]);
    match line.send(message).await?.first() {
        Some(rows) if rows.len() == 1 => Ok(()),
        _ => Err(damaged("a table that has one row has none, or several")),
    }
}

/// Removes those of the jobs that have ended; returns their number.
pub(super) async fn delete<C: Messages>(
    line: &mut C,
    jobs: &[JobId],
) -> Result<usize, StoreError> {
    let mut message = C::part();
    message.push(DELETE, &[Value::Jobs(jobs)]);
    Ok(line.send(message).await?.first().map_or(0, Vec::len))
}

/// Selects jobs that a sweep removes, [`SWEEP`] at most, with the bytes of their results: those
/// whose time is over, and then those beyond the room for results.
pub(super) async fn to_sweep<C: Messages>(
    line: &mut C,
    retention: &Retention,
    now: Option<i64>,
) -> Result<Vec<(JobId, u64)>, StoreError> {
    let [succeeded, failed] =
        [retention.succeeded, retention.failed].map(|keep| Value::number(keep.as_micros()));
    let (most, mut message) = (Value::number(SWEEP), C::part());
    message.push(OLD, &[Value::Time(now), succeeded, failed, most]);
    if let Some(bytes) = retention.stored_bytes {
        message.push(SURPLUS, &[Value::number(bytes), most]);
    }
    let mut jobs = BTreeMap::new();
    for row in line.send(message).await?.into_iter().flatten().take(SWEEP) {
        let (id, bytes): (Uuid, i64) = C::columns(&row)?;
        jobs.insert(id, count(bytes)?);
    }
    Ok(jobs.into_iter().map(|(id, bytes)| (JobId::from(id), bytes)).collect())
}
