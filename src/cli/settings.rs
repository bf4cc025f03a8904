//! `--print-config`: the settings as they would be used, each as its variable, with where it comes
//! from.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command};

use super::fault::Fault;
use super::input::write_answer;

/// Prints the settings of the command that was given, in the form of an environment file.
pub(super) fn print(command: &Command, matches: &ArgMatches) -> Result<ExitCode, Fault> {
    let Some((name, matches)) = matches.subcommand() else { return Ok(ExitCode::SUCCESS) };
    let arguments = command.find_subcommand(name).into_iter().flat_map(Command::get_arguments);
    let text: String = arguments.filter_map(|argument| line(argument, matches)).collect();
    write_answer(None, text.as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// One setting; `None` if it has no variable.
fn line(argument: &Arg, matches: &ArgMatches) -> Option<String> {
    let (flag, variable) = (argument.get_long()?, argument.get_env()?.to_string_lossy());
    let id = argument.get_id().as_str();
    let values = matches.get_raw(id).into_iter().flatten();
    let value: Vec<_> = values.map(|value| value.to_string_lossy()).collect();
    let source = match matches.value_source(id) {
        Some(ValueSource::CommandLine) => "set by the flag",
        Some(ValueSource::EnvVariable) => "set by the variable",
        _ if value.is_empty() => "not set",
        _ => "the default",
    };
    let mut text = format!("# --{flag}: {source}\n");
    let is_secret = argument.is_hide_env_values_set();
    let value = if is_secret { redacted(&value.join(",")) } else { value.join(",") };
    let comment = if value.is_empty() { "# " } else { "" };
    let _ = writeln!(text, "{comment}{variable}={value}");
    Some(text)
}

/// Returns a URL without its user, password and query string, which may hold a password.
fn redacted(text: &str) -> String {
    let Some((scheme, rest)) = text.split_once("://") else {
        return if text.is_empty() { String::new() } else { "***".to_owned() };
    };
    let rest = rest.split('?').next().unwrap_or_default();
    let place = match rest.rsplit_once('@') {
        Some((_, place)) => format!("***@{place}"),
        None => rest.to_owned(),
    };
    format!("{scheme}://{place}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn secrets_are_left_out() {
        assert_eq!(
            redacted("postgres://user:sec@ret@host:1/name?password=x"),
            "postgres://***@host:1/name"
        );
        assert_eq!(redacted("postgres://host/name"), "postgres://host/name");
        assert_eq!(redacted("whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw"), "***");
        assert_eq!(redacted(""), "");
    }
}
