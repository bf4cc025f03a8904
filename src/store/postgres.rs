//! Jobs in PostgreSQL, shared by any number of processes on any number of machines.
//!
//! All times come from the clock of the database, so the machines' clocks do not matter. Processes
//! announce changes by `NOTIFY`; a task that waits also queries once a second.

mod notifications;

use std::ops::{Deref, DerefMut};
use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use async_trait::async_trait;
use sqlx::pool::PoolConnection;
use sqlx::postgres::{PgConnectOptions, PgPoolOptions};
use sqlx::{ConnectOptions, Connection, Executor, PgConnection, PgPool, Postgres, Transaction};
use thiserror::Error;
use tokio::task::AbortHandle;
use tokio::time::timeout;

use self::notifications::{Announcer, listen};
use super::deadline::Timely;
use super::migration::{self, Step, steps};
use super::sql::{Backend, Change, Reserved, SqlStore, WriteTransaction};
use super::{Store, StoreLimits};
use crate::jobs::{Clock, JobNotifier, StoreError, WorkerId};

const STEPS: &[Step] = steps!("postgres");

/// Longest wait for a connection: of a client that reads, for a transaction, and of a worker that
/// writes, for whom no client waits.
const LINE_WAIT: Duration = Duration::from_secs(2);
const TRANSACTION_WAIT: Duration = Duration::from_secs(5);
const WORKER_WAIT: Duration = Duration::from_secs(30);

/// Longest time for a reserved connection to be made; a server that answers after 5 s takes four
/// answers.
const CONNECT_WAIT: Duration = Duration::from_secs(25);

/// Longest time that a connection may be in use for one purpose. One that is given back later is
/// closed: its line may be dead.
const LINE_TIME: Duration = Duration::from_secs(10);

/// Time without use after which a connection is asked for a sign of life before its next use, and
/// the longest wait for that.
const IDLE: Duration = Duration::from_secs(1);

/// Longest wait for the sign of life of a connection that is given back, for which nobody waits.
const RELEASE_WAIT: Duration = Duration::from_secs(10);

/// Settings of every session. The server ends what a client that has vanished, or stopped, has
/// left behind: a transaction that nothing is done in, a statement whose answer nobody takes.
///
/// A claim takes half a millisecond. On tables without statistics the planner overestimates its
/// cost and would compile it first (JIT), for fifty milliseconds each time.
const SESSION: &str = "
    SET jit = off;
    SET lock_timeout = '2s';
    SET statement_timeout = '10s';
    SET idle_in_transaction_session_timeout = '5s';
    SET tcp_keepalives_idle = 10;
    SET tcp_keepalives_interval = 5;
    SET tcp_keepalives_count = 3;
    SET tcp_user_timeout = '15s';";

/// Claims and heartbeats do not wait for the disk: if a crash of the server takes one back, the
/// worker makes it again. It writes progress and steps once, which therefore outlive a crash.
const OF_RESERVED: &str = "SET synchronous_commit = off";

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

/// Connections to the database. Transactions may wait for the lock of a row, which no reader does.
/// Heartbeats, claims and the listener have one each, which nothing else can take.
struct PostgresPool {
    address: PgConnectOptions,
    lines: PgPool,
    transactions: PgPool,
    heartbeats: Kept,
    claims: Kept,
    clock: Option<Arc<dyn Clock>>,
    announcer: Announcer,
    listener: AbortHandle,
}

/// A reserved connection while nobody uses it.
type Kept = Mutex<Option<PgConnection>>;

/// Options of a pool whose connections are never waited for without bound.
fn pool(connections: u32, wait: Duration) -> PgPoolOptions {
    let options = PgPoolOptions::new().max_connections(connections).acquire_timeout(wait);
    let options = options.test_before_acquire(false).after_connect(|connection, _| {
        Box::pin(async move { connection.execute(SESSION).await.map(drop) })
    });
    let options = options.before_acquire(|connection, used| {
        Box::pin(
            async move { Ok(used.idle_for < IDLE || answers(connection, IDLE).await.is_ok()) },
        )
    });
    options.after_release(|connection, _| {
        Box::pin(async move { answers(connection, RELEASE_WAIT).await.map(|()| true) })
    })
}

/// Pings the server, which also rolls an abandoned transaction back.
async fn answers(connection: &mut PgConnection, wait: Duration) -> Result<(), sqlx::Error> {
    let pinged = timeout(wait, connection.ping()).await;
    pinged.unwrap_or_else(|late| Err(sqlx::Error::Io(late.into())))
}

/// Says why there is no connection of a pool.
fn none_free(pool: &PgPool, wait: Duration, error: sqlx::Error) -> StoreError {
    let (used, most) = (
        (pool.size() as usize).saturating_sub(pool.num_idle()),
        pool.options().get_max_connections(),
    );
    match error {
        sqlx::Error::PoolTimedOut => StoreError::unavailable(format!(
            "no connection to the database within {wait:?}: {used} of {most} are in use or being \
             made; either --database-connections is too small or the database does not answer"
        )),
        error => error.into(),
    }
}

/// Takes a connection of a pool.
async fn acquire(pool: &PgPool, wait: Duration) -> Result<Line, StoreError> {
    let acquired = timeout(wait, pool.acquire()).await;
    let acquired = acquired.unwrap_or(Err(sqlx::Error::PoolTimedOut));
    let connection = acquired.map_err(|error| none_free(pool, wait, error))?;
    Ok(Line::Shared(Shared { connection, until: Instant::now() + LINE_TIME }))
}

/// Connects to the store at a `postgres://` address and runs the migrations. Clients and the writes
/// of a worker share so many `connections`; the listener, and a worker's heartbeats and claims, have
/// one each beside them. A test may pass a `clock` in place of the database's.
///
/// # Errors
/// [`PostgresError`].
pub async fn open_postgres(
    url: &str,
    connections: u32,
    limits: StoreLimits,
    notifier: Arc<JobNotifier>,
    clock: Option<Arc<dyn Clock>>,
) -> Result<Arc<dyn Store>, PostgresError> {
    let address: PgConnectOptions = url.parse().map_err(PostgresError::Connect)?;
    // The text of a message has what clients have sent, which no log may have.
    let address = address.disable_statement_logging();
    let address = match address.get_application_name() {
        Some(_) => address,
        None => address.application_name(concat!("brinell ", env!("CARGO_PKG_VERSION"))),
    };
    // A migration takes as long as it takes.
    let first = PgPoolOptions::new().max_connections(1).connect_with(address.clone()).await;
    let first = first.map_err(PostgresError::Connect)?;
    migration::run(STEPS, &first).await.map_err(PostgresError::Migrate)?;
    first.close().await;
    let of_transactions = (connections / 2).max(1);
    let transactions = pool(of_transactions, TRANSACTION_WAIT);
    let lines = pool((connections - of_transactions).max(1), WORKER_WAIT);
    let own = PgPoolOptions::new().max_connections(1).acquire_timeout(CONNECT_WAIT);
    let lines = lines.connect_lazy_with(address.clone());
    let node = WorkerId::generate();
    let own = own.connect_lazy_with(address.clone());
    let listener = tokio::spawn(listen(own, node, Arc::clone(&notifier))).abort_handle();
    let announcer = Announcer::start(&lines, node);
    let backend = PostgresPool {
        lines,
        transactions: transactions.connect_lazy_with(address.clone()),
        address,
        heartbeats: Kept::default(),
        claims: Kept::default(),
        clock,
        announcer,
        listener,
    };
    Ok(Arc::new(Timely(SqlStore { backend, notifier, limits })))
}

impl PostgresPool {
    fn kept(&self, purpose: Reserved) -> MutexGuard<'_, Option<PgConnection>> {
        let kept = match purpose {
            Reserved::Heartbeats => &self.heartbeats,
            Reserved::Claims => &self.claims,
        };
        kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    async fn connect(&self) -> Result<PgConnection, StoreError> {
        let connect = async {
            let mut connection = PgConnection::connect_with(&self.address).await?;
            connection.execute(SESSION).await?;
            connection.execute(OF_RESERVED).await?;
            Ok::<_, sqlx::Error>(connection)
        };
        Ok(timeout(CONNECT_WAIT, connect).await.map_err(StoreError::silent)??)
    }
}

/// A connection without a transaction.
enum Line {
    Shared(Shared),
    Reserved(Reserved, PgConnection),
}

/// A connection of a pool.
struct Shared {
    connection: PoolConnection<Postgres>,
    until: Instant,
}

impl Deref for Line {
    type Target = PgConnection;

    fn deref(&self) -> &PgConnection {
        match self {
            Self::Shared(shared) => &shared.connection,
            Self::Reserved(_, connection) => connection,
        }
    }
}

impl DerefMut for Line {
    fn deref_mut(&mut self) -> &mut PgConnection {
        match self {
            Self::Shared(shared) => &mut shared.connection,
            Self::Reserved(_, connection) => connection,
        }
    }
}

impl Drop for Shared {
    fn drop(&mut self) {
        if Instant::now() >= self.until {
            self.connection.close_on_drop();
        }
    }
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
    type Connection = PgConnection;
    type Line = Line;
    type Write = Transaction<'static, Postgres>;

    async fn read(&self) -> Result<Line, StoreError> {
        acquire(&self.lines, LINE_WAIT).await
    }

    async fn statements(&self) -> Result<Line, StoreError> {
        acquire(&self.lines, WORKER_WAIT).await
    }

    async fn reserved(&self, purpose: Reserved) -> Result<Line, StoreError> {
        let kept = self.kept(purpose).take();
        let connection = match kept {
            Some(connection) => connection,
            None => self.connect().await?,
        };
        Ok(Line::Reserved(purpose, connection))
    }

    fn keep(&self, line: Line) {
        if let Line::Reserved(purpose, connection) = line {
            *self.kept(purpose) = Some(connection);
        }
    }

    fn now(&self) -> Option<i64> {
        self.clock.as_ref().map(|clock| clock.now().as_microsecond())
    }

    async fn write(&self) -> Result<(Self::Write, i64), StoreError> {
        let begun = self.transactions.begin().await;
        let mut transaction =
            begun.map_err(|error| none_free(&self.transactions, TRANSACTION_WAIT, error))?;
        if let Some(now) = self.now() {
            return Ok((transaction, now));
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
