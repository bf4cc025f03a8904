//! The keys of a database.

use async_trait::async_trait;

use super::SqlStore;
use super::backend::Backend;
use super::backend::Durability::Synced;
use super::keys::Keys;
use crate::jobs::{ApiKey, KeyId, KeyStore, StoreError};

#[async_trait]
impl<B: Backend> KeyStore for SqlStore<B> {
    async fn add_key(&self, key: ApiKey) -> Result<(), StoreError> {
        let (mut transaction, _) = self.backend.write().await?;
        Keys::add_key(&mut *transaction, key).await?;
        self.commit(transaction, Synced, &[]).await
    }

    async fn keys(&self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError> {
        Keys::keys(&mut *self.backend.read().await?, id).await
    }

    async fn revoke_key(&self, id: KeyId) -> Result<bool, StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let revoked = Keys::revoke_key(&mut *transaction, id, now).await?;
        self.commit(transaction, Synced, &[]).await?;
        Ok(revoked)
    }
}
