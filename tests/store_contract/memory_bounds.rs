//! Bounds that only the store in memory has.

use brinell::jobs::{NewJob, Outcome, StoreError};
use brinell::store::MemoryLimits;
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;

use crate::subject::{ALL, Subject};

#[tokio::test]
async fn the_oldest_finished_jobs_are_forgotten() {
    let subject = Subject::memory(MemoryLimits { finished_jobs: 2, ..MemoryLimits::default() });
    let mut ids = Vec::new();
    for _ in 0..3 {
        ids.push(subject.enqueue("x").await);
        let lease = subject.claim_one().await;
        subject.finish(&lease, SolveStatus::Converged).await.unwrap();
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
        subject.store.finish(&lease, &[], outcome).await.unwrap();
    }
    assert_eq!(subject.page(ALL).await.0, [ids[1]]);
}

#[tokio::test]
async fn waiting_jobs_are_bounded_in_bytes_too() {
    let subject = Subject::memory(MemoryLimits { queued_bytes: 10_000, ..MemoryLimits::default() });
    let job = |size| NewJob::new(Bytes::from(vec![b' '; size]));
    subject.store.enqueue(job(6_000)).await.unwrap();
    let refused = subject.store.enqueue(job(6_000)).await;
    assert!(matches!(refused, Err(StoreError::QueueFull { queued: 1 })));
    subject.claim_one().await;
    subject.store.enqueue(job(6_000)).await.unwrap();
}
