//! Conversion of jobs to rows: JSON in text columns, compressed JSON in binary columns, times in
//! microseconds.
//!
//! Version 1 compressed with zstd; its rows are still read.

use std::io::Read;

use bytes::Bytes;
use jiff::Timestamp;
use ruzstd::decoding::StreamingDecoder;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use sqlx::types::Uuid;
use thiserror::Error;

use crate::jobs::{
    About, Deflated, FailureKind, FieldError, IterationRecord, JobFailure, JobId, JobRecord,
    JobState, KeyId, NumberedIteration, StoreError, UNPACKED_LIMIT,
};
use brinell_solver::job::Named as _;

/// An error for a row that no version of this program can have written.
#[derive(Debug, Error)]
#[error("a row of the store is damaged: {0}")]
pub(super) struct Damaged(String);

#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
pub(super) fn damaged(what: impl ToString) -> StoreError {
    StoreError::damaged(Damaged(what.to_string()))
}

/// The columns of [`JobRow`], of a table `jobs j`, without the place in the queue.
macro_rules! job_columns {
    () => {
        "j.id, j.state, j.tags, j.priority, j.submitter, j.created_at, j.started_at, \
         j.finished_at, j.attempts, j.cancel_requested, j.iterations, j.latest, j.has_report, \
         j.failure, EXISTS (SELECT 1 FROM deliveries d WHERE d.job = j.id)"
    };
}
pub(super) use job_columns;

/// A job as selected by [`job_columns`] and a place in the queue.
pub(super) type JobRow = (
    Uuid,
    String,
    String,
    i32,
    Option<Uuid>,
    i64,
    Option<i64>,
    Option<i64>,
    i32,
    bool,
    i32,
    Option<String>,
    bool,
    Option<String>,
    bool,
    Option<i64>,
);

pub(super) fn job_record(row: JobRow) -> Result<JobRecord, StoreError> {
    let (id, state, tags, priority, submitter, created, started, finished, attempts, cancel, ..) =
        row;
    let (.., iterations, latest, has_report, failure, has_callback, place) = row;
    let mut tags = from_json(&tags)?;
    Ok(JobRecord {
        id: JobId::from(id),
        state: state_named(&state)?,
        about: About::take(&mut tags),
        tags,
        priority: i16::try_from(priority).map_err(damaged)?,
        submitter: submitter.map(KeyId::from),
        created_at: time(created)?,
        started_at: started.map(time).transpose()?,
        finished_at: finished.map(time).transpose()?,
        attempts: count(attempts)?,
        queue_position: place.map(count).transpose()?,
        cancel_requested: cancel,
        iterations: count(iterations)?,
        latest: latest.as_deref().map(from_json::<IterationRecord>).transpose()?,
        has_report,
        failure: failure
            .as_deref()
            .map(from_json::<StoredFailure>)
            .transpose()?
            .map(JobFailure::from),
        has_callback,
    })
}

pub(super) fn state_named(name: &str) -> Result<JobState, StoreError> {
    JobState::of_word(name).ok_or_else(|| damaged(format!("state {name:?}")))
}

/// Converts a column that cannot be negative or too large.
pub(super) fn count<T: TryInto<U, Error: ToString>, U>(value: T) -> Result<U, StoreError> {
    value.try_into().map_err(damaged)
}

pub(super) fn time(micros: i64) -> Result<Timestamp, StoreError> {
    Timestamp::from_microsecond(micros).map_err(damaged)
}

/// A failure as JSON stores it.
#[derive(Serialize, Deserialize)]
struct StoredFailure {
    kind: FailureKind,
    detail: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    errors: Vec<(String, String)>,
}

impl From<StoredFailure> for JobFailure {
    fn from(stored: StoredFailure) -> Self {
        let errors = stored.errors.into_iter();
        let errors =
            errors.map(|(pointer, detail)| FieldError::not_solvable(pointer, detail)).collect();
        Self { kind: stored.kind, detail: stored.detail, errors }
    }
}

pub(super) fn failure_json(failure: &JobFailure) -> Result<String, StoreError> {
    let errors =
        failure.errors.iter().map(|error| (error.pointer.clone(), error.detail.clone())).collect();
    to_json(&StoredFailure { kind: failure.kind, detail: failure.detail.clone(), errors })
}

pub(super) fn to_json<T: Serialize>(value: &T) -> Result<String, StoreError> {
    serde_json::to_string(value).map_err(StoreError::unavailable)
}

fn from_json<T: DeserializeOwned>(text: &str) -> Result<T, StoreError> {
    serde_json::from_str(text).map_err(damaged)
}

pub(super) fn pack(text: &[u8]) -> Result<Vec<u8>, StoreError> {
    Ok(Deflated::compress(text).map_err(StoreError::unavailable)?.into_bytes().into())
}

pub(super) fn unpack(packed: Vec<u8>) -> Result<Bytes, StoreError> {
    let packed = Bytes::from(packed);
    match Deflated::from_bytes(packed.clone()) {
        Some(deflated) => deflated.text().map_err(damaged),
        None => unpack_zstd(&packed),
    }
}

fn unpack_zstd(packed: &[u8]) -> Result<Bytes, StoreError> {
    let decoder = StreamingDecoder::new(packed).map_err(damaged)?;
    let mut text = Vec::new();
    let length = decoder.take(UNPACKED_LIMIT + 1).read_to_end(&mut text).map_err(damaged)?;
    if length as u64 > UNPACKED_LIMIT { Err(damaged("too long")) } else { Ok(text.into()) }
}

pub(super) fn pack_records(records: &[NumberedIteration]) -> Result<Vec<u8>, StoreError> {
    let records: Vec<_> = records.iter().map(|iteration| &iteration.record).collect();
    pack(to_json(&records)?.as_bytes())
}

pub(super) fn unpack_records(packed: Vec<u8>) -> Result<Vec<IterationRecord>, StoreError> {
    serde_json::from_slice(&unpack(packed)?).map_err(damaged)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 100 000 spaces, as zstd packed them.
    const FIRST_VERSION: [u8; 22] =
        [40, 181, 47, 253, 160, 160, 134, 1, 0, 85, 0, 0, 16, 32, 32, 1, 0, 155, 134, 57, 192, 2];

    #[test]
    fn packed_texts_are_unpacked() {
        let long = vec![b' '; 100_000];
        for text in [&b""[..], b"{}", &long] {
            let packed = pack(text).unwrap();
            assert_eq!(unpack(packed).unwrap(), text);
        }
        assert!(pack(&long).unwrap().len() < 1000);
        assert_eq!(unpack(FIRST_VERSION.to_vec()).unwrap(), long, "as the first version packed");
    }

    #[test]
    fn damage_is_an_error() {
        let mut packed = pack(b"a text of some length, and then some more of it").unwrap();
        packed.truncate(packed.len() / 2);
        assert!(unpack(packed).is_err());
        assert!(unpack(Vec::new()).is_err());
        assert!(unpack(b"neither form".to_vec()).is_err());
    }

    #[test]
    fn failures_keep_their_fields() {
        let failure = JobFailure::input(vec![FieldError::not_solvable("/load", "too much")]);
        let stored: StoredFailure = from_json(&failure_json(&failure).unwrap()).unwrap();
        assert_eq!(JobFailure::from(stored), failure);
    }
}
