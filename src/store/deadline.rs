//! Deadlines of the calls of a store behind a network: a server that falls silent fails each call
//! that waits for it, in bounded time.

use std::path::Path;
use std::time::Duration;

use async_trait::async_trait;
use bytes::Bytes;
use jiff::Timestamp;
use tokio::time::timeout;

use crate::jobs::{
    ApiKey, Callback, ClaimRequest, Claims, Counts, Deflated, Delivery, DeliveryEnd,
    DeliveryStore, Enqueued, FieldsPart, IterationRecord, JobFilter, JobId, JobPage, JobRecord,
    JobStore, KeyId, KeyLimits, KeyStore, Lease, LeaseStatus, NewJob, NumberedIteration, Outcome,
    ResultHead, Retention, StepResult, StoreError, Turn, WorkerId,
};

/// Longest time of a call.
const CALL: Duration = Duration::from_secs(15);

/// Longest time of a worker's call, for which no client waits: a database that answers after 5 s
/// takes half of it to connect.
const OF_WORKER: Duration = Duration::from_mins(1);

/// Longest time of calls that read or remove much: a check, a sweep.
const LONG: Duration = Duration::from_hours(1);

/// Slowest line over which results are written \[bytes/s\].
const SLOWEST: u64 = 20_000;

/// A store whose calls end.
pub(super) struct Timely<S>(pub(super) S);

/// Time to write steps in.
fn to_write(steps: &[StepResult]) -> Duration {
    let bytes: usize = steps.iter().map(StepResult::bytes).sum();
    OF_WORKER + Duration::from_secs(bytes as u64 / SLOWEST)
}

macro_rules! timely {
    ($trait:ident { $($limit:expr => fn $method:ident($($name:ident: $type:ty),*) -> $output:ty;)* }
     $($rest:tt)*) => {
        #[async_trait]
        impl<S: $trait> $trait for Timely<S> {
            $(async fn $method(&self, $($name: $type),*) -> Result<$output, StoreError> {
                let called = timeout($limit, self.0.$method($($name),*)).await;
                called.unwrap_or_else(|late| Err(StoreError::silent(late)))
            })*
            $($rest)*
        }
    };
}

timely!(JobStore {
    CALL => fn enqueue(job: NewJob, turn: Turn) -> Enqueued;
    CALL => fn enqueue_all(jobs: Vec<NewJob>, turn: Turn) -> Vec<Result<Enqueued, StoreError>>;
    CALL => fn get(id: JobId) -> JobRecord;
    CALL => fn history(id: JobId, after: usize) -> Vec<NumberedIteration>;
    CALL => fn request(id: JobId) -> Bytes;
    CALL => fn result(id: JobId) -> Option<ResultHead>;
    CALL => fn step(id: JobId, step: usize) -> Deflated;
    CALL => fn fields(id: JobId, step: usize, at: usize) -> Option<FieldsPart>;
    OF_WORKER => fn claim(request: &ClaimRequest) -> Claims;
    OF_WORKER => fn give_back(owner: WorkerId, known: &[JobId]) -> ();
    OF_WORKER => fn heartbeat(leases: &[Lease], lease: Duration) -> Vec<LeaseStatus>;
    OF_WORKER => fn record_progress(
        lease: &Lease, records: &[NumberedIteration], latest: &IterationRecord
    ) -> ();
    to_write(steps) => fn record_steps(lease: &Lease, steps: &[StepResult]) -> ();
    to_write(steps) => fn finish(
        lease: &Lease, records: &[NumberedIteration], steps: &[StepResult], outcome: Outcome
    ) -> ();
    OF_WORKER => fn release(leases: &[Lease]) -> ();
    CALL => fn cancel(id: JobId) -> JobRecord;
    CALL => fn list(filter: &JobFilter) -> JobPage;
    CALL => fn delete(id: JobId) -> ();
    CALL => fn counts() -> Counts;
    LONG => fn sweep(retention: &Retention) -> usize;
    CALL => fn sync() -> ();
    LONG => fn check(jobs: bool) -> Vec<String>;
    LONG => fn backup(file: &Path) -> bool;
    CALL => fn ping() -> ();
}
async fn close(&self) {
    self.0.close().await;
});

timely!(KeyStore {
    CALL => fn add_key(key: ApiKey) -> ();
    CALL => fn keys(id: Option<KeyId>) -> Vec<ApiKey>;
    CALL => fn rotate_key(id: KeyId, digest: [u8; 32], overlap: Duration) -> bool;
    CALL => fn limit_key(id: KeyId, limits: KeyLimits, expires_at: Option<Timestamp>) -> bool;
    CALL => fn revoke_key(id: KeyId) -> bool;
});

timely!(DeliveryStore {
    CALL => fn claim_deliveries(limit: usize, lease: Duration) -> Vec<Delivery>;
    CALL => fn end_deliveries(ends: &[(Delivery, DeliveryEnd)]) -> ();
    CALL => fn callback(job: JobId) -> Option<Callback>;
});
