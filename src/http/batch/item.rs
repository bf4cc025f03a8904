//! What became of the jobs of a request.

use serde::Serialize;
use utoipa::ToSchema;

use crate::http::problem::{Problem, ProblemDocument};
use crate::http::wire::JobDocument;
use crate::jobs::JobId;

/// Most jobs in one request.
pub(in crate::http) const MAX_JOBS: usize = 100;

/// What became of the jobs of a request, in their order.
#[derive(Debug, Serialize, ToSchema)]
pub(in crate::http) struct BatchAnswer {
    /// One for each job of the request, in the same order.
    pub(in crate::http) jobs: Vec<BatchItem>,
    /// How many there were of which nothing is wrong.
    pub(in crate::http) accepted: usize,
    /// How many were refused.
    pub(in crate::http) refused: usize,
}

/// What became of one job: `job` or `problem`.
#[derive(Debug, Serialize, ToSchema)]
pub(in crate::http) struct BatchItem {
    /// The HTTP status that a request for this job alone would have been answered with.
    #[schema(minimum = 200, maximum = 599, example = 202)]
    status: u16,
    /// The job that was asked for; of jobs that are handed in, its new id is in `job`.
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<JobId>,
    /// The same submission came before under its idempotency key.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[schema(required = false)]
    replayed: bool,
    /// The job as it is now.
    #[serde(skip_serializing_if = "Option::is_none")]
    job: Option<JobDocument>,
    /// Why not; pointers are those of the job by itself.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<ProblemDocument>)]
    problem: Option<Problem>,
}

impl BatchItem {
    /// A job that was handed in.
    pub(in crate::http) fn submitted(job: JobDocument, replayed: bool) -> Self {
        let status = if job.done { 200 } else { 202 };
        Self { status, id: None, replayed, job: Some(job), problem: None }
    }

    /// A job that exists.
    pub(in crate::http) fn found(job: JobDocument) -> Self {
        Self { status: 200, id: Some(job.id), replayed: false, job: Some(job), problem: None }
    }

    /// An error; `id` is the job that was asked for.
    pub(in crate::http) fn refused(id: Option<JobId>, problem: Problem) -> Self {
        Self {
            status: problem.kind().status().as_u16(),
            id,
            replayed: false,
            job: None,
            problem: Some(problem),
        }
    }
}

impl BatchAnswer {
    pub(in crate::http) fn of(jobs: Vec<BatchItem>) -> Self {
        let refused = jobs.iter().filter(|item| item.problem.is_some()).count();
        Self { accepted: jobs.len() - refused, refused, jobs }
    }
}
