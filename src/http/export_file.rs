//! Results in the forms that other programs read.

use axum::body::Body;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};

use super::access::Caller;
use super::result_body::no_result;
use super::{HttpState, Problem, ProblemType};
use crate::jobs::{Export, ExportError, ExportFailure, JobId};

/// The result of a job in another form.
pub(super) async fn export(
    state: &HttpState,
    id: JobId,
    form: Export,
    step: Option<usize>,
) -> Result<String, Problem> {
    match state.jobs.export(id, form, step).await {
        Ok(text) => Ok(text),
        Err(ExportFailure::NoResult) => Err(no_result(&state.jobs.get(id).await?)),
        Err(ExportFailure::Store(error)) => Err(error.into()),
        Err(ExportFailure::Export(error)) => Err(unavailable(&error)),
        Err(error @ ExportFailure::Unreadable(_)) => {
            tracing::error!(job = %id, %error, "no export");
            Err(Problem::new(ProblemType::Internal, "the stored result cannot be read"))
        }
    }
}

/// The result of a job in another form, as it is sent.
pub(super) async fn export_file(
    state: &HttpState,
    caller: Caller,
    id: JobId,
    form: Export,
    step: Option<usize>,
) -> Result<Response, Problem> {
    if is_figure(form) {
        return Ok(file(id, form, export(state, id, form, step).await?).into_response());
    }
    // Lines for each node of a mesh, or of each step.
    let place = state.texts.take(caller.key()).await;
    let text = export(state, id, form, step).await?;
    Ok(file(id, form, place.send(text.into())).into_response())
}

/// Figures are looked at and small, the rest is for other programs.
fn is_figure(form: Export) -> bool {
    form.media_type().starts_with("image/")
}

/// A file as it is sent, with a name to keep it under.
pub(super) fn file(id: JobId, form: Export, text: impl Into<Body>) -> impl IntoResponse {
    let disposition = if is_figure(form) { "inline" } else { "attachment" };
    let disposition = format!("{disposition}; filename=\"{id}-{}\"", form.file_name());
    let headers = [(CONTENT_TYPE, form.media_type().to_owned()), (CONTENT_DISPOSITION, disposition)];
    (headers, text.into())
}

fn unavailable(error: &ExportError) -> Problem {
    let kind = match error {
        ExportError::NoStep(_) => ProblemType::StepNotFound,
        ExportError::NoSubsurface | ExportError::NoFields | ExportError::NoFlow | ExportError::NoCurve => {
            ProblemType::NotInResult
        }
        ExportError::Drawing(_) => ProblemType::Internal,
    };
    Problem::new(kind, error.to_string())
}
