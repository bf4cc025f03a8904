//! Messages about wrong settings: one line that names the flag and the variable.

use std::error::Error as _;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, Error};

use super::style::Style;

/// Exit code for wrong usage.
const USAGE: u8 = 2;

/// Prints a message about the arguments, or clap's help or version.
pub(super) fn report(error: &Error, command: &Command) -> ExitCode {
    let Some(line) = explain(error, command) else { error.exit() };
    // If the output is closed, the message is lost.
    let _ = writeln!(io::stderr(), "{} {line}", Style::of_stderr().red("error:"));
    ExitCode::from(USAGE)
}

/// Describes a wrong value; `None` for other errors.
fn explain(error: &Error, command: &Command) -> Option<String> {
    if !matches!(error.kind(), ErrorKind::ValueValidation | ErrorKind::InvalidValue) {
        return None;
    }
    let ContextValue::String(argument) = error.get(ContextKind::InvalidArg)? else { return None };
    let ContextValue::String(value) = error.get(ContextKind::InvalidValue)? else { return None };
    let flag = argument.split([' ', '=']).next()?;
    let variable = variable(command, flag.strip_prefix("--")?)?;
    let reason = match (error.source(), error.get(ContextKind::ValidValue)) {
        (Some(reason), _) => reason.to_string(),
        (None, Some(ContextValue::Strings(words))) => {
            format!("must be one of: {}", words.join(", "))
        }
        (None, _) => "not a value it can have".to_owned(),
    };
    // A value that may be a secret is not repeated.
    let value = if variable.1 { "what it is".to_owned() } else { format!("{value:?}") };
    Some(format!("{flag} ({}) cannot be {value}: {reason}", variable.0))
}

/// The variable of a flag, wherever it is defined, and whether its value is a secret.
fn variable(command: &Command, flag: &str) -> Option<(String, bool)> {
    let mut arguments = command.get_arguments();
    let own = arguments
        .find(|argument: &&Arg| argument.get_long() == Some(flag) && argument.get_env().is_some());
    let found = own.and_then(|argument| {
        Some((
            argument.get_env()?.to_string_lossy().into_owned(),
            argument.is_hide_env_values_set(),
        ))
    });
    found.or_else(|| command.get_subcommands().find_map(|command| variable(command, flag)))
}
