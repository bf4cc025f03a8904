//! Results as files of other programs.

use std::future::ready;

use axum::body::Body;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use brinell_solver::job::Named as _;

use super::access::Caller;
use super::result_body::no_result;
use super::written_body::written;
use super::{HttpState, Problem, ProblemType};
use crate::jobs::{Export, ExportError, ExportFailure, JobId};

/// Answers with the result of a job as a file with a name.
pub(super) async fn export_file(
    state: &HttpState,
    caller: Caller,
    id: JobId,
    form: Export,
    step: Option<usize>,
) -> Result<Response, Problem> {
    // From here on, the export holds a step in memory.
    let turn = state.turn(caller.key()).await;
    let body = match state.jobs.export(id, form, step, caller.key()).await {
        Ok(exported) => Body::from_stream(written(ready(turn), |sender| exported.send(sender))),
        Err(ExportFailure::NoResult) => return Err(no_result(&state.jobs.get(id).await?)),
        Err(ExportFailure::Store(error)) => return Err(error.into()),
        Err(ExportFailure::Export(error)) => return Err(unavailable(&error)),
    };
    // A browser shows figures and saves all other files.
    let disposition =
        if form.media_type().starts_with("image/") { "inline" } else { "attachment" };
    let disposition = format!("{disposition}; filename=\"{id}-{}\"", form.name());
    let headers =
        [(CONTENT_TYPE, form.media_type().to_owned()), (CONTENT_DISPOSITION, disposition)];
    Ok((headers, body).into_response())
}

fn unavailable(error: &ExportError) -> Problem {
    let kind = match error {
        ExportError::NoStep(_) => ProblemType::StepNotFound,
        ExportError::NoSubsurface
        | ExportError::NoFields
        | ExportError::NoLayers
        | ExportError::NoFlow
        | ExportError::Rolling
        | ExportError::NotRolling
        | ExportError::NoFatigue
        | ExportError::NoHardness
        | ExportError::NoCurve => ProblemType::NotInResult,
        ExportError::Drawing(_) | ExportError::Fields(_) => ProblemType::Internal,
    };
    Problem::new(kind, error.to_string())
}
