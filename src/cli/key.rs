//! `brinell key`: API keys are made, listed and revoked here, also beside a running service.

use std::process::ExitCode;

use clap::{Args, Subcommand, ValueEnum};

use super::block_on;
use super::fault::Fault;
use super::input::write_answer;
use crate::app::open_keys;
use crate::config::StorageConfig;
use crate::jobs::{ApiKey, Clock, KeyId, Scope, SystemClock};

/// Arguments of `brinell key`.
#[derive(Debug, Args)]
pub(super) struct KeyArgs {
    #[command(subcommand)]
    command: KeyCommand,
}

#[derive(Debug, Subcommand)]
enum KeyCommand {
    /// Make a key and print its token, which is not shown again
    Create {
        /// Whose it is, for people
        name: String,
        /// What it may do
        #[arg(long, value_name = "SCOPE", default_value = "write")]
        scope: KeyScope,
        #[command(flatten)]
        storage: StorageConfig,
    },
    /// List all keys
    List {
        #[command(flatten)]
        storage: StorageConfig,
    },
    /// Make a key no longer good, at once and for ever
    Revoke {
        /// Which
        id: KeyId,
        #[command(flatten)]
        storage: StorageConfig,
    },
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum KeyScope {
    /// Look at its own jobs
    Read,
    /// Hand jobs in, stop and remove its own
    Write,
    /// Everything, with everybody's jobs
    Admin,
}

impl From<KeyScope> for Scope {
    fn from(scope: KeyScope) -> Self {
        match scope {
            KeyScope::Read => Self::Read,
            KeyScope::Write => Self::Write,
            KeyScope::Admin => Self::Admin,
        }
    }
}

pub(super) fn key(args: &KeyArgs) -> Result<ExitCode, Fault> {
    block_on(async {
        let text = match &args.command {
            KeyCommand::Create { name, scope, storage } => create(name, *scope, storage).await?,
            KeyCommand::List { storage } => {
                open_keys(storage).await?.keys(None).await?.iter().map(line).collect()
            }
            KeyCommand::Revoke { id, storage } => {
                if !open_keys(storage).await?.revoke_key(*id).await? {
                    return Err(Fault::NoKey(*id));
                }
                format!("{id} is revoked\n")
            }
        };
        write_answer(None, text.as_bytes())?;
        Ok(ExitCode::SUCCESS)
    })
}

async fn create(name: &str, scope: KeyScope, storage: &StorageConfig) -> Result<String, Fault> {
    let (key, token) = ApiKey::generate(name.to_owned(), scope.into(), SystemClock.now());
    open_keys(storage).await?.add_key(key).await?;
    Ok(format!("{token}\n"))
}

fn line(key: &ApiKey) -> String {
    let state = if key.revoked_at.is_some() { "revoked" } else { "good" };
    format!("{}  {:5}  {state:7}  {:.0}  {}\n", key.id, key.scope.name(), key.created_at, key.name)
}
