//! `GET /v1/jobs/{id}/fields/{step}`: mesh and nodal fields of a step as arrays of numbers.

use std::future::ready;
use std::io::{self, Write};
use std::mem;
use std::sync::{Arc, Mutex, PoisonError};

use axum::body::Body;
use axum::extract::{Path, State};
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE, ETAG};
use axum::http::{HeaderMap, HeaderName, StatusCode};
use axum::response::{IntoResponse, Response};
use bytes::Bytes;
use tokio::sync::mpsc::Sender;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::http::access::Caller;
use crate::http::job_path::JobPath;
use crate::http::negotiation::is_known;
use crate::http::query::Arrays;
use crate::http::result_body::{self, Fields, no_result};
use crate::http::written_body::written;
use crate::http::{HttpState, Problem, ProblemType};
use crate::jobs::{JobId, KeyId, StoreError};
use brinell_solver::report::{FIELD_NAMES, LAYER_NAMES, NpyFile};

/// Mesh and nodal fields of a step, as arrays of numbers
///
/// An archive that numpy opens (`.npz`): `lower/von_mises.npy` and so on, in single precision, not
/// compressed. A fifth of the size of the same fields in the result, and read without parsing.
#[utoipa::path(
    get, path = "/v1/jobs/{id}/fields/{step}", tag = "results",
    params(
        ("id" = JobId, Path, description = "The job's id, as its `Location` has it."),
        ("step" = usize, Path, description = "The step, counted from \
                                              1.", minimum = 1, example = 1),
        Arrays,
    ),
    responses(
        (
            status = OK,
            description = "The archive.",
            body = Vec<u8>, content_type = "application/octet-stream",
            headers(
                ("ETag" = String, description = "Name of these bytes, for `If-None-Match`."),
            ),
        ),
        (status = NOT_MODIFIED, description = "The client has these bytes already."),
    ),
    extensions(("x-problems" = json!([
        "step-not-found", "job-unfinished", "no-result", "not-in-result"
    ]))),
)]
pub(in crate::http) async fn get_fields(
    State(state): State<HttpState>,
    caller: Caller,
    JobPath(id): JobPath,
    Path((_, step)): Path<(String, String)>,
    wanted: Arrays,
    headers: HeaderMap,
) -> Result<Response, Problem> {
    let no_step =
        || Problem::new(ProblemType::StepNotFound, format!("the result has no step {step}"));
    let number =
        step.parse::<usize>().ok().and_then(|step| step.checked_sub(1)).ok_or_else(no_step)?;
    let Some(head) = state.jobs.result(id).await? else {
        return Err(no_result(&state.jobs.get(id).await?));
    };
    if number >= head.steps {
        return Err(no_step());
    }
    let turn = state.turn(caller.key()).await;
    let Some(fields) = state.jobs.fields(id, number).await? else {
        let detail =
            "the result has no mesh fields; solve the job with \"output\": {\"fields\": true}";
        return Err(Problem::new(ProblemType::NotInResult, detail));
    };
    let known = match fields.layout().member() {
        "layers" => &LAYER_NAMES[..],
        _ => &FIELD_NAMES,
    };
    if wanted.0.as_ref().is_some_and(|names| !names.iter().any(|name| known.contains(name))) {
        let detail = format!("the result has none of these arrays; it has {}", known.join(", "));
        return Err(Problem::new(ProblemType::NotInResult, detail));
    }
    let tag = format!("\"{id}-{}-{step}-npz{}\"", head.attempt, wanted.name());
    let common: [(HeaderName, &str); 3] = [
        (CONTENT_TYPE, "application/octet-stream"),
        (ETAG, &tag),
        (CACHE_CONTROL, "private, no-cache"),
    ];
    if is_known(&tag, &headers) {
        return Ok((StatusCode::NOT_MODIFIED, common).into_response());
    }
    let files = fields.layout().npy(wanted.0.as_deref());
    let write = move |sender| send(state, caller.key(), fields, files, sender);
    Ok((common, Body::from_stream(written(ready(turn), write))).into_response())
}

/// Sends an archive of these files (zip, not compressed); each piece is read and written when the
/// client takes it.
async fn send(
    state: HttpState,
    key: Option<KeyId>,
    mut fields: Fields,
    files: Vec<NpyFile>,
    sender: Sender<Bytes>,
) -> Result<(), StoreError> {
    let written = Written::default();
    let mut archive = ZipWriter::new_stream(written.clone());
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for NpyFile { name, header, numbers } in files {
        archive.start_file(name, options).map_err(StoreError::unavailable)?;
        archive.write_all(&header).map_err(StoreError::unavailable)?;
        for piece in numbers {
            let piece = result_body::written(&state, key, &mut fields, piece).await?;
            archive.write_all(&piece).map_err(StoreError::unavailable)?;
            if sender.send(written.take()).await.is_err() {
                return Ok(());
            }
        }
    }
    archive.finish().map_err(StoreError::unavailable)?;
    let _ = sender.send(written.take()).await;
    Ok(())
}

/// The bytes of an archive that are not sent yet.
#[derive(Clone, Default)]
struct Written(Arc<Mutex<Vec<u8>>>);

impl Written {
    fn take(&self) -> Bytes {
        mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner)).into()
    }
}

impl Write for Written {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
