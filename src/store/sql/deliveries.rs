//! Statements about announcements (webhook deliveries).

use std::time::Duration;

use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::claiming::until;
use super::codec::{count, damaged, time};
use crate::jobs::{Callback, CallbackState, Delivery, DeliveryEnd, JobId, KeyId, StoreError};
use brinell_solver::job::Named as _;

pub(super) const ADD: &str = "INSERT INTO deliveries (job, id, url) VALUES ($1, $2, $3)";
const SCHEDULE: &str =
    "UPDATE deliveries SET state = 'pending', due_at = (SELECT finished_at FROM jobs WHERE id = $1)
     WHERE job = $1 AND state = 'waiting'";
const END: &str =
    "UPDATE deliveries SET state = $3, due_at = $4, status = $5, error = $6, delivered_at = $7
     WHERE job = $1 AND attempts = $2 AND state = 'pending'";
const POSTPONE: &str = "UPDATE deliveries SET due_at = $3, attempts = attempts - 1
     WHERE job = $1 AND attempts = $2 AND state = 'pending'";
const FIND: &str = "SELECT id, state, attempts, due_at, status, error, delivered_at FROM \
                    deliveries WHERE job = $1";

/// An announcement as selected by [`FIND`].
type FindRow = (Uuid, String, i32, Option<i64>, Option<i32>, Option<String>, Option<i64>);

/// An announcement that is due: job, id, URL, attempt, API key and trace of the job.
type DueRow = (Uuid, Uuid, String, i32, Option<Uuid>, Option<String>);

/// Announcements on a connection.
pub(in crate::store) trait Deliveries: Send {
    /// Makes the announcement of a job due that has just ended.
    fn schedule_delivery(
        &mut self,
        job: JobId,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn claim_deliveries(
        &mut self,
        limit: usize,
        lease: Duration,
        now: i64,
    ) -> impl Future<Output = Result<Vec<Delivery>, StoreError>> + Send;
    fn end_delivery(
        &mut self,
        delivery: &Delivery,
        end: &DeliveryEnd,
        now: i64,
    ) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn find_callback(
        &mut self,
        job: JobId,
    ) -> impl Future<Output = Result<Option<Callback>, StoreError>> + Send;
}

fn callback(
    (id, state, attempts, due, status, error, delivered): FindRow,
) -> Result<Callback, StoreError> {
    Ok(Callback {
        id,
        state: CallbackState::of_word(&state)
            .ok_or_else(|| damaged(format!("state {state:?}")))?,
        attempts: count(attempts)?,
        next_attempt_at: due.map(time).transpose()?,
        last_status: status.map(count).transpose()?,
        last_error: error,
        delivered_at: delivered.map(time).transpose()?,
    })
}

macro_rules! deliveries {
    ($database:ty, $connection:ty, $lock:literal) => {
        impl Deliveries for $connection {
            async fn schedule_delivery(&mut self, job: JobId) -> Result<(), StoreError> {
                sqlx::query::<$database>(SCHEDULE).bind(job.uuid()).execute(self).await?;
                Ok(())
            }

            async fn claim_deliveries(
                &mut self,
                limit: usize,
                lease: Duration,
                now: i64,
            ) -> Result<Vec<Delivery>, StoreError> {
                let claim = sqlx::query_as::<$database, DueRow>(concat!(
                    "UPDATE deliveries SET attempts = attempts + 1, due_at = $2
                     WHERE job IN (SELECT job FROM deliveries
                         WHERE state = 'pending' AND due_at <= $1 ORDER BY due_at LIMIT $3",
                    $lock,
                    ") RETURNING job, id, url, attempts,
                           (SELECT submitter FROM jobs WHERE jobs.id = deliveries.job),
                           (SELECT traceparent FROM jobs WHERE jobs.id = deliveries.job)"
                ));
                let limit = i64::try_from(limit).unwrap_or(i64::MAX);
                let claim = claim.bind(now).bind(until(now, lease)).bind(limit);
                let rows = claim.fetch_all(self).await?;
                let read = |(job, id, url, attempt, submitter, trace): DueRow| {
                    let (job, submitter) = (JobId::from(job), submitter.map(KeyId::from));
                    let trace = trace.and_then(|text| text.parse().ok());
                    Ok(Delivery { job, id, url, attempt: count(attempt)?, submitter, trace })
                };
                rows.into_iter().map(read).collect()
            }

            async fn end_delivery(
                &mut self,
                delivery: &Delivery,
                end: &DeliveryEnd,
                now: i64,
            ) -> Result<(), StoreError> {
                let attempt = i32::try_from(delivery.attempt).unwrap_or(i32::MAX);
                let (state, due, status, error) = match end {
                    DeliveryEnd::Postponed { retry } => {
                        let postpone = sqlx::query::<$database>(POSTPONE);
                        let postpone = postpone.bind(delivery.job.uuid()).bind(attempt);
                        postpone.bind(until(now, *retry)).execute(self).await?;
                        return Ok(());
                    }
                    DeliveryEnd::Failed { status, error, retry: Some(retry) } => {
                        (CallbackState::Pending, Some(until(now, *retry)), *status, Some(error))
                    }
                    DeliveryEnd::Failed { status, error, retry: None } => {
                        (CallbackState::Failed, None, *status, Some(error))
                    }
                    DeliveryEnd::Delivered { status } => {
                        (CallbackState::Delivered, None, Some(*status), None)
                    }
                };
                sqlx::query::<$database>(END)
                    .bind(delivery.job.uuid())
                    .bind(attempt)
                    .bind(state.name())
                    .bind(due)
                    .bind(status.map(i32::from))
                    .bind(error)
                    .bind((state == CallbackState::Delivered).then_some(now))
                    .execute(self)
                    .await?;
                Ok(())
            }

            async fn find_callback(&mut self, job: JobId) -> Result<Option<Callback>, StoreError> {
                let found = sqlx::query_as::<$database, FindRow>(FIND).bind(job.uuid());
                found.fetch_optional(self).await?.map(callback).transpose()
            }
        }
    };
}

deliveries!(Sqlite, SqliteConnection, "");
deliveries!(Postgres, PgConnection, " FOR UPDATE SKIP LOCKED");
