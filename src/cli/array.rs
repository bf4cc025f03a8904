//! `brinell solve --array`: jobs by the thousand, shared between the tasks of a cluster.
//!
//! A file of JSON Lines has a job in each line. Task i of n solves the lines i, i + n, i + 2n and
//! so on, and leaves out those whose results are there: a task that was killed goes on where it
//! was. A result is `<digest>-<version>.jsonl`: a line without its large parts, the job, the whole
//! result; the fields of its first step are `<digest>-<version>.1.npz`. The Python package writes
//! and reads the same.

use std::env;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Cursor, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::str::FromStr;
use std::sync::Arc;

use clap::Args;
use serde_json::Value;
use sha2::{Digest, Sha256};
use uuid::Uuid;
use zip::write::{SimpleFileOptions, ZipWriter};

use super::common::NOT_CONVERGED;
use super::fault::{Fault, report_fault};
use super::progress::ProgressLine;
use crate::config::WorkConfig;
use crate::http::summary;
use crate::jobs::{encode, take_fields};
use brinell_solver::job::{Job, JobError};
use brinell_solver::report::{self, FieldLayout, Report, RunError};
use brinell_solver::solver::{FactorCache, Options, SolveStatus};

/// Arguments of `brinell solve --array`.
#[derive(Debug, Args)]
pub(super) struct ArrayArgs {
    /// Jobs (JSON Lines) to solve instead of FILE; those whose results are there are left out
    #[arg(long, value_name = "JOBS", requires = "out", conflicts_with_all = ["format", "step", "output", "settings"])]
    pub(super) array: Option<PathBuf>,

    /// The folder of the results of --array
    #[arg(long, value_name = "FOLDER", requires = "array", conflicts_with = "job")]
    out: Option<PathBuf>,

    /// The part of --array that is solved here, as 3/8 [default: that of SLURM_ARRAY_TASK_ID, or
    /// all]
    #[arg(long, value_name = "I/N", requires = "array", conflicts_with = "job")]
    part: Option<Part>,
}

/// Stands before text that some programs of Windows write.
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// One of several parts of a list, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Part {
    index: usize,
    count: usize,
}

impl Part {
    const ALL: Self = Self { index: 0, count: 1 };

    fn has(self, number: usize) -> bool {
        number % self.count == self.index
    }

    /// The part of a task of a job array of Slurm, by its variables; `None` of other processes.
    fn of_task(variable: impl Fn(&str) -> Option<String>) -> Option<Result<Self, &'static str>> {
        let read = |name: &str| variable(&format!("SLURM_ARRAY_TASK_{name}"))?.parse().ok();
        let id: usize = read("ID")?;
        let least = read("MIN").unwrap_or(1);
        let step = read("STEP").unwrap_or(1).max(1);
        let past = id.checked_sub(least).filter(|past| past % step == 0);
        let (Some(past), Some(count @ 1..)) = (past, read("COUNT")) else {
            return Some(Err("of a task of an array with SLURM_ARRAY_TASK_COUNT"));
        };
        let has_gaps = read("MAX").is_some_and(|most| most != least + (count - 1) * step);
        let part = Self { index: past / step, count };
        let is_whole = part.index < count && !has_gaps;
        Some(if is_whole { Ok(part) } else { Err("of an array without gaps, as 1-8") })
    }
}

impl FromStr for Part {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (number, count) = text.split_once('/').ok_or("must be I/N, as 3/8")?;
        match (number.parse(), count.parse()) {
            (Ok(number @ 1..), Ok(count)) if number <= count => {
                Ok(Self { index: number - 1, count })
            }
            _ => Err("must be I/N, 1/N to N/N"),
        }
    }
}

/// Solves the jobs of a part. What is at fault is told, and does not stop the others.
pub(super) fn solve_array(jobs: &Path, args: &ArrayArgs) -> Result<ExitCode, Fault> {
    let unread = |source| Fault::Read { name: jobs.display().to_string(), source };
    let part = match (args.part, Part::of_task(|name| env::var(name).ok())) {
        (Some(part), _) => part,
        (None, None) => Part::ALL,
        (None, Some(part)) => part.map_err(|reason| Fault::Read {
            name: "SLURM_ARRAY_TASK_ID".to_owned(),
            source: io::Error::new(io::ErrorKind::InvalidInput, format!("it is not {reason}")),
        })?,
    };
    let lines = BufReader::new(File::open(jobs).map_err(unread)?).split(b'\n');
    let folder = Folder(args.out.clone().unwrap_or_default());
    fs::create_dir_all(&folder.0)
        .map_err(|source| Fault::Write { name: folder.0.display().to_string(), source })?;
    let cache = Arc::new(FactorCache::new(WorkConfig::default().factor_cache()));
    let mut ending = None;
    let mut converged = true;
    for (number, line) in lines.enumerate() {
        let line = line.map_err(unread)?;
        if line.trim_ascii().is_empty() || !part.has(number) {
            continue;
        }
        let name = format!("{} line {}", jobs.display(), number + 1);
        let job = line.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&line);
        match folder.answer(&name, job, &cache) {
            Ok(status) => converged &= status == SolveStatus::Converged,
            // Further results would find no room either.
            Err(fault @ Fault::Write { .. }) => return Err(fault),
            Err(fault) => {
                let code = report_fault(&fault);
                ending.get_or_insert(code);
            }
        }
    }
    let solved = if converged { ExitCode::SUCCESS } else { ExitCode::from(NOT_CONVERGED) };
    Ok(ending.unwrap_or(solved))
}

/// A folder of results.
struct Folder(PathBuf);

impl Folder {
    /// Solves a job unless its result is there.
    fn answer(
        &self,
        name: &str,
        text: &[u8],
        cache: &Arc<FactorCache>,
    ) -> Result<SolveStatus, Fault> {
        let of_job = |error| Fault::of_job(name, error);
        let job = Job::from_json(text).map_err(of_job)?;
        let document: Value = serde_json::from_slice(text)
            .map_err(|error| Fault::Read { name: name.to_owned(), source: error.into() })?;
        let file = format!("{}-{}", digest(&document), env!("CARGO_PKG_VERSION"));
        if let Some(status) = self.status(&file) {
            return Ok(status);
        }
        let options = Options { cache: Some(cache), ..Options::default() };
        let mut report =
            report::run_with(&job, options, &mut ProgressLine::start()).map_err(|error| {
                match error {
                    RunError::Input(errors) => of_job(JobError::Fields(errors)),
                    other => Fault::Run(other),
                }
            })?;
        self.keep(&file, &document, &mut report)?;
        Ok(report.status)
    }

    /// Returns the status of a result, if it is there and whole.
    fn status(&self, file: &str) -> Option<SolveStatus> {
        let kept = fs::read(self.0.join(format!("{file}.jsonl"))).ok()?;
        let lines: Vec<_> = kept.split(|byte| *byte == b'\n').collect();
        let [summary, _, _, []] = lines[..] else { return None };
        let summary: Value = serde_json::from_slice(summary).ok()?;
        serde_json::from_value(summary["status"].clone()).ok()
    }

    /// Writes a result; its fields first, so that a result that is there has them.
    fn keep(&self, file: &str, document: &Value, report: &mut Report) -> Result<(), Fault> {
        for number in 0..report.steps.len() {
            if let Some(fields) = take_fields(&mut report.steps[number])? {
                self.write(&format!("{file}.{}.npz", number + 1), &archive(&fields)?)?;
            }
        }
        let whole = encode(report)?;
        let summary = summary(&whole).map_err(io::Error::from)?;
        let job = document.to_string();
        let text = [&summary, &b"\n"[..], job.as_bytes(), b"\n", &whole, b"\n"].concat();
        self.write(&format!("{file}.jsonl"), &text)
    }

    /// Writes a file, whole or not at all; the last of several writers wins.
    fn write(&self, file: &str, bytes: &[u8]) -> Result<(), Fault> {
        let path = self.0.join(file);
        let part = self.0.join(format!("{file}.{}.part", Uuid::new_v4().simple()));
        fs::write(&part, bytes).and_then(|()| fs::rename(&part, &path)).map_err(|source| {
            // A disk that is full has no room for halves.
            let _ = fs::remove_file(&part);
            Fault::Write { name: path.display().to_string(), source }
        })
    }
}

/// Writes fields as an archive that numpy opens.
fn archive(fields: &[u8]) -> Result<Vec<u8>, Fault> {
    let layout = FieldLayout::read(fields).map_err(io::Error::other)?;
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for file in layout.npy(None) {
        archive.start_file(file.name, SimpleFileOptions::default()).map_err(io::Error::from)?;
        archive.write_all(&file.header)?;
        for piece in file.numbers {
            let source = piece.source();
            archive.write_all(&piece.write(&fields[source]))?;
        }
    }
    Ok(archive.finish().map_err(io::Error::from)?.into_inner())
}

/// Returns 128 bits of the SHA-256 of the values of a job. A number counts by the bits of its
/// double, an object by its members in the order of their names: neither spaces nor `20` for
/// `20.0` make another job.
fn digest(document: &Value) -> String {
    let mut hash = Sha256::new();
    feed(document, &mut hash);
    let bits = hash.finalize().first_chunk().copied().map_or(0, u128::from_be_bytes);
    format!("{bits:032x}")
}

fn feed(value: &Value, hash: &mut Sha256) {
    match value {
        Value::Null => hash.update(b"n"),
        Value::Bool(true) => hash.update(b"t"),
        Value::Bool(false) => hash.update(b"f"),
        Value::Number(number) => {
            hash.update(b"d");
            hash.update(number.as_f64().unwrap_or(f64::INFINITY).to_be_bytes());
        }
        Value::String(text) => feed_text(text, hash),
        Value::Array(list) => {
            hash.update(b"[");
            for one in list {
                feed(one, hash);
            }
            hash.update(b"]");
        }
        Value::Object(members) => {
            let mut members: Vec<_> = members.iter().collect();
            members.sort_unstable_by_key(|(name, _)| *name);
            hash.update(b"{");
            for (name, one) in members {
                feed_text(name, hash);
                feed(one, hash);
            }
            hash.update(b"}");
        }
    }
}

fn feed_text(text: &str, hash: &mut Sha256) {
    hash.update(format!("s{}:", text.len()));
    hash.update(text);
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn the_digest_is_that_of_the_python_package() {
        // The same stands in clients/python/tests/test_many.py.
        let document = json!({"b": [1, 2.5, true, null], "a": {"ü": "x", "": false}});
        assert_eq!(digest(&document), "839cc667e7c409e7085e1118abb76a75");
    }

    #[test]
    fn parts_have_each_line_once() {
        let parts: Vec<Part> = ["1/3", "2/3", "3/3"].map(|one| one.parse().unwrap()).to_vec();
        for number in 0..20 {
            assert_eq!(parts.iter().filter(|part| part.has(number)).count(), 1);
        }
        for wrong in ["0/3", "4/3", "3", "a/b", "1/0", "-1/2"] {
            assert!(wrong.parse::<Part>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_task_of_slurm_has_its_part() {
        let with = |id: &str, least: &str, most: &str, step: &str, count: &str| {
            let named =
                [("ID", id), ("MIN", least), ("MAX", most), ("STEP", step), ("COUNT", count)];
            let found = named.map(|(name, value)| (format!("SLURM_ARRAY_TASK_{name}"), value));
            Part::of_task(|name| {
                let (_, value) = found.iter().find(|(known, _)| known == name)?;
                (!value.is_empty()).then(|| (*value).to_owned())
            })
        };
        let of = |id, least, step, count| with(id, least, "", step, count);
        assert_eq!(of("", "1", "1", "8"), None);
        assert_eq!(of("3", "1", "1", "8"), Some(Ok(Part { index: 2, count: 8 })));
        assert_eq!(of("7", "3", "2", "4"), Some(Ok(Part { index: 2, count: 4 })));
        assert!(of("9", "1", "1", "3").unwrap().is_err());
        assert!(of("4", "1", "2", "3").unwrap().is_err());
        assert!(of("4", "1", "1", "").unwrap().is_err());
        assert!(of("4", "1", "1", "0").unwrap().is_err());
        assert_eq!(with("5", "1", "7", "2", "4"), Some(Ok(Part { index: 2, count: 4 })));
        // Of an array 2,7 both tasks are refused.
        assert!(with("2", "2", "7", "1", "2").unwrap().is_err());
        assert!(with("7", "2", "7", "1", "2").unwrap().is_err());
    }
}
