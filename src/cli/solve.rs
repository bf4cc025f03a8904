//! `brinell solve`

use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use super::fault::Fault;
use super::input::{read_job, write_answer};
use super::progress::ProgressLine;
use super::style::Style;
use super::table::table;
use super::{Format, NOT_CONVERGED};
use crate::jobs::{check_finite, encode};
use crate::model::JobError;
use crate::results::{self, RunError};
use crate::solve::SolveStatus;

/// Arguments of `brinell solve`.
#[derive(Debug, Args)]
pub(super) struct SolveArgs {
    /// The job (JSON); - is standard input
    #[arg(value_name = "FILE")]
    job: PathBuf,

    /// How to print the result [default: table on a terminal, json elsewhere]
    #[arg(long, value_enum)]
    format: Option<Format>,

    /// Where to write the result [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl SolveArgs {
    fn format(&self) -> Format {
        let for_a_person = self.output.is_none() && io::stdout().is_terminal();
        self.format.unwrap_or(if for_a_person { Format::Table } else { Format::Json })
    }

    fn style(&self) -> Style {
        if self.output.is_none() { Style::of_stdout() } else { Style::PLAIN }
    }
}

pub(super) fn solve(args: &SolveArgs) -> Result<ExitCode, Fault> {
    let (name, job) = read_job(&args.job)?;
    let mut progress = ProgressLine::start();
    let report = results::run(&job, &mut progress).map_err(|error| match error {
        RunError::Input(errors) => Fault::of_job(&name, JobError::Fields(errors)),
        other => Fault::Run(other),
    })?;
    drop(progress);
    let text = match args.format() {
        Format::Json => [encode(&report)?.as_ref(), b"\n"].concat(),
        Format::Table => {
            check_finite(&report)?;
            table(&job, &report, args.style()).into_bytes()
        }
    };
    write_answer(args.output.as_deref(), &text)?;
    Ok(match report.status {
        SolveStatus::Converged => ExitCode::SUCCESS,
        _ => ExitCode::from(NOT_CONVERGED),
    })
}
