//! `brinell validate`

use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use serde_json::json;

use super::common::Format;
use super::fault::Fault;
use super::input::{Settings, write_answer};
use super::style::Style;
use brinell_solver::job::JobError;
use brinell_solver::report;

/// Arguments of `brinell validate`.
#[derive(Debug, Args)]
pub(super) struct ValidateArgs {
    /// The job (JSON); - is standard input
    #[arg(value_name = "FILE")]
    job: PathBuf,

    #[command(flatten)]
    settings: Settings,

    /// How to print the answer [default: table on a terminal, json elsewhere]
    #[arg(long, value_enum)]
    format: Option<Format>,
}

pub(super) fn validate(args: &ValidateArgs) -> Result<ExitCode, Fault> {
    let (name, job) = args.settings.read_job(&args.job)?;
    let estimate = report::preflight(&job)
        .map_err(|errors| Fault::of_job(&name, JobError::Fields(errors)))?;
    let default = if io::stdout().is_terminal() { Format::Table } else { Format::Json };
    let text = match args.format.unwrap_or(default) {
        Format::Json => format!("{}\n", json!({"valid": true, "estimate": estimate})),
        Format::Table => {
            let (verdict, mebibytes) =
                (Style::of_stdout().green("valid"), estimate.bytes.div_ceil(1 << 20));
            format!(
                "{name} is {verdict}: {} equations, about {mebibytes} MiB\n",
                estimate.equations
            )
        }
    };
    write_answer(None, text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
