//! Jobs from files and pipes; answers to files and pipes.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Map, Value};

use super::fault::Fault;
use brinell_solver::job::Job;

/// Members that replace those of a job.
#[derive(Debug, Args)]
pub(super) struct Settings {
    /// A member of the job and its value, as /load/force=700; may be given several times
    #[arg(long = "set", value_name = "POINTER=VALUE", value_parser = setting)]
    settings: Vec<(String, Value)>,
}

impl Settings {
    /// Reads and checks the job in a file; `-` is standard input. Returns its name too.
    pub(super) fn read_job(&self, path: &Path) -> Result<(String, Job), Fault> {
        let (name, text) = if path == Path::new("-") {
            let mut text = Vec::new();
            let read = io::stdin().lock().read_to_end(&mut text);
            ("standard input".to_owned(), read.map(|_| text))
        } else {
            (path.display().to_string(), fs::read(path))
        };
        let text = text.map_err(|source| Fault::Read { name: name.clone(), source })?;
        let job = match serde_json::from_slice::<Value>(&text) {
            Ok(mut job) if !self.settings.is_empty() => {
                for (pointer, value) in &self.settings {
                    set(&mut job, pointer, value.clone())?;
                }
                Job::from_value(&job)
            }
            _ => Job::from_json(&text),
        };
        let job = job.map_err(|error| Fault::of_job(&name, error))?;
        Ok((name, job))
    }
}

/// Reads a pointer and its value: JSON, or else a text.
fn setting(text: &str) -> Result<(String, Value), String> {
    let found = text.split_once('=').filter(|(pointer, _)| pointer.starts_with('/'));
    let (pointer, value) = found.ok_or("must be a JSON pointer and a value: /load/force=700")?;
    Ok((pointer.to_owned(), serde_json::from_str(value).unwrap_or_else(|_| value.into())))
}

/// Sets a member. The objects on the way to it are made where they are missing.
fn set(job: &mut Value, pointer: &str, value: Value) -> Result<(), Fault> {
    let mut at = job;
    for key in pointer.split('/').skip(1) {
        let key = key.replace("~1", "/").replace("~0", "~");
        let next = match at {
            Value::Object(members) => {
                Some(members.entry(key).or_insert_with(|| Value::Object(Map::new())))
            }
            Value::Array(items) => key.parse().ok().and_then(|at: usize| items.get_mut(at)),
            _ => None,
        };
        at = next.ok_or_else(|| Fault::Setting(pointer.to_owned()))?;
    }
    *at = value;
    Ok(())
}

/// Where an answer goes. It is opened before the work, which would be lost on a path that cannot
/// be written; what is there stays until the answer is.
pub(super) struct Output {
    file: Option<(PathBuf, File)>,
    is_new: bool,
}

impl Output {
    /// Opens a file, or standard output. The file of the job is refused.
    pub(super) fn open(path: Option<&Path>, job: Option<&Path>) -> Result<Self, Fault> {
        let Some(path) = path else { return Ok(Self { file: None, is_new: false }) };
        let place = |path: &Path| fs::canonicalize(path).ok().filter(|place| place.is_file());
        if place(path).is_some_and(|file| job.and_then(place) == Some(file)) {
            return Err(fault(path, io::Error::other("the job is there")));
        }
        let is_new = !path.exists();
        let file = OpenOptions::new().write(true).create(true).truncate(false).open(path);
        let file = file.map_err(|source| fault(path, source))?;
        Ok(Self { file: Some((path.to_owned(), file)), is_new })
    }

    /// Writes the answer.
    pub(super) fn write(mut self, text: &[u8]) -> Result<(), Fault> {
        self.is_new = false;
        match &mut self.file {
            Some((path, file)) => replace(file, text).map_err(|source| fault(path, source)),
            None => print(text).map_err(|source| fault(Path::new("standard output"), source)),
        }
    }
}

impl Drop for Output {
    /// Work that failed leaves no empty file behind.
    fn drop(&mut self) {
        if let Some((path, _)) = self.file.take().filter(|_| self.is_new) {
            let _ = fs::remove_file(path);
        }
    }
}

/// Writes an answer that is made at once to a file, or to standard output.
pub(super) fn write_answer(path: Option<&Path>, text: &[u8]) -> Result<(), Fault> {
    Output::open(path, None)?.write(text)
}

fn fault(path: &Path, source: io::Error) -> Fault {
    Fault::Write { name: path.display().to_string(), source }
}

/// Writes a file anew; what is no file, as a pipe, has no length.
fn replace(file: &mut File, text: &[u8]) -> io::Result<()> {
    if file.metadata()?.is_file() {
        file.set_len(0)?;
    }
    file.write_all(text)
}

fn print(text: &[u8]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text)?;
    out.flush()
}
