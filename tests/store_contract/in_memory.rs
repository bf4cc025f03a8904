//! What only a store in memory has: a bound, which is met like the end of a disk.

use brinell::jobs::{NewJob, StoreError, Turn};
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;

use crate::subject::{QUEUE_CAPACITY, Subject};

/// Text that does not compress.
fn noise(bytes: usize) -> Bytes {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        b'!' + u8::try_from((state >> 40) % 90).unwrap()
    };
    (0..bytes).map(|_| next()).collect()
}

#[tokio::test]
async fn a_full_memory_refuses_jobs_and_recovers_when_there_is_room() {
    let subject = Subject::memory(2 << 20).await;
    let first =
        subject.store.enqueue(NewJob::new(noise(700_000)), Turn::free()).await.unwrap().job.id;
    let mut refused = 0;
    for _ in 1..QUEUE_CAPACITY {
        match subject.store.enqueue(NewJob::new(noise(700_000)), Turn::free()).await {
            Ok(_) => {}
            Err(StoreError::DiskFull) => refused += 1,
            Err(other) => panic!("{other}"),
        }
    }
    assert!(refused > 0, "2 MiB do not hold them all");
    let lease = subject.claim_one().await;
    assert_eq!(lease.job, first);
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    subject.store.delete(first).await.unwrap();
    subject
        .store
        .enqueue(NewJob::new(noise(400_000)), Turn::free())
        .await
        .expect("there is room again");
    subject.store.ping().await.expect("the store is well");
}
