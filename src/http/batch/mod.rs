//! Several jobs in one request, each answered as by a request of its own.

mod fetch;
mod members;
mod request;

pub(super) use fetch::fetched;
pub(super) use request::{BatchOfIds, BatchOfJobs, read_ids, read_jobs};

use serde::Serialize;
use utoipa::ToSchema;

use super::problem::{Problem, ProblemDocument};
use super::wire::JobDocument;
use crate::jobs::JobId;

/// Most jobs in one request.
pub(super) const MAX_JOBS: usize = 100;

/// What became of the jobs of a request, in their order.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct BatchAnswer {
    /// One for each job of the request, in the same order.
    pub(super) jobs: Vec<BatchItem>,
    /// How many there were of which nothing is wrong.
    pub(super) accepted: usize,
    /// How many were refused.
    pub(super) refused: usize,
}

/// What became of one job: `job` or `problem`.
#[derive(Debug, Serialize, ToSchema)]
pub(super) struct BatchItem {
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
    pub(super) fn submitted(job: JobDocument, replayed: bool) -> Self {
        let status = if job.done { 200 } else { 202 };
        Self { status, id: None, replayed, job: Some(job), problem: None }
    }

    /// A job that exists.
    pub(super) fn found(job: JobDocument) -> Self {
        Self { status: 200, id: Some(job.id), replayed: false, job: Some(job), problem: None }
    }

    /// An error; `id` is the job that was asked for.
    pub(super) fn refused(id: Option<JobId>, problem: Problem) -> Self {
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
    pub(super) fn of(jobs: Vec<BatchItem>) -> Self {
        let refused = jobs.iter().filter(|item| item.problem.is_some()).count();
        Self { accepted: jobs.len() - refused, refused, jobs }
    }
}
