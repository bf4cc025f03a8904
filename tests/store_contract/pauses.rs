//! A simulation of processes that stop in the middle of a call, as a machine does that pauses or
//! loses power: what they have begun is neither finished nor undone, and their connections stay
//! open. Seeds choose the call and the moment.

use std::future::Future;
use std::pin::Pin;
use std::sync::Arc;
use std::time::Duration;

use brinell::jobs::{
    CoreSolver, Deflated, JobId, JobNotifier, JobState, Lease, LeaseStatus, NewJob, StepResult,
    StoreError, Turn,
};
use brinell::store::{Store, StoreLimits, open_postgres, open_sqlite_in_memory};
use brinell::worker::{Worker, WorkerSettings};
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;
use jiff::SignedDuration;
use tokio::time::{Instant, timeout};

use crate::cluster::Cluster;
use crate::subject::{
    DEADLINE, LEASE, LIMITS, MEMORY_STORE, Subject, clock, iteration, job, numbered, reported,
};

/// Longest time for which a process that has stopped may hold others up: less than a third of the
/// default lease.
const BOUND: Duration = Duration::from_secs(9);

/// Numbers that only the seed determines (xorshift).
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % sides
    }
}

/// Calls that a process stops in.
const CALLS: [&str; 7] =
    ["claim", "heartbeat", "progress", "steps", "finish", "release", "cancel"];

type Call = Pin<Box<dyn Future<Output = ()> + Send>>;

/// A step whose fields are written in several parts.
fn step() -> StepResult {
    let fields = Some(Bytes::from(vec![7; 700_000]));
    StepResult { number: 0, report: Deflated::compress(b"{}").unwrap(), fields }
}

fn call(name: &str, store: Arc<dyn Store>, lease: Lease) -> Call {
    match name {
        "claim" => Box::pin(async move { drop(store.claim(&Subject::request(1)).await) }),
        "heartbeat" => Box::pin(async move { drop(store.heartbeat(&[lease], LEASE).await) }),
        "progress" => Box::pin(async move {
            drop(store.record_progress(&lease, &[numbered(1), numbered(2)], &iteration(2)).await);
        }),
        "steps" => Box::pin(async move { drop(store.record_steps(&lease, &[step()]).await) }),
        "finish" => Box::pin(async move {
            let outcome = reported(SolveStatus::Converged);
            drop(store.finish(&lease, &[numbered(1)], &[step()], outcome).await);
        }),
        "release" => Box::pin(async move { drop(store.release(&[lease]).await) }),
        _ => Box::pin(async move { drop(store.cancel(lease.job).await) }),
    }
}

/// Makes a call of another process until the store answers it.
async fn insist<T, F: Future<Output = Result<T, StoreError>>>(
    what: &str,
    call: impl Fn() -> F,
) -> T {
    let begin = Instant::now();
    loop {
        match timeout(BOUND.saturating_sub(begin.elapsed()), call()).await {
            Ok(Ok(answer)) => return answer,
            Ok(Err(StoreError::Unavailable(_))) if begin.elapsed() < BOUND => {}
            Ok(Err(error)) => panic!("{what}: {error}"),
            Err(late) => panic!("{what} is held up for {BOUND:?}: {late}"),
        }
    }
}

/// Other processes hand in, claim, end and cancel jobs beside one that has stopped, and take over
/// its job.
async fn others_go_on(others: &Subject, stopped: JobId, what: &str) {
    let store = &others.store;
    let own = insist(what, || store.enqueue(job("other"), Turn::free())).await.job.id;
    let begin = Instant::now();
    let lease = loop {
        assert!(begin.elapsed() < BOUND, "{what}: nobody gets the job");
        let claims = insist(what, || async { store.claim(&Subject::request(1)).await }).await;
        match claims.jobs.first() {
            Some(claim) if claim.lease.job == own => break claim.lease,
            Some(claim) => {
                let outcome = reported(SolveStatus::Converged);
                insist(what, || store.finish(&claim.lease, &[], &[], outcome.clone())).await;
            }
            // The process that has stopped got it: its lease ends.
            None => others.clock.advance(SignedDuration::from_secs(31)),
        }
    };
    insist(what, || async { store.record_progress(&lease, &[numbered(1)], &iteration(1)).await })
        .await;
    let (last, outcome) = ([numbered(2)], reported(SolveStatus::Converged));
    insist(what, || store.finish(&lease, &last, &[], outcome.clone())).await;
    assert_eq!(others.get(own).await.state, JobState::Succeeded, "{what}");
    others.clock.advance(SignedDuration::from_secs(31));
    let begin = Instant::now();
    while !others.get(stopped).await.state.is_finished() {
        assert!(begin.elapsed() < BOUND, "{what}: nobody takes the job over");
        let claims = insist(what, || async { store.claim(&Subject::request(1)).await }).await;
        for claim in claims.jobs {
            let outcome = reported(SolveStatus::Converged);
            insist(what, || store.finish(&claim.lease, &[], &[], outcome.clone())).await;
        }
    }
}

async fn stop_in_calls(seed: u64) {
    let mut dice = Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let others = Subject::postgres().await;
    for name in CALLS {
        let stopping = Subject::again(others.place.clone(), Arc::clone(&others.clock)).await;
        let id = stopping.enqueue("stopped").await;
        let lease = stopping.claim_one().await;
        if name == "claim" {
            others.enqueue("in between").await;
        }
        let what = format!("a process that stops in {name}, seed {seed}");
        let mut begun = call(name, Arc::clone(&stopping.store), lease);
        let moment = Duration::from_micros(dice.roll(6000));
        let _ = timeout(moment, &mut begun).await;
        // From here on nobody polls the call, and its connections stay as they are.
        others_go_on(&others, id, &what).await;
        drop(begun);
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn processes_that_stop_hold_nobody_up() {
    for seed in 1..=2 {
        stop_in_calls(seed).await;
    }
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[ignore = "full"]
async fn processes_that_stop_at_many_moments_hold_nobody_up() {
    for seed in 3..=60 {
        stop_in_calls(seed).await;
    }
}

/// A slow line: a step takes longer to write than the lease lasts, and the worker's heartbeats
/// come as ever.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn a_worker_that_writes_slowly_keeps_its_job() {
    for moment in [1, 3, 6, 10].map(Duration::from_millis) {
        let subject = Subject::postgres().await;
        let id = subject.enqueue("slow").await;
        let lease = subject.claim_one().await;
        let mut writing = call("steps", Arc::clone(&subject.store), lease);
        let is_written = timeout(moment, &mut writing).await.is_ok();
        for _ in 0..4 {
            subject.clock.advance(SignedDuration::from_secs(10));
            let held = LeaseStatus::Held { cancel_requested: false };
            assert_eq!(subject.store.heartbeat(&[lease], LEASE).await.unwrap(), [held]);
        }
        if !is_written {
            timeout(DEADLINE, writing).await.expect("the step is written");
        }
        assert!(subject.claim(1).await.is_empty(), "its lease has been extended");
        subject.finish(&lease, SolveStatus::Converged).await.unwrap();
        let ended = subject.get(id).await;
        assert_eq!((ended.attempts, ended.state), (1, JobState::Succeeded));
    }
}

/// The worker would look again by itself after an hour only.
async fn one_caller_is_served(store: Arc<dyn Store>, notifier: Arc<JobNotifier>) {
    let mut ids = Vec::new();
    for _ in 0..30 {
        let new = NewJob::new(Bytes::from_static(b"{}"));
        ids.push(store.enqueue(new, Turn::free()).await.unwrap().job.id);
    }
    let settings = WorkerSettings {
        slots: 1,
        memory: 1 << 30,
        memory_of_place: 1 << 20,
        job_timeout: DEADLINE,
        lease: LEASE,
        poll: Duration::from_hours(1),
        max_attempts: 2,
        empties_queue: false,
    };
    let worker = Worker::start(
        Arc::clone(&store) as _,
        Arc::clone(&notifier),
        Arc::new(CoreSolver::default()),
        settings,
    );
    let served = async {
        for id in ids {
            let mut subscription = notifier.subscribe(id);
            if !store.get(id).await.unwrap().state.is_finished() {
                subscription.finished().await;
            }
        }
    };
    timeout(DEADLINE, served).await.expect("each end makes room for the next job");
    worker.drain(DEADLINE).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn the_end_of_a_job_makes_room_for_the_next_of_its_key() {
    let limits = StoreLimits { queue_capacity: 100, ..LIMITS };
    let notifier = JobNotifier::new();
    let url = Cluster::shared().database().await;
    let shared = open_postgres(&url, 10, limits, Arc::clone(&notifier), None).await.unwrap();
    one_caller_is_served(shared, notifier).await;
    let notifier = JobNotifier::new();
    let own = open_sqlite_in_memory(MEMORY_STORE, limits, Arc::clone(&notifier), clock()).await;
    one_caller_is_served(own.unwrap(), notifier).await;
}
