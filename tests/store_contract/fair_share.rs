//! Keys share the places of a worker, and the time of its solvers, whatever they submit.

use brinell::jobs::{ClaimRequest, JobId, KeyId, NewJob, Quota, StoreError, WorkerId};
use brinell_solver::solver::SolveStatus;
use jiff::SignedDuration;

use crate::subject::{QUEUE_CAPACITY, Subject, ids, job};

async fn submit(subject: &Subject, key: KeyId, priority: i16) -> JobId {
    let new = NewJob { submitter: Some(key), priority, ..job("x") };
    subject.submit(new).await.unwrap().job.id
}

/// Solves the next job of the queue in some time.
async fn solve_next(subject: &Subject, time: impl Fn(JobId) -> SignedDuration) -> JobId {
    let lease = subject.claim_one().await;
    subject.clock.advance(time(lease.job));
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
    lease.job
}

pub async fn a_greedy_key_does_not_hold_up_another(subject: &Subject) {
    let [greedy, modest] = [(); 2].map(|()| KeyId::generate());
    let first = submit(subject, greedy, 100).await;
    let second = submit(subject, greedy, 100).await;
    let other = submit(subject, modest, -100).await;
    assert_eq!(ids(&subject.claim(3).await), [first, other, second], "whatever its priority");
}

pub async fn a_key_leaves_a_place_of_a_worker_to_others(subject: &Subject) {
    let [greedy, modest] = [(); 2].map(|()| KeyId::generate());
    let mut of_greedy = Vec::new();
    for _ in 0..3 {
        of_greedy.push(submit(subject, greedy, 100).await);
    }
    let two_solvers = ClaimRequest { places_of_key: 2, ..Subject::request(3) };
    assert_eq!(ids(&subject.claims(two_solvers).await.jobs), of_greedy[..2]);
    let rest = ClaimRequest { places: 1, ..two_solvers };
    assert!(subject.claims(rest).await.jobs.is_empty());
    let other = submit(subject, modest, 0).await;
    assert_eq!(ids(&subject.claims(rest).await.jobs), [other]);
    let elsewhere = ClaimRequest { owner: WorkerId::generate(), ..rest };
    assert_eq!(ids(&subject.claims(elsewhere).await.jobs), of_greedy[2..]);
}

pub async fn keys_share_by_solver_time_and_not_by_number(subject: &Subject) {
    let keys = [(); 2].map(|()| KeyId::generate());
    let times = [1000, 100].map(SignedDuration::from_millis);
    let mut served = [0, 0];
    // Both always have a job waiting.
    let mut waiting = [submit(subject, keys[0], 0).await, submit(subject, keys[1], 0).await];
    for _ in 0..44 {
        let id = solve_next(subject, |id| times[usize::from(id == waiting[1])]).await;
        let which = waiting.iter().position(|job| *job == id).expect("one of the two");
        served[which] += 1;
        waiting[which] = submit(subject, keys[which], 0).await;
    }
    assert!((3..=5).contains(&served[0]), "{served:?}: as much time for each");
}

pub async fn solver_time_is_forgotten_within_a_minute(subject: &Subject) {
    let [busy, idle] = [(); 2].map(|()| KeyId::generate());
    let spend = async || {
        submit(subject, busy, 0).await;
        solve_next(subject, |_| SignedDuration::from_secs(100)).await;
    };
    spend().await;
    subject.clock.advance(SignedDuration::from_secs(50));
    let late = submit(subject, busy, 0).await;
    let first = submit(subject, idle, 0).await;
    assert_eq!(solve_next(subject, |_| SignedDuration::ZERO).await, first);
    assert_eq!(solve_next(subject, |_| SignedDuration::ZERO).await, late);
    spend().await;
    subject.clock.advance(SignedDuration::from_secs(60));
    let early = submit(subject, busy, 0).await;
    submit(subject, idle, 0).await;
    assert_eq!(
        solve_next(subject, |_| SignedDuration::ZERO).await,
        early,
        "the oldest among equals"
    );
}

pub async fn a_small_job_does_not_wait_for_memory(subject: &Subject) {
    let [one, other] = [(); 2].map(|()| KeyId::generate());
    let mut queued = Vec::new();
    for (key, memory) in [(one, 600), (one, 500), (other, 300)] {
        let new = NewJob { submitter: Some(key), memory, ..job("x") };
        queued.push(subject.submit(new).await.unwrap().job.id);
    }
    let request = ClaimRequest { memory_of_place: 10, free_memory: 700, ..Subject::request(4) };
    let large = ClaimRequest { free_memory: 800, ..request };
    assert_eq!(
        ids(&subject.claims(large).await.jobs),
        [queued[0]],
        "the third does not fit and holds up the second"
    );
    let small = NewJob { submitter: Some(one), memory: 10, ..job("x") };
    let small = subject.submit(small).await.unwrap().job.id;
    let beside = ClaimRequest { free_memory: 200, ..request };
    assert_eq!(ids(&subject.claims(beside).await.jobs), [small]);
}

pub async fn a_key_has_its_places_in_the_queue_and_no_more(subject: &Subject) {
    let [greedy, modest] = [(); 2].map(|()| KeyId::generate());
    for _ in 1..QUEUE_CAPACITY {
        submit(subject, greedy, 0).await;
    }
    let refused = subject.submit(NewJob { submitter: Some(greedy), ..job("x") }).await;
    assert!(matches!(
        refused,
        Err(StoreError::QuotaExceeded { quota: Quota::Queued { limit: 3 } })
    ));
    submit(subject, modest, 0).await;
}
