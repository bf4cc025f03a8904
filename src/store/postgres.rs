//! Jobs in PostgreSQL, shared by any number of processes on any number of machines.
//!
//! The database's clock stamps all times, so the machines' own clocks do not matter. Changes are told by
//! `NOTIFY` inside the transaction that makes them; each process listens on one connection. When that breaks, it is
//! made anew and everybody looks again; and whoever waits also looks once a second by himself.

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use sqlx::pool::PoolConnection;
use sqlx::postgres::{PgListener, PgPoolOptions};
use sqlx::{PgConnection, PgPool, Postgres, Transaction};
use thiserror::Error;
use tokio::task::AbortHandle;
use tokio::time::sleep;

use super::migration::{self, Step};
use super::sql::{Backend, Change, SqlStore, WriteTransaction};
use super::{Store, StoreLimits};
use crate::jobs::{Clock, JobId, JobNotifier, StoreError, Turns, WorkerId};

const STEPS: &[Step] = &[
    Step { version: 1, name: "jobs", sql: include_str!("../../migrations/postgres/0001_jobs.sql") },
    Step { version: 2, name: "requests", sql: include_str!("../../migrations/postgres/0002_requests.sql") },
    Step { version: 3, name: "results", sql: include_str!("../../migrations/postgres/0003_results.sql") },
    Step {
        version: 4,
        name: "fair share",
        sql: include_str!("../../migrations/postgres/0004_fair_share.sql"),
    },
    Step { version: 5, name: "quotas", sql: include_str!("../../migrations/postgres/0005_quotas.sql") },
    Step { version: 6, name: "callbacks", sql: include_str!("../../migrations/postgres/0006_callbacks.sql") },
    Step {
        version: 7,
        name: "field parts",
        sql: include_str!("../../migrations/postgres/0007_field_parts.sql"),
    },
];

/// Connections of one process.
const CONNECTIONS: u32 = 10;

/// Longest wait for one of them.
const ACQUIRE_TIMEOUT: Duration = Duration::from_secs(10);

/// Channel of the notifications.
const CHANNEL: &str = "brinell";

/// Time between two tries to listen.
const RECONNECT_INTERVAL: Duration = Duration::from_secs(1);

/// Why there is no store.
#[derive(Debug, Error)]
pub enum PostgresError {
    /// The database cannot be reached.
    #[error("cannot connect to the database: {0}")]
    Connect(#[source] sqlx::Error),
    /// Its tables cannot be brought up to date.
    #[error("cannot bring the database up to date: {0}")]
    Migrate(#[source] sqlx::Error),
}

/// The database, connected.
struct PostgresPool {
    pool: PgPool,
    node: WorkerId,
    clock: Option<Arc<dyn Clock>>,
    listener: AbortHandle,
}

/// Connects to the store at a `postgres://` address and makes its tables if need be. A `clock` takes the place of
/// the database's own, for tests.
///
/// # Errors
/// [`PostgresError`].
pub async fn open_postgres(
    url: &str,
    limits: StoreLimits,
    notifier: Arc<JobNotifier>,
    clock: Option<Arc<dyn Clock>>,
) -> Result<Arc<dyn Store>, PostgresError> {
    let pool = PgPoolOptions::new().max_connections(CONNECTIONS).acquire_timeout(ACQUIRE_TIMEOUT);
    let pool = pool.connect(url).await.map_err(PostgresError::Connect)?;
    migration::run(STEPS, &pool).await.map_err(PostgresError::Migrate)?;
    let node = WorkerId::generate();
    let listener = tokio::spawn(listen(pool.clone(), node, Arc::clone(&notifier))).abort_handle();
    let backend = PostgresPool { pool, node, clock, listener };
    Ok(Arc::new(SqlStore { backend, notifier, limits, submissions: Turns::new(1) }))
}

#[async_trait]
impl WriteTransaction for Transaction<'static, Postgres> {
    async fn commit(self) -> Result<(), StoreError> {
        Ok(Transaction::commit(self).await?)
    }
}

impl Drop for PostgresPool {
    fn drop(&mut self) {
        self.listener.abort();
    }
}

#[async_trait]
impl Backend for PostgresPool {
    type Database = Postgres;
    type Write = Transaction<'static, Postgres>;

    async fn read(&self) -> Result<PoolConnection<Postgres>, StoreError> {
        Ok(self.pool.acquire().await?)
    }

    async fn write(&self) -> Result<(Self::Write, i64), StoreError> {
        let mut transaction = self.pool.begin().await?;
        if let Some(clock) = &self.clock {
            return Ok((transaction, clock.now().as_microsecond()));
        }
        let now = sqlx::query_scalar("SELECT (extract(epoch FROM clock_timestamp()) * 1000000)::bigint");
        let now = now.fetch_one(&mut *transaction).await?;
        Ok((transaction, now))
    }

    async fn sync(&self) -> Result<(), StoreError> {
        // The server syncs every commit.
        Ok(())
    }

    async fn check_space(&self) -> Result<(), StoreError> {
        // The server's disk is out of sight; a write that does not fit fails as such.
        Ok(())
    }

    async fn check(&self) -> Result<Vec<String>, StoreError> {
        // The server's own files are its administrator's matter.
        Ok(Vec::new())
    }

    async fn backup(&self, _: &Path) -> Result<bool, StoreError> {
        Ok(false)
    }

    async fn notify(&self, connection: &mut PgConnection, changes: &[Change]) -> Result<(), StoreError> {
        for change in changes {
            let notify = sqlx::query("SELECT pg_notify($1, $2)").bind(CHANNEL);
            notify.bind(message(self.node, *change)).execute(&mut *connection).await?;
        }
        Ok(())
    }
}

/// Payload of a notification: sender, kind of change, job.
fn message(node: WorkerId, change: Change) -> String {
    match change {
        Change::Work => format!("{node} work"),
        Change::Progress(id) => format!("{node} progress {id}"),
        Change::Cancel(id) => format!("{node} cancel {id}"),
        Change::Finished(id) => format!("{node} finished {id}"),
    }
}

/// What another process tells; nothing if it is our own voice, or a newer version's.
fn heard(message: &str, node: WorkerId) -> Option<Change> {
    let mut words = message.split(' ');
    if words.next()? == node.to_string() {
        return None;
    }
    let (what, id) = (words.next()?, words.next().and_then(|id| id.parse::<JobId>().ok()));
    match (what, id) {
        ("work", None) => Some(Change::Work),
        ("progress", Some(id)) => Some(Change::Progress(id)),
        ("cancel", Some(id)) => Some(Change::Cancel(id)),
        ("finished", Some(id)) => Some(Change::Finished(id)),
        _ => None,
    }
}

/// Forwards the notifications of other processes for as long as the store is open.
async fn listen(pool: PgPool, node: WorkerId, notifier: Arc<JobNotifier>) {
    loop {
        if let Err(error) = listen_once(&pool, node, &notifier).await {
            tracing::warn!(%error, "not listening to the database; looking once a second instead");
        }
        sleep(RECONNECT_INTERVAL).await;
    }
}

async fn listen_once(pool: &PgPool, node: WorkerId, notifier: &JobNotifier) -> Result<(), sqlx::Error> {
    let mut listener = PgListener::connect_with(pool).await?;
    listener.listen(CHANNEL).await?;
    loop {
        // Notifications sent before this connection listened are lost: every waiter queries the store again.
        notifier.announce_gap();
        while let Some(notification) = listener.try_recv().await? {
            if let Some(change) = heard(notification.payload(), node) {
                change.announce(notifier);
            }
        }
        tracing::warn!("the connection that listens to the database broke and is made anew");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn others_are_heard_and_one_self_is_not() {
        let (here, there, id) = (WorkerId::generate(), WorkerId::generate(), JobId::generate());
        for change in [Change::Work, Change::Progress(id), Change::Cancel(id), Change::Finished(id)] {
            assert_eq!(heard(&message(there, change), here), Some(change));
            assert_eq!(heard(&message(here, change), here), None);
        }
        for noise in ["", "x", "x y", "x cancel", "x cancel y"] {
            assert_eq!(heard(noise, here), None, "{noise:?}");
        }
    }
}
