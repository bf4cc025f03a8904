//! What goes over the wire beside results and problems.

use std::collections::BTreeMap;

use axum::http::StatusCode;
use axum::http::header::LOCATION;
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use jiff::Timestamp;
use serde::Serialize;
use utoipa::ToSchema;

use super::openapi;
use super::problem::Problem;
use super::request_log::JobIdExtension;
use crate::jobs::{IterationRecord, JobEstimate, JobId, JobRecord, JobState};

/// Addresses that belong to a job.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Links {
    /// The job itself.
    #[serde(rename = "self")]
    #[schema(example = "/v1/jobs/0197e1f0-0000-7000-8000-000000000000")]
    pub job: String,
    /// What was submitted.
    pub request: String,
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
            request: format!("{job}/request"),
            result: format!("{job}/result"),
            events: format!("{job}/events"),
            cancel: format!("{job}/cancel"),
            job,
        }
    }
}

/// Receipt for a job that has been queued.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Receipt {
    /// Its name.
    pub id: JobId,
    /// Where it stands.
    pub status: JobState,
    /// Where to go from here.
    pub links: Links,
}

/// A job as its watchers see it.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct JobDocument {
    /// Its name.
    pub id: JobId,
    /// Where it stands.
    pub status: JobState,
    /// Jobs before it in the queue, while it is queued.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(nullable = false)]
    pub queue_position: Option<usize>,
    /// Whether somebody asked it to stop.
    pub cancel_requested: bool,
    /// When it was accepted.
    pub created_at: Timestamp,
    /// When its latest attempt began.
    #[schema(required)]
    pub started_at: Option<Timestamp>,
    /// When it reached its final state.
    #[schema(required)]
    pub finished_at: Option<Timestamp>,
    /// How often it was taken up.
    pub attempts: u32,
    /// Larger goes first.
    #[schema(minimum = -100, maximum = 100)]
    pub priority: i16,
    /// Labels.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    #[schema(schema_with = openapi::tags, required = false)]
    pub tags: BTreeMap<String, String>,
    /// How far it has come.
    pub progress: Progress,
    /// Why it failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(schema_with = openapi::problem, required = false)]
    pub error: Option<Problem>,
    /// Where to go from here.
    pub links: Links,
}

/// A page of jobs.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct JobList {
    /// Newest first. Places in the queue are told job by job only.
    pub jobs: Vec<JobDocument>,
    /// `?cursor=` of the next page; `null` on the last.
    #[schema(required)]
    pub next_cursor: Option<JobId>,
}

/// How far a job has come.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Progress {
    /// Iterations made.
    pub iterations: usize,
    /// The latest of them.
    #[schema(schema_with = openapi::latest_iteration, required)]
    pub latest: Option<IterationRecord>,
}

/// Answer to a job that could be solved.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Validation {
    /// Always true; a job at fault is answered by a problem.
    #[schema(example = true)]
    pub valid: bool,
    /// What it would cost.
    #[schema(schema_with = openapi::estimate)]
    pub estimate: JobEstimate,
}

/// What a node can do and how busy the queue is.
#[derive(Debug, Clone, Serialize, ToSchema)]
#[schema(as = Capacity)]
pub struct CapacityDocument {
    /// Jobs solved here at the same time; 0 on a node without solvers.
    #[schema(example = 8)]
    pub solvers: usize,
    /// Memory \[bytes\] that they may need together.
    pub memory_bytes: u64,
    /// The queue, of all nodes that share it.
    pub queue: Queue,
    /// Bounds on single requests.
    pub limits: Limits,
}

/// The queue.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Queue {
    /// Jobs waiting.
    pub queued: usize,
    /// Jobs being solved.
    pub running: usize,
    /// Most jobs that may wait.
    #[schema(example = 10_000)]
    pub capacity: usize,
}

/// Bounds on single requests.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Limits {
    /// Largest body \[bytes\].
    #[schema(example = 1_048_576)]
    pub body_bytes: usize,
    /// Largest estimated memory \[bytes\] of a job.
    pub job_memory_bytes: u64,
    /// Longest time \[s\] `POST /v1/solve` waits for its result.
    #[schema(example = 30)]
    pub solve_seconds: f64,
    /// Longest time \[s\] `?wait=` and `Prefer: wait` wait.
    #[schema(example = 60)]
    pub wait_seconds: f64,
    /// Longest time \[s\] a job is solved for.
    #[schema(example = 600)]
    pub job_seconds: f64,
}

/// How the service is.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Health {
    /// In a word.
    #[schema(example = "ready")]
    pub status: &'static str,
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
    (StatusCode::ACCEPTED, location, Extension(JobIdExtension(record.id)), Json(receipt)).into_response()
}
