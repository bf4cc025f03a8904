//! Statements of a worker that holds a lease. Each names owner and attempt in its condition, so
//! that a lost lease changes nothing.

use std::time::Duration;

use sqlx::types::Uuid;

use super::claiming::until;
use super::codec::{failure_json, pack, pack_records, to_json};
use super::message::{Message, Messages, Value};
use crate::jobs::{
    HISTORY_PAGE, IterationRecord, JobId, Lease, LeaseStatus, NumberedIteration, Outcome,
    StepResult, StoreError, WorkerId,
};
use brinell_solver::job::Named as _;

/// The job whose lease holds.
macro_rules! held {
    ($columns:literal) => {
        concat!(
            "SELECT ",
            $columns,
            " FROM jobs WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running'"
        )
    };
}

/// Sets columns of the job whose lease holds.
macro_rules! set {
    ($columns:literal) => {
        concat!(
            "UPDATE jobs SET ",
            $columns,
            " WHERE id = $1 AND owner = $2 AND attempts = $3 AND state = 'running' RETURNING id"
        )
    };
}

const PROGRESS: &str = set!("iterations = coalesce($4, iterations), latest = $5");
const STEPS: &str = set!(
    "steps = coalesce($4, steps),
     stored_bytes = CASE WHEN $6 THEN $5 WHEN $4 <= steps THEN stored_bytes
         ELSE stored_bytes + $5 END"
);
/// Ends a job; without a report, its steps no longer count.
const FINISH: &str = set!(
    "state = $4, finished_at = $5, has_report = $6, failure = $7,
     iterations = coalesce($8, iterations), latest = coalesce($9, latest),
     steps = CASE WHEN $6 THEN coalesce($10, steps) ELSE 0 END,
     stored_bytes = CASE WHEN NOT $6 THEN 0 WHEN $12 THEN $11 ELSE stored_bytes + $11 END,
     owner = NULL, leased_until = NULL"
);
const RELEASE: &str = set!(
    "state = CASE WHEN cancel_requested THEN 'cancelled' ELSE 'queued' END,
     finished_at = CASE WHEN cancel_requested THEN $4 END,
     started_at = CASE WHEN cancel_requested THEN started_at END,
     owner = NULL, leased_until = NULL,
     iterations = CASE WHEN cancel_requested THEN iterations ELSE 0 END,
     latest = CASE WHEN cancel_requested THEN latest END, steps = 0, stored_bytes = 0"
);
/// Returns the jobs to the queue that a worker has leased and does not know of.
const GIVE_BACK: &str = "UPDATE jobs SET state = 'queued', started_at = NULL, owner = NULL,
         leased_until = NULL
     WHERE state = 'running' AND owner = $1 AND id NOT IN $2";
/// Charges the solver time of an attempt to its key. Time charged before decays to zero within a
/// minute.
const SETTLE: &str = concat!(
    "UPDATE accounts SET settled_at = $4, spent = $4 - (",
    held!("started_at"),
    ") + CASE WHEN $4 - settled_at < 60000000
         THEN spent * (60000000 - ($4 - settled_at)) / 60000000 ELSE 0 END WHERE id = (",
    held!("account"),
    ")"
);
/// Makes the announcement of the job due; a further condition and a parenthesis follow.
const DUE: &str = concat!(
    "UPDATE deliveries SET state = 'pending', due_at = $4 WHERE state = 'waiting' AND job = (",
    held!("id"),
);
const REPORT: &str = concat!("INSERT INTO reports (job, body) ", held!("id, $4"));
const FORGET_STEPS: [&str; 2] = [
    concat!("DELETE FROM result_steps WHERE job = (", held!("id"), ")"),
    concat!("DELETE FROM field_parts WHERE job = (", held!("id"), ")"),
];
const FORGET_ITERATIONS: &str =
    concat!("DELETE FROM iterations WHERE job = (", held!("id"), " AND NOT cancel_requested)");
// A repeated write, after its acknowledgement was lost, changes nothing: numbers are those of the
// attempt.
const ITERATIONS: [&str; 2] = [
    concat!("INSERT INTO iterations (job, first, last, records) ", held!("id, $4, $5, $6")),
    " ON CONFLICT (job, first) DO UPDATE SET last = excluded.last, records = excluded.records",
];
const STEP: [&str; 2] = [
    concat!("INSERT INTO result_steps (job, step, body) ", held!("id, $4, $5")),
    " ON CONFLICT (job, step) DO UPDATE SET body = excluded.body",
];
const FIELDS: [&str; 2] = [
    concat!("INSERT INTO field_parts (job, step, first, body) ", held!("id, $4, $5, $6")),
    " ON CONFLICT (job, step, first) DO UPDATE SET body = excluded.body",
];

/// Values of the condition that a lease holds, and further ones.
fn fenced<'a, const N: usize>(lease: &Lease, more: [Value<'a>; N]) -> Vec<Value<'a>> {
    let lease =
        [Value::Id(lease.job.uuid()), Value::Id(lease.owner.uuid()), Value::number(lease.attempt)];
    lease.into_iter().chain(more).collect()
}

/// An insert that a takeover of the job waits for, and its heartbeat does not.
fn shared<C: Messages>([select, conflict]: [&str; 2]) -> String {
    [select, C::DIALECT.share, conflict].concat()
}

/// Begins a message that holds the row of the job until its end. Nothing else in it changes
/// anything if the lease is lost.
fn locked<C: Messages>(lease: &Lease) -> Message {
    let mut message = C::message();
    message.push(&[held!("id"), C::DIALECT.lock].concat(), &fenced(lease, []));
    message
}

/// Sends a message whose last statement returns the job if the lease holds.
async fn send_held<C: Messages>(line: &mut C, message: Message) -> Result<(), StoreError> {
    let last = message.len() - 1;
    let answers = line.send(message).await?;
    match answers.get(last) {
        Some(rows) if !rows.is_empty() => Ok(()),
        _ => Err(StoreError::LeaseLost),
    }
}

/// Returns the number of steps of the job with these (`None` without any), the bytes of these, and
/// whether they replace all earlier ones.
fn sum_up(steps: &[StepResult]) -> (Value<'static>, Value<'static>, Value<'static>) {
    let count = steps.last().map(|last| i64::try_from(last.number + 1).unwrap_or(i64::MAX));
    let bytes = steps.iter().map(StepResult::bytes).sum::<usize>();
    let begin_anew = begins_anew(steps);
    (Value::Number(count), Value::number(bytes), Value::Flag(begin_anew))
}

fn begins_anew(steps: &[StepResult]) -> bool {
    steps.first().is_some_and(|first| first.number == 0)
}

fn push_forget_steps(message: &mut Message, lease: &Lease) {
    for forget in FORGET_STEPS {
        message.push(forget, &fenced(lease, []));
    }
}

fn push_records<C: Messages>(
    message: &mut Message,
    lease: &Lease,
    records: &[NumberedIteration],
) -> Result<(), StoreError> {
    for page in records.chunks(HISTORY_PAGE) {
        let packed = pack_records(page)?;
        let first = page.first().map_or(0, |iteration| iteration.number);
        let place = [Value::number(first), count_of(page), Value::Bytes(&packed)];
        message.push(&shared::<C>(ITERATIONS), &fenced(lease, place));
    }
    Ok(())
}

/// Returns the number of iterations of the attempt up to the last of these, if there are any.
fn count_of(records: &[NumberedIteration]) -> Value<'static> {
    records.last().map_or(Value::Number(None), |last| Value::number(last.number + 1))
}

/// Extends the leases of one worker. Also without any, the answer is a sign of life of the store.
pub(super) async fn heartbeat<C: Messages>(
    line: &mut C,
    leases: &[Lease],
    lease: Duration,
    now: Option<i64>,
) -> Result<Vec<LeaseStatus>, StoreError> {
    let jobs: Vec<JobId> = leases.iter().map(|lease| lease.job).collect();
    let owner = leases.first().map_or_else(Uuid::nil, |first| first.owner.uuid());
    let values = [
        Value::Time(now),
        Value::Number(Some(until(0, lease))),
        Value::Id(owner),
        Value::Jobs(&jobs),
    ];
    let mut message = C::message();
    // Passes over a row that another transaction changes; the next heartbeat renews it.
    let beat = [
        "UPDATE jobs SET leased_until = $1 + $2 WHERE id IN (SELECT id FROM jobs
             WHERE owner = $3 AND state = 'running' AND id IN $4",
        C::DIALECT.lock_change,
        ")",
    ];
    message.push(&beat.concat(), &values);
    message.push(
        "SELECT id, attempts, cancel_requested FROM jobs
             WHERE owner = $3 AND state = 'running' AND id IN $4",
        &values,
    );
    let answers = line.send(message).await?;
    let rows = answers.into_iter().nth(1).unwrap_or_default();
    let rows = rows.iter().map(C::columns).collect::<Result<Vec<(Uuid, i32, bool)>, _>>()?;
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

pub(super) async fn record_progress<C: Messages>(
    line: &mut C,
    lease: &Lease,
    records: &[NumberedIteration],
    latest: &IterationRecord,
) -> Result<(), StoreError> {
    let mut message = C::message();
    push_records::<C>(&mut message, lease, records)?;
    let latest = to_json(latest)?;
    let values = [count_of(records), Value::Text(Some(&latest))];
    message.push(PROGRESS, &fenced(lease, values));
    send_held(line, message).await
}

/// Removes all earlier steps if these begin anew.
pub(super) async fn begin_steps<C: Messages>(
    line: &mut C,
    lease: &Lease,
    steps: &[StepResult],
) -> Result<(), StoreError> {
    if !begins_anew(steps) {
        return Ok(());
    }
    let mut message = locked::<C>(lease);
    push_forget_steps(&mut message, lease);
    message.push(held!("id"), &fenced(lease, []));
    send_held(line, message).await
}

/// A part of the result of a step.
#[derive(Debug, Clone, Copy)]
pub(super) enum ResultPart<'a> {
    /// Fields from this byte on.
    Fields(usize, &'a [u8]),
    /// The report, through which the fields are found.
    Report(&'a [u8]),
}

/// Writes a part of a step, without counting it.
pub(super) async fn append_part<C: Messages>(
    line: &mut C,
    lease: &Lease,
    step: usize,
    part: ResultPart<'_>,
) -> Result<(), StoreError> {
    let [step, first] = [step, if let ResultPart::Fields(first, _) = part { first } else { 0 }]
        .map(|number| i64::try_from(number).unwrap_or(i64::MAX));
    let rows = match part {
        ResultPart::Fields(_, bytes) => {
            line.insert(&shared::<C>(FIELDS), lease, &[step, first], bytes).await?
        }
        ResultPart::Report(bytes) => {
            line.insert(&shared::<C>(STEP), lease, &[step], bytes).await?
        }
    };
    if rows == 0 { Err(StoreError::LeaseLost) } else { Ok(()) }
}

/// Counts steps that are written.
pub(super) async fn count_steps<C: Messages>(
    line: &mut C,
    lease: &Lease,
    steps: &[StepResult],
) -> Result<(), StoreError> {
    let (count, bytes, begin_anew) = sum_up(steps);
    let mut message = C::message();
    message.push(STEPS, &fenced(lease, [count, bytes, begin_anew]));
    send_held(line, message).await
}

/// Ends a job. `steps` are counted, and `written` too unless they are written already.
pub(super) async fn finish<C: Messages>(
    line: &mut C,
    lease: &Lease,
    records: &[NumberedIteration],
    steps: &[StepResult],
    are_written: bool,
    outcome: &Outcome,
    now: Option<i64>,
) -> Result<(), StoreError> {
    let mut message = locked::<C>(lease);
    push_records::<C>(&mut message, lease, records)?;
    let (report, failure) = match outcome {
        Outcome::Reported { report, .. } => (Some(pack(report)?), None),
        Outcome::Failed(failure) => (None, Some(failure_json(failure)?)),
        Outcome::Interrupted(_) => (None, None),
    };
    if report.is_none() || (!are_written && begins_anew(steps)) {
        push_forget_steps(&mut message, lease);
    }
    if let Some(report) = &report {
        for step in steps.iter().filter(|_| !are_written) {
            let number = Value::number(step.number);
            for (first, part) in step.parts() {
                let place = [number, Value::number(first), Value::Bytes(part)];
                message.push(&shared::<C>(FIELDS), &fenced(lease, place));
            }
            let place = [number, Value::Bytes(step.report.packed())];
            message.push(&shared::<C>(STEP), &fenced(lease, place));
        }
        message.push(REPORT, &fenced(lease, [Value::Bytes(report)]));
    }
    message.push(&[DUE, ")"].concat(), &fenced(lease, [Value::Time(now)]));
    // The row of the key is locked last, for as short as can be.
    message.push(SETTLE, &fenced(lease, [Value::Time(now)]));
    let latest = records.last().map(|last| to_json(&last.record)).transpose()?;
    let (count, bytes, begin_anew) = sum_up(steps);
    let values = [
        Value::Text(Some(outcome.state().name())),
        Value::Time(now),
        Value::Flag(report.is_some()),
        Value::Text(failure.as_deref()),
        count_of(records),
        Value::Text(latest.as_deref()),
        count,
        bytes,
        begin_anew,
    ];
    message.push(FINISH, &fenced(lease, values));
    send_held(line, message).await
}

/// Returns a job to the queue. The result is `Some(true)` if the job was cancelled instead, `None`
/// if the lease was lost.
pub(super) async fn release<C: Messages>(
    line: &mut C,
    lease: &Lease,
    now: Option<i64>,
) -> Result<Option<bool>, StoreError> {
    let mut message = locked::<C>(lease);
    message.push(FORGET_ITERATIONS, &fenced(lease, []));
    push_forget_steps(&mut message, lease);
    let due = [DUE, " AND cancel_requested)"].concat();
    message.push(&due, &fenced(lease, [Value::Time(now)]));
    message.push(&[RELEASE, ", cancel_requested"].concat(), &fenced(lease, [Value::Time(now)]));
    let last = message.len() - 1;
    let rows = line.send(message).await?.into_iter().nth(last).unwrap_or_default();
    let ended = rows.first().map(C::columns::<(Uuid, bool)>).transpose()?;
    Ok(ended.map(|(_, cancelled)| cancelled))
}

/// Returns the jobs to the queue that a worker has leased and does not know of.
pub(super) async fn give_back<C: Messages>(
    line: &mut C,
    owner: WorkerId,
    known: &[JobId],
) -> Result<(), StoreError> {
    let mut message = C::message();
    message.push(GIVE_BACK, &[Value::Id(owner.uuid()), Value::Jobs(known)]);
    line.send(message).await.map(drop)
}
