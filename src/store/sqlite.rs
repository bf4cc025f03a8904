//! Jobs in an embedded SQLite file: nothing to set up, and nothing acknowledged is lost.
//!
//! WAL and `synchronous = FULL`: a commit is on the disk when it returns. All writing goes through one connection,
//! so that nobody waits for a lock; readers have their own and never wait for the writer. One process owns the
//! directory, by a lock on a file in it; therefore whatever is marked as running at the start was interrupted, and
//! runs again at once.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use sqlx::pool::PoolConnection;
use sqlx::sqlite::{SqliteConnectOptions, SqliteJournalMode, SqlitePoolOptions, SqliteSynchronous};
use sqlx::{Sqlite, SqliteConnection, SqlitePool, Transaction};
use thiserror::Error;

use super::Store;
use super::express::ExpressStore;
use super::migration::{self, Step};
use super::sql::{Backend, Change, SqlStore};
use crate::jobs::{Clock, JobNotifier, StoreError};

const STEPS: &[Step] =
    &[Step { version: 1, name: "jobs", sql: include_str!("../../migrations/sqlite/0001_jobs.sql") }];

/// Readers beside the writer.
const READERS: u32 = 4;

/// Longest wait for the lock of another process's statement (a command beside a running service).
const BUSY_TIMEOUT: Duration = Duration::from_secs(10);

/// Why there is no store.
#[derive(Debug, Error)]
pub enum SqliteError {
    /// The directory or its lock cannot be made.
    #[error("the data directory {}: {source}", .path.display())]
    Directory {
        /// Which.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Another process owns the directory.
    #[error(
        "the data directory {} is in use by another process; give each its own, or share PostgreSQL with \
         --database-url", .0.display()
    )]
    InUse(PathBuf),
    /// The file cannot be opened or brought up to date.
    #[error("the database {}: {source}", .path.display())]
    Database {
        /// Which.
        path: PathBuf,
        /// Why.
        source: sqlx::Error,
    },
}

/// The file, open.
struct SqliteFile {
    writer: SqlitePool,
    readers: SqlitePool,
    clock: Arc<dyn Clock>,
    _lock: Option<File>,
}

/// Opens the store in a directory, making both if need be.
///
/// # Errors
/// [`SqliteError`].
pub async fn open_sqlite(
    directory: &Path,
    queue_capacity: usize,
    notifier: Arc<JobNotifier>,
    clock: Arc<dyn Clock>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let lock = own(directory)?;
    open(directory, queue_capacity, notifier, clock, Some(lock)).await
}

/// Opens the store beside the process that owns it, to look after its API keys.
///
/// # Errors
/// [`SqliteError`].
pub async fn open_sqlite_keys(
    directory: &Path,
    clock: Arc<dyn Clock>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let failed = |source| SqliteError::Directory { path: directory.to_owned(), source };
    fs::create_dir_all(directory).map_err(failed)?;
    open(directory, 0, JobNotifier::new(), clock, None).await
}

async fn open(
    directory: &Path,
    queue_capacity: usize,
    notifier: Arc<JobNotifier>,
    clock: Arc<dyn Clock>,
    lock: Option<File>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let path = directory.join("brinell.db");
    let file = SqliteFile::open(&path, Arc::clone(&clock), lock).await;
    let backend = file.map_err(|source| SqliteError::Database { path, source })?;
    Ok(Arc::new(ExpressStore::new(SqlStore { backend, notifier, queue_capacity }, clock)))
}

/// Makes the directory and locks it. The lock ends with the process, however it ends.
fn own(directory: &Path) -> Result<File, SqliteError> {
    let failed = |source| SqliteError::Directory { path: directory.to_owned(), source };
    fs::create_dir_all(directory).map_err(failed)?;
    let lock = File::create(directory.join("brinell.lock")).map_err(failed)?;
    match lock.try_lock() {
        Ok(()) => Ok(lock),
        Err(TryLockError::WouldBlock) => Err(SqliteError::InUse(directory.to_owned())),
        Err(TryLockError::Error(source)) => Err(failed(source)),
    }
}

impl SqliteFile {
    async fn open(path: &Path, clock: Arc<dyn Clock>, lock: Option<File>) -> Result<Self, sqlx::Error> {
        let options = SqliteConnectOptions::new()
            .filename(path)
            .create_if_missing(true)
            .journal_mode(SqliteJournalMode::Wal)
            .synchronous(SqliteSynchronous::Full)
            .foreign_keys(true)
            .busy_timeout(BUSY_TIMEOUT);
        let pool =
            || SqlitePoolOptions::new().idle_timeout(None).max_lifetime(None).test_before_acquire(false);
        let writer = pool().min_connections(1).max_connections(1).connect_with(options.clone()).await?;
        migration::run(STEPS, &writer).await?;
        if lock.is_some() {
            sqlx::query("UPDATE jobs SET leased_until = 0 WHERE state = 'running'").execute(&writer).await?;
        }
        let readers =
            pool().max_connections(READERS).connect_with(options.pragma("query_only", "on")).await?;
        Ok(Self { writer, readers, clock, _lock: lock })
    }
}

#[async_trait]
impl Backend for SqliteFile {
    type Database = Sqlite;

    async fn read(&self) -> Result<PoolConnection<Sqlite>, StoreError> {
        Ok(self.readers.acquire().await?)
    }

    async fn write(&self) -> Result<(Transaction<'static, Sqlite>, i64), StoreError> {
        let transaction = self.writer.begin_with("BEGIN IMMEDIATE").await?;
        Ok((transaction, self.clock.now().as_microsecond()))
    }

    async fn notify(&self, _: &mut SqliteConnection, _: &[Change]) -> Result<(), StoreError> {
        Ok(())
    }
}
