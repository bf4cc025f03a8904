//! Statements about API keys.

use jiff::Timestamp;
use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{count, damaged, time};
use crate::jobs::{ApiKey, KeyId, KeyLimits, PreviousSecret, Scope, StoreError};
use brinell_solver::job::Named as _;

const ADD: &str = "INSERT INTO api_keys (id, name, scope, digest, created_at, expires_at,
         max_queued, max_running, max_stored, max_priority)
     VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9, $10)";
const REVOKE: &str = "UPDATE api_keys SET revoked_at = $2 WHERE id = $1 AND revoked_at IS NULL";
const ROTATE: &str =
    "UPDATE api_keys SET previous_digest = digest, previous_until = $3, digest = $2
     WHERE id = $1 AND revoked_at IS NULL";
const LIMIT: &str = "UPDATE api_keys SET expires_at = $2, max_queued = $3,
         max_running = $4, max_stored = $5, max_priority = $6
     WHERE id = $1 AND revoked_at IS NULL";

/// Selects the columns of [`KeyRow`] from the table of keys.
macro_rules! select_keys {
    ($rest:literal) => {
        concat!(
            "SELECT id, name, scope, digest, previous_digest, previous_until, max_queued, \
             max_running, max_stored, max_priority, created_at, expires_at, revoked_at FROM \
             api_keys ",
            $rest
        )
    };
}

/// Limits of a key: queued jobs, running jobs, bytes of results, priority.
type LimitsRow = (Option<i64>, Option<i64>, Option<i64>, Option<i32>);

/// A key as selected by [`select_keys`].
type KeyRow = (
    Uuid,
    String,
    String,
    Vec<u8>,
    Option<Vec<u8>>,
    Option<i64>,
    Option<i64>,
    Option<i64>,
    Option<i64>,
    Option<i32>,
    i64,
    Option<i64>,
    Option<i64>,
);

fn api_key(row: KeyRow) -> Result<ApiKey, StoreError> {
    let (id, name, scope, digest, previous, until, ..) = row;
    let (.., queued, running, bytes, priority, created, expires, revoked) = row;
    let digest_of =
        |bytes: Vec<u8>| bytes.try_into().map_err(|_| damaged("the length of a digest"));
    let previous = match (previous, until) {
        (Some(digest), Some(until)) => {
            Some(PreviousSecret { digest: digest_of(digest)?, until: time(until)? })
        }
        _ => None,
    };
    Ok(ApiKey {
        id: KeyId::from(id),
        name,
        scope: Scope::of_word(&scope).ok_or_else(|| damaged(format!("scope {scope:?}")))?,
        digest: digest_of(digest)?,
        previous,
        limits: key_limits((queued, running, bytes, priority))?,
        created_at: time(created)?,
        expires_at: expires.map(time).transpose()?,
        revoked_at: revoked.map(time).transpose()?,
    })
}

/// [`LimitsRow`], whether the key is revoked, and when it expires.
pub(super) type SubmitterRow =
    (Option<i64>, Option<i64>, Option<i64>, Option<i32>, bool, Option<i64>);

fn key_limits((queued, running, bytes, priority): LimitsRow) -> Result<KeyLimits, StoreError> {
    Ok(KeyLimits {
        queued: queued.map(count).transpose()?,
        running: running.map(count).transpose()?,
        stored_bytes: bytes.map(count).transpose()?,
        priority: priority.map(count).transpose()?,
    })
}

/// Returns the limits of a key that has not ended.
pub(super) fn limits_of(row: SubmitterRow, now: i64) -> Result<KeyLimits, StoreError> {
    let (queued, running, bytes, priority, is_revoked, expires_at) = row;
    if is_revoked || expires_at.is_some_and(|end| end <= now) {
        return Err(StoreError::KeyEnded);
    }
    key_limits((queued, running, bytes, priority))
}

fn limits_row(limits: KeyLimits) -> LimitsRow {
    let bytes = limits.stored_bytes.map(|bytes| i64::try_from(bytes).unwrap_or(i64::MAX));
    (
        limits.queued.map(i64::from),
        limits.running.map(i64::from),
        bytes,
        limits.priority.map(i32::from),
    )
}

/// Statements about keys on a connection.
pub(in crate::store) trait Keys: Send {
    fn add_key(&mut self, key: ApiKey) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn keys(
        &mut self,
        id: Option<KeyId>,
    ) -> impl Future<Output = Result<Vec<ApiKey>, StoreError>> + Send;
    fn rotate_key(
        &mut self,
        id: KeyId,
        digest: [u8; 32],
        previous_until: i64,
    ) -> impl Future<Output = Result<bool, StoreError>> + Send;
    fn limit_key(
        &mut self,
        id: KeyId,
        limits: KeyLimits,
        expires_at: Option<Timestamp>,
    ) -> impl Future<Output = Result<bool, StoreError>> + Send;
    fn revoke_key(
        &mut self,
        id: KeyId,
        now: i64,
    ) -> impl Future<Output = Result<bool, StoreError>> + Send;
}

macro_rules! keys {
    ($database:ty, $connection:ty) => {
        impl Keys for $connection {
            async fn add_key(&mut self, key: ApiKey) -> Result<(), StoreError> {
                let (queued, running, bytes, priority) = limits_row(key.limits);
                sqlx::query::<$database>(ADD)
                    .bind(key.id.uuid())
                    .bind(key.name)
                    .bind(key.scope.name())
                    .bind(key.digest.to_vec())
                    .bind(key.created_at.as_microsecond())
                    .bind(key.expires_at.map(Timestamp::as_microsecond))
                    .bind(queued)
                    .bind(running)
                    .bind(bytes)
                    .bind(priority)
                    .execute(self)
                    .await?;
                Ok(())
            }

            async fn keys(&mut self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError> {
                let rows = match id {
                    Some(id) => sqlx::query_as::<$database, KeyRow>(select_keys!("WHERE id = $1"))
                        .bind(id.uuid()),
                    None => sqlx::query_as::<$database, KeyRow>(select_keys!("ORDER BY id")),
                };
                rows.fetch_all(self).await?.into_iter().map(api_key).collect()
            }

            async fn rotate_key(
                &mut self,
                id: KeyId,
                digest: [u8; 32],
                previous_until: i64,
            ) -> Result<bool, StoreError> {
                let rotate =
                    sqlx::query::<$database>(ROTATE).bind(id.uuid()).bind(digest.to_vec());
                Ok(rotate.bind(previous_until).execute(self).await?.rows_affected() == 1)
            }

            async fn limit_key(
                &mut self,
                id: KeyId,
                limits: KeyLimits,
                expires_at: Option<Timestamp>,
            ) -> Result<bool, StoreError> {
                let (queued, running, bytes, priority) = limits_row(limits);
                let limit = sqlx::query::<$database>(LIMIT)
                    .bind(id.uuid())
                    .bind(expires_at.map(Timestamp::as_microsecond))
                    .bind(queued)
                    .bind(running)
                    .bind(bytes)
                    .bind(priority);
                Ok(limit.execute(self).await?.rows_affected() == 1)
            }

            async fn revoke_key(&mut self, id: KeyId, now: i64) -> Result<bool, StoreError> {
                let revoke = sqlx::query::<$database>(REVOKE).bind(id.uuid()).bind(now);
                Ok(revoke.execute(self).await?.rows_affected() == 1)
            }
        }
    };
}

keys!(Sqlite, SqliteConnection);
keys!(Postgres, PgConnection);
