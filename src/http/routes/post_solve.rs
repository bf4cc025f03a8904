//! `POST /v1/solve`: solve a job while the client waits.
//!
//! | ending | answer |
//! |---|---|
//! | there is a report, converged or not | 200, its `status` says which |
//! | past the time limit | 202, as `POST /v1/jobs`; the job goes on |
//! | the input turned out impossible | 422 |
//! | the solver or the program failed | 500 |
//! | stopped before there was a report | 409 |
//! | the client hung up | the job is cancelled |

use std::sync::Arc;

use axum::extract::State;
use axum::response::Response;
use tokio::runtime::Handle;

use super::get_result::finished;
use crate::http::access::Caller;
use crate::http::body::JobBody;
use crate::http::{HttpState, Problem, wire};
use crate::jobs::{Desk, JobId, Submission};

/// Somebody waits: these jobs go before queued ones of ordinary priority.
const URGENT: i16 = 1;

pub(in crate::http) async fn post_solve(
    State(state): State<HttpState>,
    caller: Caller,
    JobBody(text): JobBody,
) -> Result<Response, Problem> {
    state.rates.take(caller.key())?;
    let submission = Submission {
        request: text,
        priority: URGENT,
        submitter: caller.key(),
        ephemeral: true,
        idempotency_key: None,
    };
    let id = state.desk.submit(submission).await?.job.id;
    let mut hang_up = HangUp { desk: Arc::clone(&state.desk), job: Some(id) };
    let mut record = state.desk.wait(id, state.settings.solve_limit).await?;
    if !record.state.is_finished() {
        record = state.desk.keep(id).await?;
    }
    hang_up.job = None;
    if !record.state.is_finished() {
        return Ok(wire::accepted(&record));
    }
    finished(&state, &record).await
}

/// Cancels the job when the handler is dropped before its end, which is what happens when the client goes.
struct HangUp {
    desk: Arc<Desk>,
    job: Option<JobId>,
}

impl Drop for HangUp {
    fn drop(&mut self) {
        let (Some(id), Ok(runtime)) = (self.job, Handle::try_current()) else { return };
        let desk = Arc::clone(&self.desk);
        runtime.spawn(async move {
            if let Err(error) = desk.cancel(id).await {
                tracing::warn!(job = %id, %error, "cannot cancel the job of a client that hung up");
            }
        });
    }
}
