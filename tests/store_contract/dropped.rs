//! Requests that are dropped at any time before they are answered.

use std::future::poll_fn;
use std::pin::pin;
use std::sync::Arc;
use std::task::Poll;

use brinell::jobs::{
    CoreSolver, Idempotency, JobFilter, JobService, KeyLimits, NewJob, Submission,
    SubmissionLimits, SubmitError, Turn,
};
use tokio::task::yield_now;
use tokio::time::{Instant, timeout};

use crate::subject::{DEADLINE, Subject, job};

pub const JOB: &str = include_str!("../../api/examples/two_cylinders.json");
/// Times a request is polled before it is dropped, at most.
const POLLS: usize = 40;

pub fn service(subject: &Subject) -> Arc<JobService> {
    let limits = SubmissionLimits { job_bytes: u64::MAX, result_bytes: u64::MAX };
    let (store, notifier) = (&subject.store, Arc::clone(&subject.notifier));
    let solver = Arc::new(CoreSolver::with_cache(0));
    Arc::new(JobService::new(
        store.clone(),
        notifier,
        solver,
        store.clone(),
        store.clone(),
        limits,
    ))
}

/// Polls a request some times, each time that it asks for it, and drops it; `true` if it came to
/// its end.
async fn dropped_after(polls: usize, request: impl Future) -> bool {
    let mut request = pin!(request);
    let mut left = polls;
    poll_fn(|context| {
        if left == 0 {
            return Poll::Ready(false);
        }
        left -= 1;
        request.as_mut().poll(context).map(|_| true)
    })
    .await
}

async fn soon(mut holds: impl AsyncFnMut() -> bool) -> bool {
    let deadline = Instant::now() + DEADLINE;
    while !holds().await {
        if Instant::now() > deadline {
            return false;
        }
        yield_now().await;
    }
    true
}

/// Waits until what was begun for a client is over: all of it holds the service, or its store.
async fn over<T: ?Sized>(held: &Arc<T>, holders: usize) {
    assert!(soon(async || Arc::strong_count(held) == holders).await, "something goes on");
}

pub async fn a_client_that_goes_leaves_no_job_behind(subject: &Subject) {
    let jobs = service(subject);
    for polls in 0..POLLS {
        let submission =
            Submission { request: JOB.into(), interactive: true, ..Submission::default() };
        // What came to its end is dropped too.
        dropped_after(polls, jobs.submit_attended(submission)).await;
        over(&jobs, 1).await;
        let page =
            jobs.store().list(&JobFilter { limit: 100, ..JobFilter::default() }).await.unwrap();
        let all_ended = page.jobs.iter().all(|job| job.state.is_finished());
        assert!(all_ended, "a job goes on after {polls} polls");
    }
}

pub async fn a_client_that_means_to_come_again_finds_its_job(subject: &Subject) {
    let jobs = service(subject);
    let submission = |name: &str| Submission {
        request: JOB.into(),
        interactive: true,
        idempotency_key: Some(name.to_owned()),
        ..Submission::default()
    };
    let (first, attended) = jobs.submit_attended(submission("press-7")).await.unwrap();
    drop(attended);
    over(&jobs, 1).await;
    let (again, _attended) = jobs.submit_attended(submission("press-7")).await.unwrap();
    assert!(again.replayed && again.job.id == first.job.id && !again.job.state.is_finished());
}

pub async fn changes_are_announced_although_their_client_has_gone(subject: &Subject) {
    let jobs = service(subject);
    for polls in 0..POLLS {
        let id = subject.enqueue("x").await;
        let lease = subject.claim_one().await;
        let mut subscription = jobs.subscribe(id);
        let holders = Arc::strong_count(&subject.store);
        dropped_after(polls, jobs.cancel(id, None)).await;
        over(&subject.store, holders).await;
        if subject.get(id).await.cancel_requested {
            let told = timeout(DEADLINE, async {
                while !subscription.changed().await.cancel_requested {}
            });
            told.await.unwrap_or_else(|_| panic!("a job is not told to stop after {polls} polls"));
        }
        subject.store.release(&[lease]).await.unwrap();
        jobs.cancel(id, None).await.unwrap();
    }
}

pub async fn names_in_any_order_are_taken_in_together(subject: &Subject) {
    for round in 0_u8..10 {
        let names: Vec<String> = (0..3).map(|k| format!("{round} {k}")).collect();
        let batch = |names: Vec<String>| {
            let store = subject.store.clone();
            let jobs = names.into_iter().map(|key| {
                let idempotency = Some(Idempotency { key, digest: [0; 32] });
                NewJob { idempotency, ..job("x") }
            });
            let jobs = jobs.collect();
            tokio::spawn(async move { store.enqueue_all(jobs, Turn::free()).await })
        };
        let begin = Instant::now();
        let both = [batch(names.clone()), batch(names.into_iter().rev().collect())];
        let mut fresh = 0;
        for taken in both {
            let taken = taken.await.unwrap().expect("neither waits for the other for ever");
            fresh += taken.iter().filter(|taken| !taken.as_ref().unwrap().replayed).count();
        }
        assert_eq!(fresh, 3);
        assert!(begin.elapsed() < DEADLINE);
        let page =
            subject.store.list(&JobFilter { limit: 100, ..JobFilter::default() }).await.unwrap();
        for record in page.jobs {
            subject.store.cancel(record.id).await.unwrap();
        }
    }
}

pub async fn waiting_submissions_end_when_the_service_closes(subject: &Subject) {
    let jobs = service(subject);
    let limits = KeyLimits { stored_bytes: Some(1 << 30), ..KeyLimits::default() };
    let submitter = Some(crate::quotas::key(subject, limits).await);
    let submissions: Vec<_> = (0..50)
        .map(|_| {
            let jobs = Arc::clone(&jobs);
            let submission =
                Submission { request: JOB.into(), submitter, ..Submission::default() };
            tokio::spawn(async move { jobs.submit(submission).await })
        })
        .collect();
    jobs.close();
    let (mut accepted, mut refused) = (0, 0);
    for submission in submissions {
        match submission.await.unwrap() {
            Ok(_) => accepted += 1,
            Err(SubmitError::Closed) => refused += 1,
            Err(error) => panic!("{error:?}"),
        }
    }
    let page =
        subject.store.list(&JobFilter { limit: 100, ..JobFilter::default() }).await.unwrap();
    assert_eq!(page.jobs.len(), accepted);
    assert!(refused >= 45, "{refused} of 50 were told");
}

/// A sweep of a thousand loads takes milliseconds to check.
#[tokio::test]
async fn checks_leave_the_runtime_to_others() {
    let jobs = service(&Subject::memory(crate::subject::MEMORY_STORE).await);
    let loads: Vec<String> = (400..1400).map(|force| force.to_string()).collect();
    let mut sweep: serde_json::Value = serde_json::from_str(JOB).unwrap();
    sweep["load"] =
        serde_json::from_str(&format!("{{\"forces\": [{}]}}", loads.join(", "))).unwrap();
    let mut check = Box::pin(jobs.validate(sweep.to_string().into(), None));
    let mut turns_of_others = 0;
    let estimate = loop {
        tokio::select! {
            biased;
            estimate = &mut check => break estimate,
            () = tokio::task::yield_now() => turns_of_others += 1,
        }
    };
    estimate.unwrap();
    assert!(turns_of_others > 10, "{turns_of_others}");
}
