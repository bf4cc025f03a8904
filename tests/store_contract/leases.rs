//! Leases of jobs.

use brinell::jobs::{
    Deflated, FailureKind, JobId, JobState, Lease, LeaseStatus, StepResult, StoreError, WorkerId,
};
use brinell_solver::solver::SolveStatus;
use jiff::SignedDuration;

use crate::subject::{LEASE, Subject, ids, iteration, numbered};

pub async fn only_the_holder_of_the_lease_writes(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    let strangers = [
        Lease { owner: WorkerId::generate(), ..lease },
        Lease { attempt: lease.attempt + 1, ..lease },
        Lease { job: JobId::generate(), ..lease },
    ];
    for stranger in strangers {
        let refused = store.record_progress(&stranger, &[numbered(1)], &iteration(1)).await;
        assert!(matches!(refused, Err(StoreError::LeaseLost)));
        let refused = subject.finish(&stranger, SolveStatus::Converged).await;
        assert!(matches!(refused, Err(StoreError::LeaseLost)));
        assert_eq!(store.heartbeat(&[stranger], LEASE).await.unwrap(), [LeaseStatus::Lost]);
    }
    subject.finish(&lease, SolveStatus::NotConverged).await.unwrap();
    let again = subject.finish(&lease, SolveStatus::Converged).await;
    assert!(matches!(again, Err(StoreError::LeaseLost)));
    assert_eq!(subject.get(id).await.state, JobState::NotConverged);
}

pub async fn an_expired_job_is_handed_out_again_and_given_up_at_last(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let first = subject.claim_one().await;
    store.record_progress(&first, &[numbered(1)], &iteration(1)).await.unwrap();
    assert!(subject.claim(1).await.is_empty(), "the lease still holds");

    subject.clock.advance(SignedDuration::from_secs(31));
    let second = subject.claim_one().await;
    assert_eq!((second.job, second.attempt), (id, 2));
    assert!(matches!(
        store.record_progress(&first, &[numbered(2)], &iteration(2)).await,
        Err(StoreError::LeaseLost)
    ));
    assert!(store.history(id, 0).await.unwrap().is_empty(), "a new attempt has a new history");

    subject.clock.advance(SignedDuration::from_secs(31));
    assert!(subject.claim(1).await.is_empty());
    let given_up = subject.get(id).await;
    assert_eq!(given_up.state, JobState::Failed);
    let failure = given_up.failure.unwrap();
    assert_eq!(failure.kind, FailureKind::Internal);
    assert!(failure.detail.contains("lost 2 times"), "{}", failure.detail);
}

pub async fn heartbeats_keep_a_job_and_tell_of_cancellation(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    for _ in 0..3 {
        subject.clock.advance(SignedDuration::from_secs(20));
        let kept = LeaseStatus::Held { cancel_requested: false };
        assert_eq!(store.heartbeat(&[lease], LEASE).await.unwrap(), [kept]);
        assert!(subject.claim(1).await.is_empty());
    }
    store.cancel(id).await.unwrap();
    let to_stop = LeaseStatus::Held { cancel_requested: true };
    assert_eq!(store.heartbeat(&[lease], LEASE).await.unwrap(), [to_stop]);
}

pub async fn an_expired_job_that_was_to_stop_is_cancelled(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    subject.claim_one().await;
    store.cancel(id).await.unwrap();
    subject.clock.advance(SignedDuration::from_secs(31));
    assert!(subject.claim(1).await.is_empty());
    assert_eq!(subject.get(id).await.state, JobState::Cancelled);
}

pub async fn last_attempts_run_one_at_a_time(subject: &Subject) {
    let (guilty, neighbour) =
        (subject.enqueue("guilty").await, subject.enqueue("neighbour").await);
    assert_eq!(subject.claim(2).await.len(), 2);
    subject.clock.advance(SignedDuration::from_secs(31));
    let fresh = subject.enqueue("fresh").await;
    let worker = Subject::request(3);
    let claims = subject.claims(worker).await.jobs;
    assert_eq!(ids(&claims), [guilty, fresh]);
    assert_eq!(claims[0].lease.attempt, 2);
    assert!(ids(&subject.claims(worker).await.jobs).is_empty(), "beside the job it was lost with");
    subject.finish(&claims[0].lease, SolveStatus::Converged).await.unwrap();
    assert_eq!(ids(&subject.claims(worker).await.jobs), [neighbour]);
}

pub async fn a_released_job_is_queued_as_if_never_taken_up(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    for attempt in 1..=4 {
        let lease = subject.claim_one().await;
        assert_eq!(lease.attempt, attempt, "being released is no loss");
        store.record_progress(&lease, &[numbered(1)], &iteration(1)).await.unwrap();
        store.release(&[lease]).await.unwrap();
        let released = subject.get(id).await;
        assert_eq!((released.state, released.queue_position), (JobState::Queued, Some(0)));
        assert_eq!((released.iterations, released.started_at), (0, None));
        assert!(matches!(
            subject.finish(&lease, SolveStatus::Converged).await,
            Err(StoreError::LeaseLost)
        ));
    }
    let lease = subject.claim_one().await;
    store.record_progress(&lease, &[numbered(1)], &iteration(1)).await.unwrap();
    let report = Deflated::compress(b"{}").unwrap();
    store.record_steps(&lease, &[StepResult { number: 0, report, fields: None }]).await.unwrap();
    store.cancel(id).await.unwrap();
    store.release(&[lease]).await.unwrap();
    let cancelled = subject.get(id).await;
    assert_eq!((cancelled.state, cancelled.iterations), (JobState::Cancelled, 1));
    assert!(
        matches!(store.step(id, 0).await, Err(StoreError::NotFound)),
        "a result that nobody can read"
    );
    store.release(&[lease]).await.unwrap();
}

/// The answer to a claim was lost: the store has leased a job that its worker does not know of.
pub async fn a_worker_gives_back_what_it_does_not_know(subject: &Subject) {
    let (known, unknown) = (subject.enqueue("known").await, subject.enqueue("unknown").await);
    let request = Subject::request(2);
    let lease = subject.claims(request).await.jobs[0].lease;
    assert_eq!(lease.job, known);
    subject.store.give_back(WorkerId::generate(), &[]).await.unwrap();
    assert_eq!(subject.get(unknown).await.state, JobState::Running, "it is another worker's");
    subject.store.give_back(request.owner, &[known]).await.unwrap();
    let kept = LeaseStatus::Held { cancel_requested: false };
    assert_eq!(subject.store.heartbeat(&[lease], LEASE).await.unwrap(), [kept]);
    let claims = subject.claims(Subject::request(1)).await;
    assert_eq!(ids(&claims.jobs), [unknown]);
    assert_eq!(subject.get(unknown).await.attempts, 2, "no loss, but an attempt");
}
