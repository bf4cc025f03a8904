//! The bookkeeping of [`MemoryStore`](super::MemoryStore): plain data and plain functions under one lock.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap, VecDeque};
use std::ops::Bound;
use std::time::Duration;

use bytes::Bytes;
use jiff::{SignedDuration, Timestamp};

use super::MemoryLimits;
use crate::jobs::{
    Claim, ClaimRequest, Claims, Counts, Enqueued, IterationRecord, JobFailure, JobFilter, JobId, JobPage,
    JobRecord, JobState, KeyId, Lease, LeaseStatus, NewJob, Outcome, Retention, SWEEP, StoreError, WorkerId,
};
use brinell_solver::solver::Interrupt;

/// One job.
pub(super) struct Entry {
    state: JobState,
    pub(super) request: Bytes,
    tags: BTreeMap<String, String>,
    priority: i16,
    memory: u64,
    submitter: Option<KeyId>,
    idempotency_key: Option<String>,
    created_at: Timestamp,
    started_at: Option<Timestamp>,
    finished_at: Option<Timestamp>,
    attempts: u32,
    losses: u32,
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

    fn place(&self, id: JobId) -> Place {
        (Reverse(self.priority), id)
    }

    fn is_held_by(&self, lease: &Lease) -> bool {
        self.state == JobState::Running && self.owner == Some(lease.owner) && self.attempts == lease.attempt
    }
}

/// An unfinished job as another store takes it over.
pub(super) struct Departure {
    pub(super) job: NewJob,
    pub(super) created_at: Timestamp,
    pub(super) started_at: Option<Timestamp>,
    pub(super) cancel_requested: bool,
    /// Of a running job: whose it is, and until when.
    pub(super) lease: Option<(Lease, Timestamp)>,
    pub(super) history: Vec<IterationRecord>,
}

/// A job's place in the queue: the highest priority first, then the oldest.
type Place = (Reverse<i16>, JobId);

/// All jobs. `queued` and `finished` are in the order of queueing and finishing.
pub(super) struct Shelf {
    limits: MemoryLimits,
    jobs: BTreeMap<JobId, Entry>,
    queued: BTreeSet<Place>,
    queued_bytes: usize,
    running: Vec<JobId>,
    finished: VecDeque<JobId>,
    finished_bytes: usize,
    known: HashMap<(Option<KeyId>, String), ([u8; 32], JobId)>,
}

impl Shelf {
    pub(super) fn new(limits: MemoryLimits) -> Self {
        Self {
            limits,
            jobs: BTreeMap::new(),
            queued: BTreeSet::new(),
            queued_bytes: 0,
            running: Vec::new(),
            finished: VecDeque::new(),
            finished_bytes: 0,
            known: HashMap::new(),
        }
    }

    pub(super) fn enqueue(&mut self, job: NewJob, now: Timestamp) -> Result<Enqueued, StoreError> {
        let known = job.idempotency.map(|name| ((job.submitter, name.key), name.digest));
        if let Some((key, digest)) = &known
            && let Some((first, id)) = self.known.get(key)
        {
            if first != digest {
                return Err(StoreError::KeyReused);
            }
            return Ok(Enqueued { job: self.record(*id)?, replayed: true });
        }
        let entry = Entry {
            state: JobState::Queued,
            request: job.request,
            tags: job.tags,
            priority: job.priority,
            memory: job.memory,
            submitter: job.submitter,
            idempotency_key: known.as_ref().map(|((_, key), _)| key.clone()),
            created_at: now,
            started_at: None,
            finished_at: None,
            attempts: 0,
            losses: 0,
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
        self.queued.insert(entry.place(job.id));
        self.jobs.insert(job.id, entry);
        if let Some((key, digest)) = known {
            self.known.insert(key, (digest, job.id));
        }
        Ok(Enqueued { job: self.record(job.id)?, replayed: false })
    }

    /// What another store needs to take over an unfinished job.
    pub(super) fn departure(&self, id: JobId) -> Option<Departure> {
        let entry = self.jobs.get(&id).filter(|entry| !entry.state.is_finished())?;
        let lease = entry.owner.map(|owner| Lease { job: id, owner, attempt: entry.attempts });
        Some(Departure {
            job: NewJob {
                id,
                request: entry.request.clone(),
                tags: entry.tags.clone(),
                priority: entry.priority,
                memory: entry.memory,
                submitter: entry.submitter,
                idempotency: None,
                ephemeral: false,
            },
            created_at: entry.created_at,
            started_at: entry.started_at,
            cancel_requested: entry.cancel_requested,
            lease: lease.map(|lease| (lease, entry.leased_until)),
            history: entry.history.clone(),
        })
    }

    /// Forgets an unfinished job.
    pub(super) fn depart(&mut self, id: JobId) {
        let Some(entry) = self.jobs.remove(&id) else { return };
        if self.queued.remove(&entry.place(id)) {
            self.queued_bytes -= entry.bytes();
        }
        self.running.retain(|other| *other != id);
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
        let place = (entry.state == JobState::Queued).then(|| self.queued.range(..entry.place(id)).count());
        Ok(JobRecord {
            id,
            state: entry.state,
            tags: entry.tags.clone(),
            priority: entry.priority,
            submitter: entry.submitter,
            created_at: entry.created_at,
            started_at: entry.started_at,
            finished_at: entry.finished_at,
            attempts: entry.attempts,
            queue_position: place,
            cancel_requested: entry.cancel_requested,
            iterations: entry.history.len(),
            latest: entry.history.last().cloned(),
            has_report: entry.report.is_some(),
            failure: entry.failure.clone(),
        })
    }

    /// Jobs handed out, and jobs that ended because nobody may take them up again.
    pub(super) fn claim(&mut self, request: &ClaimRequest, now: Timestamp) -> (Claims, Vec<JobId>) {
        let ended = self.expire(request.max_attempts, now);
        let expired: Vec<JobId> =
            self.running.iter().copied().filter(|id| self.has_expired(*id, now)).collect();
        let (exclusive, others): (Vec<JobId>, Vec<JobId>) = expired
            .into_iter()
            .filter(|id| self.fits(*id, request.memory))
            .partition(|id| self.jobs.get(id).is_some_and(|job| job.losses + 2 >= request.max_attempts));
        if let (Some(id), true) = (exclusive.first(), request.exclusive) {
            let jobs = self.lease_job(*id, true, request, now).into_iter().collect();
            return (Claims { jobs, exclusive_pending: false }, ended);
        }
        let mut claims = Claims { jobs: Vec::new(), exclusive_pending: !exclusive.is_empty() };
        let mut free = request.free_memory;
        let queued = self.queued.iter().map(|(_, id)| *id).filter(|id| self.fits(*id, request.memory));
        let candidates: Vec<JobId> = others.into_iter().chain(queued.take(request.slots)).collect();
        for id in candidates {
            let memory = self.jobs.get(&id).map_or(0, |job| job.memory);
            if claims.jobs.len() >= request.slots || memory > free {
                break;
            }
            free -= memory;
            claims.jobs.extend(self.lease_job(id, false, request, now));
        }
        (claims, ended)
    }

    fn fits(&self, id: JobId, memory: u64) -> bool {
        self.jobs.get(&id).is_some_and(|job| job.memory <= memory)
    }

    /// Ends the jobs whose lease ran out and that nobody takes up again.
    fn expire(&mut self, max_attempts: u32, now: Timestamp) -> Vec<JobId> {
        let mut ended = Vec::new();
        for id in self.running.clone() {
            let Some(entry) = self.jobs.get(&id).filter(|entry| entry.leased_until <= now) else { continue };
            let losses = entry.losses + 1;
            let outcome = if entry.cancel_requested {
                Outcome::Interrupted(Interrupt::Cancelled)
            } else if losses >= max_attempts {
                Outcome::Failed(JobFailure::lost(losses))
            } else {
                continue;
            };
            self.end(id, outcome, now);
            ended.push(id);
        }
        ended
    }

    fn has_expired(&self, id: JobId, now: Timestamp) -> bool {
        self.jobs.get(&id).is_some_and(|entry| entry.leased_until <= now)
    }

    fn lease_job(
        &mut self,
        id: JobId,
        exclusive: bool,
        request: &ClaimRequest,
        now: Timestamp,
    ) -> Option<Claim> {
        let entry = self.jobs.get_mut(&id)?;
        if entry.state == JobState::Queued {
            self.queued_bytes -= entry.bytes();
            self.queued.remove(&entry.place(id));
            self.running.push(id);
        } else {
            entry.losses += 1;
        }
        entry.state = JobState::Running;
        entry.started_at = Some(now);
        entry.attempts += 1;
        entry.owner = Some(request.owner);
        entry.leased_until = after(now, request.lease);
        entry.history.clear();
        let lease = Lease { job: id, owner: request.owner, attempt: entry.attempts };
        Some(Claim { lease, exclusive, memory: entry.memory, request: entry.request.clone() })
    }

    /// Gives leased jobs back. Returns those that ended instead.
    pub(super) fn release(&mut self, leases: &[Lease], now: Timestamp) -> Vec<JobId> {
        let mut ended = Vec::new();
        for lease in leases {
            let Ok(entry) = self.leased(lease) else { continue };
            if entry.cancel_requested {
                self.end(lease.job, Outcome::Interrupted(Interrupt::Cancelled), now);
                ended.push(lease.job);
                continue;
            }
            entry.state = JobState::Queued;
            entry.owner = None;
            entry.started_at = None;
            entry.history.clear();
            let (place, bytes) = (entry.place(lease.job), entry.bytes());
            self.queued.insert(place);
            self.queued_bytes += bytes;
            self.running.retain(|id| *id != lease.job);
        }
        ended
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
        records: &[IterationRecord],
        outcome: Outcome,
        now: Timestamp,
    ) -> Result<(), StoreError> {
        self.leased(lease)?.history.extend_from_slice(records);
        self.end(lease.job, outcome, now);
        Ok(())
    }

    pub(super) fn cancel(&mut self, id: JobId, now: Timestamp) -> Result<JobRecord, StoreError> {
        let entry = self.jobs.get_mut(&id).ok_or(StoreError::NotFound)?;
        match entry.state {
            JobState::Queued => {
                entry.cancel_requested = true;
                self.queued_bytes -= entry.bytes();
                self.queued.remove(&entry.place(id));
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
            let Some(oldest) = self.finished.front().copied() else { return };
            self.remove(oldest);
        }
    }

    fn remove(&mut self, id: JobId) {
        self.finished.retain(|other| *other != id);
        if let Some(entry) = self.jobs.remove(&id) {
            self.finished_bytes -= entry.bytes();
            if let Some(key) = entry.idempotency_key {
                self.known.remove(&(entry.submitter, key));
            }
        }
    }

    pub(super) fn sweep(&mut self, retention: &Retention, now: Timestamp) -> usize {
        let is_old = |entry: &Entry| {
            let with_result = matches!(entry.state, JobState::Succeeded | JobState::NotConverged);
            let keep = if with_result { retention.succeeded } else { retention.failed };
            entry.finished_at.is_some_and(|finished| after(finished, keep) <= now)
        };
        let jobs = &self.jobs;
        let old = self.finished.iter().copied().filter(|id| jobs.get(id).is_some_and(is_old));
        let old: Vec<JobId> = old.take(SWEEP).collect();
        for id in &old {
            self.remove(*id);
        }
        old.len()
    }

    pub(super) fn list(&self, filter: &JobFilter) -> JobPage {
        let end = filter.before.map_or(Bound::Unbounded, Bound::Excluded);
        let wanted = |entry: &Entry| {
            filter.state.is_none_or(|state| entry.state == state)
                && filter.submitter.is_none_or(|key| entry.submitter == Some(key))
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
        self.remove(id);
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
