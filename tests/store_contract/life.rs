//! A job from submission to removal.

use std::time::Duration;

use brinell::jobs::{JobFailure, JobId, JobState, Outcome, Retention, StoreError};
use brinell_solver::solver::SolveStatus;
use jiff::SignedDuration;

use crate::subject::{ALL, DEADLINE, HEAD, Subject, iteration, numbered, reported};

pub async fn a_job_goes_its_way(subject: &Subject) {
    let store = &subject.store;
    let id = subject.enqueue("one").await;
    let queued = subject.get(id).await;
    assert_eq!(
        (queued.state, queued.queue_position, queued.attempts),
        (JobState::Queued, Some(0), 0)
    );
    assert_eq!(queued.tags["name"], "one");

    subject.clock.advance(SignedDuration::from_secs(5));
    let claims = subject.claim(3).await;
    assert_eq!(claims.len(), 1);
    assert_eq!(claims[0].request, "{\"job\": \"one\"}");
    assert_eq!(store.request(id).await.unwrap(), claims[0].request);
    let lease = claims[0].lease;
    let running = subject.get(id).await;
    assert_eq!(
        (running.state, running.queue_position, running.attempts),
        (JobState::Running, None, 1)
    );
    let waited = running.created_at.duration_until(running.started_at.unwrap());
    assert_eq!(waited, SignedDuration::from_secs(5));

    store.record_progress(&lease, &[numbered(1), numbered(2)], &iteration(2)).await.unwrap();
    store.record_progress(&lease, &[numbered(3)], &iteration(3)).await.unwrap();
    let running = subject.get(id).await;
    assert_eq!((running.iterations, running.latest), (3, Some(iteration(3))));
    assert_eq!(store.history(id, 1).await.unwrap(), [numbered(2), numbered(3)]);
    assert_eq!(store.result(id).await.unwrap(), None);

    // The acknowledgement was lost: the same again. The fourth is damaged and was left out.
    store.record_progress(&lease, &[numbered(3)], &iteration(3)).await.unwrap();
    assert_eq!(store.history(id, 0).await.unwrap().len(), 3);
    store.finish(&lease, &[numbered(5)], &[], reported(SolveStatus::Converged)).await.unwrap();
    let finished = subject.get(id).await;
    assert_eq!(finished.iterations, 5);
    assert_eq!(store.history(id, 2).await.unwrap(), [numbered(3), numbered(5)]);
    assert_eq!((finished.state, finished.has_report), (JobState::Succeeded, true));
    assert!(finished.finished_at.is_some());
    assert_eq!(store.request(id).await.unwrap(), "{\"job\": \"one\"}");
    assert_eq!(subject.head(id).await, HEAD);
    assert!(store.counts().await.unwrap().is_empty(), "nothing is queued or running");
}

pub async fn unknown_jobs_are_not_found(subject: &Subject) {
    let (store, id) = (&subject.store, JobId::generate());
    assert!(matches!(store.get(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.request(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.result(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.history(id, 0).await, Err(StoreError::NotFound)));
    assert!(matches!(store.cancel(id).await, Err(StoreError::NotFound)));
    assert!(matches!(store.delete(id).await, Err(StoreError::NotFound)));
}

pub async fn a_queued_job_is_cancelled_at_once(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let other = subject.enqueue("y").await;
    let cancelled = store.cancel(id).await.unwrap();
    assert_eq!((cancelled.state, cancelled.queue_position), (JobState::Cancelled, None));
    assert_eq!(subject.claim_one().await.job, other);
    assert_eq!(
        store.cancel(id).await.unwrap().state,
        JobState::Cancelled,
        "asking twice is no error"
    );
}

pub async fn a_running_job_is_asked_to_stop(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    let asked = store.cancel(id).await.unwrap();
    assert_eq!((asked.state, asked.cancel_requested), (JobState::Running, true));
    subject.finish(&lease, SolveStatus::Cancelled).await.unwrap();
    let stopped = subject.get(id).await;
    assert_eq!((stopped.state, stopped.has_report), (JobState::Cancelled, true));
}

pub async fn failures_are_kept(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    let lease = subject.claim_one().await;
    let failure = JobFailure::solver("the stiffness matrix is not positive definite");
    store.finish(&lease, &[], &[], Outcome::Failed(failure.clone())).await.unwrap();
    let failed = subject.get(id).await;
    assert_eq!(
        (failed.state, failed.failure, failed.has_report),
        (JobState::Failed, Some(failure), false)
    );
}

pub async fn only_finished_jobs_are_deleted(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    assert!(matches!(store.delete(id).await, Err(StoreError::Unfinished(JobState::Queued))));
    let lease = subject.claim_one().await;
    assert!(matches!(store.delete(id).await, Err(StoreError::Unfinished(JobState::Running))));
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    store.delete(id).await.unwrap();
    assert!(matches!(store.get(id).await, Err(StoreError::NotFound)));
}

pub async fn changes_are_announced_after_they_can_be_read(subject: &Subject) {
    let (store, id) = (&subject.store, subject.enqueue("x").await);
    tokio::time::timeout(DEADLINE, subject.notifier.work()).await.expect("new work is announced");
    let mut subscription = subject.notifier.subscribe(id);
    let lease = subject.claim_one().await;
    tokio::time::timeout(DEADLINE, subscription.changed()).await.expect("the start is announced");
    store.cancel(id).await.unwrap();
    let signal = tokio::time::timeout(DEADLINE, subscription.changed())
        .await
        .expect("the wish to stop is announced");
    assert!(signal.cancel_requested && subject.get(id).await.cancel_requested);
    subject.finish(&lease, SolveStatus::Cancelled).await.unwrap();
    tokio::time::timeout(DEADLINE, subscription.finished()).await.expect("the end is announced");
    assert!(subject.get(id).await.state.is_finished());
}

pub async fn old_jobs_are_swept_each_in_its_time(subject: &Subject) {
    let retention = Retention {
        succeeded: Duration::from_hours(2),
        failed: Duration::from_hours(1),
        stored_bytes: None,
    };
    let mut ids = Vec::new();
    for status in [SolveStatus::Converged, SolveStatus::Cancelled] {
        ids.push(subject.enqueue("x").await);
        let lease = subject.claim_one().await;
        subject.finish(&lease, status).await.unwrap();
    }
    let waiting = subject.enqueue("y").await;
    assert_eq!(subject.store.sweep(&retention).await.unwrap(), 0);
    subject.clock.advance(SignedDuration::from_mins(61));
    assert_eq!(subject.store.sweep(&retention).await.unwrap(), 1);
    assert_eq!(subject.page(ALL).await.0, [waiting, ids[0]]);
    subject.clock.advance(SignedDuration::from_mins(60));
    assert_eq!(subject.store.sweep(&retention).await.unwrap(), 1);
    assert_eq!(subject.page(ALL).await.0, [waiting]);
    assert!(matches!(subject.store.result(ids[0]).await, Err(StoreError::NotFound)));
}
