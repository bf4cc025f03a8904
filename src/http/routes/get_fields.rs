//! `GET /v1/jobs/{id}/fields/{step}`: mesh and nodal fields of a step as arrays of numbers.

use std::ops::Range;
use std::vec;

use axum::body::{Body, Bytes};
use axum::extract::{Path, State};
use axum::http::HeaderMap;
use axum::response::Response;
use futures_util::{Stream, stream};

use crate::http::job_path::JobPath;
use crate::http::query::{Arrays, ArraysQuery};
use crate::http::result_body::{Fields, no_result};
use crate::http::{HttpState, Problem, ProblemType, result_body};
use crate::jobs::{JobId, StoreError};
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
    let Some(fields) = state.jobs.fields(id, number).await? else {
        let detail = "the result has no mesh fields; solve the job with \"output\": {\"fields\": true}";
        return Err(Problem::new(ProblemType::NotInResult, detail));
    };
    let arrays = fields.layout().single_precision(wanted.0.as_deref());
    let arrays = arrays.map_err(|error| StoreError::damaged(error.to_string()))?;
    let length = arrays.iter().filter_map(FieldPiece::length).sum();
    let tag = format!("\"{id}-{}-{step}-f32{}\"", head.attempt, wanted.name());
    let body = |range| Body::from_stream(Sent::new(state, fields, arrays, range).stream());
    Ok(result_body::bytes(&tag, "application/octet-stream", length, &headers, body))
}

/// A range of pieces, each of which is read and written when the client takes it.
struct Sent {
    state: HttpState,
    fields: Fields,
    /// Each with the part of it that is in the range.
    pieces: vec::IntoIter<(FieldPiece, Range<usize>)>,
}

impl Sent {
    fn new(state: HttpState, fields: Fields, pieces: Vec<FieldPiece>, range: Range<usize>) -> Self {
        let mut begin = 0;
        let mut within = Vec::new();
        for piece in pieces {
            let end = begin + piece.length().unwrap_or(0);
            let (from, to) = (range.start.max(begin), range.end.min(end));
            if from < to {
                within.push((piece, from - begin..to - begin));
            }
            begin = end;
        }
        Self { state, fields, pieces: within.into_iter() }
    }

    fn stream(self) -> impl Stream<Item = Result<Bytes, StoreError>> + Send {
        stream::try_unfold(self, async |mut sent| {
            let Some((piece, part)) = sent.pieces.next() else { return Ok(None) };
            let text = result_body::written(&sent.state, &mut sent.fields, piece).await?;
            Ok(Some((text.slice(part), sent)))
        })
    }
}
