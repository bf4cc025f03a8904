//! [`KeyStore`] in a database.

use std::time::Duration;

use async_trait::async_trait;
use jiff::Timestamp;

use super::backend::Durability::Synced;
use super::claiming::until;
use super::keys::Keys;
use super::{SqlBackend, SqlStore};
use crate::jobs::{ApiKey, KeyId, KeyLimits, KeyStore, StoreError};

#[async_trait]
impl<B: SqlBackend> KeyStore for SqlStore<B> {
    async fn add_key(&self, key: ApiKey) -> Result<(), StoreError> {
        let (mut transaction, _) = self.backend.write().await?;
        Keys::add_key(&mut *transaction, key).await?;
        self.commit(transaction, Synced, &[]).await
    }

    async fn keys(&self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError> {
        Keys::keys(&mut *self.backend.read().await?, id).await
    }

    async fn rotate_key(
        &self,
        id: KeyId,
        digest: [u8; 32],
        overlap: Duration,
    ) -> Result<bool, StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let rotated = Keys::rotate_key(&mut *transaction, id, digest, until(now, overlap)).await?;
        self.commit(transaction, Synced, &[]).await?;
        Ok(rotated)
    }

    async fn limit_key(
        &self,
        id: KeyId,
        limits: KeyLimits,
        expires_at: Option<Timestamp>,
    ) -> Result<bool, StoreError> {
        let (mut transaction, _) = self.backend.write().await?;
        let limited = Keys::limit_key(&mut *transaction, id, limits, expires_at).await?;
        self.commit(transaction, Synced, &[]).await?;
        Ok(limited)
    }

    async fn revoke_key(&self, id: KeyId) -> Result<bool, StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let revoked = Keys::revoke_key(&mut *transaction, id, now).await?;
        self.commit(transaction, Synced, &[]).await?;
        Ok(revoked)
    }
}
