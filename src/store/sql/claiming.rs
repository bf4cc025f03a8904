//! Statements that claim queued jobs for a worker. Each claim of a job is one statement; claims
//! exclude each other, so that each sees the places that the others have taken.

use bytes::Bytes;
use sqlx::postgres::PgRow;
use sqlx::sqlite::SqliteRow;
use sqlx::types::Uuid;
use sqlx::{AssertSqlSafe, FromRow, PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{damaged, failure_json, unpack};
use crate::jobs::{ClaimRequest, JobFailure, JobId, StoreError};
use crate::store::StoreLimits;

/// Selects the next job: the first queued job of the key that holds the fewest places; among equal
/// keys, of the key that has spent the least solver time. A key may hold at most `$3` places of
/// one worker and `$4` places of all workers.
///
/// SQLite keeps the order of a cross join: it goes through the keys, which are few, and looks the
/// first job of each up in the index.
pub(in crate::store) const NEXT: &str = "
    SELECT j.id
    FROM accounts a CROSS JOIN jobs j
    WHERE j.id = (
            SELECT q.id FROM jobs q
            WHERE q.account = a.id AND q.state = 'queued' AND q.memory <= $1 AND q.losses < $6
            ORDER BY q.losses DESC, q.priority DESC, q.id LIMIT 1)
        AND (SELECT count(*) FROM jobs r
            WHERE r.state = 'running' AND r.account = a.id AND r.owner = $2) < $3
        AND (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id)
            < coalesce((SELECT k.max_running FROM api_keys k WHERE k.id = a.id), $4)
    ORDER BY
        (SELECT count(*) FROM jobs r WHERE r.state = 'running' AND r.account = a.id),
        CASE WHEN $5 - a.settled_at < 60000000
            THEN a.spent * (60000000 - ($5 - a.settled_at)) / 60000000 ELSE 0 END,
        j.id
    LIMIT 1";

/// Selects the job that fails if its worker is lost once more.
const LAST_CHANCE: &str = "SELECT id FROM jobs
    WHERE state = 'queued' AND losses > 0 AND losses >= $6 AND memory <= $1 ORDER BY id LIMIT 1";

/// Leases the job that a query selects, if its memory is free: `$8` bytes are those of a place,
/// `$9` those that are left for large jobs.
fn lease_of(selected: &str) -> String {
    format!(
        "UPDATE jobs SET state = 'running', owner = $2, leased_until = $5 + $7, started_at = $5,
            attempts = attempts + 1, iterations = 0, latest = NULL, steps = 0, stored_bytes = 0
        WHERE id = ({selected}) AND state = 'queued' AND (memory <= $8 OR memory <= $9)
        RETURNING id, memory, attempts, traceparent"
    )
}

/// Charges the solver time of an attempt to its key. Time charged before decays to zero within a
/// minute.
pub(super) const SETTLE: &str = "UPDATE accounts SET settled_at = $2,
        spent = $2 - (SELECT started_at FROM jobs WHERE id = $1)
            + CASE WHEN $2 - settled_at < 60000000
                THEN spent * (60000000 - ($2 - settled_at)) / 60000000 ELSE 0 END
    WHERE id = (SELECT account FROM jobs WHERE id = $1)";

/// Queues the jobs again whose lease expired. Those that have lost their last worker fail, those
/// that a client asked to stop are cancelled.
macro_rules! expire {
    ($lock:literal) => {
        concat!(
            "UPDATE jobs SET losses = losses + 1, owner = NULL, leased_until = NULL,
                steps = 0, stored_bytes = 0,
                state = CASE WHEN cancel_requested THEN 'cancelled'
                    WHEN losses + 1 >= $2 THEN 'failed' ELSE 'queued' END,
                failure = CASE WHEN losses + 1 >= $2 AND NOT cancel_requested THEN $3 END,
                finished_at = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN $1 END,
                started_at = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN started_at END,
                iterations = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN iterations
                    ELSE 0 END,
                latest = CASE WHEN cancel_requested OR losses + 1 >= $2 THEN latest END
            WHERE id IN (SELECT id FROM jobs WHERE state = 'running' AND leased_until <= $1",
            $lock,
            ") RETURNING id, state <> 'queued'"
        )
    };
}

/// Whether a lease has expired, and whether a queued job has lost a worker before.
macro_rules! look {
    ($now:literal) => {
        concat!(
            "SELECT EXISTS (SELECT 1 FROM jobs WHERE state = 'running' AND leased_until <= ",
            $now,
            "), EXISTS (SELECT 1 FROM jobs WHERE state = 'queued' AND losses > 0)"
        )
    };
}

const TEXT: &str = "SELECT body FROM requests WHERE job = $1";

/// Removes the iterations, steps and fields of an earlier attempt.
pub(super) const FORGET: [&str; 3] = [
    "DELETE FROM iterations WHERE job = $1",
    "DELETE FROM result_steps WHERE job = $1",
    "DELETE FROM field_parts WHERE job = $1",
];

/// Which job to lease.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Which {
    /// The next one.
    Next,
    /// The one that fails if its worker is lost once more.
    LastChance,
}

/// A leased job: id, estimated memory \[bytes\], number of the attempt, trace.
pub(in crate::store) type LeasedRow = (Uuid, i64, i32, Option<String>);

/// The values of the parameters `$1` to `$9` of a claim, but the time.
#[derive(Debug, Clone, Copy)]
pub(in crate::store) struct Terms {
    /// Memory \[bytes\] that the job may need at most.
    pub(super) largest: u64,
    /// Memory \[bytes\] left for jobs that need more than a place has.
    pub(super) shared: u64,
    request: ClaimRequest,
    running: Option<u32>,
}

impl Terms {
    /// The terms of a claim whose memory is not used up.
    pub(super) fn new(request: &ClaimRequest, limits: StoreLimits) -> Self {
        Self {
            largest: request.memory.max(request.memory_of_place),
            shared: request.free_memory,
            request: *request,
            running: limits.by_key.running,
        }
    }

    /// The values `$3` and `$4`.
    fn places(&self) -> [i64; 2] {
        [bound(self.request.places_of_key), self.running.map_or(i64::MAX, i64::from)]
    }

    /// The values `$6` to `$9`.
    fn rest(&self) -> [i64; 4] {
        let request = &self.request;
        [
            bound(request.max_attempts.saturating_sub(1).max(1)),
            bound(request.lease.as_micros()),
            bound(request.memory_of_place),
            bound(self.shared),
        ]
    }
}

/// Claims on a connection. `now` is `None` where the clock of the database counts.
pub(in crate::store) trait Claiming: Send {
    /// Returns whether a lease has expired, and whether a queued job has lost a worker before.
    fn look(
        &mut self,
        now: Option<i64>,
    ) -> impl Future<Output = Result<(bool, bool), StoreError>> + Send;
    /// Queues the jobs again whose lease expired. Ends, and returns, the jobs that have lost their
    /// last worker or were cancelled.
    fn expire(
        &mut self,
        max_attempts: u32,
        now: i64,
    ) -> impl Future<Output = Result<Vec<JobId>, StoreError>> + Send;
    /// Whether there is a job that [`Claiming::lease`] would lease if its memory were free.
    fn is_pending(
        &mut self,
        which: Which,
        terms: &Terms,
        now: Option<i64>,
    ) -> impl Future<Output = Result<bool, StoreError>> + Send;
    /// Leases a job.
    fn lease(
        &mut self,
        which: Which,
        terms: &Terms,
        now: Option<i64>,
    ) -> impl Future<Output = Result<Option<LeasedRow>, StoreError>> + Send;
    /// Returns the text of a leased job, and removes what an earlier attempt has left.
    fn begin(
        &mut self,
        leased: &LeasedRow,
    ) -> impl Future<Output = Result<Bytes, StoreError>> + Send;
}

/// Returns the text of a job, empty where the row is damaged: the reader then fails this job, and
/// the jobs behind it go on.
fn readable_text(id: JobId, packed: Option<Vec<u8>>) -> Bytes {
    let text = packed.map_or_else(|| Err(damaged("no text")), unpack);
    text.unwrap_or_else(|error| {
        let error = &error as &dyn std::error::Error;
        tracing::error!(job = %id, error, "the text of a job is damaged");
        Bytes::new()
    })
}

/// Returns when a lease that begins now expires.
pub(super) fn until(now: i64, lease: std::time::Duration) -> i64 {
    now.saturating_add(i64::try_from(lease.as_micros()).unwrap_or(i64::MAX))
}

/// Converts a number to the database's integer, its largest one where the number is beyond it.
fn bound(number: impl TryInto<i64>) -> i64 {
    number.try_into().unwrap_or(i64::MAX)
}

impl Which {
    const fn query(self) -> &'static str {
        match self {
            Self::Next => NEXT,
            Self::LastChance => LAST_CHANCE,
        }
    }
}

// Both databases run the same statements, with different types of sqlx.
macro_rules! claiming {
    ($database:ty, $connection:ty, $now:literal, $lock:literal, $rows:ident) => {
        impl Claiming for $connection {
            async fn look(&mut self, now: Option<i64>) -> Result<(bool, bool), StoreError> {
                let look = sqlx::query_as::<$database, (bool, bool)>(look!($now));
                Ok(look.bind(now).fetch_one(self).await?)
            }

            async fn expire(
                &mut self,
                max_attempts: u32,
                now: i64,
            ) -> Result<Vec<JobId>, StoreError> {
                let expire = sqlx::query_as::<$database, (Uuid, bool)>(expire!($lock));
                let expire = expire.bind(now).bind(bound(max_attempts));
                let expire = expire.bind(failure_json(&JobFailure::lost(max_attempts))?);
                let expired = expire.fetch_all(self).await?.into_iter();
                Ok(expired.filter_map(|(id, ended)| ended.then_some(JobId::from(id))).collect())
            }

            async fn is_pending(
                &mut self,
                which: Which,
                terms: &Terms,
                now: Option<i64>,
            ) -> Result<bool, StoreError> {
                let rows = $rows(self, which.query(), terms, now).await?;
                Ok(!rows.is_empty())
            }

            async fn lease(
                &mut self,
                which: Which,
                terms: &Terms,
                now: Option<i64>,
            ) -> Result<Option<LeasedRow>, StoreError> {
                let rows = $rows(self, &lease_of(which.query()), terms, now).await?;
                Ok(rows.first().map(LeasedRow::from_row).transpose()?)
            }

            async fn begin(&mut self, leased: &LeasedRow) -> Result<Bytes, StoreError> {
                let (id, _, attempt, _) = leased;
                if *attempt > 1 {
                    for forget in FORGET {
                        sqlx::query::<$database>(forget).bind(id).execute(&mut *self).await?;
                    }
                }
                let text = sqlx::query_scalar::<$database, Vec<u8>>(TEXT).bind(id);
                Ok(readable_text(JobId::from(*id), text.fetch_optional(self).await?))
            }
        }
    };
}

/// Runs a query of a claim.
async fn sqlite_rows(
    connection: &mut SqliteConnection,
    query: &str,
    terms: &Terms,
    now: Option<i64>,
) -> Result<Vec<SqliteRow>, StoreError> {
    let mut query = sqlx::query(AssertSqlSafe(query.to_owned())).bind(bound(terms.largest));
    query = query.bind(terms.request.owner.uuid());
    for number in terms.places().into_iter().chain(now).chain(terms.rest()) {
        query = query.bind(number);
    }
    Ok(query.fetch_all(connection).await?)
}

/// Runs a query of a claim in one message, of which the lock is the first statement and the query
/// the second, which sees all earlier claims. The server ends the transaction by itself: a worker
/// that stops meanwhile does not keep the lock. Such a message has no parameters; the values are
/// numbers and an id of this program's own.
async fn postgres_rows(
    connection: &mut PgConnection,
    query: &str,
    terms: &Terms,
    now: Option<i64>,
) -> Result<Vec<PgRow>, StoreError> {
    // No other lock has this number.
    let mut message = format!("SELECT pg_advisory_xact_lock(4242002); {query}");
    let now = now.map_or_else(
        || "(extract(epoch FROM statement_timestamp()) * 1000000)::bigint".to_owned(),
        |now| format!("{now}::bigint"),
    );
    let number = |number: i64| format!("{number}::bigint");
    let owner = format!("'{}'::uuid", terms.request.owner.uuid());
    let values = [number(bound(terms.largest)), owner].into_iter();
    let values = values.chain(terms.places().map(number)).chain([now]);
    for (value, at) in values.chain(terms.rest().map(number)).zip(1..) {
        message = message.replace(&format!("${at}"), &value);
    }
    let rows = sqlx::raw_sql(AssertSqlSafe(message)).fetch_all(connection).await?;
    // The first row is that of the lock.
    Ok(rows.into_iter().skip(1).collect())
}

claiming!(Sqlite, SqliteConnection, "$1", "", sqlite_rows);
// SKIP LOCKED passes over a job that its worker is writing to.
claiming!(
    Postgres,
    PgConnection,
    "coalesce($1, (extract(epoch FROM clock_timestamp()) * 1000000)::bigint)",
    " FOR UPDATE SKIP LOCKED",
    postgres_rows
);
