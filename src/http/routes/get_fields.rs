//! `GET /v1/jobs/{id}/fields/{step}`: mesh and nodal fields of a step as arrays of numbers.

use std::future::ready;
use std::ops::Range;

use axum::body::Body;
use axum::extract::{Path, State};
use axum::http::HeaderMap;
use axum::response::Response;
use bytes::Bytes;
use tokio::sync::mpsc::Sender;

use crate::http::access::Caller;
use crate::http::job_path::JobPath;
use crate::http::query::{Arrays, ArraysQuery};
use crate::http::result_body::{Fields, no_result};
use crate::http::written_body::written;
use crate::http::{HttpState, Problem, ProblemType, result_body};
use crate::jobs::{JobId, KeyId, StoreError};
use brinell_solver::report::FieldPiece;

/// Mesh and nodal fields of a step, as arrays of numbers
///
/// In single precision, little-endian, behind a header of JSON that lists the arrays: docs/results.md has the layout. A
/// fifth of the size of the same fields in the result, and read without parsing.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/fields/{step}", tag = "results",
    params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        ("step" = usize, Path, description = "The step, counted from 1.", minimum = 1, example = 1),
        ArraysQuery,
        ("Range" = Option<String>, Header, description = "One range of bytes (RFC 9110).", example = "bytes=0-1023"),
    ),
    responses(
        (status = OK, description = "The arrays.", body = Vec<u8>, content_type = "application/octet-stream", headers(
            ("ETag" = String, description = "Name of these bytes, for `If-None-Match` and `If-Range`."),
        )),
        (status = PARTIAL_CONTENT, description = "The range that was asked for.", body = Vec<u8>, content_type = "application/octet-stream"),
        (status = NOT_MODIFIED, description = "The client has these bytes already."),
        (status = RANGE_NOT_SATISFIABLE, description = "The range begins behind the end."),
    ),
    extensions(("x-problems" = json!(["step-not-found", "job-unfinished", "no-result", "not-in-result"]))),
)]
pub(in crate::http) async fn get_fields(
    State(state): State<HttpState>,
    caller: Caller,
    JobPath(id): JobPath,
    Path((_, step)): Path<(String, String)>,
    wanted: Arrays,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let no_step = || Problem::new(ProblemType::StepNotFound, format!("the result has no step {step}"));
    let number = step.parse::<usize>().ok().and_then(|step| step.checked_sub(1)).ok_or_else(no_step)?;
    let Some(head) = state.jobs.result(id).await? else { return Err(no_result(&state.jobs.get(id).await?)) };
    if number >= head.steps {
        return Err(no_step());
    }
    let turn = state.turn(caller).await;
    let Some(fields) = state.jobs.fields(id, number).await? else {
        let detail = "the result has no mesh fields; solve the job with \"output\": {\"fields\": true}";
        return Err(Problem::new(ProblemType::NotInResult, detail));
    };
    let arrays = fields.layout().single_precision(wanted.0.as_deref());
    let arrays = arrays.map_err(|error| StoreError::damaged(error.to_string()))?;
    let length = arrays.iter().filter_map(FieldPiece::length).sum();
    let tag = format!("\"{id}-{}-{step}-f32{}\"", head.attempt, wanted.name());
    let write = move |range| move |sender| send(state, caller.key(), fields, arrays, range, sender);
    let body = |range| Body::from_stream(written(ready(turn), write(range)));
    Ok(result_body::bytes(&tag, "application/octet-stream", length, &headers, body))
}

/// Sends the part of the pieces that is in a range; each is read and made when the client takes
/// it.
async fn send(
    state: HttpState,
    key: Option<KeyId>,
    mut fields: Fields,
    pieces: Vec<FieldPiece>,
    range: Range<usize>,
    sender: Sender<Bytes>,
) -> Result<(), StoreError> {
    let mut begin = 0;
    for piece in pieces {
        let end = begin + piece.length().unwrap_or(0);
        let (from, to) = (range.start.max(begin), range.end.min(end));
        if from < to {
            let text = result_body::written(&state, key, &mut fields, piece).await?;
            let _ = sender.send(text.slice(from - begin..to - begin)).await;
        }
        begin = end;
    }
    Ok(())
}
