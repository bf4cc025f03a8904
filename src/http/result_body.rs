//! Results as they leave: step by step as they are read, so that none is in memory as a whole; compressed as they are
//! kept; under a tag that says when a client has them already; in ranges where they are bytes.

use axum::body::Body;
use axum::http::header::{
    ACCEPT_ENCODING, ACCEPT_RANGES, CACHE_CONTROL, CONTENT_ENCODING, CONTENT_LOCATION, CONTENT_RANGE,
    CONTENT_TYPE, ETAG, IF_NONE_MATCH, IF_RANGE, RANGE, VARY,
};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use axum::{Extension, body::Bytes};
use futures_util::stream;
use tokio::sync::mpsc::{self, Sender};
use tokio::task::spawn_blocking;

use super::HttpState;
use super::problem::Problem;
use super::problem_type::ProblemType;
use super::request_log::JobIdExtension;
use crate::jobs::{Deflated, GzipStream, JobId, ResultHead, StoreError};
use brinell_solver::report::{FieldArrays, Report};

/// Pieces that wait for a client that reads slowly.
const WAITING_PIECES: usize = 2;

/// What stands between two steps.
const COMMA: &[u8] = b",";

/// Which part of a result is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct ResultParts {
    /// One step, counted from 0, instead of all.
    pub step: Option<usize>,
    /// Whether fields are left out.
    pub without_fields: bool,
}

/// Whether a client takes gzip.
pub(super) fn takes_gzip(headers: &HeaderMap) -> bool {
    let codings = headers.get_all(ACCEPT_ENCODING).iter().filter_map(|value| value.to_str().ok());
    codings.flat_map(|list| list.split(',')).any(|coding| {
        let (name, weight) = coding.split_once(";q=").unwrap_or((coding, "1"));
        name.trim().eq_ignore_ascii_case("gzip") && weight.trim().parse().is_ok_and(|q: f32| q > 0.0)
    })
}

/// Whether a client has what is under this tag.
pub(super) fn is_known(tag: &str, headers: &HeaderMap) -> bool {
    let known = headers.get_all(IF_NONE_MATCH).iter().filter_map(|value| value.to_str().ok());
    known.flat_map(|list| list.split(',')).any(|one| {
        let one = one.trim();
        one == "*" || one.strip_prefix("W/").unwrap_or(one) == tag
    })
}

/// 200 with a report, or 304.
pub(super) async fn result(
    state: &HttpState,
    id: JobId,
    head: ResultHead,
    parts: ResultParts,
    headers: &HeaderMap,
) -> Result<Response, Problem> {
    if parts.step.is_some_and(|step| head.steps > 0 && step >= head.steps) {
        let detail = format!("the result has {} steps", head.steps);
        return Err(Problem::new(ProblemType::InvalidQuery, detail));
    }
    let has_fields = head.has_fields && !parts.without_fields;
    let gzip = takes_gzip(headers) && !has_fields && head.around_steps().is_some();
    let step = parts.step.map_or_else(|| "all".to_owned(), |step| (step + 1).to_string());
    let (fields, coding) = (if has_fields { "-fields" } else { "" }, if gzip { "-gzip" } else { "" });
    let tag = format!("\"{id}-{}-{step}{fields}{coding}\"", head.attempt);
    let common: [(HeaderName, String); 5] = [
        (CONTENT_TYPE, "application/json".to_owned()),
        (CONTENT_LOCATION, format!("/v1/jobs/{id}/result")),
        (ETAG, tag.clone()),
        (CACHE_CONTROL, "private, no-cache".to_owned()),
        (VARY, "accept-encoding".to_owned()),
    ];
    if is_known(&tag, headers) {
        return Ok((StatusCode::NOT_MODIFIED, common).into_response());
    }
    let about = Extension(JobIdExtension(id));
    let Some((before, behind)) = head.around_steps() else {
        let body = whole(state, head.report, parts).await?;
        return Ok((common, about, body).into_response());
    };
    let (sender, receiver) = mpsc::channel(WAITING_PIECES);
    let steps = parts.step.map_or(0..head.steps, |step| step..step + 1);
    let writer = ResultWriter { state: state.clone(), id, steps, has_fields, sender };
    tokio::spawn(writer.run(before, behind, gzip));
    let pieces = stream::unfold(receiver, async |mut receiver| Some((receiver.recv().await?, receiver)));
    let mut response = (common, about, Body::from_stream(pieces)).into_response();
    if gzip {
        response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
    } else if has_fields {
        // Hundreds of megabytes are not compressed for each reader; there is a binary form.
        response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("identity"));
    }
    Ok(response)
}

/// A report of the first version, which was kept as a whole.
async fn whole(state: &HttpState, report: Bytes, parts: ResultParts) -> Result<Bytes, Problem> {
    if parts == ResultParts::default() {
        return Ok(report);
    }
    let _decoder = state.jobs.decoder().await;
    let cut = move || {
        let mut report: Report = serde_json::from_slice(&report).map_err(StoreError::unavailable)?;
        if let Some(wanted) = parts.step {
            report.steps = report.steps.into_iter().skip(wanted).take(1).collect();
        }
        if parts.without_fields {
            report.steps.iter_mut().for_each(|step| step.fields = None);
        }
        serde_json::to_vec(&report).map(Bytes::from).map_err(StoreError::unavailable)
    };
    Ok(spawn_blocking(cut).await.map_err(StoreError::unavailable)??)
}

/// Reads a result and sends it on.
struct ResultWriter {
    state: HttpState,
    id: JobId,
    steps: std::ops::Range<usize>,
    has_fields: bool,
    sender: Sender<Result<Bytes, StoreError>>,
}

impl ResultWriter {
    async fn run(self, before: Bytes, behind: Bytes, gzip: bool) {
        let written =
            if gzip { self.compressed(before, behind).await } else { self.plain(before, behind).await };
        if let Err(error) = written {
            // The answer breaks off, so that no client takes it for whole.
            tracing::error!(job = %self.id, error = &error as &dyn std::error::Error, "a result could not be read");
            let _ = self.sender.send(Err(error)).await;
        }
    }

    /// A client that has gone is no error.
    async fn send(&self, piece: Bytes) -> bool {
        self.sender.send(Ok(piece)).await.is_ok()
    }

    async fn compressed(&self, before: Bytes, behind: Bytes) -> Result<(), StoreError> {
        let compress = |text: &[u8]| Deflated::compress(text).map_err(StoreError::unavailable);
        let (mut gzip, begin) = GzipStream::begin();
        let (before, behind) = (compress(&before)?, compress(&behind)?);
        let comma = Deflated::stored(COMMA);
        let mut go_on = self.send(begin).await && self.send(gzip.append(&before)).await;
        for number in self.steps.clone() {
            if number > self.steps.start {
                go_on = go_on && self.send(gzip.append(&comma)).await;
            }
            if !go_on {
                return Ok(());
            }
            let step = self.state.jobs.step(self.id, number).await?;
            go_on = self.send(gzip.append(&step)).await;
        }
        let _ = go_on && self.send(gzip.append(&behind)).await && self.send(gzip.end()).await;
        Ok(())
    }

    async fn plain(&self, before: Bytes, behind: Bytes) -> Result<(), StoreError> {
        let mut go_on = self.send(before).await;
        for number in self.steps.clone() {
            if number > self.steps.start {
                go_on = go_on && self.send(Bytes::from_static(COMMA)).await;
            }
            if !go_on {
                return Ok(());
            }
            let step = self.state.jobs.step(self.id, number).await?;
            let text = spawn_blocking(move || step.text()).await;
            let text = text.map_err(StoreError::unavailable)?.map_err(StoreError::unavailable)?;
            go_on =
                if self.has_fields { self.with_fields(number, text).await? } else { self.send(text).await };
        }
        let _ = go_on && self.send(behind).await;
        Ok(())
    }

    /// A step with its fields as its last member; they become JSON piece by piece, as the client reads.
    async fn with_fields(&self, number: usize, text: Bytes) -> Result<bool, StoreError> {
        let _decoder = self.state.jobs.decoder().await;
        let Some(fields) = self.state.jobs.fields(self.id, number).await? else {
            return Ok(self.send(text).await);
        };
        let (text, end) =
            (text.slice(..text.len().saturating_sub(1)), text.slice(text.len().saturating_sub(1)..));
        let sender = self.sender.clone();
        let written = spawn_blocking(move || {
            let arrays = FieldArrays::read(fields).map_err(StoreError::unavailable)?;
            let member = std::iter::once(Bytes::from_static(b",\"fields\":"));
            let pieces = member.chain(arrays.json().map(Bytes::from));
            let mut pieces = std::iter::once(text).chain(pieces).chain([end]);
            Ok(pieces.all(|piece| sender.blocking_send(Ok(piece)).is_ok()))
        });
        written.await.map_err(StoreError::unavailable)?
    }
}

/// Bytes under a tag, whole or the one range that is asked for (RFC 9110, section 14).
pub(super) fn bytes(tag: &str, media_type: &'static str, body: Bytes, headers: &HeaderMap) -> Response {
    let common: [(HeaderName, &str); 4] = [
        (CONTENT_TYPE, media_type),
        (ETAG, tag),
        (ACCEPT_RANGES, "bytes"),
        (CACHE_CONTROL, "private, no-cache"),
    ];
    if is_known(tag, headers) {
        return (StatusCode::NOT_MODIFIED, common).into_response();
    }
    let is_current = headers.get(IF_RANGE).is_none_or(|known| known.as_bytes() == tag.as_bytes());
    let range = headers.get(RANGE).filter(|_| is_current).and_then(|range| range.to_str().ok());
    match range.and_then(|range| byte_range(range, body.len())) {
        None => (common, body).into_response(),
        Some(Err(())) => {
            let all = [(CONTENT_RANGE, format!("bytes */{}", body.len()))];
            (StatusCode::RANGE_NOT_SATISFIABLE, common, all).into_response()
        }
        Some(Ok((from, to))) => {
            let part = [(CONTENT_RANGE, format!("bytes {from}-{}/{}", to - 1, body.len()))];
            (StatusCode::PARTIAL_CONTENT, common, part, body.slice(from..to)).into_response()
        }
    }
}

/// The one range of bytes in a header, its end excluded; an error where it begins behind the end, `None` where the header is to
/// be ignored.
fn byte_range(text: &str, length: usize) -> Option<Result<(usize, usize), ()>> {
    let (first, last) = text.strip_prefix("bytes=")?.split_once('-')?;
    let (first, last) = (first.trim(), last.trim());
    let (from, to) = if first.is_empty() {
        (length.saturating_sub(last.parse().ok()?), length)
    } else {
        let from: usize = first.parse().ok()?;
        let to =
            if last.is_empty() { length } else { last.parse::<usize>().ok()?.saturating_add(1).min(length) };
        if from >= to && from < length {
            return None;
        }
        (from, to)
    };
    Some(if from < to { Ok((from, to)) } else { Err(()) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_as_the_standard_has_them() {
        for (text, range) in [
            ("bytes=0-9", Some(Ok((0, 10)))),
            ("bytes=90-", Some(Ok((90, 100)))),
            ("bytes=-5", Some(Ok((95, 100)))),
            ("bytes=-500", Some(Ok((0, 100)))),
            ("bytes=95-200", Some(Ok((95, 100)))),
            ("bytes=100-", Some(Err(()))),
            ("bytes=-0", Some(Err(()))),
            ("bytes=9-3", None),
            ("bytes=0-1,5-6", None),
            ("lines=0-1", None),
        ] {
            assert_eq!(byte_range(text, 100), range, "{text}");
        }
    }
}
