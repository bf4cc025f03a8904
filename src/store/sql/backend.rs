//! The interface that SQLite and PostgreSQL implement.

use std::ops::DerefMut;
use std::path::Path;

use async_trait::async_trait;

use crate::jobs::{JobId, JobNotifier, StoreError};

/// A database with jobs in it.
#[async_trait]
pub(in crate::store) trait Backend: Send + Sync + 'static {
    /// Type of a connection of sqlx.
    type Connection: Send;
    /// A connection without a transaction.
    type Line: DerefMut<Target = Self::Connection> + Send;
    /// A transaction that may write.
    type Write: WriteTransaction<Target = Self::Connection>;

    /// Acquires a connection for reading; fails if there is none for too long.
    async fn read(&self) -> Result<Self::Line, StoreError>;

    /// Acquires a connection for single statements that write. Each is a transaction of its own,
    /// which the database ends by itself: a process that stops between two of them holds nothing.
    async fn statements(&self) -> Result<Self::Line, StoreError>;

    /// Takes the connection that is reserved for a purpose: no other use can hold it up.
    async fn reserved(&self, purpose: Reserved) -> Result<Self::Line, StoreError>;

    /// Keeps a reserved connection for its next use. One whose call fails, or is given up, is not
    /// kept: its line may be dead.
    fn keep(&self, line: Self::Line);

    /// Begins a transaction that may write; returns it and the time in microseconds since 1970.
    async fn write(&self) -> Result<(Self::Write, i64), StoreError>;

    /// Returns the time in microseconds since 1970 where a clock of this process counts; `None`
    /// where that of the database does.
    fn now(&self) -> Option<i64>;

    /// Returns once everything that was committed before the call survives a loss of power.
    async fn sync(&self) -> Result<(), StoreError>;

    /// Checks that there is room for another job.
    ///
    /// # Errors
    /// [`StoreError::DiskFull`] below the reserve.
    async fn check_space(&self) -> Result<(), StoreError>;

    /// Checks the database file for damage; returns one line for each fault.
    async fn check(&self) -> Result<Vec<String>, StoreError>;

    /// Copies the database into a new file; returns `false` where the database server makes its
    /// own backups.
    async fn backup(&self, file: &Path) -> Result<bool, StoreError>;

    /// Closes all connections, after which the database file is complete and every call fails.
    async fn close(&self) {}

    /// Tells other processes of changes that are committed.
    fn announce(&self, changes: &[Change]);
}

/// What a worker has connections of their own for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Reserved {
    /// The heartbeats that extend its leases.
    Heartbeats,
    /// Its claims of jobs.
    Claims,
}

/// A transaction that is rolled back unless it is committed.
#[async_trait]
pub(in crate::store) trait WriteTransaction: DerefMut + Send {
    /// Makes the changes visible to others.
    async fn commit(self) -> Result<(), StoreError>;
}

/// Durability of a commit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Durability {
    /// The commit is synced to the disk before it is acknowledged.
    Synced,
    /// The commit survives a crash of the process; a loss of power may undo it.
    Written,
}

/// A change that other tasks or processes may be waiting for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Change {
    /// A job can be claimed.
    Work,
    /// A job has progressed.
    Progress(JobId),
    /// A job was asked to stop.
    Cancel(JobId),
    /// A job has ended.
    Finished(JobId),
}

impl Change {
    /// Announces the change in this process.
    pub(in crate::store) fn announce(self, notifier: &JobNotifier) {
        match self {
            Self::Work => notifier.announce_work(),
            Self::Progress(id) => notifier.announce_progress(id),
            Self::Cancel(id) => notifier.announce_cancel(id),
            Self::Finished(id) => notifier.announce_finished(id),
        }
    }
}
