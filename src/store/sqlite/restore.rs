//! Puts a backup in the place of a database.

use std::fs::{self, File};
use std::io;
use std::path::Path;

use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{ConnectOptions, Connection};

use super::{DATABASE, STEPS, SqliteError, lock_directory};

/// Restores a backup into a directory that has no database. The file is checked first, and is in
/// place as a whole or not at all.
///
/// # Errors
/// [`SqliteError`].
pub async fn restore_sqlite(directory: &Path, backup: &Path) -> Result<(), SqliteError> {
    let _lock = lock_directory(directory)?;
    let database = directory.join(DATABASE);
    if database.exists() {
        return Err(SqliteError::Exists(database));
    }
    check_backup(backup).await?;
    let failed = |source| SqliteError::Directory { path: directory.to_owned(), source };
    install(directory, &database, backup).map_err(failed)
}

/// Refuses what is damaged, what is no backup, and what a newer version has made.
async fn check_backup(path: &Path) -> Result<(), SqliteError> {
    let refused = |reason: String| SqliteError::NotRestorable { path: path.to_owned(), reason };
    let failed = |error: sqlx::Error| refused(error.to_string());
    // A backup is one file, complete without a log beside it.
    let options = SqliteConnectOptions::new().filename(path).read_only(true).immutable(true);
    let mut connection = options.connect().await.map_err(failed)?;
    let found =
        sqlx::query_scalar::<_, String>("PRAGMA quick_check(1)").fetch_one(&mut connection).await;
    let found = found.map_err(failed)?;
    if found != "ok" {
        return Err(refused(found));
    }
    let version = sqlx::query_scalar::<_, i64>("SELECT max(version) FROM _sqlx_migrations");
    let version = version.fetch_one(&mut connection).await.map_err(failed)?;
    connection.close().await.map_err(failed)?;
    if STEPS.last().is_some_and(|last| version > last.version) {
        return Err(refused("a newer version of brinell has made it".to_owned()));
    }
    Ok(())
}

fn install(directory: &Path, database: &Path, backup: &Path) -> io::Result<()> {
    for log in ["-wal", "-shm"] {
        match fs::remove_file(directory.join(format!("{DATABASE}{log}"))) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    let partial = directory.join(format!("{DATABASE}.partial"));
    fs::copy(backup, &partial)?;
    File::open(&partial)?.sync_all()?;
    fs::rename(&partial, database)?;
    File::open(directory)?.sync_all()
}
