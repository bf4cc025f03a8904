//! `GET /v1/jobs/{id}/pressure.csv`, `subsurface.csv`, `field.vtu`, `pressure.svg`, `depth.svg`: the result in the
//! forms that other programs read.
//!
//! The tables hold every step of a sweep and name it in a column. The others show one step, the last one unless
//! `?step=` names another, counted from 1 as in the tables.

use axum::extract::State;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};

use super::get_result::no_result;
use crate::http::job_path::JobPath;
use crate::http::query::{Step, wrong};
use crate::http::{HttpState, Problem, ProblemType};
use crate::jobs::{Export, ExportError, ExportFailure, JobId};

pub(in crate::http) async fn get_export(
    State(state): State<HttpState>,
    JobPath(id): JobPath,
    Step(step): Step,
    form: Export,
) -> Result<Response, Problem> {
    if step.is_some() && !form.shows_one_step() {
        return Err(wrong(format!("{} holds every step and takes no step", form.file_name())));
    }
    match state.desk.export(id, form, step).await {
        Ok(text) => Ok(file(id, form, text)),
        Err(ExportFailure::NoResult) => Err(no_result(&state.desk.get(id).await?)),
        Err(ExportFailure::Store(error)) => Err(error.into()),
        Err(ExportFailure::Export(error)) => Err(unavailable(&error)),
        Err(error @ ExportFailure::Unreadable(_)) => {
            tracing::error!(job = %id, %error, "no export");
            Err(Problem::new(ProblemType::Internal, "the stored result cannot be read"))
        }
    }
}

fn file(id: JobId, form: Export, text: String) -> Response {
    // Figures are looked at, the rest is for other programs.
    let is_figure = matches!(form, Export::PressureSvg | Export::DepthSvg);
    let disposition = if is_figure { "inline" } else { "attachment" };
    let disposition = format!("{disposition}; filename=\"{id}-{}\"", form.file_name());
    let headers = [(CONTENT_TYPE, form.media_type().to_owned()), (CONTENT_DISPOSITION, disposition)];
    (headers, text).into_response()
}

fn unavailable(error: &ExportError) -> Problem {
    let kind = match error {
        ExportError::NoStep(_) => ProblemType::InvalidQuery,
        ExportError::NoSubsurface | ExportError::NoFields => ProblemType::NotInResult,
        ExportError::Drawing(_) => ProblemType::Internal,
    };
    Problem::new(kind, error.to_string())
}
