//! [`DeliveryStore`] in a database.

use std::time::Duration;

use async_trait::async_trait;

use super::backend::Durability::{Synced, Written};
use super::deliveries::Deliveries;
use super::{SqlBackend, SqlStore};
use crate::jobs::{Callback, Delivery, DeliveryEnd, DeliveryStore, JobId, StoreError};

#[async_trait]
impl<B: SqlBackend> DeliveryStore for SqlStore<B> {
    async fn claim_deliveries(
        &self,
        limit: usize,
        lease: Duration,
    ) -> Result<Vec<Delivery>, StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        let claimed = Deliveries::claim_deliveries(&mut *transaction, limit, lease, now).await?;
        self.commit(transaction, Written, &[]).await?;
        Ok(claimed)
    }

    async fn end_deliveries(&self, ends: &[(Delivery, DeliveryEnd)]) -> Result<(), StoreError> {
        let (mut transaction, now) = self.backend.write().await?;
        for (delivery, end) in ends {
            Deliveries::end_delivery(&mut *transaction, delivery, end, now).await?;
        }
        // An announcement whose postponement is lost is due again when its lease expires.
        let was_postponed =
            ends.iter().all(|(_, end)| matches!(end, DeliveryEnd::Postponed { .. }));
        self.commit(transaction, if was_postponed { Written } else { Synced }, &[]).await
    }

    async fn callback(&self, job: JobId) -> Result<Option<Callback>, StoreError> {
        self.backend.read().await?.find_callback(job).await
    }
}
