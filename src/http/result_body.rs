//! Answers with results. Steps are sent as they are read, so that no result is in memory as a
//! whole. Stored steps are compressed already and sent so. An `ETag` lets a client keep its copy.

use std::ops::Range;
use std::sync::Arc;

use axum::body::Body;
use axum::http::header::{CACHE_CONTROL, CONTENT_ENCODING, CONTENT_TYPE, ETAG, VARY};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use axum::{Extension, body::Bytes};
use tokio::sync::mpsc::Sender;

use super::HttpState;
use super::access::Caller;
use super::negotiation::{is_known, takes_gzip};
use super::problem::Problem;
use super::problem_type::ProblemType;
use super::query::Selection;
use super::request_log::JobIdExtension;
use super::selection::{edit, no_step};
use super::wire::JobDocument;
use super::written_body;
use crate::jobs::{
    Deflated, FieldsReader, GzipStream, JobId, JobRecord, JobStore, KeyId, ResultHead, StoreError,
};
use brinell_solver::report::FieldPiece;

/// JSON between two steps.
const COMMA: &[u8] = b",";

/// Marks an answer whose coding no layer may change.
#[derive(Debug, Clone, Copy)]
pub(super) struct CodingChosen;

/// The result of a job for a client: all of it, or the requested parts.
pub(super) struct SentResult {
    pub(super) state: HttpState,
    pub(super) caller: Caller,
    pub(super) id: JobId,
    pub(super) head: ResultHead,
    pub(super) selection: Selection,
}

/// JSON before and behind a result.
type Around = [Bytes; 2];

fn join<const N: usize>(texts: [&Bytes; N]) -> Bytes {
    texts.map(Bytes::as_ref).concat().into()
}

/// Whether the client is still connected.
async fn sent(sender: &Sender<Bytes>, piece: Bytes) -> bool {
    sender.send(piece).await.is_ok()
}

impl SentResult {
    fn has_fields(&self) -> bool {
        self.head.has_fields && self.selection.has_fields()
    }

    /// Hundreds of megabytes of fields are not compressed for each reader; there is a binary form.
    fn is_compressed(&self, headers: &HeaderMap) -> bool {
        takes_gzip(headers) && !self.has_fields()
    }

    /// Returns the requested steps.
    fn steps(&self) -> Result<Range<usize>, Problem> {
        match self.selection.step {
            Some(step) if step >= self.head.steps => Err(no_step(self.head.steps)),
            Some(step) => Ok(step..step + 1),
            None => Ok(0..self.head.steps),
        }
    }

    /// 200 with the report, or 304.
    pub(super) fn alone(self, headers: &HeaderMap) -> Result<Response, Problem> {
        let coding = if self.is_compressed(headers) { "-gzip" } else { "" };
        let tag =
            format!("\"{}-{}-{}{coding}\"", self.id, self.head.attempt, self.selection.name());
        let common: [(HeaderName, &str); 4] = [
            (CONTENT_TYPE, "application/json"),
            (ETAG, &tag),
            (CACHE_CONTROL, "private, no-cache"),
            (VARY, "accept, accept-encoding"),
        ];
        self.steps()?;
        if is_known(&tag, headers) {
            return Ok((StatusCode::NOT_MODIFIED, common).into_response());
        }
        let body = self.body(Around::default(), headers)?;
        Ok((common, body).into_response())
    }

    /// Answers 200 with the job and the report inside, without an `ETag`: the state of the job
    /// changes.
    pub(super) fn inside(
        self,
        job: &JobDocument,
        headers: &HeaderMap,
    ) -> Result<Response, Problem> {
        let mut before = serde_json::to_vec(job).map_err(StoreError::unavailable)?;
        before.pop();
        before.extend_from_slice(b",\"result\":");
        let body = self.body([before.into(), Bytes::from_static(b"}")], headers)?;
        let common = [(CONTENT_TYPE, "application/json"), (VARY, "accept-encoding")];
        Ok((common, body).into_response())
    }

    fn body(self, [before, behind]: Around, headers: &HeaderMap) -> Result<Response, Problem> {
        let about = (Extension(JobIdExtension(self.id)), Extension(CodingChosen));
        let (begin, end) = self.head.around_steps().ok_or_else(|| no_step(0))?;
        let steps = self.steps()?;
        let around = [join([&before, &begin]), join([&end, &behind])];
        let (turn, is_compressed) =
            (self.state.turn(self.caller.key()), self.is_compressed(headers));
        let write = move |sender| async move {
            if is_compressed {
                self.compressed(around, steps, &sender).await
            } else {
                self.plain(around, steps, &sender).await
            }
        };
        let mut response =
            (about, Body::from_stream(written_body::written(turn, write))).into_response();
        if is_compressed {
            response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
        }
        Ok(response)
    }

    /// Sends the report between two texts, uncompressed. Returns a problem, before the first byte,
    /// if there is no report.
    pub(super) async fn send(
        &self,
        [before, behind]: Around,
        sender: &Sender<Bytes>,
    ) -> Result<Result<(), Problem>, StoreError> {
        let Some((begin, end)) = self.head.around_steps() else { return Ok(Err(no_step(0))) };
        match self.steps() {
            Ok(steps) => self
                .plain([join([&before, &begin]), join([&end, &behind])], steps, sender)
                .await
                .map(Ok),
            Err(problem) => Ok(Err(problem)),
        }
    }

    async fn compressed(
        &self,
        around: Around,
        steps: Range<usize>,
        sender: &Sender<Bytes>,
    ) -> Result<(), StoreError> {
        let compress = |text: &[u8]| Deflated::compress(text).map_err(StoreError::unavailable);
        let (mut gzip, begin) = GzipStream::begin();
        let [before, behind] = around;
        let comma = Deflated::stored(COMMA);
        let mut go_on =
            sent(sender, begin).await && sent(sender, gzip.append(&compress(&before)?)).await;
        for number in steps.clone() {
            if number > steps.start {
                go_on = go_on && sent(sender, gzip.append(&comma)).await;
            }
            if !go_on {
                return Ok(());
            }
            let mut step = self.state.jobs.store().step(self.id, number).await?;
            if self.selection.edits_steps() {
                step = compress(&self.edited(step).await?)?;
            }
            go_on = sent(sender, gzip.append(&step)).await;
        }
        let behind = gzip.append(&compress(&behind)?);
        let _ = go_on && sent(sender, behind).await && sent(sender, gzip.end()).await;
        Ok(())
    }

    async fn plain(
        &self,
        [before, behind]: Around,
        steps: Range<usize>,
        sender: &Sender<Bytes>,
    ) -> Result<(), StoreError> {
        let mut go_on = sent(sender, before).await;
        for number in steps.clone() {
            if number > steps.start {
                go_on = go_on && sent(sender, Bytes::from_static(COMMA)).await;
            }
            if !go_on {
                return Ok(());
            }
            let step = self.state.jobs.store().step(self.id, number).await?;
            let text = self.edited(step).await?;
            go_on = if self.has_fields() {
                self.with_fields(number, text, sender).await?
            } else {
                sent(sender, text).await
            };
        }
        let _ = go_on && sent(sender, behind).await;
        Ok(())
    }

    /// Returns the JSON of a step with the requested parts.
    async fn edited(&self, step: Deflated) -> Result<Bytes, StoreError> {
        let selection = self.selection.clone();
        let edited = move || {
            let text = step.text().map_err(StoreError::damaged)?;
            if selection.edits_steps() {
                edit(&text, &selection).map_err(StoreError::damaged)
            } else {
                Ok(text)
            }
        };
        self.state.jobs.decoders.run(self.caller.key(), edited).await
    }

    /// Sends a step with its fields as last member; the fields become JSON piece by piece as the
    /// client reads.
    async fn with_fields(
        &self,
        number: usize,
        text: Bytes,
        sender: &Sender<Bytes>,
    ) -> Result<bool, StoreError> {
        let Some(mut fields) = self.state.jobs.fields(self.id, number).await? else {
            return Ok(sent(sender, text).await);
        };
        let member = format!(",\"{}\":", fields.layout().member());
        let (text, end) = (
            text.slice(..text.len().saturating_sub(1)),
            text.slice(text.len().saturating_sub(1)..),
        );
        let mut go_on = sent(sender, text).await && sent(sender, member.into()).await;
        for piece in fields.layout().json() {
            if !go_on {
                return Ok(false);
            }
            go_on =
                sent(sender, written(&self.state, self.caller.key(), &mut fields, piece).await?)
                    .await;
        }
        Ok(go_on && sent(sender, end).await)
    }
}

/// A reader of fields for an answer.
pub(super) type Fields = FieldsReader<Arc<dyn JobStore>>;

/// Decodes a piece of the fields. Waiting for a slow client occupies no decoder thread.
pub(super) async fn written(
    state: &HttpState,
    key: Option<KeyId>,
    fields: &mut Fields,
    piece: FieldPiece,
) -> Result<Bytes, StoreError> {
    let source = fields.bytes(piece.source()).await?;
    if source.is_empty() {
        return Ok(piece.write(&source).into());
    }
    Ok(state.jobs.decoders.run(key, move || Bytes::from(piece.write(&source))).await)
}

/// Returns the problem of a job without a report.
pub(super) fn no_result(record: &JobRecord) -> Problem {
    let kind = if record.state.is_finished() {
        ProblemType::NoResult
    } else {
        ProblemType::JobUnfinished
    };
    let problem = if record.has_report {
        let detail = "an older version of the program has solved the job, and its result has another \
                      form: solve the job again";
        Problem::new(kind, detail)
    } else {
        Problem::new(kind, format!("the job is {}", record.state))
    };
    match &record.failure {
        Some(failure) => Problem::new(kind, format!("the job failed: {}", failure.detail))
            .with_errors(failure.errors.clone()),
        None => problem,
    }
}
