//! Quotas of API keys.

use std::sync::Arc;

use brinell::jobs::{
    ApiKey, Clock, KeyId, KeyLimits, NewJob, Quota, Scope, StepResult, StoreError, Turn,
};
use brinell_solver::solver::SolveStatus;
use jiff::Timestamp;

use crate::subject::{Subject, ids, job, reported};

pub async fn key(subject: &Subject, limits: KeyLimits) -> KeyId {
    let (key, _) = ApiKey::generate("press".to_owned(), Scope::Write, Timestamp::UNIX_EPOCH);
    let id = key.id;
    subject.store.add_key(ApiKey { limits, ..key }).await.unwrap();
    id
}

fn job_of(key: KeyId) -> NewJob {
    NewJob { submitter: Some(key), ..job("x") }
}

pub async fn a_key_has_as_many_jobs_running_as_it_may(subject: &Subject) {
    let bound = key(subject, KeyLimits { running: Some(1), ..KeyLimits::default() }).await;
    let free = key(subject, KeyLimits::default()).await;
    let [first, second] = [(); 2].map(|()| job_of(bound));
    let waiting = NewJob { interactive: true, ..job_of(bound) };
    let (first_id, other) = (first.id, job_of(free));
    let other_id = other.id;
    for new in [first, second, waiting, other] {
        subject.submit(new).await.unwrap();
    }
    let claims = subject.claim(4).await;
    assert_eq!(claims.len(), 2, "one of the key, whichever way it was handed in, and the other's");
    assert!(ids(&claims).contains(&other_id));
    let lease = claims.iter().find(|claim| claim.lease.job != other_id).unwrap().lease;
    assert!(subject.claim(4).await.is_empty());
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    assert_eq!(subject.claim(4).await.len(), 1);
    assert!(subject.get(first_id).await.attempts <= 1);
}

pub async fn a_key_stores_as_much_as_it_may(subject: &Subject) {
    let greedy =
        key(subject, KeyLimits { stored_bytes: Some(5000), ..KeyLimits::default() }).await;
    let large = |key| NewJob { result_bytes: 3000, ..job_of(key) };
    subject.submit(large(greedy)).await.unwrap();
    let refused = subject.submit(large(greedy)).await;
    let quota = Quota::Stored { limit: 5000, used: 3000, needed: 3000 };
    assert!(
        matches!(refused, Err(StoreError::QuotaExceeded { quota: found }) if found == quota),
        "{refused:?}"
    );
    // What the result takes counts in the end, not what it was estimated to take.
    let lease = subject.claim_one().await;
    let text = vec![b'x'; 10];
    let report = brinell::jobs::Deflated::compress(&text).unwrap();
    let step = StepResult { number: 0, report, fields: Some(vec![0; 1500].into()) };
    let taken = step.bytes() as u64;
    subject.store.finish(&lease, &[], &[step], reported(SolveStatus::Converged)).await.unwrap();
    let second = subject.submit(large(greedy)).await.unwrap().job.id;
    let refused = subject.submit(large(greedy)).await;
    let quota = Quota::Stored { limit: 5000, used: taken + 3000, needed: 3000 };
    assert!(
        matches!(refused, Err(StoreError::QuotaExceeded { quota: found }) if found == quota),
        "{refused:?}"
    );
    subject.store.cancel(second).await.unwrap();
    subject.submit(large(greedy)).await.unwrap();
    subject
        .submit(large(
            key(subject, KeyLimits { stored_bytes: Some(3000), ..KeyLimits::default() }).await,
        ))
        .await
        .unwrap();
}

pub async fn a_key_asks_for_the_priority_that_it_may(subject: &Subject) {
    let modest = key(subject, KeyLimits { priority: Some(-1), ..KeyLimits::default() }).await;
    let refused = subject.submit(job_of(modest)).await;
    assert!(matches!(
        refused,
        Err(StoreError::QuotaExceeded { quota: Quota::Priority { limit: -1 } })
    ));
    subject.submit(NewJob { priority: -1, ..job_of(modest) }).await.unwrap();
    // The order among those that somebody waits for is the service's own matter.
    subject.submit(NewJob { priority: 1, interactive: true, ..job_of(modest) }).await.unwrap();
    let others = KeyId::generate();
    let refused = subject.submit(NewJob { priority: 101, ..job_of(others) }).await;
    assert!(matches!(
        refused,
        Err(StoreError::QuotaExceeded { quota: Quota::Priority { limit: 100 } })
    ));
}

pub async fn submissions_at_the_same_instant_are_counted(subject: &Subject) {
    let bound = key(subject, KeyLimits { queued: Some(2), ..KeyLimits::default() }).await;
    let submissions = (0..8).map(|_| {
        let store = Arc::clone(&subject.store);
        tokio::spawn(async move { store.enqueue(job_of(bound), Turn::free()).await })
    });
    let mut accepted = 0;
    for submission in submissions.collect::<Vec<_>>() {
        match submission.await.unwrap() {
            Ok(_) => accepted += 1,
            Err(StoreError::QuotaExceeded { quota: Quota::Queued { limit: 2 } }) => {}
            Err(error) => panic!("{error:?}"),
        }
    }
    assert_eq!(accepted, 2);
}

pub async fn a_key_that_has_ended_hands_nothing_in(subject: &Subject) {
    let revoked = key(subject, KeyLimits::default()).await;
    subject.submit(job_of(revoked)).await.unwrap();
    subject.store.revoke_key(revoked).await.unwrap();
    assert!(matches!(subject.submit(job_of(revoked)).await, Err(StoreError::KeyEnded)));
    let (short, _) = ApiKey::generate("short".to_owned(), Scope::Write, Timestamp::UNIX_EPOCH);
    let expires_at = Some(subject.clock.now());
    subject.store.add_key(ApiKey { expires_at, ..short.clone() }).await.unwrap();
    assert!(matches!(subject.submit(job_of(short.id)).await, Err(StoreError::KeyEnded)));
}
