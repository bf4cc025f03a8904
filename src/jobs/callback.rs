//! Announcements of the ends of jobs to those who handed them in: what is to be delivered, and how
//! far that has come.

use std::time::Duration;

use async_trait::async_trait;
use brinell_solver::job::Named;
use jiff::Timestamp;
use serde::Serialize;
use strum::{IntoStaticStr, VariantArray};
use utoipa::ToSchema;
use uuid::Uuid;

use super::{JobId, KeyId, StoreError, TraceParent};

/// How far the announcement of a job's end has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, ToSchema, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum CallbackState {
    /// The job has not ended.
    Waiting,
    /// The job has ended, and no attempt was successful so far.
    Pending,
    /// The receiver has taken it.
    Delivered,
    /// Every attempt failed.
    Failed,
}

impl Named for CallbackState {}

/// The announcement of a job's end.
#[derive(Debug, Clone, PartialEq, Serialize, ToSchema)]
pub struct Callback {
    /// What the receiver finds in `webhook-id`, the same in every attempt.
    pub id: Uuid,
    /// How far it has come.
    pub state: CallbackState,
    /// Attempts so far.
    pub attempts: u32,
    /// When the next attempt is made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub next_attempt_at: Option<Timestamp>,
    /// HTTP status of the last attempt, if there was one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(minimum = 100, maximum = 999)]
    pub last_status: Option<u16>,
    /// Why the last attempt failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub last_error: Option<String>,
    /// When the receiver took it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub delivered_at: Option<Timestamp>,
}

/// One attempt to announce the end of a job.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Delivery {
    /// The job.
    pub job: JobId,
    /// The same in every attempt.
    pub id: Uuid,
    /// Where to.
    pub url: String,
    /// Which attempt, counted from 1.
    pub attempt: u32,
    /// The API key that the job came under.
    pub submitter: Option<KeyId>,
    /// Trace that the submission belongs to.
    pub trace: Option<TraceParent>,
}

/// How an attempt ended.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DeliveryEnd {
    /// The receiver has taken it.
    Delivered {
        /// HTTP status.
        status: u16,
    },
    /// It failed.
    Failed {
        /// HTTP status, if there was an answer.
        status: Option<u16>,
        /// Why.
        error: String,
        /// When to try again; `None` is never.
        retry: Option<Duration>,
    },
    /// There was no attempt: there is no room for another one to this receiver now.
    Postponed {
        /// When to try again.
        retry: Duration,
    },
}

/// Keeps announcements, beside the jobs they are of.
#[async_trait]
pub trait DeliveryStore: Send + Sync + 'static {
    /// Hands out up to `limit` announcements that are due, the most overdue first. One whose end
    /// is not told within `lease` is handed out again.
    async fn claim_deliveries(
        &self,
        limit: usize,
        lease: Duration,
    ) -> Result<Vec<Delivery>, StoreError>;

    /// Tells how attempts ended; without effect on those of which another has been made meanwhile.
    async fn end_deliveries(&self, ends: &[(Delivery, DeliveryEnd)]) -> Result<(), StoreError>;

    /// The announcement of a job's end, if it has one.
    async fn callback(&self, job: JobId) -> Result<Option<Callback>, StoreError>;
}
