//! The bookkeeping of [`MemoryStore`](super::MemoryStore): plain data and plain functions under one lock.

use std::collections::{BTreeMap, VecDeque};
use std::ops::Bound;
use std::time::Duration;

use bytes::Bytes;
use jiff::{SignedDuration, Timestamp};

use super::MemoryLimits;
use crate::jobs::{
    Claim, ClaimRequest, Counts, IterationRecord, JobFailure, JobFilter, JobId, JobPage, JobRecord, JobState,
    Lease, LeaseStatus, NewJob, Outcome, StoreError, WorkerId,
};
use crate::solve::Interrupt;

/// One job.
pub(super) struct Entry {
    state: JobState,
    request: Bytes,
    tags: BTreeMap<String, String>,
    created_at: Timestamp,
    started_at: Option<Timestamp>,
    finished_at: Option<Timestamp>,
    attempts: u32,
    owner: Option<WorkerId>,
    leased_until: Timestamp,
    cancel_requested: bool,
    pub(super) history: Vec<IterationRecord>,
    pub(super) report: Option<Bytes>,
    failure: Option<JobFailure>,
}

impl Entry {
    fn bytes(&self) -> usize {
        let tags: usize = self.tags.iter().map(|(key, value)| key.len() + value.len()).sum();
        let history = self.history.len() * size_of::<IterationRecord>();
        size_of::<Self>() + self.request.len() + tags + history + self.report.as_ref().map_or(0, Bytes::len)
    }

    fn is_held_by(&self, lease: &Lease) -> bool {
        self.state == JobState::Running && self.owner == Some(lease.owner) && self.attempts == lease.attempt
    }
}

/// All jobs. `queued` and `finished` are in the order of queueing and finishing.
pub(super) struct Shelf {
    limits: MemoryLimits,
    jobs: BTreeMap<JobId, Entry>,
    queued: VecDeque<JobId>,
    queued_bytes: usize,
    running: Vec<JobId>,
    finished: VecDeque<JobId>,
    finished_bytes: usize,
}

impl Shelf {
    pub(super) fn new(limits: MemoryLimits) -> Self {
        Self {
            limits,
            jobs: BTreeMap::new(),
            queued: VecDeque::new(),
            queued_bytes: 0,
            running: Vec::new(),
            finished: VecDeque::new(),
            finished_bytes: 0,
        }
    }

    pub(super) fn enqueue(&mut self, job: NewJob, now: Timestamp) -> Result<JobRecord, StoreError> {
        let entry = Entry {
            state: JobState::Queued,
            request: job.request,
            tags: job.tags,
            created_at: now,
            started_at: None,
            finished_at: None,
            attempts: 0,
            owner: None,
            leased_until: now,
            cancel_requested: false,
            history: Vec::new(),
            report: None,
            failure: None,
        };
        let bytes = self.queued_bytes + entry.bytes();
        if self.queued.len() >= self.limits.queued_jobs || bytes > self.limits.queued_bytes {
            return Err(StoreError::QueueFull { queued: self.queued.len() });
        }
        self.queued_bytes = bytes;
        self.queued.push_back(job.id);
        self.jobs.insert(job.id, entry);
        self.record(job.id)
    }

    pub(super) fn entry(&self, id: JobId) -> Result<&Entry, StoreError> {
        self.jobs.get(&id).ok_or(StoreError::NotFound)
    }

    /// The entry of a job, if `lease` still holds it.
    pub(super) fn leased(&mut self, lease: &Lease) -> Result<&mut Entry, StoreError> {
        self.jobs.get_mut(&lease.job).filter(|entry| entry.is_held_by(lease)).ok_or(StoreError::LeaseLost)
    }

    pub(super) fn record(&self, id: JobId) -> Result<JobRecord, StoreError> {
        let entry = self.entry(id)?;
        let queued = entry.state == JobState::Queued;
        Ok(JobRecord {
            id,
            state: entry.state,
            tags: entry.tags.clone(),
            created_at: entry.created_at,
            started_at: entry.started_at,
            finished_at: entry.finished_at,
            attempts: entry.attempts,
            queue_position: if queued { self.queued.iter().position(|other| *other == id) } else { None },
            cancel_requested: entry.cancel_requested,
            iterations: entry.history.len(),
            latest: entry.history.last().cloned(),
            has_report: entry.report.is_some(),
            failure: entry.failure.clone(),
        })
    }

    /// Jobs handed out, and jobs that ended because nobody may take them up again.
    pub(super) fn claim(&mut self, request: &ClaimRequest, now: Timestamp) -> (Vec<Claim>, Vec<JobId>) {
        let (mut claims, mut ended) = (Vec::new(), Vec::new());
        let expired: Vec<JobId> =
            self.running.iter().copied().filter(|id| self.has_expired(*id, now)).collect();
        for id in expired {
            let Some(entry) = self.jobs.get(&id) else { continue };
            let outcome = if entry.cancel_requested {
                Outcome::Interrupted(Interrupt::Cancelled)
            } else if entry.attempts >= request.max_attempts {
                let lost = format!("the worker was lost {} times while solving this job", entry.attempts);
                Outcome::Failed(JobFailure::internal(lost))
            } else {
                if claims.len() < request.slots {
                    claims.extend(self.hand_out(id, request, now));
                }
                continue;
            };
            self.end(id, outcome, now);
            ended.push(id);
        }
        while claims.len() < request.slots {
            let Some(id) = self.queued.pop_front() else { break };
            self.queued_bytes -= self.jobs.get(&id).map_or(0, Entry::bytes);
            self.running.push(id);
            claims.extend(self.hand_out(id, request, now));
        }
        (claims, ended)
    }

    fn has_expired(&self, id: JobId, now: Timestamp) -> bool {
        self.jobs.get(&id).is_some_and(|entry| entry.leased_until <= now)
    }

    fn hand_out(&mut self, id: JobId, request: &ClaimRequest, now: Timestamp) -> Option<Claim> {
        let entry = self.jobs.get_mut(&id)?;
        entry.state = JobState::Running;
        entry.started_at = Some(now);
        entry.attempts += 1;
        entry.owner = Some(request.owner);
        entry.leased_until = after(now, request.lease);
        entry.history.clear();
        let lease = Lease { job: id, owner: request.owner, attempt: entry.attempts };
        Some(Claim { lease, request: entry.request.clone() })
    }

    pub(super) fn heartbeat(
        &mut self,
        leases: &[Lease],
        lease: Duration,
        now: Timestamp,
    ) -> Vec<LeaseStatus> {
        let mut beat = |held: &Lease| match self.leased(held) {
            Ok(entry) => {
                entry.leased_until = after(now, lease);
                LeaseStatus::Held { cancel_requested: entry.cancel_requested }
            }
            Err(_) => LeaseStatus::Lost,
        };
        leases.iter().map(&mut beat).collect()
    }

    pub(super) fn finish(
        &mut self,
        lease: &Lease,
        outcome: Outcome,
        now: Timestamp,
    ) -> Result<(), StoreError> {
        self.leased(lease)?;
        self.end(lease.job, outcome, now);
        Ok(())
    }

    pub(super) fn cancel(&mut self, id: JobId, now: Timestamp) -> Result<JobRecord, StoreError> {
        let entry = self.jobs.get_mut(&id).ok_or(StoreError::NotFound)?;
        match entry.state {
            JobState::Queued => {
                entry.cancel_requested = true;
                self.queued_bytes -= entry.bytes();
                self.queued.retain(|other| *other != id);
                self.end(id, Outcome::Interrupted(Interrupt::Cancelled), now);
            }
            JobState::Running => entry.cancel_requested = true,
            _ => {}
        }
        self.record(id)
    }

    /// Moves a job, no longer queued, to its final state.
    fn end(&mut self, id: JobId, outcome: Outcome, now: Timestamp) {
        let Some(entry) = self.jobs.get_mut(&id) else { return };
        entry.state = outcome.state();
        entry.finished_at = Some(now);
        entry.owner = None;
        match outcome {
            Outcome::Reported { report, .. } => entry.report = Some(report),
            Outcome::Failed(failure) => entry.failure = Some(failure),
            Outcome::Interrupted(_) => {}
        }
        self.finished_bytes += entry.bytes();
        self.finished.push_back(id);
        self.running.retain(|other| *other != id);
        self.forget_the_oldest();
    }

    fn forget_the_oldest(&mut self) {
        while self.finished.len() > 1
            && (self.finished.len() > self.limits.finished_jobs
                || self.finished_bytes > self.limits.finished_bytes)
        {
            let Some(oldest) = self.finished.pop_front() else { return };
            self.finished_bytes -= self.jobs.remove(&oldest).map_or(0, |entry| entry.bytes());
        }
    }

    pub(super) fn list(&self, filter: &JobFilter) -> JobPage {
        let end = filter.before.map_or(Bound::Unbounded, Bound::Excluded);
        let wanted = |entry: &Entry| {
            filter.state.is_none_or(|state| entry.state == state)
                && filter.tag.as_ref().is_none_or(|(key, value)| entry.tags.get(key) == Some(value))
        };
        let newest_first = self.jobs.range((Bound::Unbounded, end)).rev();
        let mut found = newest_first.filter(|(_, entry)| wanted(entry)).map(|(id, _)| *id);
        let ids: Vec<JobId> = found.by_ref().take(filter.limit).collect();
        let next = if found.next().is_some() { ids.last().copied() } else { None };
        JobPage { jobs: ids.into_iter().filter_map(|id| self.record(id).ok()).collect(), next }
    }

    pub(super) fn delete(&mut self, id: JobId) -> Result<(), StoreError> {
        let state = self.entry(id)?.state;
        if !state.is_finished() {
            return Err(StoreError::Unfinished(state));
        }
        self.finished.retain(|other| *other != id);
        self.finished_bytes -= self.jobs.remove(&id).map_or(0, |entry| entry.bytes());
        Ok(())
    }

    pub(super) fn counts(&self) -> Counts {
        let mut counts = Counts::new();
        for entry in self.jobs.values() {
            *counts.entry(entry.state).or_default() += 1;
        }
        counts
    }
}

fn after(now: Timestamp, wait: Duration) -> Timestamp {
    let wait = SignedDuration::try_from(wait).unwrap_or(SignedDuration::MAX);
    now.checked_add(wait).unwrap_or(Timestamp::MAX)
}
