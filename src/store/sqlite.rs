//! Jobs in an embedded SQLite file: no server to set up, and no acknowledged change is lost.
//! `:memory:` keeps the same tables in this process's memory.
//!
//! One connection does all writing, so that no statement waits for a lock; readers have
//! connections of their own and never wait for the writer. The file has a write-ahead log with
//! `synchronous = NORMAL`: a commit survives a crash of the process at once, and a loss of power
//! after [`Backend::sync`], which several commits share. One process owns the directory by a lock
//! on a file in it. Jobs that are marked as running at the start were therefore interrupted; they
//! run again at once.

mod own_file;
mod restore;
mod space;
mod wal;

use std::fs::{self, File, TryLockError};
use std::io;
use std::ops::{Deref, DerefMut};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use sqlx::pool::PoolConnection;
use sqlx::sqlite::{
    SqliteConnectOptions, SqliteJournalMode, SqlitePoolOptions, SqliteSynchronous,
};
use sqlx::{ConnectOptions, Sqlite, SqliteConnection, SqlitePool};
use thiserror::Error;
use tokio::time::timeout;

use self::own_file::OwnFile;
pub use self::restore::restore_sqlite;
use self::space::FreeSpace;
use self::wal::WalSync;
use super::migration::{self, Step, steps};
use super::sql::{Backend, Change, Reserved, SqlStore, WriteTransaction};
use super::{Store, StoreLimits};
use crate::jobs::{Clock, JobNotifier, StoreError};

const STEPS: &[Step] = steps!("sqlite");

/// Name of the database in its directory.
pub const DATABASE: &str = "brinell.db";

/// Readers beside the writer.
const READERS: u32 = 4;

/// Longest wait for a connection to read from.
const READER_WAIT: Duration = Duration::from_secs(2);

/// Longest wait for a lock that another process holds (a command beside a running service).
const BUSY_TIMEOUT: Duration = Duration::from_secs(10);

/// Size \[bytes\] to which the write-ahead log shrinks once its content is in the database.
const WAL_BYTES: &str = "67108864";

/// Size \[bytes\] of a page.
const PAGE_BYTES: u64 = 4096;

/// One part in so many of a store in memory is reserved for the results of accepted jobs.
const MEMORY_RESERVE: u64 = 8;

/// An error that keeps the store from opening.
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
        "the data directory {} is in use by another process; give each its own, or share \
         PostgreSQL with --database-url", .0.display()
    )]
    InUse(PathBuf),
    /// The directory has a database already.
    #[error("{} exists; a backup is restored into a directory without a database", .0.display())]
    Exists(PathBuf),
    /// The file is no backup, or is damaged.
    #[error("{} cannot be restored: {reason}", .path.display())]
    NotRestorable {
        /// Which.
        path: PathBuf,
        /// Why.
        reason: String,
    },
    /// The file cannot be opened or brought up to date.
    #[error("the database {}: {source}", .path.display())]
    Database {
        /// Which.
        path: PathBuf,
        /// Why.
        source: sqlx::Error,
    },
}

/// An open database.
struct SqliteDatabase {
    writer: SqlitePool,
    /// The writer's pool again where the database is in memory: such a database exists only on its
    /// one connection.
    readers: SqlitePool,
    clock: Arc<dyn Clock>,
    /// `None` in memory, where nothing survives anyway.
    wal: Option<WalSync>,
    space: Space,
    _lock: Option<DirectoryLock>,
}

/// The space that a database may take.
enum Space {
    Disk {
        disk: FreeSpace,
        /// The database and its log.
        files: [OwnFile; 2],
    },
    /// Memory, up to so many bytes.
    Memory { bytes: u64 },
}

/// Opens the store in a directory, making both if need be.
///
/// # Errors
/// [`SqliteError`].
pub async fn open_sqlite(
    directory: &Path,
    limits: StoreLimits,
    notifier: Arc<JobNotifier>,
    clock: Arc<dyn Clock>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let lock = lock_directory(directory)?;
    open(directory, limits, notifier, clock, Some(lock)).await
}

/// Opens the store beside the process that owns it, to manage its API keys.
///
/// # Errors
/// [`SqliteError`].
pub async fn open_sqlite_keys(
    directory: &Path,
    clock: Arc<dyn Clock>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let failed = |source| SqliteError::Directory { path: directory.to_owned(), source };
    fs::create_dir_all(directory).map_err(failed)?;
    open(directory, StoreLimits::default(), JobNotifier::new(), clock, None).await
}

/// Opens a store in this process's memory that may grow to `bytes`.
///
/// # Errors
/// [`SqliteError::Database`].
pub async fn open_sqlite_in_memory(
    bytes: u64,
    limits: StoreLimits,
    notifier: Arc<JobNotifier>,
    clock: Arc<dyn Clock>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let backend = SqliteDatabase::in_memory(bytes, clock).await;
    let failed = |source| SqliteError::Database { path: PathBuf::from(":memory:"), source };
    let backend = backend.map_err(failed)?;
    Ok(Arc::new(SqlStore { backend, notifier, limits }))
}

async fn open(
    directory: &Path,
    limits: StoreLimits,
    notifier: Arc<JobNotifier>,
    clock: Arc<dyn Clock>,
    lock: Option<DirectoryLock>,
) -> Result<Arc<dyn Store>, SqliteError> {
    let path = directory.join(DATABASE);
    let backend = SqliteDatabase::open(&path, clock, lock, limits.min_free_bytes).await;
    let backend = backend.map_err(|source| SqliteError::Database { path, source })?;
    Ok(Arc::new(SqlStore { backend, notifier, limits }))
}

/// The lock of a data directory. The operating system releases it when the process ends.
struct DirectoryLock(File);

impl Drop for DirectoryLock {
    fn drop(&mut self) {
        // Closing the file is not enough: a child process that another thread is starting may
        // still hold a copy of the descriptor.
        drop(self.0.unlock());
    }
}

/// Makes the directory and locks it.
fn lock_directory(directory: &Path) -> Result<DirectoryLock, SqliteError> {
    let failed = |source| SqliteError::Directory { path: directory.to_owned(), source };
    fs::create_dir_all(directory).map_err(failed)?;
    let lock = File::create(directory.join("brinell.lock")).map_err(failed)?;
    match lock.try_lock() {
        Ok(()) => Ok(DirectoryLock(lock)),
        Err(TryLockError::WouldBlock) => Err(SqliteError::InUse(directory.to_owned())),
        Err(TryLockError::Error(source)) => Err(failed(source)),
    }
}

/// Makes the file of a new database, for its owner alone; SQLite gives its log the same rights.
fn private(path: &Path) -> io::Result<()> {
    let mut options = File::options();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options.append(true).create(true).open(path).map(drop)
}

/// Options of all connections. Automatic indices are off: SQLite would build one for a single
/// statement by reading the whole table, and every statement here has its own index. Statements are
/// not logged: the text of a message has what clients have sent.
fn connect_options() -> SqliteConnectOptions {
    let options = SqliteConnectOptions::new().disable_statement_logging();
    options.foreign_keys(true).pragma("automatic_index", "off")
}

impl SqliteDatabase {
    async fn open(
        path: &Path,
        clock: Arc<dyn Clock>,
        lock: Option<DirectoryLock>,
        min_free_bytes: u64,
    ) -> Result<Self, sqlx::Error> {
        let options = connect_options()
            .filename(path)
            .create_if_missing(true)
            .journal_mode(SqliteJournalMode::Wal)
            .synchronous(SqliteSynchronous::Normal)
            .pragma("journal_size_limit", WAL_BYTES)
            .busy_timeout(BUSY_TIMEOUT);
        private(path).map_err(sqlx::Error::Io)?;
        let writer = writer_pool().connect_with(options.clone()).await?;
        migration::run(STEPS, &writer).await?;
        if lock.is_some() {
            sqlx::query("UPDATE jobs SET leased_until = 0 WHERE state = 'running'")
                .execute(&writer)
                .await?;
        }
        let wal = WalSync::open(path).await.map_err(sqlx::Error::Io)?;
        wal.sync().await.map_err(sqlx::Error::Io)?;
        let readers = pool()
            .max_connections(READERS)
            .connect_with(options.pragma("query_only", "on"))
            .await?;
        let disk = FreeSpace::new(path, min_free_bytes);
        let own = |path: &Path| OwnFile::new(path).map_err(sqlx::Error::Io);
        let files = [own(path)?, own(&wal::path(path))?];
        Ok(Self {
            writer,
            readers,
            clock,
            wal: Some(wal),
            space: Space::Disk { disk, files },
            _lock: lock,
        })
    }

    async fn in_memory(bytes: u64, clock: Arc<dyn Clock>) -> Result<Self, sqlx::Error> {
        let options = connect_options()
            .in_memory(true)
            .pragma("max_page_count", (bytes / PAGE_BYTES).to_string());
        let writer = writer_pool().connect_with(options).await?;
        migration::run(STEPS, &writer).await?;
        Ok(Self {
            readers: writer.clone(),
            writer,
            clock,
            wal: None,
            space: Space::Memory { bytes },
            _lock: None,
        })
    }
}

impl SqliteDatabase {
    /// A count of pages, in bytes.
    async fn pages(&self, pragma: &'static str) -> Result<u64, StoreError> {
        let pages = sqlx::query_scalar::<_, i64>(pragma).fetch_one(&self.readers).await?;
        Ok(u64::try_from(pages).unwrap_or(0) * PAGE_BYTES)
    }
}

/// Makes a pool of one connection. Acquiring it rolls back a transaction that an error or a
/// dropped future left open.
fn writer_pool() -> SqlitePoolOptions {
    pool().min_connections(1).max_connections(1).after_release(|connection, _| {
        Box::pin(async move {
            // The statement fails where no transaction is open.
            let _ = sqlx::query("ROLLBACK").execute(connection).await;
            Ok(true)
        })
    })
}

/// A pool that keeps its connections.
fn pool() -> SqlitePoolOptions {
    SqlitePoolOptions::new().idle_timeout(None).max_lifetime(None).test_before_acquire(false)
}

#[async_trait]
impl Backend for SqliteDatabase {
    type Connection = SqliteConnection;
    type Line = PoolConnection<Sqlite>;
    type Write = SqliteTransaction;

    async fn read(&self) -> Result<PoolConnection<Sqlite>, StoreError> {
        let reader = timeout(READER_WAIT, self.readers.acquire()).await;
        Ok(reader.map_err(StoreError::unavailable)??)
    }

    async fn statements(&self) -> Result<PoolConnection<Sqlite>, StoreError> {
        Ok(self.writer.acquire().await?)
    }

    async fn reserved(&self, _: Reserved) -> Result<PoolConnection<Sqlite>, StoreError> {
        self.statements().await
    }

    fn keep(&self, _: PoolConnection<Sqlite>) {}

    fn now(&self) -> Option<i64> {
        Some(self.clock.now().as_microsecond())
    }

    async fn write(&self) -> Result<(SqliteTransaction, i64), StoreError> {
        let mut connection = self.writer.acquire().await?;
        sqlx::query("BEGIN IMMEDIATE").execute(&mut *connection).await?;
        Ok((SqliteTransaction(connection), self.clock.now().as_microsecond()))
    }

    async fn sync(&self) -> Result<(), StoreError> {
        let Some(wal) = &self.wal else { return Ok(()) };
        wal.sync().await.map_err(StoreError::unavailable)
    }

    async fn check_space(&self) -> Result<(), StoreError> {
        // The database reuses the pages of removed jobs before it grows.
        let reusable = async || self.pages("PRAGMA freelist_count").await;
        let is_low = match &self.space {
            Space::Disk { disk, files } => {
                files.iter().try_for_each(OwnFile::check).map_err(StoreError::unavailable)?;
                disk.is_low(0) && disk.is_low(reusable().await?)
            }
            Space::Memory { bytes } => {
                let used =
                    self.pages("PRAGMA page_count").await?.saturating_sub(reusable().await?);
                used > bytes - bytes / MEMORY_RESERVE
            }
        };
        if is_low { Err(StoreError::DiskFull) } else { Ok(()) }
    }

    async fn check(&self) -> Result<Vec<String>, StoreError> {
        let found = sqlx::query_scalar::<_, String>("PRAGMA quick_check(100)")
            .fetch_all(&self.readers)
            .await;
        match found.map_err(StoreError::from) {
            Ok(lines) => Ok(lines.into_iter().filter(|line| line != "ok").collect()),
            Err(StoreError::Damaged(source)) => Ok(vec![source.to_string()]),
            Err(error) => Err(error),
        }
    }

    async fn backup(&self, file: &Path) -> Result<bool, StoreError> {
        let name = file
            .to_str()
            .ok_or_else(|| StoreError::unavailable("the name of the file is not UTF-8"))?;
        // The copy is one read transaction: it contains no later commits.
        let mut connection = self.writer.acquire().await?;
        sqlx::query("VACUUM INTO $1").bind(name).execute(&mut *connection).await?;
        Ok(true)
    }

    async fn close(&self) {
        self.readers.close().await;
        // The last connection moves the log into the database and removes it.
        self.writer.close().await;
    }

    fn announce(&self, _: &[Change]) {
        // This process is the only one.
    }
}

/// A transaction of the writer. The pool rolls back a transaction without commit, see
/// [`writer_pool`].
///
/// sqlx's own type counts nested transactions. When the disk is full, SQLite ends a transaction by
/// itself and the count is wrong: that connection never begins another transaction.
struct SqliteTransaction(PoolConnection<Sqlite>);

impl Deref for SqliteTransaction {
    type Target = SqliteConnection;

    fn deref(&self) -> &SqliteConnection {
        &self.0
    }
}

impl DerefMut for SqliteTransaction {
    fn deref_mut(&mut self) -> &mut SqliteConnection {
        &mut self.0
    }
}

#[async_trait]
impl WriteTransaction for SqliteTransaction {
    async fn commit(mut self) -> Result<(), StoreError> {
        sqlx::query("COMMIT").execute(&mut *self.0).await?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use sqlx::Row as _;

    use super::*;
    use crate::jobs::SystemClock;
    use crate::store::sql::NEXT;

    /// A duplicated descriptor, as a child process holds between fork and exec.
    #[test]
    fn a_lock_ends_although_its_file_is_open_elsewhere() {
        let directory = std::env::temp_dir().join(format!("brinell-lock-{}", std::process::id()));
        let lock = lock_directory(&directory).unwrap();
        assert!(matches!(lock_directory(&directory), Err(SqliteError::InUse(_))));
        let open = lock.0.try_clone().unwrap();
        drop(lock);
        assert!(lock_directory(&directory).is_ok());
        drop(open);
        fs::remove_dir_all(directory).unwrap();
    }

    /// A claim blocks the writer, so its cost must not grow with the queue.
    #[tokio::test]
    async fn a_claim_looks_the_heads_of_the_queues_up() {
        let store = SqliteDatabase::in_memory(1 << 20, Arc::new(SystemClock)).await.unwrap();
        let plan = sqlx::query(sqlx::AssertSqlSafe(format!("EXPLAIN QUERY PLAN {NEXT}")));
        let plan = plan.fetch_all(&store.readers).await.unwrap();
        let steps: Vec<String> = plan.iter().map(|step| step.get("detail")).collect();
        for (table, index) in [("q", "(account=?"), ("l", "(state=?"), ("jobs", "(state=?")] {
            let of_table = |step: &&String| step.split(' ').nth(1) == Some(table);
            let mut steps = steps.iter().filter(of_table).peekable();
            assert!(steps.peek().is_some() && steps.all(|step| step.contains(index)), "{table}");
        }
    }
}
