//! Keys share the solvers by the work of their jobs, whatever they submit.

use brinell::jobs::{ClaimRequest, JobId, KeyId, NewJob, Quota, SHORT_WORK, StoreError, WorkerId};

use crate::subject::{QUEUE_CAPACITY, Subject, ids, job};

struct Client {
    key: KeyId,
    interactive: bool,
}

impl Client {
    fn new(interactive: bool) -> Self {
        Self { key: KeyId::generate(), interactive }
    }

    async fn submit(&self, subject: &Subject, work: u64, priority: i16) -> JobId {
        let (submitter, interactive) = (Some(self.key), self.interactive);
        let new = NewJob { submitter, interactive, work, priority, ..job("x") };
        subject.submit(new).await.unwrap().job.id
    }
}

/// The next job of the queue.
async fn next(subject: &Subject) -> JobId {
    let claims = subject.claim(1).await;
    ids(&claims)[0]
}

pub async fn a_greedy_key_does_not_hold_up_another(subject: &Subject) {
    let (greedy, modest) = (Client::new(false), Client::new(false));
    let first = greedy.submit(subject, 10, 100).await;
    let second = greedy.submit(subject, 10, 100).await;
    let other = modest.submit(subject, 10, -100).await;
    assert_eq!(next(subject).await, first);
    assert_eq!(next(subject).await, other, "whatever its priority");
    assert_eq!(next(subject).await, second);
}

pub async fn keys_share_by_work_and_not_by_number(subject: &Subject) {
    let (large, small) = (Client::new(false), Client::new(false));
    let mut served = [0, 0];
    // Both always have a job waiting; one hands in jobs of ten times the work.
    let mut waiting = [large.submit(subject, 100, 0).await, small.submit(subject, 10, 0).await];
    for _ in 0..44 {
        let id = next(subject).await;
        let which = waiting.iter().position(|job| *job == id).expect("one of the two");
        served[which] += 1;
        let (client, work) = if which == 0 { (&large, 100) } else { (&small, 10) };
        waiting[which] = client.submit(subject, work, 0).await;
    }
    assert_eq!(served, [4, 40], "as much work of each");
}

pub async fn waiting_clients_do_not_starve_the_queue(subject: &Subject) {
    let solve = Client::new(true);
    let queue = Client { interactive: false, ..solve };
    let mut served = [0, 0];
    let mut waiting = [solve.submit(subject, 10, 1).await, queue.submit(subject, 10, 0).await];
    for _ in 0..40 {
        let id = next(subject).await;
        let which = waiting.iter().position(|job| *job == id).expect("one of the two");
        served[which] += 1;
        let client = if which == 0 { &solve } else { &queue };
        waiting[which] = client.submit(subject, 10, 0).await;
    }
    assert!((29..=31).contains(&served[0]), "{served:?}: three parts in four");
}

pub async fn keys_share_alike_whichever_way_they_submit(subject: &Subject) {
    let (solve, queue) = (Client::new(true), Client::new(false));
    let mut served = [0, 0];
    let mut waiting = [solve.submit(subject, 10, 1).await, queue.submit(subject, 10, 0).await];
    for _ in 0..20 {
        let id = next(subject).await;
        let which = waiting.iter().position(|job| *job == id).expect("one of the two");
        served[which] += 1;
        let client = if which == 0 { &solve } else { &queue };
        waiting[which] = client.submit(subject, 10, 0).await;
    }
    assert_eq!(served, [10, 10]);
}

pub async fn an_idle_key_does_not_save_up_its_share(subject: &Subject) {
    let (busy, idle) = (Client::new(false), Client::new(false));
    for _ in 0..10 {
        busy.submit(subject, 10, 0).await;
        next(subject).await;
    }
    let mut order = Vec::new();
    let ahead = busy.submit(subject, 10, 0).await;
    let late = [idle.submit(subject, 10, 0).await, idle.submit(subject, 10, 0).await];
    for _ in 0..3 {
        order.push(next(subject).await);
    }
    assert_eq!(order.iter().position(|id| *id == ahead), Some(1), "{order:?} of {ahead} and {late:?}");
}

pub async fn a_key_has_its_places_in_the_queue_and_no_more(subject: &Subject) {
    let (greedy, modest) = (Client::new(false), Client::new(false));
    for _ in 1..QUEUE_CAPACITY {
        greedy.submit(subject, 1, 0).await;
    }
    let refused = subject.submit(NewJob { submitter: Some(greedy.key), ..job("x") }).await;
    assert!(matches!(refused, Err(StoreError::QuotaExceeded { quota: Quota::Queued { limit: 3 } })));
    modest.submit(subject, 1, 0).await;
}

pub async fn short_jobs_are_handed_out_beside_long_ones(subject: &Subject) {
    let (first, other) = (Client::new(false), Client::new(false));
    let long = first.submit(subject, SHORT_WORK + 1, 100).await;
    let short = first.submit(subject, SHORT_WORK, 0).await;
    let second = other.submit(subject, SHORT_WORK, 0).await;
    let beside = ClaimRequest { slots: 0, short_slots: 3, exclusive: false, ..Subject::request(0) };
    let claims = subject.claims(beside).await.jobs;
    assert_eq!(ids(&claims), [short, second]);
    assert!(claims.iter().all(|claim| claim.beside && claim.work == SHORT_WORK));
    let claims = subject.claim(1).await;
    assert_eq!((ids(&claims), claims[0].beside), (vec![long], false));
    let large = NewJob { memory: 11, ..job("x") };
    subject.submit(large).await.unwrap();
    assert!(
        subject.claims(ClaimRequest { short_memory: 10, ..beside }).await.jobs.is_empty(),
        "it does not fit"
    );
}

pub async fn a_key_with_long_jobs_has_part_of_the_places_beside_them(subject: &Subject) {
    let (greedy, modest) = (Client::new(false), Client::new(false));
    let long = greedy.submit(subject, SHORT_WORK + 1, 100).await;
    let request = Subject::request(1);
    let claims = subject.claims(request).await.jobs;
    assert_eq!(ids(&claims), [long]);
    assert!(!claims[0].gives_way, "its work tells that");
    let first = greedy.submit(subject, 1, 0).await;
    let second = greedy.submit(subject, 1, 0).await;
    let other = modest.submit(subject, 1, 0).await;
    let beside = ClaimRequest { slots: 0, short_slots: 3, exclusive: false, ..request };
    let claims = subject.claims(beside).await.jobs;
    let [of_greedy, of_modest] =
        [first, other].map(|id| claims.iter().find(|claim| claim.lease.job == id).unwrap());
    assert_eq!((claims.len(), of_greedy.gives_way, of_modest.gives_way), (2, true, false));
    assert!(subject.claims(beside).await.jobs.is_empty(), "one beside its own long job");
    let elsewhere = ClaimRequest { owner: WorkerId::generate(), ..beside };
    let claims = subject.claims(elsewhere).await.jobs;
    assert_eq!((ids(&claims), claims[0].gives_way), (vec![second], false), "no long job runs there");
}
