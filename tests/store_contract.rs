//! What every `JobStore` promises. Each backend runs the whole suite: `contract!(name, start)`.
#![expect(clippy::unwrap_used, clippy::expect_used, reason = "a test that cannot go on says where")]

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};
use std::time::Duration;

use brinell::jobs::{
    Claim, ClaimRequest, Clock, FailureKind, Hub, IterationRecord, JobFailure, JobFilter, JobId, JobRecord,
    JobState, JobStore, Lease, LeaseStatus, NewJob, Outcome, StoreError, WorkerId,
};
use brinell::solve::SolveStatus;
use brinell::store::{MemoryLimits, MemoryStore};
use bytes::Bytes;
use jiff::{SignedDuration, Timestamp};

/// Limits that every backend under test is started with.
const QUEUE_CAPACITY: usize = 4;
const LEASE: Duration = Duration::from_secs(30);
const MAX_ATTEMPTS: u32 = 2;

/// A clock that only the test moves.
struct TestClock(Mutex<Timestamp>);

impl TestClock {
    fn advance(&self, by: SignedDuration) {
        *self.0.lock().unwrap() += by;
    }
}

impl Clock for TestClock {
    fn now(&self) -> Timestamp {
        *self.0.lock().unwrap()
    }
}

/// A store under test with the hub it announces on and the clock it reads.
struct Subject {
    store: Arc<dyn JobStore>,
    hub: Arc<Hub>,
    clock: Arc<TestClock>,
}

impl Subject {
    fn memory(limits: MemoryLimits) -> Self {
        let hub = Hub::new();
        let clock = Arc::new(TestClock(Mutex::new("2026-01-01T00:00:00Z".parse().unwrap())));
        let store =
            Arc::new(MemoryStore::new(limits, Arc::clone(&hub), Arc::clone(&clock) as Arc<dyn Clock>));
        Self { store, hub, clock }
    }

    async fn enqueue(&self, tag: &str) -> JobId {
        let tags = BTreeMap::from([("name".to_owned(), tag.to_owned())]);
        let id = JobId::generate();
        let job = NewJob { id, request: Bytes::from(format!("{{\"job\": \"{tag}\"}}")), tags };
        self.store.enqueue(job).await.unwrap();
        id
    }

    async fn claim(&self, owner: WorkerId, slots: usize) -> Vec<Claim> {
        let request = ClaimRequest { owner, slots, lease: LEASE, max_attempts: MAX_ATTEMPTS };
        self.store.claim(&request).await.unwrap()
    }

    async fn claim_one(&self) -> Lease {
        let claims = self.claim(WorkerId::generate(), 1).await;
        assert_eq!(claims.len(), 1);
        claims[0].lease
    }

    async fn get(&self, id: JobId) -> JobRecord {
        self.store.get(id).await.unwrap()
    }

    async fn page(&self, filter: JobFilter) -> (Vec<JobId>, Option<JobId>) {
        let page = self.store.list(&filter).await.unwrap();
        (page.jobs.into_iter().map(|job| job.id).collect(), page.next)
    }
}

fn iteration(number: usize) -> IterationRecord {
    IterationRecord {
        iteration: number,
        contact_pivots: 1,
        initial_stress_updates: 1,
        factorizations: 0,
        displacement_change: 1e-3,
        force_change: 1e-3,
        equilibrium_residual: 1e-3,
        plastic_points: 10,
        contact_pairs: 20,
        approach: 0.02,
        peak_pressure: 1200.0,
        elapsed_ms: 1.0,
    }
}

fn reported(status: SolveStatus) -> Outcome {
    Outcome::Reported { status, report: Bytes::from_static(b"{\"report\": 1}") }
}

const ALL: JobFilter = JobFilter { state: None, tag: None, before: None, limit: 100 };

macro_rules! contract {
    ($backend:ident, $start:expr, [$($promise:ident),* $(,)?]) => {
        mod $backend {
            $(#[tokio::test]
            async fn $promise() {
                super::$promise(&$start).await;
            })*
        }
    };
}

contract!(
    memory,
    super::Subject::memory(super::MemoryLimits {
        queued_jobs: super::QUEUE_CAPACITY,
        ..super::MemoryLimits::default()
    }),
    [
        a_job_goes_its_way,
        jobs_are_handed_out_in_order_and_only_once,
        a_full_queue_refuses_and_keeps_nothing,
        unknown_jobs_are_not_found,
        only_the_holder_of_the_lease_writes,
        an_expired_job_is_handed_out_again_and_given_up_at_last,
        heartbeats_keep_a_job_and_tell_of_cancellation,
        a_queued_job_is_cancelled_at_once,
        a_running_job_is_asked_to_stop,
        an_expired_job_that_was_to_stop_is_cancelled,
        failures_are_kept,
        pages_are_newest_first_and_filtered,
        only_finished_jobs_are_deleted,
        changes_are_announced_after_they_can_be_read,
    ]
);

async fn a_job_goes_its_way(subject: &Subject) {
    let store = &subject.store;
    let id = subject.enqueue("one").await;
    let queued = subject.get(id).await;
    assert_eq!((queued.state, queued.queue_position, queued.attempts), (JobState::Queued, Some(0), 0));
    assert_eq!(queued.tags["name"], "one");

    subject.clock.advance(SignedDuration::from_secs(5));
    let claims = subject.claim(WorkerId::generate(), 3).await;
    assert_eq!(claims.len(), 1);
    assert_eq!(claims[0].request, "{\"job\": \"one\"}");
    let lease = claims[0].lease;
    let running = subject.get(id).await;
    assert_eq!((running.state, running.queue_position, running.attempts), (JobState::Running, None, 1));
    let waited = running.created_at.duration_until(running.started_at.unwrap());
    assert_eq!(waited, SignedDuration::from_secs(5));

    store.record_progress(&lease, &[iteration(1), iteration(2)]).await.unwrap();
    store.record_progress(&lease, &[iteration(3)]).await.unwrap();
    let running = subject.get(id).await;
    assert_eq!((running.iterations, running.latest), (3, Some(iteration(3))));
    assert_eq!(store.history(id, 1).await.unwrap(), [iteration(2), iteration(3)]);
    assert_eq!(store.report(id).await.unwrap(), None);

    store.finish(&lease, reported(SolveStatus::Converged)).await.unwrap();
    let finished = subject.get(id).await;
    assert_eq!((finished.state, finished.has_report), (JobState::Succeeded, true));
    assert!(finished.finished_at.is_some());
    assert_eq!(store.report(id).await.unwrap().unwrap(), "{\"report\": 1}");
    assert_eq!(store.counts().await.unwrap().get(&JobState::Succeeded), Some(&1));
}

async fn jobs_are_handed_out_in_order_and_only_once(subject: &Subject) {
    let mut ids = Vec::new();
    for name in ["a", "b", "c", "d"] {
        ids.push(subject.enqueue(name).await);
    }
    assert_eq!(subject.get(ids[2]).await.queue_position, Some(2));
    let claimed = |claims: Vec<Claim>| claims.into_iter().map(|claim| claim.lease.job).collect::<Vec<_>>();
    assert_eq!(claimed(subject.claim(WorkerId::generate(), 3).await), ids[..3]);
    assert_eq!(claimed(subject.claim(WorkerId::generate(), 3).await), ids[3..]);
    assert!(subject.claim(WorkerId::generate(), 3).await.is_empty());
}

async fn a_full_queue_refuses_and_keeps_nothing(subject: &Subject) {
    for _ in 0..QUEUE_CAPACITY {
        subject.enqueue("x").await;
    }
    let id = JobId::generate();
    let one_more = || NewJob { id, request: Bytes::from_static(b"{}"), tags: BTreeMap::new() };
    let refused = subject.store.enqueue(one_more()).await;
    assert!(matches!(refused, Err(StoreError::QueueFull { queued: QUEUE_CAPACITY })));
    assert!(matches!(subject.store.get(id).await, Err(StoreError::NotFound)));
    subject.claim_one().await;
    subject.store.enqueue(one_more()).await.unwrap();
}

async fn unknown_jobs_are_not_found(subject: &Subject) {
    let (store, id) = (&subject.store, JobId::generate());
    assert!(matches!(store.get(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.report(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.history(id, 0).await, Err(StoreError::NotFound)));
    assert!(matches!(store.cancel(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.delete(id).await, Err(StoreError::NotFound)));
}

async fn only_the_holder_of_the_lease_writes(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    let strangers = [
        Lease { owner: WorkerId::generate(), ..lease },
        Lease { attempt: lease.attempt + 1, ..lease },
        Lease { job: JobId::generate(), ..lease },
    ];
    for stranger in strangers {
        let refused = store.record_progress(&stranger, &[iteration(1)]).await;
        assert!(matches!(refused, Err(StoreError::LeaseLost)));
        let refused = store.finish(&stranger, reported(SolveStatus::Converged)).await;
        assert!(matches!(refused, Err(StoreError::LeaseLost)));
        assert_eq!(store.heartbeat(&[stranger], LEASE).await.unwrap(), [LeaseStatus::Lost]);
    }
    store.finish(&lease, reported(SolveStatus::NotConverged)).await.unwrap();
    let again = store.finish(&lease, reported(SolveStatus::Converged)).await;
    assert!(matches!(again, Err(StoreError::LeaseLost)));
    assert_eq!(subject.get(id).await.state, JobState::NotConverged);
}

async fn an_expired_job_is_handed_out_again_and_given_up_at_last(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let first = subject.claim_one().await;
    store.record_progress(&first, &[iteration(1)]).await.unwrap();
    assert!(subject.claim(WorkerId::generate(), 1).await.is_empty(), "the lease still holds");

    subject.clock.advance(SignedDuration::from_secs(31));
    let second = subject.claim_one().await;
    assert_eq!((second.job, second.attempt), (id, 2));
    assert!(matches!(store.record_progress(&first, &[iteration(2)]).await, Err(StoreError::LeaseLost)));
    assert!(store.history(id, 0).await.unwrap().is_empty(), "a new attempt has a new history");

    subject.clock.advance(SignedDuration::from_secs(31));
    assert!(subject.claim(WorkerId::generate(), 1).await.is_empty());
    let given_up = subject.get(id).await;
    assert_eq!(given_up.state, JobState::Failed);
    assert_eq!(given_up.failure.unwrap().kind, FailureKind::Internal);
}

async fn heartbeats_keep_a_job_and_tell_of_cancellation(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    for _ in 0..3 {
        subject.clock.advance(SignedDuration::from_secs(20));
        let kept = LeaseStatus::Held { cancel_requested: false };
        assert_eq!(store.heartbeat(&[lease], LEASE).await.unwrap(), [kept]);
        assert!(subject.claim(WorkerId::generate(), 1).await.is_empty());
    }
    store.cancel(id).await.unwrap();
    let to_stop = LeaseStatus::Held { cancel_requested: true };
    assert_eq!(store.heartbeat(&[lease], LEASE).await.unwrap(), [to_stop]);
}

async fn a_queued_job_is_cancelled_at_once(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let other = subject.enqueue("y").await;
    let cancelled = store.cancel(id).await.unwrap();
    assert_eq!((cancelled.state, cancelled.queue_position), (JobState::Cancelled, None));
    assert_eq!(subject.claim_one().await.job, other);
    assert_eq!(store.cancel(id).await.unwrap().state, JobState::Cancelled, "asking twice is no error");
}

async fn a_running_job_is_asked_to_stop(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    let asked = store.cancel(id).await.unwrap();
    assert_eq!((asked.state, asked.cancel_requested), (JobState::Running, true));
    store.finish(&lease, reported(SolveStatus::Cancelled)).await.unwrap();
    let stopped = subject.get(id).await;
    assert_eq!((stopped.state, stopped.has_report), (JobState::Cancelled, true));
}

async fn an_expired_job_that_was_to_stop_is_cancelled(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    subject.claim_one().await;
    store.cancel(id).await.unwrap();
    subject.clock.advance(SignedDuration::from_secs(31));
    assert!(subject.claim(WorkerId::generate(), 1).await.is_empty());
    assert_eq!(subject.get(id).await.state, JobState::Cancelled);
}

async fn failures_are_kept(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    let failure = JobFailure::solver("the stiffness matrix is not positive definite");
    store.finish(&lease, Outcome::Failed(failure.clone())).await.unwrap();
    let failed = subject.get(id).await;
    assert_eq!((failed.state, failed.failure, failed.has_report), (JobState::Failed, Some(failure), false));
}

async fn pages_are_newest_first_and_filtered(subject: &Subject) {
    let mut ids = Vec::new();
    for name in ["a", "b", "a"] {
        ids.push(subject.enqueue(name).await);
    }
    ids.reverse();
    assert_eq!(subject.page(ALL).await, (ids.clone(), None));
    let (first, next) = subject.page(JobFilter { limit: 2, ..ALL }).await;
    assert_eq!((first.as_slice(), next), (&ids[..2], Some(ids[1])));
    assert_eq!(subject.page(JobFilter { limit: 2, before: next, ..ALL }).await, (vec![ids[2]], None));
    let tagged = JobFilter { tag: Some(("name".to_owned(), "a".to_owned())), ..ALL };
    assert_eq!(subject.page(tagged).await.0, [ids[0], ids[2]]);
    subject.claim_one().await;
    let running = JobFilter { state: Some(JobState::Running), ..ALL };
    assert_eq!(subject.page(running).await.0, [ids[2]]);
}

async fn only_finished_jobs_are_deleted(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    assert!(matches!(store.delete(id).await, Err(StoreError::Unfinished(JobState::Queued))));
    let lease = subject.claim_one().await;
    assert!(matches!(store.delete(id).await, Err(StoreError::Unfinished(JobState::Running))));
    store.finish(&lease, reported(SolveStatus::Converged)).await.unwrap();
    store.delete(id).await.unwrap();
    assert!(matches!(store.get(id).await, Err(StoreError::NotFound)));
}

async fn changes_are_announced_after_they_can_be_read(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let deadline = Duration::from_secs(10);
    tokio::time::timeout(deadline, subject.hub.work()).await.expect("new work is announced");
    let mut watch = subject.hub.watch(id);
    let lease = subject.claim_one().await;
    tokio::time::timeout(deadline, watch.changed()).await.expect("the start is announced");
    store.cancel(id).await.unwrap();
    let signal =
        tokio::time::timeout(deadline, watch.changed()).await.expect("the wish to stop is announced");
    assert!(signal.cancel_requested && subject.get(id).await.cancel_requested);
    store.finish(&lease, reported(SolveStatus::Cancelled)).await.unwrap();
    tokio::time::timeout(deadline, watch.finished()).await.expect("the end is announced");
    assert!(subject.get(id).await.state.is_finished());
}

/// Bounds that only the store in memory has.
mod memory_bounds {
    use super::*;

    #[tokio::test]
    async fn the_oldest_finished_jobs_are_forgotten() {
        let subject = Subject::memory(MemoryLimits { finished_jobs: 2, ..MemoryLimits::default() });
        let mut ids = Vec::new();
        for _ in 0..3 {
            ids.push(subject.enqueue("x").await);
            let lease = subject.claim_one().await;
            subject.store.finish(&lease, reported(SolveStatus::Converged)).await.unwrap();
        }
        assert!(matches!(subject.store.get(ids[0]).await, Err(StoreError::NotFound)));
        assert_eq!(subject.page(ALL).await.0, [ids[2], ids[1]]);
    }

    #[tokio::test]
    async fn large_reports_push_others_out_but_the_last_one_stays() {
        let subject = Subject::memory(MemoryLimits { finished_bytes: 10_000, ..MemoryLimits::default() });
        let mut ids = Vec::new();
        for _ in 0..2 {
            ids.push(subject.enqueue("x").await);
            let lease = subject.claim_one().await;
            let report = Bytes::from(vec![b' '; 20_000]);
            let outcome = Outcome::Reported { status: SolveStatus::Converged, report };
            subject.store.finish(&lease, outcome).await.unwrap();
        }
        assert_eq!(subject.page(ALL).await.0, [ids[1]]);
    }

    #[tokio::test]
    async fn waiting_jobs_are_bounded_in_bytes_too() {
        let subject = Subject::memory(MemoryLimits { queued_bytes: 10_000, ..MemoryLimits::default() });
        let job = |size| NewJob {
            id: JobId::generate(),
            request: Bytes::from(vec![b' '; size]),
            tags: BTreeMap::new(),
        };
        subject.store.enqueue(job(6_000)).await.unwrap();
        let refused = subject.store.enqueue(job(6_000)).await;
        assert!(matches!(refused, Err(StoreError::QueueFull { queued: 1 })));
        subject.claim_one().await;
        subject.store.enqueue(job(6_000)).await.unwrap();
    }
}
