//! Statements about API keys.

use sqlx::types::Uuid;
use sqlx::{PgConnection, Postgres, Sqlite, SqliteConnection};

use super::codec::{damaged, time};
use crate::jobs::{ApiKey, KeyId, Scope, StoreError};

const ADD: &str = "INSERT INTO api_keys (id, name, scope, digest, created_at) VALUES ($1, $2, $3, $4, $5)";
const ALL: &str = "SELECT id, name, scope, digest, created_at, revoked_at FROM api_keys ORDER BY id";
const ONE: &str = "SELECT id, name, scope, digest, created_at, revoked_at FROM api_keys WHERE id = $1";
const REVOKE: &str = "UPDATE api_keys SET revoked_at = $2 WHERE id = $1 AND revoked_at IS NULL";

type KeyRow = (Uuid, String, String, Vec<u8>, i64, Option<i64>);

fn api_key(row: KeyRow) -> Result<ApiKey, StoreError> {
    let (id, name, scope, digest, created, revoked) = row;
    Ok(ApiKey {
        id: KeyId::from(id),
        name,
        scope: Scope::by_name(&scope).ok_or_else(|| damaged(format!("scope {scope:?}")))?,
        digest: digest.try_into().map_err(|_| damaged("the length of a digest"))?,
        created_at: time(created)?,
        revoked_at: revoked.map(time).transpose()?,
    })
}

/// Keys to a connection.
pub(in crate::store) trait Keys: Send {
    fn add_key(&mut self, key: ApiKey) -> impl Future<Output = Result<(), StoreError>> + Send;
    fn keys(&mut self, id: Option<KeyId>) -> impl Future<Output = Result<Vec<ApiKey>, StoreError>> + Send;
    fn revoke_key(&mut self, id: KeyId, now: i64) -> impl Future<Output = Result<bool, StoreError>> + Send;
}

macro_rules! keys {
    ($database:ty, $connection:ty) => {
        impl Keys for $connection {
            async fn add_key(&mut self, key: ApiKey) -> Result<(), StoreError> {
                sqlx::query::<$database>(ADD)
                    .bind(key.id.uuid())
                    .bind(key.name)
                    .bind(key.scope.name())
                    .bind(key.digest.to_vec())
                    .bind(key.created_at.as_microsecond())
                    .execute(self)
                    .await?;
                Ok(())
            }

            async fn keys(&mut self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError> {
                let rows = match id {
                    Some(id) => sqlx::query_as::<$database, KeyRow>(ONE).bind(id.uuid()),
                    None => sqlx::query_as::<$database, KeyRow>(ALL),
                };
                rows.fetch_all(self).await?.into_iter().map(api_key).collect()
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
