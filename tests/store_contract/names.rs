//! Repeated submissions.

use std::sync::Arc;

use brinell::jobs::{Idempotency, KeyId, NewJob, StoreError, Turn};
use brinell_solver::solver::SolveStatus;

use crate::subject::{ALL, QUEUE_CAPACITY, Subject, job};

fn named(name: &str, digest: u8) -> NewJob {
    NewJob {
        idempotency: Some(Idempotency { key: name.to_owned(), digest: [digest; 32] }),
        ..job("x")
    }
}

pub async fn the_same_name_is_the_same_job(subject: &Subject) {
    let first = subject.submit(named("a", 1)).await.unwrap();
    let again = subject.submit(named("a", 1)).await.unwrap();
    assert_eq!((first.replayed, again.replayed, again.job.id), (false, true, first.job.id));
    assert!(matches!(subject.submit(named("a", 2)).await, Err(StoreError::KeyReused)));
    assert_ne!(subject.submit(named("b", 1)).await.unwrap().job.id, first.job.id);
    let other_key = NewJob { submitter: Some(KeyId::generate()), ..named("a", 2) };
    assert!(
        !subject.submit(other_key).await.unwrap().replayed,
        "names of different keys do not meet"
    );
    assert_eq!(subject.page(ALL).await.0.len(), 3);
}

pub async fn a_name_is_free_again_with_its_job(subject: &Subject) {
    let first = subject.submit(named("a", 1)).await.unwrap().job.id;
    let lease = subject.claim_one().await;
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    assert!(subject.submit(named("a", 1)).await.unwrap().replayed);
    subject.store.delete(first).await.unwrap();
    assert!(!subject.submit(named("a", 2)).await.unwrap().replayed);
}

pub async fn a_refused_job_does_not_take_its_name(subject: &Subject) {
    for _ in 0..QUEUE_CAPACITY {
        subject.enqueue("x").await;
    }
    assert!(matches!(subject.submit(named("a", 1)).await, Err(StoreError::QueueFull { .. })));
    subject.claim_one().await;
    assert!(!subject.submit(named("a", 2)).await.unwrap().replayed);
    assert!(subject.submit(named("a", 2)).await.unwrap().replayed, "a full queue still replays");
}

pub async fn the_same_name_at_the_same_instant_is_one_job(subject: &Subject) {
    let submissions = (0..8).map(|_| {
        let store = subject.store.clone();
        tokio::spawn(async move { store.enqueue(named("a", 1), Turn::free()).await.unwrap() })
    });
    let (mut ids, mut fresh) = (Vec::new(), 0);
    for submission in submissions.collect::<Vec<_>>() {
        let enqueued = submission.await.unwrap();
        fresh += usize::from(!enqueued.replayed);
        ids.push(enqueued.job.id);
    }
    ids.dedup();
    assert_eq!((ids.len(), fresh), (1, 1));
}

pub async fn jobs_together_are_taken_in_or_refused_one_by_one(subject: &Subject) {
    let first = subject.submit(named("a", 1)).await.unwrap().job.id;
    let all = |names: &[(&str, u8)]| {
        names.iter().map(|(name, digest)| named(name, *digest)).collect::<Vec<_>>()
    };
    let together =
        all(&[("b", 1), ("a", 1), ("a", 2), ("c", 1), ("b", 1), ("d", 1), ("e", 1), ("f", 1)]);
    let taken = subject.store.enqueue_all(together, Turn::free()).await.unwrap();
    let told: Vec<_> = taken
        .iter()
        .map(|taken| match taken {
            Ok(enqueued) if enqueued.replayed => "replayed",
            Ok(_) => "new",
            Err(StoreError::KeyReused) => "reused",
            Err(StoreError::QueueFull { .. }) => "full",
            Err(_) => "other",
        })
        .collect();
    assert_eq!(told, ["new", "replayed", "reused", "new", "replayed", "new", "full", "full"]);
    assert_eq!(taken[1].as_ref().unwrap().job.id, first);
    assert_eq!(subject.page(ALL).await.0.len(), QUEUE_CAPACITY);
    subject.claim_one().await;
    assert!(
        !subject.submit(named("e", 2)).await.unwrap().replayed,
        "a refused job does not take its name"
    );
}

/// On a store without jobs the first batch also makes what the queue needs to know of its
/// submitter.
pub async fn batches_with_and_without_names_do_not_lock_each_other_out(subject: &Subject) {
    let batches = (0..6u8).map(|k| {
        let names = [0, 1].map(|n| named(&format!("{k}{n}"), 1));
        let [nameless, others] = [job("x"), job("y")].map(|job| vec![job]);
        let jobs = if k % 2 == 0 {
            [nameless, names.to_vec(), others]
        } else {
            [names.to_vec(), nameless, others]
        };
        let store = Arc::clone(&subject.store);
        tokio::spawn(async move { store.enqueue_all(jobs.concat(), Turn::free()).await })
    });
    for batch in batches.collect::<Vec<_>>() {
        for taken in batch.await.unwrap().unwrap() {
            assert!(matches!(taken, Ok(_) | Err(StoreError::QueueFull { .. })), "{taken:?}");
        }
    }
    assert_eq!(subject.page(ALL).await.0.len(), QUEUE_CAPACITY);
}
