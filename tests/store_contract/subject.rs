//! A store under test.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use brinell::jobs::{
    Claim, ClaimRequest, Claims, Clock, Enqueued, IterationRecord, JobFilter, JobId, JobNotifier,
    JobRecord, KeyLimits, Lease, NewJob, NumberedIteration, Outcome, StoreError, Turn, WorkerId,
};
use brinell::store::{Store, StoreLimits, open_postgres, open_sqlite, open_sqlite_in_memory};
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;
use jiff::{SignedDuration, Timestamp};

use crate::cluster::Cluster;

/// Limits that every backend under test is started with.
pub const QUEUE_CAPACITY: usize = 4;
pub const LIMITS: StoreLimits = StoreLimits {
    queue_capacity: QUEUE_CAPACITY,
    by_key: KeyLimits {
        queued: Some(3),
        running: None,
        stored_bytes: Some(1000),
        priority: Some(100),
    },
    min_free_bytes: 0,
};
/// Bytes that a store in memory may take.
pub const MEMORY_STORE: u64 = 64 << 20;
pub const LEASE: Duration = Duration::from_secs(30);
pub const MAX_ATTEMPTS: u32 = 2;
pub const MEMORY: u64 = 1000;

#[path = "../support/deadline.rs"]
mod deadline;
pub use deadline::DEADLINE;

pub const ALL: JobFilter = JobFilter {
    ids: Vec::new(),
    states: Vec::new(),
    tags: Vec::new(),
    since: None,
    until: None,
    submitter: None,
    oldest_first: false,
    cursor: None,
    limit: 100,
};

/// A report without steps.
pub const HEAD: &[u8] = b"{\"status\":\"x\",\"steps\":[],\"version\":\"y\"}";

/// A clock that only the test moves.
pub struct TestClock(Mutex<Timestamp>);

impl TestClock {
    pub fn advance(&self, by: SignedDuration) {
        *self.0.lock().unwrap() += by;
    }
}

impl Clock for TestClock {
    fn now(&self) -> Timestamp {
        *self.0.lock().unwrap()
    }
}

/// A store under test with its notifier and its clock.
pub struct Subject {
    pub store: Arc<dyn Store>,
    pub notifier: Arc<JobNotifier>,
    pub clock: Arc<TestClock>,
    /// Where a second process would find the same jobs.
    pub place: Place,
}

/// Where a store keeps its jobs.
#[derive(Clone)]
pub enum Place {
    Memory,
    Directory(Arc<Scratch>),
    Database(String),
}

/// A directory that is removed in the end.
pub struct Scratch(pub PathBuf);

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

impl Subject {
    pub async fn memory(bytes: u64) -> Self {
        let (notifier, clock) = (JobNotifier::new(), clock());
        let time = Arc::clone(&clock) as Arc<dyn Clock>;
        let store =
            open_sqlite_in_memory(bytes, LIMITS, Arc::clone(&notifier), time).await.unwrap();
        Self { store, notifier, clock, place: Place::Memory }
    }

    pub async fn sqlite() -> Self {
        Self::at(Self::directory(), clock()).await
    }

    /// A directory for a store of its own.
    pub fn directory() -> Place {
        let name = format!("brinell-test-{}", JobId::generate());
        Place::Directory(Arc::new(Scratch(Path::new(env!("CARGO_TARGET_TMPDIR")).join(name))))
    }

    pub async fn postgres() -> Self {
        Self::at(Place::Database(Cluster::shared().database().await), clock()).await
    }

    /// What another process would see, once this one is gone or beside it.
    pub async fn again(place: Place, clock: Arc<TestClock>) -> Self {
        Self::at(place, clock).await
    }

    async fn at(place: Place, clock: Arc<TestClock>) -> Self {
        let notifier = JobNotifier::new();
        let (announced, time) = (Arc::clone(&notifier), Arc::clone(&clock) as Arc<dyn Clock>);
        let store = match &place {
            Place::Memory => panic!("memory is not shared"),
            Place::Directory(path) => open_sqlite(&path.0, LIMITS, announced, time).await.unwrap(),
            Place::Database(url) => {
                open_postgres(url, 10, LIMITS, announced, Some(time)).await.unwrap()
            }
        };
        Self { store, notifier, clock, place }
    }

    pub async fn enqueue(&self, tag: &str) -> JobId {
        self.submit(job(tag)).await.unwrap().job.id
    }

    pub async fn submit(&self, job: NewJob) -> Result<Enqueued, StoreError> {
        self.store.enqueue(job, Turn::free()).await
    }

    /// What a worker that does nothing else is handed.
    pub fn request(places: usize) -> ClaimRequest {
        ClaimRequest {
            owner: WorkerId::generate(),
            places,
            places_of_key: usize::MAX,
            memory_of_place: 0,
            free_memory: MEMORY,
            memory: MEMORY,
            lease: LEASE,
            max_attempts: MAX_ATTEMPTS,
            expires: true,
        }
    }

    pub async fn claims(&self, request: ClaimRequest) -> Claims {
        self.store.claim(&request).await.unwrap()
    }

    pub async fn claim(&self, places: usize) -> Vec<Claim> {
        self.claims(Self::request(places)).await.jobs
    }

    pub async fn claim_one(&self) -> Lease {
        let claims = self.claim(1).await;
        assert_eq!(claims.len(), 1);
        claims[0].lease
    }

    pub async fn finish(&self, lease: &Lease, status: SolveStatus) -> Result<(), StoreError> {
        self.store.finish(lease, &[], &[], reported(status)).await
    }

    /// The report without its steps.
    pub async fn head(&self, id: JobId) -> Bytes {
        self.store.result(id).await.unwrap().expect("a result").report
    }

    pub async fn get(&self, id: JobId) -> JobRecord {
        self.store.get(id).await.unwrap()
    }

    pub async fn page(&self, filter: JobFilter) -> (Vec<JobId>, Option<JobId>) {
        let page = self.store.list(&filter).await.unwrap();
        (page.jobs.into_iter().map(|job| job.id).collect(), page.next)
    }
}

pub fn clock() -> Arc<TestClock> {
    Arc::new(TestClock(Mutex::new("2026-01-01T00:00:00Z".parse().unwrap())))
}

pub fn job(tag: &str) -> NewJob {
    let tags = BTreeMap::from([("name".to_owned(), tag.to_owned())]);
    NewJob { tags, ..NewJob::new(Bytes::from(format!("{{\"job\": \"{tag}\"}}"))) }
}

pub fn ids(claims: &[Claim]) -> Vec<JobId> {
    claims.iter().map(|claim| claim.lease.job).collect()
}

pub fn iteration(number: usize) -> IterationRecord {
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
        increment: None,
    }
}

/// The iteration of this number, counted from 1.
pub fn numbered(number: usize) -> NumberedIteration {
    NumberedIteration { number: number - 1, record: iteration(number) }
}

pub fn reported(status: SolveStatus) -> Outcome {
    Outcome::Reported { status, report: Bytes::from_static(HEAD) }
}
