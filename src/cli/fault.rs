//! Errors of the command line and their messages.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::process::ExitCode;

use thiserror::Error;

use super::client::RequestError;
use super::style::Style;
use crate::app::AppError;
use crate::jobs::{EncodeError, KeyId, StoreError};
use brinell_solver::job::{FieldError, JobError};
use brinell_solver::report::RunError;
use brinell_solver::report::export::ExportError;

/// Exit code for faults of the program or its surroundings.
const FAILED: u8 = 1;
/// Exit code for bad input and wrong usage.
pub(super) const BAD_INPUT: u8 = 2;

/// An error of a command.
#[derive(Debug, Error)]
pub(super) enum Fault {
    /// The job cannot be read.
    #[error("cannot read {name}: {source}")]
    Read { name: String, source: io::Error },
    /// The answer cannot be written.
    #[error("cannot write {name}: {source}")]
    Write { name: String, source: io::Error },
    /// The text is not a job.
    #[error("{name} is {error}")]
    Syntax { name: String, error: JobError },
    /// No member of the job is there.
    #[error("--set {0}: the job has no such place")]
    Setting(String),
    /// The job is at fault.
    #[error("{name} is not a valid job")]
    Fields { name: String, errors: Vec<FieldError> },
    /// The solver failed.
    #[error("the job could not be solved: {0}")]
    Run(RunError),
    /// The result has numbers that are not finite.
    #[error("the result is not usable: {0}")]
    Encode(#[from] EncodeError),
    /// The result cannot be written in this format.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// The service does not run.
    #[error(transparent)]
    App(#[from] AppError),
    /// The store does not answer.
    #[error("{}", with_reason(.0))]
    Store(#[from] StoreError),
    /// No good key of that id.
    #[error("there is no API key {0}, or it was revoked before")]
    NoKey(KeyId),
    /// The service that was asked is not well.
    #[error("{0}")]
    Unwell(String),
    /// The demonstration's own request failed.
    #[error("the demonstration failed: {0}")]
    Demo(String),
    /// The operating system refuses something.
    #[error(transparent)]
    System(#[from] io::Error),
}

impl From<RequestError> for Fault {
    fn from(error: RequestError) -> Self {
        Self::Demo(error.to_string())
    }
}

impl Fault {
    /// A job that cannot be solved as it stands.
    pub(super) fn of_job(name: &str, error: JobError) -> Self {
        let name = name.to_owned();
        match error {
            JobError::Fields(errors) => Self::Fields { name, errors },
            error @ JobError::Syntax { .. } => Self::Syntax { name, error },
        }
    }

    fn exit_code(&self) -> u8 {
        match self {
            Self::Export(ExportError::Fields(_) | ExportError::Drawing(_)) => FAILED,
            Self::Read { .. }
            | Self::Syntax { .. }
            | Self::Setting(_)
            | Self::Fields { .. }
            | Self::Export(_)
            | Self::App(AppError::NotShared) => BAD_INPUT,
            // An address that cannot be one, as with the port 99999.
            Self::App(AppError::Listen { source, .. })
                if source.kind() == io::ErrorKind::InvalidInput =>
            {
                BAD_INPUT
            }
            _ => FAILED,
        }
    }

    /// Returns whether the reader of standard output has closed it, as in `brinell solve job.json
    /// | head`.
    fn is_broken_pipe(&self) -> bool {
        matches!(self, Self::Write { source, .. } if source.kind() == io::ErrorKind::BrokenPipe)
    }
}

fn with_reason(error: &StoreError) -> String {
    match std::error::Error::source(error) {
        Some(reason) => format!("{error}: {reason}"),
        None => error.to_string(),
    }
}

/// Prints a fault to standard error, one line for each field.
pub(super) fn report_fault(fault: &Fault) -> ExitCode {
    if !fault.is_broken_pipe() {
        let style = Style::of_stderr();
        let mut text = format!("{} {fault}\n", style.red("error:"));
        if let Fault::Fields { errors, .. } = fault {
            for error in errors {
                let pointer = if error.pointer.is_empty() { "(the job)" } else { &error.pointer };
                let _ = writeln!(text, "  {}: {}", style.bold(pointer), error.detail);
            }
        }
        // If standard error is closed, the message is lost.
        let _ = io::stderr().write_all(text.as_bytes());
    }
    ExitCode::from(fault.exit_code())
}
