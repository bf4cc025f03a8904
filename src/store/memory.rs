//! Jobs in this process's memory: nothing to set up, nothing left after a restart, and never more than the
//! limits allow.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;

use super::shelf::{Departure, Shelf};
use crate::jobs::{
    ApiKey, ClaimRequest, Claims, Clock, Counts, Enqueued, IterationRecord, JobFilter, JobId, JobNotifier,
    JobPage, JobRecord, JobState, JobStore, KeyId, KeyStore, Lease, LeaseStatus, NewJob, Outcome, Retention,
    StoreError,
};

/// Bounds of a [`MemoryStore`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MemoryLimits {
    /// Most jobs that may wait.
    pub queued_jobs: usize,
    /// Most bytes that waiting jobs may take.
    pub queued_bytes: usize,
    /// Most finished jobs that are kept; the ones finished first go first.
    pub finished_jobs: usize,
    /// Most bytes that finished jobs may take. The one finished last is kept whatever its size.
    pub finished_bytes: usize,
}

impl Default for MemoryLimits {
    fn default() -> Self {
        Self { queued_jobs: 1000, queued_bytes: 64 << 20, finished_jobs: 1000, finished_bytes: 256 << 20 }
    }
}

/// A [`JobStore`] in memory.
pub struct MemoryStore {
    shelf: Mutex<Shelf>,
    keys: Mutex<BTreeMap<KeyId, ApiKey>>,
    notifier: Arc<JobNotifier>,
    clock: Arc<dyn Clock>,
}

impl MemoryStore {
    /// An empty store that announces its changes through `notifier`.
    pub fn new(limits: MemoryLimits, notifier: Arc<JobNotifier>, clock: Arc<dyn Clock>) -> Self {
        Self { shelf: Mutex::new(Shelf::new(limits)), keys: Mutex::default(), notifier, clock }
    }

    /// Whether the job is here.
    pub(super) fn has(&self, id: JobId) -> bool {
        self.shelf().entry(id).is_ok()
    }

    /// A job on its way to another store; `None` if it has finished or is not here.
    pub(super) fn departure(&self, id: JobId) -> Option<Departure> {
        self.shelf().departure(id)
    }

    /// Forgets a job that another store has taken over.
    pub(super) fn depart(&self, id: JobId) {
        self.shelf().depart(id);
    }

    fn shelf(&self) -> MutexGuard<'_, Shelf> {
        self.shelf.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[async_trait]
impl KeyStore for MemoryStore {
    async fn add_key(&self, key: ApiKey) -> Result<(), StoreError> {
        self.keys.lock().unwrap_or_else(PoisonError::into_inner).insert(key.id, key);
        Ok(())
    }

    async fn keys(&self, id: Option<KeyId>) -> Result<Vec<ApiKey>, StoreError> {
        let keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(keys.values().filter(|key| id.is_none_or(|id| key.id == id)).cloned().collect())
    }

    async fn revoke_key(&self, id: KeyId) -> Result<bool, StoreError> {
        let mut keys = self.keys.lock().unwrap_or_else(PoisonError::into_inner);
        let Some(key) = keys.get_mut(&id).filter(|key| key.revoked_at.is_none()) else { return Ok(false) };
        key.revoked_at = Some(self.clock.now());
        Ok(true)
    }
}

#[async_trait]
impl JobStore for MemoryStore {
    async fn enqueue(&self, job: NewJob) -> Result<Enqueued, StoreError> {
        let enqueued = self.shelf().enqueue(job, self.clock.now())?;
        self.notifier.announce_work();
        Ok(enqueued)
    }

    async fn get(&self, id: JobId) -> Result<JobRecord, StoreError> {
        self.shelf().record(id)
    }

    async fn history(&self, id: JobId, after: usize) -> Result<Vec<IterationRecord>, StoreError> {
        let shelf = self.shelf();
        Ok(shelf.entry(id)?.history.iter().skip(after).cloned().collect())
    }

    async fn request(&self, id: JobId) -> Result<Bytes, StoreError> {
        Ok(self.shelf().entry(id)?.request.clone())
    }

    async fn report(&self, id: JobId) -> Result<Option<Bytes>, StoreError> {
        Ok(self.shelf().entry(id)?.report.clone())
    }

    async fn claim(&self, request: &ClaimRequest) -> Result<Claims, StoreError> {
        let (claims, ended) = self.shelf().claim(request, self.clock.now());
        for id in ended {
            self.notifier.announce_finished(id);
        }
        for claim in &claims.jobs {
            self.notifier.announce_progress(claim.lease.job);
        }
        Ok(claims)
    }

    async fn heartbeat(&self, leases: &[Lease], lease: Duration) -> Result<Vec<LeaseStatus>, StoreError> {
        Ok(self.shelf().heartbeat(leases, lease, self.clock.now()))
    }

    async fn record_progress(&self, lease: &Lease, records: &[IterationRecord]) -> Result<(), StoreError> {
        self.shelf().leased(lease)?.history.extend_from_slice(records);
        self.notifier.announce_progress(lease.job);
        Ok(())
    }

    async fn finish(
        &self,
        lease: &Lease,
        records: &[IterationRecord],
        outcome: Outcome,
    ) -> Result<(), StoreError> {
        self.shelf().finish(lease, records, outcome, self.clock.now())?;
        self.notifier.announce_finished(lease.job);
        Ok(())
    }

    async fn release(&self, leases: &[Lease]) -> Result<(), StoreError> {
        let ended = self.shelf().release(leases, self.clock.now());
        for lease in leases {
            if ended.contains(&lease.job) {
                self.notifier.announce_finished(lease.job);
            } else {
                self.notifier.announce_progress(lease.job);
            }
        }
        self.notifier.announce_work();
        Ok(())
    }

    async fn cancel(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let record = self.shelf().cancel(id, self.clock.now())?;
        match record.state {
            JobState::Running => self.notifier.announce_cancel(id),
            JobState::Cancelled => self.notifier.announce_finished(id),
            _ => {}
        }
        Ok(record)
    }

    async fn list(&self, filter: &JobFilter) -> Result<JobPage, StoreError> {
        Ok(self.shelf().list(filter))
    }

    async fn delete(&self, id: JobId) -> Result<(), StoreError> {
        self.shelf().delete(id)
    }

    async fn counts(&self) -> Result<Counts, StoreError> {
        Ok(self.shelf().counts())
    }

    async fn sweep(&self, retention: &Retention) -> Result<usize, StoreError> {
        Ok(self.shelf().sweep(retention, self.clock.now()))
    }

    async fn ping(&self) -> Result<(), StoreError> {
        Ok(())
    }
}
