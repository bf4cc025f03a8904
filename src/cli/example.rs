//! `brinell example`: jobs to begin with.

use std::process::ExitCode;

use clap::Args;
use clap::builder::PossibleValuesParser;

use super::fault::Fault;
use super::input::write_answer;
use crate::http::EXAMPLES;

/// Arguments of `brinell example`.
#[derive(Debug, Args)]
pub(super) struct ExampleArgs {
    /// Which [default: their names]
    #[arg(value_parser = PossibleValuesParser::new(EXAMPLES.map(|(name, _)| name)), hide_possible_values = true)]
    name: Option<String>,
}

pub(super) fn example(args: &ExampleArgs) -> Result<ExitCode, Fault> {
    let text: String = match &args.name {
        None => EXAMPLES.map(|(name, _)| name).join("\n") + "\n",
        Some(wanted) => {
            EXAMPLES.iter().filter(|(name, _)| name == wanted).map(|(_, job)| *job).collect()
        }
    };
    write_answer(None, text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
