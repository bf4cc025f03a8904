//! Messages about wrong settings: one line that names the flag and its variable, if it has one.

use std::error::Error as _;
use std::io::{self, Write};
use std::num::{IntErrorKind, ParseIntError};
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, Error};

use super::fault::BAD_INPUT;
use super::style::Style;

/// Prints a message about the arguments, or clap's help or version.
pub(super) fn report(error: &Error, command: &Command) -> ExitCode {
    let Some(line) = explain(error, command) else { error.exit() };
    // If the output is closed, the message is lost.
    let _ = writeln!(io::stderr(), "{} {line}", Style::of_stderr().red("error:"));
    ExitCode::from(BAD_INPUT)
}

/// Describes a wrong value; `None` for other errors.
fn explain(error: &Error, command: &Command) -> Option<String> {
    if !matches!(error.kind(), ErrorKind::ValueValidation | ErrorKind::InvalidValue) {
        return None;
    }
    let ContextValue::String(argument) = error.get(ContextKind::InvalidArg)? else { return None };
    let ContextValue::String(value) = error.get(ContextKind::InvalidValue)? else { return None };
    let flag = argument.split([' ', '=']).next()?;
    let (variable, is_secret) = match variable(command, flag.strip_prefix("--")?) {
        Some((name, is_secret)) => (format!(" ({name})"), is_secret),
        None => (String::new(), false),
    };
    let reason = match (error.source(), error.get(ContextKind::ValidValue)) {
        (Some(reason), _) => reason_of(reason),
        (None, Some(ContextValue::Strings(words))) => {
            format!("must be one of: {}", words.join(", "))
        }
        (None, _) => "not a value it can have".to_owned(),
    };
    // A value that may be a secret is not repeated.
    let value = if is_secret { "what it is".to_owned() } else { format!("{value:?}") };
    Some(format!("{flag}{variable} cannot be {value}: {reason}"))
}

/// Why a value is refused; the language's own words for numbers are no sentence for users.
fn reason_of(error: &(dyn std::error::Error + 'static)) -> String {
    match error.downcast_ref::<ParseIntError>().map(ParseIntError::kind) {
        Some(IntErrorKind::Zero) => "must be at least 1".to_owned(),
        Some(IntErrorKind::PosOverflow | IntErrorKind::NegOverflow) => {
            "is beyond what can be counted".to_owned()
        }
        Some(_) => "must be a whole number without sign".to_owned(),
        None => error.to_string(),
    }
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
