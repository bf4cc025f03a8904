//! What tells one database from another.

use std::ops::DerefMut;
use std::path::Path;
use std::time::Duration;

use async_trait::async_trait;
use sqlx::pool::PoolConnection;
use sqlx::{Database, Pool};
use tokio::time::timeout;

use super::claiming::Claiming;
use super::deliveries::Deliveries;
use super::intake::Intake;
use super::keys::Keys;
use super::leasing::Leasing;
use super::reading::Reading;
use crate::jobs::{JobId, JobNotifier, StoreError};

/// Longest wait for a connection to read from.
const READER_WAIT: Duration = Duration::from_secs(2);

/// All statements that a connection executes.
pub(in crate::store) trait Statements:
    Reading + Intake + Claiming + Leasing + Keys + Deliveries
{
}

impl<T: Reading + Intake + Claiming + Leasing + Keys + Deliveries> Statements for T {}

/// A database with jobs in it.
#[async_trait]
pub(in crate::store) trait Backend: Send + Sync + 'static {
    /// Which kind.
    type Database: Database<Connection: Statements>;
    /// A transaction that may write.
    type Write: WriteTransaction<Target = <Self::Database as Database>::Connection>;

    /// Connections to read from.
    fn readers(&self) -> &Pool<Self::Database>;

    /// A connection to read from. Who has to wait for it for long is told so.
    async fn read(&self) -> Result<PoolConnection<Self::Database>, StoreError> {
        let reader = timeout(READER_WAIT, self.readers().acquire()).await;
        Ok(reader.map_err(StoreError::unavailable)??)
    }

    /// A transaction that may write, and the time in microseconds since 1970.
    async fn write(&self) -> Result<(Self::Write, i64), StoreError>;

    /// Returns once everything that was committed before the call survives a loss of power.
    async fn sync(&self) -> Result<(), StoreError>;

    /// Checks that there is room for another job.
    ///
    /// # Errors
    /// [`StoreError::DiskFull`] below the reserve.
    async fn check_space(&self) -> Result<(), StoreError>;

    /// Looks for damage below the tables; one line for each damage.
    async fn check(&self) -> Result<Vec<String>, StoreError>;

    /// Writes a copy to a new file; `false` if the database has means of its own for that.
    async fn backup(&self, file: &Path) -> Result<bool, StoreError>;

    /// Closes all connections, so that a file holds all there is; nothing can be asked any more.
    async fn close(&self) {}

    /// Tells other processes of changes that are committed.
    fn announce(&self, changes: &[Change]);
}

/// A transaction that is rolled back unless it is committed.
#[async_trait]
pub(in crate::store) trait WriteTransaction: DerefMut + Send {
    /// Makes the changes visible to others.
    async fn commit(self) -> Result<(), StoreError>;
}

/// Whether a change is acknowledged to somebody who relies on it after a loss of power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Durability {
    /// It is on the disk before anybody is told.
    Synced,
    /// It survives the end of the process, however sudden, but perhaps not a loss of power.
    Written,
}

/// Something others may be waiting for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Change {
    /// There is a job to claim.
    Work,
    /// A job has moved.
    Progress(JobId),
    /// A job is to stop.
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
