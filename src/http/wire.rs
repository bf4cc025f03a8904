//! What goes over the wire beside results and problems.

use std::collections::BTreeMap;

use axum::Json;
use axum::body::Bytes;
use axum::http::header::{CONTENT_LOCATION, CONTENT_TYPE, LOCATION};
use axum::http::{HeaderName, StatusCode};
use axum::response::{IntoResponse, Response};
use jiff::Timestamp;
use serde::Serialize;

use super::problem::Problem;
use crate::jobs::{IterationRecord, JobEstimate, JobId, JobRecord, JobState};

/// Addresses that belong to a job.
#[derive(Debug, Clone, Serialize)]
pub struct Links {
    /// The job itself.
    #[serde(rename = "self")]
    pub job: String,
    /// Its result.
    pub result: String,
    /// Its events as they happen.
    pub events: String,
    /// Where to POST to stop it.
    pub cancel: String,
}

impl Links {
    fn of(id: JobId) -> Self {
        let job = format!("/v1/jobs/{id}");
        Self {
            result: format!("{job}/result"),
            events: format!("{job}/events"),
            cancel: format!("{job}/cancel"),
            job,
        }
    }
}

/// Receipt for a job that has been queued.
#[derive(Debug, Clone, Serialize)]
pub struct Receipt {
    /// Its name.
    pub id: JobId,
    /// Where it stands.
    pub status: JobState,
    /// Where to go from here.
    pub links: Links,
}

/// A job as its watchers see it.
#[derive(Debug, Clone, Serialize)]
pub struct JobDocument {
    /// Its name.
    pub id: JobId,
    /// Where it stands.
    pub status: JobState,
    /// Jobs before it in the queue, while it is queued.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub queue_position: Option<usize>,
    /// Whether somebody asked it to stop.
    pub cancel_requested: bool,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// When its latest attempt began.
    pub started_at: Option<Timestamp>,
    /// When it reached its final state.
    pub finished_at: Option<Timestamp>,
    /// How often it was taken up.
    pub attempts: u32,
    /// Larger goes first.
    pub priority: i16,
    /// Labels.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub tags: BTreeMap<String, String>,
    /// How far it has come.
    pub progress: Progress,
    /// Why it failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<Problem>,
    /// Where to go from here.
    pub links: Links,
}

/// A page of jobs.
#[derive(Debug, Clone, Serialize)]
pub struct JobList {
    /// Newest first. Places in the queue are told job by job only.
    pub jobs: Vec<JobDocument>,
    /// `?cursor=` of the next page; `null` on the last.
    pub next_cursor: Option<JobId>,
}

/// How far a job has come.
#[derive(Debug, Clone, Serialize)]
pub struct Progress {
    /// Iterations made.
    pub iterations: usize,
    /// The latest of them.
    pub latest: Option<IterationRecord>,
}

/// Answer to a job that could be solved.
#[derive(Debug, Clone, Serialize)]
pub struct Validation {
    /// Always true; a job at fault is answered by a problem.
    pub valid: bool,
    /// What it would cost.
    pub estimate: JobEstimate,
}

impl From<JobRecord> for JobDocument {
    fn from(record: JobRecord) -> Self {
        Self {
            id: record.id,
            status: record.state,
            queue_position: record.queue_position,
            cancel_requested: record.cancel_requested,
            created_at: record.created_at,
            started_at: record.started_at,
            finished_at: record.finished_at,
            attempts: record.attempts,
            priority: record.priority,
            tags: record.tags,
            progress: Progress { iterations: record.iterations, latest: record.latest },
            error: record.failure.as_ref().map(Problem::from),
            links: Links::of(record.id),
        }
    }
}

/// 202 with a receipt: the job is on its way.
pub fn accepted(record: &JobRecord) -> Response {
    let links = Links::of(record.id);
    let location = [(LOCATION, links.job.clone())];
    let receipt = Receipt { id: record.id, status: record.state, links };
    (StatusCode::ACCEPTED, location, Json(receipt)).into_response()
}

/// 200 with a report.
pub fn report(id: JobId, json: Bytes) -> Response {
    let headers: [(HeaderName, String); 2] =
        [(CONTENT_TYPE, "application/json".to_owned()), (CONTENT_LOCATION, Links::of(id).result)];
    (headers, json).into_response()
}
