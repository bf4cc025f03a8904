//! `GET /v1/jobs/{id}/events`: a job as server-sent events, from its beginning or from where the
//! client left off.
//!
//! | event | id | data |
//! |---|---|---|
//! | `state` | none, or `A-N-end` with the last | the job, as `GET /v1/jobs/{id}` |
//! | `iteration` | `A-N`: the N-th iteration of attempt A | the iteration |
//!
//! The stream ends with the job. A client that comes back with `Last-Event-ID: A-N` gets what
//! followed; one that has seen the end gets 204, which tells it not to come again. When a job is
//! taken up anew, its iterations begin again under the next attempt.

use std::future::ready;
use std::time::Duration;

use axum::extract::State;
use axum::http::{HeaderMap, StatusCode};
use axum::response::sse::{KeepAlive, Sse};
use axum::response::{IntoResponse, Response};

use crate::http::access::Caller;
use crate::http::event_stream::{EventPosition, Follower};
use crate::http::job_path::JobPath;
use crate::http::prefix::Prefix;
use crate::http::written_body::written;
use crate::http::{HttpState, Problem};
use crate::jobs::JobId;

/// Time between signs of life while nothing happens.
const KEEP_ALIVE: Duration = Duration::from_secs(15);

/// A job as server-sent events
///
/// From its beginning, or from where the client left off. `state` events carry the job as `GET
/// /v1/jobs/{id}` answers it, also as a preliminary solve progresses; `iteration` events carry an
/// iteration each under the id `A-N`, the N-th of attempt A. The last event has the id `A-N-end`.
/// When a job is taken up anew, its iterations begin again under the next attempt.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/events", tag = "jobs",
    params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        ("Last-Event-ID" = Option<String>, Header, description = "Id of the last event seen: \
            what followed is \
            sent. What is no such id is ignored.", example = "1-12"),
    ),
    responses(
        (status = OK, description = "The stream, which ends with the job. It is read event by \
                                     event, not as a whole: the `data` of a `state` event is a \
                                     `Job`, that of an `iteration` event an \
                                     `Iteration`.", body = String,
            content_type = "text/event-stream"),
        (status = NO_CONTENT, description = "The client has seen the end; it need not come \
                                             again."),
    ),
    extensions(("x-problems" = json!(["too-many-streams"]))),
)]
pub(in crate::http) async fn get_events(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    prefix: Prefix,
    caller: Caller,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let last = headers.get("last-event-id").and_then(|id| id.to_str().ok());
    let record = state.jobs.get(id).await?;
    if last.is_some_and(|last| last == EventPosition::end_of(&record))
        && record.state.is_finished()
    {
        return Ok(StatusCode::NO_CONTENT.into_response());
    }
    let permit = state.streams.open(caller.key())?;
    let position = last.and_then(EventPosition::parse);
    let follow = move |events| Follower::new(state, id, position, prefix, events).run();
    let events = written(ready(permit), follow);
    let stream = Sse::new(events).keep_alive(KeepAlive::new().interval(KEEP_ALIVE));
    // A proxy like nginx would otherwise collect events before it passes them on.
    Ok(([("x-accel-buffering", "no")], stream).into_response())
}
