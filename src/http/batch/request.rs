//! Parser of requests for several jobs; it reports all faulty members at once.

use axum::body::Bytes;
use brinell_solver::job::{FaultCode, FieldError};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::value::RawValue;
use utoipa::ToSchema;

use super::MAX_JOBS;
use super::members::Members;
use crate::http::openapi::job;
use crate::http::preference::is_idempotency_key;
use crate::http::problem::Problem;
use crate::http::problem_type::ProblemType;
use crate::http::query::MAX_PRIORITY;
use crate::jobs::JobId;
use crate::webhook::CallbackRules;

/// Most faults reported for one request.
const MAX_FAULTS: usize = 100;

/// Jobs to hand in.
#[derive(Debug, Deserialize, ToSchema)]
#[expect(dead_code, reason = "declares what `read_jobs` reads")]
pub(in crate::http) struct BatchOfJobs {
    /// The jobs, in the order in which they are queued.
    #[schema(min_items = 1, max_items = 100)]
    jobs: Vec<BatchedJob>,
}

/// One of the jobs to hand in.
#[derive(Debug, Deserialize, ToSchema)]
#[expect(dead_code, reason = "declares what `read_jobs` reads")]
pub(in crate::http) struct BatchedJob {
    /// The job.
    #[schema(schema_with = job)]
    job: serde_json::Value,
    /// As `?priority=`: larger goes first.
    #[schema(minimum = -100, maximum = 100)]
    priority: Option<i16>,
    /// As the header `Idempotency-Key`, for this job alone; goes before the header.
    #[schema(pattern = "^[!-~]{1,255}$", example = "press-7")]
    idempotency_key: Option<String>,
    /// As `?callback_url=`: where to announce the end of the job.
    #[schema(max_length = 2000, example = "https://hooks.example/brinell")]
    callback_url: Option<String>,
}

/// Jobs that exist.
#[derive(Debug, Deserialize, ToSchema)]
#[expect(dead_code, reason = "declares what `read_ids` reads")]
pub(in crate::http) struct BatchOfIds {
    /// Their ids.
    #[schema(min_items = 1, max_items = 100)]
    ids: Vec<JobId>,
}

/// A job to submit, as parsed.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::http) struct ReadJob {
    /// Its text.
    pub(in crate::http) job: Bytes,
    pub(in crate::http) priority: i16,
    pub(in crate::http) idempotency_key: Option<String>,
    pub(in crate::http) callback_url: Option<String>,
}

/// Collects the faults of a request.
#[derive(Debug, Default)]
struct Faults(Vec<FieldError>);

impl Faults {
    fn add(&mut self, pointer: impl Into<String>, code: FaultCode, detail: impl Into<String>) {
        if self.0.len() < MAX_FAULTS {
            self.0.push(FieldError { pointer: pointer.into(), code, detail: detail.into() });
        }
    }

    fn finish<T>(self, read: T) -> Result<T, Problem> {
        if self.0.is_empty() {
            return Ok(read);
        }
        let count = self.0.len();
        let detail =
            format!("{count} member{} of the request at fault", if count == 1 { "" } else { "s" });
        Err(Problem::new(ProblemType::InvalidBatch, detail).with_errors(self.0))
    }

    /// Returns the members of an object with known names; reports unknown and duplicate ones.
    fn members<'a>(
        &mut self,
        pointer: &str,
        text: &'a str,
        known: &[&str],
    ) -> Vec<(String, &'a RawValue)> {
        let Ok(Members(members)) = serde_json::from_str::<Members<'a>>(text) else {
            self.add(pointer, FaultCode::WrongType, "must be an object");
            return Vec::new();
        };
        let mut kept: Vec<(String, &'a RawValue)> = Vec::new();
        for (name, value) in members {
            let shown: String = name.chars().take(40).collect();
            let place = format!("{pointer}/{}", shown.replace('~', "~0").replace('/', "~1"));
            if !known.contains(&name.as_str()) {
                let detail =
                    format!("unknown member {shown:?}; expected one of: {}", known.join(", "));
                self.add(place, FaultCode::UnknownKey, detail);
            } else if kept.iter().any(|(other, _)| *other == name) {
                self.add(place, FaultCode::DuplicateKey, "must be given once");
            } else if value.get() != "null" {
                // As in a job, `null` is the same as leaving a member out.
                kept.push((name, value));
            }
        }
        kept
    }

    /// Returns the single list that a request consists of.
    fn list<'a>(&mut self, text: &'a str, name: &str) -> Vec<&'a RawValue> {
        let members = self.members("", text, &[name]);
        let pointer = format!("/{name}");
        let Some((_, value)) = members.first() else {
            // A value that is no object is reported already.
            if self.0.iter().all(|fault| !fault.pointer.is_empty()) {
                self.add(pointer, FaultCode::Required, "is required");
            }
            return Vec::new();
        };
        let Ok(items) = serde_json::from_str::<Vec<&'a RawValue>>(value.get()) else {
            self.add(pointer, FaultCode::WrongType, "must be a list");
            return Vec::new();
        };
        if items.is_empty() || items.len() > MAX_JOBS {
            let detail = format!("must have 1 to {MAX_JOBS} items, got {}", items.len());
            self.add(pointer, FaultCode::WrongLength, detail);
            return Vec::new();
        }
        items
    }

    /// Parses a value that satisfies `accept`; reports `expected` otherwise.
    fn value<T: DeserializeOwned>(
        &mut self,
        pointer: String,
        value: &RawValue,
        expected: &str,
        accept: impl Fn(&T) -> bool,
    ) -> Option<T> {
        let read = serde_json::from_str::<T>(value.get()).ok();
        let code = if read.is_some() { FaultCode::OutOfRange } else { FaultCode::WrongType };
        let read = read.filter(accept);
        if read.is_none() {
            let shown: String = value.get().chars().take(40).collect();
            self.add(pointer, code, format!("must be {expected}, got {shown}"));
        }
        read
    }
}

/// Returns the text of a body if it is JSON.
fn text(body: &[u8]) -> Result<&str, Problem> {
    let whole: Result<&RawValue, _> = serde_json::from_slice(body);
    whole.map(RawValue::get).map_err(|error| Problem::not_json(&error))
}

/// Parses jobs to submit, without checking the jobs themselves.
///
/// # Errors
/// A problem with every member at fault.
pub(in crate::http) fn read_jobs(
    body: &[u8],
    callbacks: &CallbackRules,
) -> Result<Vec<ReadJob>, Problem> {
    let mut faults = Faults::default();
    let items = faults.list(text(body)?, "jobs");
    let mut jobs = Vec::with_capacity(items.len());
    for (k, item) in items.into_iter().enumerate() {
        let pointer = format!("/jobs/{k}");
        let mut job = None;
        let mut read = ReadJob::default();
        let count = faults.0.len();
        for (name, value) in faults.members(
            &pointer,
            item.get(),
            &["job", "priority", "idempotency_key", "callback_url"],
        ) {
            let place = format!("{pointer}/{name}");
            match name.as_str() {
                "priority" => {
                    let expected =
                        format!("a whole number between -{MAX_PRIORITY} and {MAX_PRIORITY}");
                    let is_allowed =
                        |priority: &i16| (-MAX_PRIORITY..=MAX_PRIORITY).contains(priority);
                    read.priority = faults.value(place, value, &expected, is_allowed).unwrap_or(0);
                }
                "idempotency_key" => {
                    let expected = "1 to 255 visible ASCII characters without spaces";
                    let is_key = |key: &String| is_idempotency_key(key);
                    read.idempotency_key = faults.value(place, value, expected, is_key);
                }
                "callback_url" => {
                    read.callback_url =
                        faults.value(place.clone(), value, "a text", |_: &String| true);
                    let checked = read.callback_url.as_deref().map(|url| callbacks.check(url));
                    if let Some(Err(detail)) = checked {
                        faults.add(place, FaultCode::OutOfRange, detail);
                    }
                }
                _ => job = Some(Bytes::copy_from_slice(value.get().as_bytes())),
            }
        }
        match job {
            Some(job) => read.job = job,
            None if faults.0.len() == count => {
                faults.add(format!("{pointer}/job"), FaultCode::Required, "is required");
            }
            None => {}
        }
        jobs.push(read);
    }
    faults.finish(jobs)
}

/// Parses the ids of jobs.
///
/// # Errors
/// A problem with every member at fault.
pub(in crate::http) fn read_ids(body: &[u8]) -> Result<Vec<JobId>, Problem> {
    let mut faults = Faults::default();
    let items = faults.list(text(body)?, "ids");
    let read = |(k, item): (usize, &RawValue)| {
        faults.value(format!("/ids/{k}"), item, "the id of a job", |_: &JobId| true)
    };
    let ids = items.into_iter().enumerate().filter_map(read).collect();
    faults.finish(ids)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(problem: Problem) -> Vec<(String, String)> {
        let problem = serde_json::to_value(problem).unwrap();
        let text = |fault: &serde_json::Value, key: &str| fault[key].as_str().unwrap().to_owned();
        problem["errors"]
            .as_array()
            .unwrap()
            .iter()
            .map(|f| (text(f, "pointer"), text(f, "code")))
            .collect()
    }

    #[test]
    fn jobs_keep_their_own_text() {
        let jobs = read_jobs(
            br#"{"jobs": [{"job": {"a" : 1.0e0}, "priority": -3}, {"idempotency_key": "x", "job": 7}]}"#,
            &CallbackRules::default(),
        );
        let jobs = jobs.unwrap();
        assert_eq!((jobs[0].job.as_ref(), jobs[0].priority), (&br#"{"a" : 1.0e0}"#[..], -3));
        assert_eq!(
            (jobs[1].job.as_ref(), jobs[1].idempotency_key.as_deref()),
            (&b"7"[..], Some("x"))
        );
    }

    #[test]
    fn every_member_at_fault_is_named() {
        let body =
            br#"{"jobs": [{"job": {}, "priority": 101}, 3, {"prio": 1}, {"job": null}, {"job": 1, "job": 2,
            "idempotency_key": "two words", "priority": "high"}], "more": 1}"#;
        let found = faults(read_jobs(body, &CallbackRules::default()).unwrap_err());
        let expected = [
            ("#/more", "unknown_key"),
            ("#/jobs/0/priority", "out_of_range"),
            ("#/jobs/1", "wrong_type"),
            ("#/jobs/2/prio", "unknown_key"),
            ("#/jobs/3/job", "required"),
            ("#/jobs/4/job", "duplicate_key"),
            ("#/jobs/4/idempotency_key", "out_of_range"),
            ("#/jobs/4/priority", "wrong_type"),
        ];
        assert_eq!(found, expected.map(|(pointer, code)| (pointer.to_owned(), code.to_owned())));
    }

    #[test]
    fn a_request_is_an_object_with_one_list() {
        let code = |body: &[u8]| faults(read_ids(body).unwrap_err()).remove(0).1;
        assert_eq!(code(b"[]"), "wrong_type");
        assert_eq!(code(b"{}"), "required");
        assert_eq!(code(br#"{"ids": null}"#), "required");
        assert_eq!(code(br#"{"ids": {}}"#), "wrong_type");
        assert_eq!(code(br#"{"ids": []}"#), "wrong_length");
        assert_eq!(
            code(format!("{{\"ids\": [{}1]}}", "1,".repeat(MAX_JOBS)).as_bytes()),
            "wrong_length"
        );
        assert_eq!(code(br#"{"ids": ["x"]}"#), "wrong_type");
        let problem = serde_json::to_value(read_ids(b"{\"ids\": [").unwrap_err()).unwrap();
        assert_eq!(problem["type"], "/problems/invalid-json");
    }
}
