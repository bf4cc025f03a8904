//! What becomes of jobs that somebody waits for, beside those that must survive.

use brinell::jobs::{ClaimRequest, JobState, LeaseStatus, NewJob, StoreError};
use brinell_solver::solver::SolveStatus;

use crate::subject::{ALL, LEASE, Subject, ids, iteration, job};

/// A store with both lanes; jobs of [`Subject::enqueue`] are ephemeral.
async fn both() -> Subject {
    Subject::express().await
}

async fn durable(subject: &Subject, tag: &str) -> brinell::jobs::JobId {
    subject.store.enqueue(job(tag)).await.unwrap().job.id
}

/// What the next process finds.
async fn after_a_crash(subject: Subject) -> Subject {
    let Subject { store, clock, place, .. } = subject;
    drop(store);
    Subject::again(place, clock).await
}

#[tokio::test]
async fn an_ephemeral_job_ends_with_the_process_and_others_do_not() {
    let subject = both().await;
    let (gone, stays) = (subject.enqueue("gone").await, durable(&subject, "stays").await);
    let after = after_a_crash(subject).await;
    assert!(matches!(after.store.get(gone).await, Err(StoreError::NotFound)));
    assert_eq!(after.get(stays).await.state, JobState::Queued);
}

#[tokio::test]
async fn a_queued_job_that_is_kept_survives() {
    let subject = both().await;
    let id = subject.enqueue("kept").await;
    let kept = subject.store.keep(id).await.unwrap();
    assert_eq!((kept.state, kept.queue_position), (JobState::Queued, Some(0)));
    let after = after_a_crash(subject).await;
    let record = after.get(id).await;
    assert_eq!((record.state, record.tags["name"].as_str()), (JobState::Queued, "kept"));
    assert_eq!(after.store.request(id).await.unwrap(), "{\"job\": \"kept\"}");
    assert_eq!(after.claim_one().await.job, id);
}

#[tokio::test]
async fn a_running_job_that_is_kept_goes_on_under_its_lease() {
    let subject = both().await;
    let id = subject.enqueue("kept").await;
    let lease = subject.claim_one().await;
    subject.store.record_progress(&lease, &[iteration(1)]).await.unwrap();
    let before = subject.get(id).await;
    let kept = subject.store.keep(id).await.unwrap();
    assert_eq!(kept, before);

    let beats = subject.store.heartbeat(&[lease], LEASE).await.unwrap();
    assert_eq!(beats, [LeaseStatus::Held { cancel_requested: false }]);
    subject.store.record_progress(&lease, &[iteration(2)]).await.unwrap();
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    let after = after_a_crash(subject).await;
    assert_eq!(after.get(id).await.state, JobState::Succeeded);
    assert_eq!(after.store.history(id, 0).await.unwrap(), [iteration(1), iteration(2)]);
    assert_eq!(after.store.report(id).await.unwrap().unwrap(), "{\"report\": 1}");
}

#[tokio::test]
async fn a_running_job_that_is_kept_runs_again_after_a_crash() {
    let subject = both().await;
    let id = subject.enqueue("kept").await;
    subject.claim_one().await;
    subject.store.keep(id).await.unwrap();
    let after = after_a_crash(subject).await;
    let lease = after.claim_one().await;
    assert_eq!((lease.job, lease.attempt), (id, 2));
}

#[tokio::test]
async fn keeping_what_has_finished_or_is_kept_changes_nothing() {
    let subject = both().await;
    let (finished, kept) = (subject.enqueue("finished").await, durable(&subject, "kept").await);
    let lease = subject.claim_one().await;
    assert_eq!(lease.job, finished, "who waits goes first");
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    assert_eq!(subject.store.keep(finished).await.unwrap().state, JobState::Succeeded);
    assert_eq!(subject.store.keep(kept).await.unwrap().state, JobState::Queued);
    let unknown = brinell::jobs::JobId::generate();
    assert!(matches!(subject.store.keep(unknown).await, Err(StoreError::NotFound)));
}

#[tokio::test]
async fn both_lanes_share_solvers_and_memory() {
    let subject = both().await;
    let large = |tag: &str, ephemeral| NewJob { memory: 400, ephemeral, ..job(tag) };
    let mut submitted = Vec::new();
    for (tag, ephemeral) in [("a", false), ("b", true), ("c", false), ("d", true)] {
        submitted.push(subject.store.enqueue(large(tag, ephemeral)).await.unwrap().job.id);
    }
    let request = ClaimRequest { free_memory: 1200, memory: 2000, ..Subject::request(4) };
    let claims = subject.claims(request).await.jobs;
    assert_eq!(ids(&claims), [submitted[1], submitted[3], submitted[0]], "1200 bytes hold three of 400");
    let page = subject.page(brinell::jobs::JobFilter { limit: 3, ..ALL }).await;
    let newest_first: Vec<_> = submitted.iter().rev().copied().collect();
    assert_eq!(page, (newest_first[..3].to_vec(), Some(submitted[1])));
    let counts = subject.store.counts().await.unwrap();
    assert_eq!((counts[&JobState::Running], counts[&JobState::Queued]), (3, 1));
    let leases: Vec<_> = claims.iter().map(|claim| claim.lease).collect();
    subject.store.release(&leases).await.unwrap();
    assert_eq!(subject.store.counts().await.unwrap()[&JobState::Queued], 4);
}
