//! `brinell completions`

use std::process::ExitCode;

use clap::{Args, Command};
use clap_complete::Shell;

use super::fault::Fault;
use super::input::write_answer;

/// Arguments of `brinell completions`.
#[derive(Debug, Args)]
pub(super) struct CompletionsArgs {
    /// Of which shell
    shell: Shell,
}

pub(super) fn completions(
    args: &CompletionsArgs,
    mut command: Command,
) -> Result<ExitCode, Fault> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, "brinell", &mut script);
    write_answer(None, &script)?;
    Ok(ExitCode::SUCCESS)
}
