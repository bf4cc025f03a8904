//! `brinell check`, `brinell backup` and `brinell restore`: for the administrator of a store.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::common::block_on;
use super::fault::Fault;
use super::input::write_answer;
use crate::app::open_existing;
use crate::config::StorageConfig;
use crate::store::restore_sqlite;
use crate::telemetry::AUDIT;

/// Arguments of `brinell check`.
#[derive(Debug, Args)]
pub(super) struct CheckArgs {
    #[command(flatten)]
    storage: StorageConfig,
}

/// Arguments of `brinell backup`.
#[derive(Debug, Args)]
pub(super) struct BackupArgs {
    /// File to write, which must not exist
    file: PathBuf,
    #[command(flatten)]
    storage: StorageConfig,
}

/// Arguments of `brinell restore`.
#[derive(Debug, Args)]
pub(super) struct RestoreArgs {
    /// What `brinell backup` wrote
    file: PathBuf,
    #[command(flatten)]
    storage: StorageConfig,
}

pub(super) fn check(args: &CheckArgs) -> Result<ExitCode, Fault> {
    let found = block_on(async { Ok(open_existing(&args.storage).await?.check(true).await?) })?;
    if found.is_empty() {
        write_answer(None, b"no damage found\n")?;
        return Ok(ExitCode::SUCCESS);
    }
    write_answer(None, format!("{}\n", found.join("\n")).as_bytes())?;
    Err(Fault::Unwell(format!("{} damages found", found.len())))
}

pub(super) fn backup(args: &BackupArgs) -> Result<ExitCode, Fault> {
    if args.storage.is_shared() {
        return Err(Fault::Unwell(
            "back PostgreSQL up with its own means, such as pg_dump".to_owned(),
        ));
    }
    let failed = |source| Fault::Write { name: args.file.display().to_string(), source };
    if args.file.exists() {
        return Err(failed(io::ErrorKind::AlreadyExists.into()));
    }
    let mut partial = OsString::from(&args.file);
    partial.push(".partial");
    let partial = PathBuf::from(partial);
    // An interrupted backup may have left this file.
    match fs::remove_file(&partial) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(failed(error)),
        _ => {}
    }
    block_on(async { Ok(open_existing(&args.storage).await?.backup(&partial).await?) })?;
    publish(&partial, &args.file).map_err(failed)?;
    tracing::info!(target: AUDIT, file = %args.file.display(), "backup written");
    Ok(ExitCode::SUCCESS)
}

/// Renames a complete file to its final name.
fn publish(partial: &Path, file: &Path) -> io::Result<()> {
    File::open(partial)?.sync_all()?;
    fs::rename(partial, file)?;
    let directory = file.parent().filter(|parent| !parent.as_os_str().is_empty());
    File::open(directory.unwrap_or(Path::new(".")))?.sync_all()
}

pub(super) fn restore(args: &RestoreArgs) -> Result<ExitCode, Fault> {
    if args.storage.is_shared() {
        return Err(Fault::Unwell(
            "restore PostgreSQL with its own means, such as pg_restore".to_owned(),
        ));
    }
    block_on(async {
        restore_sqlite(&args.storage.data_dir, &args.file)
            .await
            .map_err(|error| Fault::App(error.into()))
    })?;
    let [file, directory] = [&args.file, &args.storage.data_dir].map(|path| path.display());
    tracing::info!(target: AUDIT, %file, %directory, "backup restored");
    Ok(ExitCode::SUCCESS)
}
