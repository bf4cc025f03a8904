//! Documents of the HTTP interface besides results and problems.

use std::collections::BTreeMap;

use axum::http::header::RETRY_AFTER;
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use brinell_solver::job::{Analysis, Job, Load, Units};
use jiff::Timestamp;
use serde::Serialize;
use utoipa::ToSchema;

use super::HttpState;
use super::openapi::{tags, units};
use super::prefix::Prefix;
use super::problem::{Problem, ProblemDocument};
use super::request_log::JobIdExtension;
use crate::jobs::{
    Callback, IterationRecord, JobEstimate, JobId, JobRecord, JobState, Retention, StoreError,
};

/// Seconds after which to ask again for a job that is not done.
const POLL_SECONDS: u16 = 1;

/// Addresses that belong to a job: those that answer in its present state.
#[derive(Debug, Clone, Serialize, ToSchema)]
#[serde(rename_all = "snake_case")]
pub struct Links {
    /// The job itself.
    #[serde(rename = "self")]
    #[schema(example = "/v1/jobs/0197e1f0-0000-7000-8000-000000000000")]
    pub job: String,
    /// What was submitted.
    pub request: String,
    /// Its events as they happen.
    pub events: String,
    /// Where to POST to stop it; until it is done.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cancel: Option<String>,
    /// Its result; as soon as it has one. So are the following.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub result: Option<String>,
    /// One row of figures for each step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub summary_csv: Option<String>,
    /// Contact pressure of all steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_csv: Option<String>,
    /// Contact pressure, drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_svg: Option<String>,
    /// Stresses over depth; where the job asks for them. In a list of jobs this and the following
    /// are left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub subsurface_csv: Option<String>,
    /// Stresses over depth, drawn; where the job asks for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth_svg: Option<String>,
    /// Mesh and fields for ParaView; where the job asks for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_vtu: Option<String>,
    /// Layers of half-spaces for ParaView, of a track its section; where a job in three dimensions
    /// asks for fields.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field_vtr: Option<String>,
    /// The increments of all loads; by flow theory. So are the following.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub increments_csv: Option<String>,
    /// The load-displacement curve of a hardness test.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hardness_csv: Option<String>,
    /// The passes of a load that rolls.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub passes_csv: Option<String>,
    /// The surfaces of both bodies after every load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface_csv: Option<String>,
    /// The surfaces of both bodies, drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface_svg: Option<String>,
    /// Force over approach, drawn; where all of several loads have converged.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load_approach_svg: Option<String>,
}

impl Links {
    fn of(record: &JobRecord, submitted: Option<&Job>, prefix: &Prefix) -> Self {
        let job = format!("{}/v1/jobs/{}", prefix.path(), record.id);
        let below = |name: &str| format!("{job}/{name}");
        let with_result = |name| record.has_report.then(|| below(name));
        // A stopped job has neither stresses nor fields.
        let is_whole = matches!(record.state, JobState::Succeeded | JobState::NotConverged);
        let has = |wanted: fn(&Job) -> bool| is_whole && submitted.is_some_and(wanted);
        let over_depth = |name| with_result(name).filter(|_| has(|job| job.output.subsurface));
        let of_flow = |name| {
            with_result(name).filter(|_| {
                has(|job| {
                    let has_increments = !matches!(job.load, Load::Onset | Load::Rolling(_));
                    job.has_memory() && has_increments
                })
            })
        };
        Self {
            request: below("request"),
            events: below("events"),
            cancel: (!record.state.is_finished()).then(|| below("cancel")),
            result: with_result("result"),
            summary_csv: with_result("summary.csv"),
            pressure_csv: with_result("pressure.csv"),
            pressure_svg: with_result("pressure.svg"),
            subsurface_csv: over_depth("subsurface.csv"),
            depth_svg: over_depth("depth.svg"),
            field_vtu: with_result("field.vtu")
                .filter(|_| has(|job| job.output.fields && !rolls(job))),
            field_vtr: with_result("field.vtr").filter(|_| {
                has(|job| job.output.fields && job.analysis == Analysis::ThreeDimensional)
            }),
            increments_csv: of_flow("increments.csv"),
            hardness_csv: of_flow("hardness.csv")
                .filter(|_| has(|job| job.load.hardness().is_some())),
            passes_csv: with_result("passes.csv").filter(|_| has(rolls)),
            surface_csv: of_flow("surface.csv"),
            surface_svg: of_flow("surface.svg"),
            load_approach_svg: with_result("load_approach.svg")
                .filter(|_| record.state == JobState::Succeeded && has(has_curve)),
            job,
        }
    }
}

/// Returns whether the load of a job rolls.
const fn rolls(job: &Job) -> bool {
    matches!(job.load, Load::Rolling(_))
}

/// Returns whether the converged loads give more than one point of force over approach. Flow
/// theory adds the unloaded state as a point.
fn has_curve(job: &Job) -> bool {
    fn differ<T: PartialEq>(values: &[T]) -> bool {
        values.windows(2).any(|pair| pair[0] != pair[1])
    }
    match &job.load {
        Load::Onset | Load::Rolling(_) => false,
        _ if job.has_memory() => true,
        Load::Target(_) => false,
        Load::Forces(sweep) | Load::Approaches(sweep) => differ(sweep),
        Load::History(history) => differ(history),
    }
}

/// A job: where it stands, where to go from here and, when it finishes within the time its client
/// waits, its result.
#[derive(Debug, Clone, Serialize, ToSchema)]
#[schema(as = Job)]
pub struct JobDocument {
    /// Its name.
    pub id: JobId,
    /// What people call it: the title of the job, or else its description. This and the following
    /// two are missing of jobs taken in before version 0.3.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(example = "cylinder R 20 on cylinder R 20, 500 N/mm, S355")]
    pub title: Option<String>,
    /// Bodies, load and materials in a line, in the units of the job.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// Units of its figures.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(schema_with = units, required = false)]
    pub units: Option<Units>,
    /// Where it stands.
    pub status: JobState,
    /// Whether nothing can happen to it any more.
    pub done: bool,
    /// Whether there is a result to fetch, of a stopped job as far as it came.
    pub has_result: bool,
    /// Jobs before it in the queue, while it is queued.
    #[serde(skip_serializing_if = "Option::is_none")]
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
    /// When it is removed with its result; `null` until it is done.
    #[schema(required)]
    pub expires_at: Option<Timestamp>,
    /// How often it was taken up.
    pub attempts: u32,
    /// Larger goes first.
    #[schema(minimum = -100, maximum = 100)]
    pub priority: i16,
    /// Labels.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    #[schema(schema_with = tags, required = false)]
    pub tags: BTreeMap<String, String>,
    /// How far it has come.
    pub progress: Progress,
    /// Why it failed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<ProblemDocument>)]
    pub error: Option<Problem>,
    /// The announcement of its end, where it was handed in with a `callback_url`; not in lists of
    /// jobs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub callback: Option<Callback>,
    /// Where to go from here.
    pub links: Links,
}

impl JobDocument {
    /// A job without what its request and its result say.
    pub fn brief(record: JobRecord, retention: &Retention, prefix: &Prefix) -> Self {
        Self::new(record, None, retention, prefix)
    }

    /// A job of this store. Its result is not inside.
    ///
    /// # Errors
    /// The store's.
    pub async fn of(
        state: &HttpState,
        record: JobRecord,
        prefix: &Prefix,
    ) -> Result<Self, StoreError> {
        let job = if record.has_report {
            let request = state.jobs.store().request(record.id).await?;
            Job::from_json(&request).ok()
        } else {
            None
        };
        let callback =
            if record.has_callback { state.jobs.callback(record.id).await? } else { None };
        Ok(Self { callback, ..Self::new(record, job.as_ref(), &state.settings.retention, prefix) })
    }

    /// Makes the document of a new job. If the store stops answering, it shows the job as it was
    /// accepted: an error would make the client submit it again.
    pub async fn taken_in(state: &HttpState, record: JobRecord, prefix: &Prefix) -> Self {
        let known = Self::brief(record.clone(), &state.settings.retention, prefix);
        Self::of(state, record, prefix).await.unwrap_or(known)
    }

    fn new(record: JobRecord, job: Option<&Job>, retention: &Retention, prefix: &Prefix) -> Self {
        let units = record.about.as_ref().map(|about| about.units);
        let (title, description) = record
            .about
            .as_ref()
            .map(|about| (about.title.clone(), about.description.clone()))
            .unzip();
        Self {
            id: record.id,
            title,
            description,
            units,
            status: record.state,
            done: record.state.is_finished(),
            has_result: record.has_report,
            queue_position: record.queue_position,
            cancel_requested: record.cancel_requested,
            created_at: record.created_at,
            started_at: record.started_at,
            finished_at: record.finished_at,
            expires_at: retention.expires_at(&record),
            attempts: record.attempts,
            priority: record.priority,
            callback: None,
            links: Links::of(&record, job, prefix),
            tags: record.tags,
            progress: Progress { iterations: record.iterations, latest: record.latest },
            error: record.failure.as_ref().map(|failure| Problem::from(failure).under(prefix)),
        }
    }
}

impl IntoResponse for JobDocument {
    /// Answers 200, with `Retry-After` if the job is not done.
    fn into_response(self) -> Response {
        let retry = (!self.done).then_some([(RETRY_AFTER, POLL_SECONDS)]);
        (retry, Extension(JobIdExtension(self.id)), Json(self)).into_response()
    }
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
    /// The latest of them. While `iterations` is 0, the latest iteration of a preliminary solve,
    /// which sizes meshes, increments or a force and which no history lists.
    #[schema(required)]
    pub latest: Option<IterationRecord>,
}

/// Answer to a job that could be solved.
#[derive(Debug, Clone, Serialize, ToSchema)]
pub struct Validation {
    /// Always true; a job at fault is answered by a problem.
    #[schema(example = true)]
    pub valid: bool,
    /// What it would cost.
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
    /// What a single request may ask for.
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
    /// Largest estimated result \[bytes\] of a job.
    pub result_bytes: u64,
    /// Most jobs in one request to `/v1/batch`.
    #[schema(example = 100)]
    pub batch_jobs: usize,
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
