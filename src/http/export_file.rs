//! Results in the forms that other programs read.

use std::convert::Infallible;
use std::sync::Arc;

use axum::body::{Body, Bytes};
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use futures_util::stream;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use super::access::Caller;
use super::result_body::no_result;
use super::{HttpState, Problem, ProblemType};
use crate::jobs::{Export, ExportError, ExportFailure, JobId, KeyId, Turn, Turns};

/// Files that are in memory as a whole at a time, and those of one API key; callers without a key
/// are one key.
const FILES: usize = 8;
const FILES_OF_KEY: usize = 2;

/// Size \[bytes\] of the pieces that are sent.
const PIECE: usize = 64 << 10;

/// A bound on the files that are in memory as a whole while they are sent.
#[derive(Debug, Clone)]
pub(super) struct Files {
    places: Arc<Semaphore>,
    keys: Arc<Turns>,
}

impl Default for Files {
    fn default() -> Self {
        let (places, keys) = (Semaphore::new(FILES), Turns::new(FILES_OF_KEY));
        Self { places: Arc::new(places), keys: Arc::new(keys) }
    }
}

impl Files {
    /// Waits for a place.
    async fn place(&self, key: Option<KeyId>) -> FilePlace {
        let turn = self.keys.take(key.or(Some(KeyId::from(uuid::Uuid::nil())))).await;
        FilePlace { _place: Arc::clone(&self.places).acquire_owned().await.ok(), _turn: turn }
    }
}

/// The place of a file, free again when it is dropped.
#[derive(Debug)]
struct FilePlace {
    _place: Option<OwnedSemaphorePermit>,
    _turn: Turn,
}

/// A file, which keeps its place until its last piece is sent.
struct HeldFile {
    text: String,
    _place: FilePlace,
}

impl AsRef<[u8]> for HeldFile {
    fn as_ref(&self) -> &[u8] {
        self.text.as_bytes()
    }
}

impl HeldFile {
    /// In pieces, so that a body under a key can end before its end.
    fn into_body(self) -> Body {
        Body::from_stream(stream::unfold(Bytes::from_owner(self), async |mut rest| {
            let piece = rest.split_to(PIECE.min(rest.len()));
            (!piece.is_empty()).then_some((Ok::<_, Infallible>(piece), rest))
        }))
    }
}

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
    if form != Export::FieldVtu {
        return Ok(file(id, form, export(state, id, form, step).await?).into_response());
    }
    // The one form with a line for each node and element.
    let place = state.files.place(caller.key()).await;
    let text = export(state, id, form, step).await?;
    Ok(file(id, form, HeldFile { text, _place: place }.into_body()).into_response())
}

/// A file as it is sent, with a name to keep it under.
pub(super) fn file(id: JobId, form: Export, text: impl Into<Body>) -> impl IntoResponse {
    // Figures are looked at, the rest is for other programs.
    let is_figure = form.media_type().starts_with("image/");
    let disposition = if is_figure { "inline" } else { "attachment" };
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

#[cfg(test)]
mod tests {
    use futures_util::FutureExt as _;
    use http_body_util::BodyExt as _;

    use super::*;

    #[tokio::test]
    async fn a_file_is_sent_whole_and_keeps_its_place_until_then() {
        let files = Files::default();
        let mut held = Vec::new();
        for _ in 0..FILES_OF_KEY {
            let text = "abc".repeat(PIECE);
            held.push(HeldFile { text, _place: files.place(None).await }.into_body());
        }
        let mut third = Box::pin(files.place(None));
        let other = files.place(Some(KeyId::generate()));
        assert!((&mut third).now_or_never().is_none() && other.now_or_never().is_some());
        let mut body = held.remove(0);
        let first = body.frame().await.unwrap().unwrap().into_data().unwrap();
        let rest = body.collect().await.unwrap().to_bytes();
        assert_eq!([&first[..], &rest[..]].concat(), "abc".repeat(PIECE).into_bytes());
        assert!((&mut third).now_or_never().is_none(), "a piece that is not yet sent");
        drop(first);
        assert!(third.now_or_never().is_some());
    }
}
