//! The command line.
//!
//! Exit codes: 0 done (and, for `solve`, converged), 1 the program or its surroundings are at
//! fault, 2 bad input or usage, 3 not converged.

mod array;
mod backup;
mod client;
mod common;
mod completions;
mod demo;
mod example;
mod fault;
mod healthcheck;
mod input;
mod key;
mod man;
mod openapi;
mod progress;
mod serve;
mod settings;
mod solve;
mod style;
mod table;
mod usage;
mod validate;
mod worker;

use std::process::ExitCode;

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::config::{ServeConfig, WorkerConfig};
use crate::telemetry::{self, LevelFilter, LogConfig};
use backup::{BackupArgs, CheckArgs, RestoreArgs};
use completions::CompletionsArgs;
use demo::DemoArgs;
use example::ExampleArgs;
use fault::report_fault;
use healthcheck::HealthcheckArgs;
use key::KeyArgs;
use man::ManArgs;
use openapi::OpenapiArgs;
use solve::SolveArgs;
use validate::ValidateArgs;

/// Elasto-plastic contact between two bodies, solved in milliseconds
#[derive(Debug, Parser)]
#[command(name = "brinell", version, propagate_version = true)]
struct Cli {
    #[command(flatten)]
    log: LogConfig,

    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run the HTTP service
    Serve(Box<Configured<ServeConfig>>),
    /// Solve the jobs that services sharing a database take in
    Worker(Configured<WorkerConfig>),
    /// Solve one job here and now, without a server
    Solve(SolveArgs),
    /// Check a job and estimate its cost without solving it
    Validate(ValidateArgs),
    /// Ask a running service whether it is well: exit code 0 if it is, 1 if not
    Healthcheck(HealthcheckArgs),
    /// Print the HTTP interface as an OpenAPI document
    Openapi(OpenapiArgs),
    /// Make, list and revoke API keys
    Key(KeyArgs),
    /// Look for damage in everything that is stored, also beside a running service: exit code 0 if
    /// there is none
    Check(CheckArgs),
    /// Write a consistent copy of the embedded database to a file, also beside a running service
    Backup(BackupArgs),
    /// Put a backup into a data directory that has no database
    Restore(RestoreArgs),
    /// Start the service, send it the reference problem over HTTP and show the answer
    Demo(DemoArgs),
    /// Print a job to begin with, or the names of all
    Example(ExampleArgs),
    /// Print what completes commands and options in a shell
    Completions(CompletionsArgs),
    /// Write manual pages of all commands into a folder
    Man(ManArgs),
}

/// A command with settings, which can be shown instead.
#[derive(Debug, Args)]
struct Configured<T: Args> {
    /// Print the settings as they would be used, each as its variable, and stop
    #[arg(long)]
    print_config: bool,

    #[command(flatten)]
    config: T,
}

/// Runs the program with the process's arguments.
pub fn main() -> ExitCode {
    let mut command = Cli::command();
    let matches = match command.try_get_matches_from_mut(std::env::args_os()) {
        Ok(matches) => matches,
        Err(error) => return usage::report(&error, &command),
    };
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let prints_config = match &cli.command {
        Command::Serve(serve) => serve.print_config,
        Command::Worker(worker) => worker.print_config,
        _ => false,
    };
    if prints_config {
        return settings::print(&command, &matches).unwrap_or_else(|fault| report_fault(&fault));
    }
    let (level, audit) = match cli.command {
        Command::Serve(_) | Command::Worker(_) => (LevelFilter::INFO, LevelFilter::INFO),
        // Its own job is shown, not logged.
        Command::Demo(_) => (LevelFilter::WARN, LevelFilter::WARN),
        _ => (LevelFilter::WARN, LevelFilter::INFO),
    };
    telemetry::start(&cli.log, level, audit);
    let done = match cli.command {
        Command::Serve(serve) => serve::serve(&serve.config),
        Command::Worker(worker) => worker::worker(&worker.config),
        Command::Solve(args) => solve::solve(&args),
        Command::Validate(args) => validate::validate(&args),
        Command::Healthcheck(args) => healthcheck::healthcheck(&args),
        Command::Openapi(args) => openapi::openapi(&args),
        Command::Key(args) => key::key(&args),
        Command::Check(args) => backup::check(&args),
        Command::Backup(args) => backup::backup(&args),
        Command::Restore(args) => backup::restore(&args),
        Command::Demo(args) => demo::demo(&args),
        Command::Example(args) => example::example(&args),
        Command::Completions(args) => completions::completions(&args, Cli::command()),
        Command::Man(args) => man::man(&args, Cli::command()),
    };
    #[cfg(feature = "otlp")]
    telemetry::flush();
    done.unwrap_or_else(|fault| report_fault(&fault))
}
