//! Jobs from files and pipes; answers to files and pipes.

use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

use super::fault::Fault;
use brinell_solver::job::Job;

/// Reads and checks the job in a file; `-` is standard input.
pub(super) fn read_job(path: &Path) -> Result<(String, Job), Fault> {
    let (name, text) = if path == Path::new("-") {
        let mut text = Vec::new();
        let read = io::stdin().lock().read_to_end(&mut text);
        ("standard input".to_owned(), read.map(|_| text))
    } else {
        (path.display().to_string(), fs::read(path))
    };
    let text = text.map_err(|source| Fault::Read { name: name.clone(), source })?;
    let job = Job::from_json(&text).map_err(|error| Fault::of_job(&name, error))?;
    Ok((name, job))
}

/// Writes an answer to a file, or to standard output.
pub(super) fn write_answer(path: Option<&Path>, text: &[u8]) -> Result<(), Fault> {
    let (name, written) = match path {
        Some(path) => (path.display().to_string(), fs::write(path, text)),
        None => ("standard output".to_owned(), print(text)),
    };
    written.map_err(|source| Fault::Write { name, source })
}

fn print(text: &[u8]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text)?;
    out.flush()
}
