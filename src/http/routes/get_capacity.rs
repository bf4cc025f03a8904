//! `GET /v1/capacity`: what this node can do and how busy the queue is.

use axum::Json;
use axum::extract::State;

use crate::http::batch::MAX_JOBS;
use crate::http::wire::{CapacityDocument, Limits, Queue};
use crate::http::{HttpState, Problem};
use crate::jobs::JobState;

/// What this node can do and how busy the queue is
#[utoipa::path(
    get, path = "/v1/capacity", tag = "service",
    responses((status = OK, description = "Capacity and load.", body = CapacityDocument)),
    extensions(("x-problems" = json!(["store-unavailable"]))),
)]
pub(in crate::http) async fn get_capacity(
    State(state): State<HttpState>,
) -> Result<Json<CapacityDocument>, Problem> {
    let counts = state.jobs.store().counts().await?;
    let jobs = |wanted: JobState| counts.get(&wanted).copied().unwrap_or(0);
    let (settings, capacity) = (&state.settings, &state.settings.capacity);
    Ok(Json(CapacityDocument {
        solvers: capacity.solvers,
        memory_bytes: capacity.memory_bytes,
        queue: Queue {
            queued: jobs(JobState::Queued),
            running: jobs(JobState::Running),
            capacity: capacity.queued_jobs,
        },
        limits: Limits {
            body_bytes: settings.max_body_bytes,
            job_memory_bytes: state.jobs.limits().job_bytes,
            result_bytes: state.jobs.limits().result_bytes,
            batch_jobs: MAX_JOBS,
            solve_seconds: settings.solve_limit.as_secs_f64(),
            wait_seconds: settings.wait_limit.as_secs_f64(),
            job_seconds: capacity.job_seconds,
        },
    }))
}
