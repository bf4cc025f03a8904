//! What tells one database from another.

use async_trait::async_trait;
use sqlx::pool::PoolConnection;
use sqlx::{Database, Transaction};

use super::claiming::Claiming;
use super::intake::Intake;
use super::keys::Keys;
use super::leasing::Leasing;
use super::reading::Reading;
use crate::jobs::{JobId, JobNotifier, StoreError};

/// Everything that is asked of a connection.
pub(in crate::store) trait Statements: Reading + Intake + Claiming + Leasing + Keys {}

impl<T: Reading + Intake + Claiming + Leasing + Keys> Statements for T {}

/// A database with jobs in it.
#[async_trait]
pub(in crate::store) trait Backend: Send + Sync + 'static {
    /// Which kind.
    type Database: Database<Connection: Statements>;

    /// A connection to read from.
    async fn read(&self) -> Result<PoolConnection<Self::Database>, StoreError>;

    /// A transaction that may write, and the time.
    async fn write(&self) -> Result<(Transaction<'static, Self::Database>, i64), StoreError>;

    /// Tells other processes of changes, once the transaction is committed.
    async fn notify(
        &self,
        connection: &mut <Self::Database as Database>::Connection,
        changes: &[Change],
    ) -> Result<(), StoreError>;
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
    /// Tells this process.
    pub(in crate::store) fn announce(self, notifier: &JobNotifier) {
        match self {
            Self::Work => notifier.announce_work(),
            Self::Progress(id) => notifier.announce_progress(id),
            Self::Cancel(id) => notifier.announce_cancel(id),
            Self::Finished(id) => notifier.announce_finished(id),
        }
    }
}
