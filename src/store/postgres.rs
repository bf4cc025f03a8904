//! Jobs in PostgreSQL, shared by any number of processes on any number of machines.
//!
//! All times come from the clock of the database, so the machines' clocks do not matter. Processes
//! announce changes by `NOTIFY`; a task that waits also queries once a second.

mod notifications;

use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use sqlx::postgres::PgPoolOptions;
use sqlx::{Executor, PgPool, Postgres, Transaction};
use thiserror::Error;
use tokio::task::AbortHandle;

use self::notifications::{Announcer, listen};
use super::migration::{self, Step, steps};
use super::sql::{Backend, Change, SqlStore, WriteTransaction};
use super::{Store, StoreLimits};
use crate::jobs::{Clock, JobNotifier, StoreError, WorkerId};

const STEPS: &[Step] = steps!("postgres");

/// Connections of one process.
const CONNECTIONS: u32 = 10;

/// Longest wait for a connection.
const ACQUIRE_TIMEOUT: Duration = Duration::from_secs(10);

/// An error that keeps the store from opening.
#[derive(Debug, Error)]
pub enum PostgresError {
    /// The database cannot be reached.
    #[error("cannot connect to the database: {0}")]
    Connect(#[source] sqlx::Error),
    /// The migrations of its tables fail.
    #[error("cannot bring the database up to date: {0}")]
    Migrate(#[source] sqlx::Error),
}

/// A pool of connections to the database.
struct PostgresPool {
    pool: PgPool,
    clock: Option<Arc<dyn Clock>>,
    announcer: Announcer,
    listener: AbortHandle,
}

/// Connects to the store at a `postgres://` address and runs the migrations. A test may pass a
/// `clock` in place of the database's.
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
    let pool = pool.after_connect(|connection, _| {
        // A claim takes half a millisecond. On tables without statistics the planner overestimates
        // its cost and would compile it first (JIT), for fifty milliseconds each time.
        Box::pin(async move { connection.execute("SET jit = off").await.map(drop) })
    });
    let pool = pool.connect(url).await.map_err(PostgresError::Connect)?;
    migration::run(STEPS, &pool).await.map_err(PostgresError::Migrate)?;
    let node = WorkerId::generate();
    let listener = tokio::spawn(listen(pool.clone(), node, Arc::clone(&notifier))).abort_handle();
    let announcer = Announcer::start(&pool, node);
    let backend = PostgresPool { pool, clock, announcer, listener };
    Ok(Arc::new(SqlStore { backend, notifier, limits }))
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

    fn readers(&self) -> &PgPool {
        &self.pool
    }

    async fn write(&self) -> Result<(Self::Write, i64), StoreError> {
        let mut transaction = self.pool.begin().await?;
        if let Some(clock) = &self.clock {
            return Ok((transaction, clock.now().as_microsecond()));
        }
        let now =
            sqlx::query_scalar("SELECT (extract(epoch FROM clock_timestamp()) * 1000000)::bigint");
        let now = now.fetch_one(&mut *transaction).await?;
        Ok((transaction, now))
    }

    async fn sync(&self) -> Result<(), StoreError> {
        // The server syncs every commit.
        Ok(())
    }

    async fn check_space(&self) -> Result<(), StoreError> {
        // A client cannot see the server's disk; a write to a full disk fails with its own error.
        Ok(())
    }

    async fn check(&self) -> Result<Vec<String>, StoreError> {
        // The administrator of the server checks the server's files.
        Ok(Vec::new())
    }

    async fn backup(&self, _: &Path) -> Result<bool, StoreError> {
        Ok(false)
    }

    fn announce(&self, changes: &[Change]) {
        self.announcer.announce(changes);
    }
}
