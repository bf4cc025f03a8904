//! `brinell man`

use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, Command};

use super::fault::Fault;

/// Arguments of `brinell man`.
#[derive(Debug, Args)]
pub(super) struct ManArgs {
    /// Folder of the pages
    folder: PathBuf,
}

pub(super) fn man(args: &ManArgs, command: Command) -> Result<ExitCode, Fault> {
    fs::create_dir_all(&args.folder)?;
    clap_mangen::generate_to(command, &args.folder)?;
    Ok(ExitCode::SUCCESS)
}
