//! Announcements of the ends of jobs.

use std::time::Duration;

use brinell::jobs::{CallbackState, Delivery, DeliveryEnd, JobId, NewJob, TraceParent};
use brinell_solver::solver::SolveStatus;
use jiff::SignedDuration;

use crate::subject::{Subject, job};

const URL: &str = "https://hooks.example/";
const TERM: Duration = Duration::from_mins(1);

async fn enqueue(subject: &Subject) -> JobId {
    let new = NewJob { callback_url: Some(URL.to_owned()), ..job("x") };
    subject.submit(new).await.unwrap().job.id
}

async fn due(subject: &Subject) -> Vec<Delivery> {
    subject.store.claim_deliveries(10, TERM).await.unwrap()
}

async fn end(subject: &Subject, delivery: &Delivery, end: DeliveryEnd) {
    subject.store.end_deliveries(&[(delivery.clone(), end)]).await.unwrap();
}

async fn state(subject: &Subject, id: JobId) -> (CallbackState, u32) {
    let callback = subject.store.callback(id).await.unwrap().unwrap();
    (callback.state, callback.attempts)
}

pub async fn an_announcement_is_due_with_the_end_of_its_job(subject: &Subject) {
    let [finished, cancelled, released] =
        [enqueue(subject).await, enqueue(subject).await, enqueue(subject).await];
    let silent = subject.enqueue("x").await;
    assert!(subject.get(finished).await.has_callback && !subject.get(silent).await.has_callback);
    assert_eq!(subject.store.callback(silent).await.unwrap(), None);
    let lease = subject.claim_one().await;
    assert!(due(subject).await.is_empty());
    assert_eq!(state(subject, finished).await, (CallbackState::Waiting, 0));
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    subject.store.cancel(cancelled).await.unwrap();
    let lease = subject.claim_one().await;
    subject.store.cancel(released).await.unwrap();
    subject.store.release(&[lease]).await.unwrap();
    let due = due(subject).await;
    let mut jobs: Vec<JobId> = due.iter().map(|delivery| delivery.job).collect();
    jobs.sort();
    assert_eq!(jobs, [finished, cancelled, released]);
    assert!(due.iter().all(|delivery| delivery.url == URL && delivery.attempt == 1));
}

pub async fn the_end_of_a_lost_job_is_announced(subject: &Subject) {
    let id = enqueue(subject).await;
    subject.claim_one().await;
    subject.store.cancel(id).await.unwrap();
    subject.clock.advance(SignedDuration::from_hours(1));
    assert!(subject.claim(1).await.is_empty());
    assert_eq!(due(subject).await.len(), 1);
}

pub async fn an_attempt_is_made_again_until_its_end_is_told(subject: &Subject) {
    let id = enqueue(subject).await;
    subject.store.cancel(id).await.unwrap();
    let first = due(subject).await.remove(0);
    assert!(due(subject).await.is_empty(), "it is being made");
    subject.clock.advance(SignedDuration::from_secs(61));
    let second = due(subject).await.remove(0);
    assert_eq!((second.attempt, second.id), (2, first.id));
    // The first is heard of after all, too late.
    end(subject, &first, DeliveryEnd::Delivered { status: 200 }).await;
    assert_eq!(state(subject, id).await, (CallbackState::Pending, 2));
    let failed = |retry| DeliveryEnd::Failed { status: Some(500), error: "no".to_owned(), retry };
    end(subject, &second, failed(Some(Duration::from_secs(10)))).await;
    let callback = subject.store.callback(id).await.unwrap().unwrap();
    assert_eq!((callback.last_status, callback.last_error.as_deref()), (Some(500), Some("no")));
    assert!(callback.next_attempt_at.is_some() && due(subject).await.is_empty());
    subject.clock.advance(SignedDuration::from_secs(11));
    let third = due(subject).await.remove(0);
    let postponed = DeliveryEnd::Postponed { retry: Duration::from_secs(1) };
    end(subject, &third, postponed).await;
    subject.clock.advance(SignedDuration::from_secs(2));
    let third = due(subject).await.remove(0);
    assert_eq!(third.attempt, 3, "there was no attempt");
    end(subject, &third, DeliveryEnd::Delivered { status: 204 }).await;
    let callback = subject.store.callback(id).await.unwrap().unwrap();
    assert_eq!((callback.state, callback.attempts), (CallbackState::Delivered, 3));
    assert!(callback.delivered_at.is_some() && callback.last_error.is_none());
    subject.clock.advance(SignedDuration::from_hours(100));
    assert!(due(subject).await.is_empty());
}

pub async fn abandoned_announcements_are_not_due_again(subject: &Subject) {
    let id = enqueue(subject).await;
    subject.store.cancel(id).await.unwrap();
    let delivery = due(subject).await.remove(0);
    let gone = DeliveryEnd::Failed { status: None, error: "gone".to_owned(), retry: None };
    end(subject, &delivery, gone).await;
    subject.clock.advance(SignedDuration::from_hours(100));
    assert!(due(subject).await.is_empty());
    assert_eq!(state(subject, id).await, (CallbackState::Failed, 1));
    subject.store.delete(id).await.unwrap();
    assert_eq!(subject.store.callback(id).await.unwrap(), None);
}

pub async fn many_at_once_never_get_the_same_announcement(subject: &Subject) {
    let mut ids = Vec::new();
    for _ in 0..24 {
        let id = enqueue(subject).await;
        subject.store.cancel(id).await.unwrap();
        ids.push(id);
    }
    let claims = (0..8).map(|_| {
        let store = subject.store.clone();
        tokio::spawn(async move { store.claim_deliveries(5, TERM).await.unwrap() })
    });
    let mut claimed = Vec::new();
    for claim in claims.collect::<Vec<_>>() {
        claimed.extend(claim.await.unwrap().into_iter().map(|delivery| delivery.job));
    }
    claimed.extend(due(subject).await.into_iter().map(|delivery| delivery.job));
    claimed.extend(due(subject).await.into_iter().map(|delivery| delivery.job));
    claimed.extend(due(subject).await.into_iter().map(|delivery| delivery.job));
    claimed.sort();
    assert_eq!(claimed, ids);
}

pub async fn the_trace_of_a_submission_goes_with_its_job(subject: &Subject) {
    let trace: TraceParent =
        "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01".parse().unwrap();
    let new = NewJob { callback_url: Some(URL.to_owned()), trace: Some(trace), ..job("x") };
    subject.submit(new).await.unwrap();
    subject.enqueue("y").await;
    let claims = subject.claim(2).await;
    assert_eq!([claims[0].trace, claims[1].trace], [Some(trace), None]);
    subject.finish(&claims[0].lease, SolveStatus::Converged).await.unwrap();
    assert_eq!(due(subject).await[0].trace, Some(trace));
}
