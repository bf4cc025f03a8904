//! `brinell openapi`

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use super::fault::Fault;
use super::input::write_answer;
use crate::http::openapi;

/// Arguments of `brinell openapi`.
#[derive(Debug, Args)]
pub(super) struct OpenapiArgs {
    /// File to write to [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn openapi(args: &OpenapiArgs) -> Result<ExitCode, Fault> {
    let document = openapi::pretty(&openapi::document());
    write_answer(args.output.as_deref(), document.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
