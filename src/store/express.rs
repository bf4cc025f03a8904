//! Two lanes into one worker: jobs that must survive the process go into the database, those that somebody waits for
//! with an open connection stay in memory.
//!
//! Who waits on a connection learns of a crash by its breaking, and nothing has been promised to him yet. Writing such a
//! job down three times, each time waiting for the disk, would cost more than solving it. When the wait ends before the
//! job does, the job changes lanes ([`JobStore::keep`]), running or not, and is as durable as any other from then on.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;
use tokio::sync::RwLock;

use super::memory::{MemoryLimits, MemoryStore};
use super::sql::{Backend, SqlStore};
use crate::jobs::{
    ApiKey, ClaimRequest, Claims, Clock, Counts, Enqueued, IterationRecord, JobFilter, JobId, JobPage,
    JobRecord, JobStore, KeyId, KeyStore, Lease, LeaseStatus, NewJob, Outcome, Retention, StoreError,
};

/// Most answered jobs of the express lane that are kept, and the bytes they may take.
const ANSWERED: (usize, usize) = (1000, 64 << 20);

/// A [`JobStore`] with an express lane for ephemeral jobs.
pub(super) struct ExpressStore<B> {
    lane: MemoryStore,
    kept: SqlStore<B>,
    /// Held for writing while a job changes lanes, for reading by whatever changes a job.
    crossing: RwLock<()>,
}

impl<B: Backend> ExpressStore<B> {
    /// The express lane before a database, with a queue as long.
    pub(super) fn new(kept: SqlStore<B>, clock: Arc<dyn Clock>) -> Self {
        let limits = MemoryLimits {
            queued_jobs: kept.queue_capacity,
            finished_jobs: ANSWERED.0,
            finished_bytes: ANSWERED.1,
            ..MemoryLimits::default()
        };
        let lane = MemoryStore::new(limits, Arc::clone(&kept.notifier), clock);
        Self { lane, kept, crossing: RwLock::new(()) }
    }

    /// The lane that a job is in.
    fn lane_of(&self, id: JobId) -> &dyn JobStore {
        if self.lane.has(id) { &self.lane } else { &self.kept }
    }
}

#[async_trait]
impl<B: Backend> JobStore for ExpressStore<B> {
    async fn enqueue(&self, job: NewJob) -> Result<Enqueued, StoreError> {
        if job.ephemeral { self.lane.enqueue(job).await } else { self.kept.enqueue(job).await }
    }

    async fn keep(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let _crossing = self.crossing.write().await;
        if let Some(departure) = self.lane.departure(id) {
            self.kept.adopt(departure).await?;
            self.lane.depart(id);
        }
        self.lane_of(id).get(id).await
    }

    async fn get(&self, id: JobId) -> Result<JobRecord, StoreError> {
        self.lane_of(id).get(id).await
    }

    async fn history(&self, id: JobId, after: usize) -> Result<Vec<IterationRecord>, StoreError> {
        self.lane_of(id).history(id, after).await
    }

    async fn request(&self, id: JobId) -> Result<Bytes, StoreError> {
        self.lane_of(id).request(id).await
    }

    async fn report(&self, id: JobId) -> Result<Option<Bytes>, StoreError> {
        self.lane_of(id).report(id).await
    }

    async fn claim(&self, request: &ClaimRequest) -> Result<Claims, StoreError> {
        let _staying = self.crossing.read().await;
        let mut claims = self.lane.claim(request).await?;
        let taken: u64 = claims.jobs.iter().map(|claim| claim.memory).sum();
        let slots = request.slots.saturating_sub(claims.jobs.len());
        if slots > 0 && !claims.jobs.iter().any(|claim| claim.exclusive) {
            let rest = ClaimRequest {
                slots,
                exclusive: request.exclusive && claims.jobs.is_empty(),
                free_memory: request.free_memory.saturating_sub(taken),
                ..*request
            };
            let kept = self.kept.claim(&rest).await?;
            claims.jobs.extend(kept.jobs);
            claims.exclusive_pending |= kept.exclusive_pending;
        }
        Ok(claims)
    }

    async fn heartbeat(&self, leases: &[Lease], lease: Duration) -> Result<Vec<LeaseStatus>, StoreError> {
        let _staying = self.crossing.read().await;
        let (here, there): (Vec<Lease>, Vec<Lease>) = leases.iter().partition(|held| self.lane.has(held.job));
        let mut statuses: BTreeMap<JobId, LeaseStatus> = BTreeMap::new();
        for (store, held) in [(&self.lane as &dyn JobStore, here), (&self.kept, there)] {
            if !held.is_empty() {
                let found = store.heartbeat(&held, lease).await?;
                statuses.extend(held.iter().map(|held| held.job).zip(found));
            }
        }
        Ok(leases.iter().map(|held| statuses.get(&held.job).copied().unwrap_or(LeaseStatus::Lost)).collect())
    }

    async fn record_progress(&self, lease: &Lease, records: &[IterationRecord]) -> Result<(), StoreError> {
        let _staying = self.crossing.read().await;
        self.lane_of(lease.job).record_progress(lease, records).await
    }

    async fn finish(
        &self,
        lease: &Lease,
        records: &[IterationRecord],
        outcome: Outcome,
    ) -> Result<(), StoreError> {
        let _staying = self.crossing.read().await;
        self.lane_of(lease.job).finish(lease, records, outcome).await
    }

    async fn release(&self, leases: &[Lease]) -> Result<(), StoreError> {
        let _staying = self.crossing.read().await;
        let (here, there): (Vec<Lease>, Vec<Lease>) = leases.iter().partition(|held| self.lane.has(held.job));
        self.lane.release(&here).await?;
        self.kept.release(&there).await
    }

    async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let _staying = self.crossing.read().await;
        self.lane_of(id).cancel(id).await
    }

    async fn list(&self, filter: &JobFilter) -> Result<JobPage, StoreError> {
        let (here, there) = (self.lane.list(filter).await?, self.kept.list(filter).await?);
        let has_more = here.next.is_some() || there.next.is_some();
        let mut jobs = [here.jobs, there.jobs].concat();
        jobs.sort_by_key(|job| std::cmp::Reverse(job.id));
        jobs.dedup_by_key(|job| job.id);
        let is_last = !has_more && jobs.len() <= filter.limit;
        jobs.truncate(filter.limit);
        let next = if is_last { None } else { jobs.last().map(|job| job.id) };
        Ok(JobPage { jobs, next })
    }

    async fn delete(&self, id: JobId) -> Result<(), StoreError> {
        self.lane_of(id).delete(id).await
    }

    async fn counts(&self) -> Result<Counts, StoreError> {
        let mut counts = self.kept.counts().await?;
        for (state, jobs) in self.lane.counts().await? {
            *counts.entry(state).or_default() += jobs;
        }
        Ok(counts)
    }

    async fn sweep(&self, retention: &Retention) -> Result<usize, StoreError> {
        Ok(self.lane.sweep(retention).await? + self.kept.sweep(retention).await?)
    }

    async fn ping(&self) -> Result<(), StoreError> {
        self.kept.ping().await
    }
}

#[async_trait]
impl<B: Backend> KeyStore for ExpressStore<B> {
    async fn add_key(&self, key: ApiKey) -> Result<(), StoreError> {
        self.kept.add_key(key).await
    }

    async fn keys(&self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError> {
        self.kept.keys(id).await
    }

    async fn revoke_key(&self, id: KeyId) -> Result<bool, StoreError> {
        self.kept.revoke_key(id).await
    }
}
