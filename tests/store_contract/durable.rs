//! Durability of the stores in databases beyond the process.

use std::sync::Arc;

use brinell::jobs::{Deflated, JobNotifier, JobState, StepResult, StoreError, SystemClock};
use brinell::store::{SqliteError, open_sqlite};
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;
use jiff::SignedDuration;
use tokio::time::timeout;

use crate::cluster::Cluster;
use crate::subject::{
    DEADLINE, HEAD, LIMITS, Place, Subject, clock, iteration, numbered, reported,
};

#[tokio::test]
async fn sqlite_remembers_everything_and_runs_interrupted_jobs_again_at_once() {
    let subject = Subject::sqlite().await;
    let (done, running, queued) = (
        subject.enqueue("done").await,
        subject.enqueue("running").await,
        subject.enqueue("queued").await,
    );
    let claims = subject.claim(2).await;
    let records = [numbered(1), numbered(2)];
    subject
        .store
        .finish(&claims[0].lease, &records, &[], reported(SolveStatus::Converged))
        .await
        .unwrap();
    let Subject { store, clock, place, .. } = subject;
    drop(store);

    let after = Subject::again(place, clock).await;
    assert_eq!(after.store.history(done, 0).await.unwrap(), records);
    assert_eq!(after.head(done).await, HEAD);
    assert_eq!(after.get(queued).await.queue_position, Some(0));
    let stale = after.finish(&claims[1].lease, SolveStatus::Converged).await;
    assert!(stale.is_ok(), "nobody has taken it up yet");
    assert_eq!(after.get(running).await.state, JobState::Succeeded);
    assert_eq!(after.claim_one().await.job, queued);
    let Subject { store, clock, place, .. } = after;
    drop(store);
    let again = Subject::again(place, clock).await;
    let lease = again.claim_one().await;
    assert_eq!((lease.job, lease.attempt), (queued, 2), "without waiting for the lease");
}

#[tokio::test]
async fn a_data_directory_has_one_owner() {
    let subject = Subject::sqlite().await;
    let Place::Directory(directory) = &subject.place else { panic!("a directory") };
    let second =
        open_sqlite(&directory.0, LIMITS, JobNotifier::new(), Arc::new(SystemClock)).await;
    assert!(matches!(second.err(), Some(SqliteError::InUse(_))));
}

#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn processes_hear_of_changes_of_others() {
    let here = Subject::postgres().await;
    let there = Subject::again(here.place.clone(), Arc::clone(&here.clock)).await;
    let id = here.enqueue("x").await;
    timeout(DEADLINE, there.notifier.work()).await.expect("work is heard of");
    let (mut at_worker, mut at_client) =
        (there.notifier.subscribe(id), here.notifier.subscribe(id));
    let lease = there.claim_one().await;
    // The listener may have started only now; then every waiter is woken.
    while here.get(id).await.state != JobState::Running {
        timeout(DEADLINE, at_client.changed()).await.expect("the start is heard of");
    }
    here.store.cancel(id).await.unwrap();
    let heard = async { while !at_worker.changed().await.cancel_requested {} };
    timeout(DEADLINE, heard).await.expect("the wish to stop is heard of");
    there.finish(&lease, SolveStatus::Cancelled).await.unwrap();
    while !here.get(id).await.state.is_finished() {
        timeout(DEADLINE, at_client.changed()).await.expect("the end is heard of");
    }
    assert_eq!(here.head(id).await, HEAD);
}

/// The worker goes on behind them, and writes them once.
#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn progress_and_steps_outlive_a_crash_of_the_server() {
    let mut cluster = Cluster::start();
    let before = Subject::again(Place::Database(cluster.database().await), clock()).await;
    let id = before.enqueue("x").await;
    let lease = before.claim_one().await;
    let records = [numbered(1), numbered(2)];
    before.store.record_progress(&lease, &records, &iteration(2)).await.unwrap();
    let report = Deflated::compress(b"a").unwrap();
    let step = StepResult { number: 0, report, fields: Some(Bytes::from_static(b"A")) };
    before.store.record_steps(&lease, &[step]).await.unwrap();
    cluster.restart();

    let after = Subject::again(before.place.clone(), Arc::clone(&before.clock)).await;
    assert_eq!(after.store.history(id, 0).await.unwrap(), records);
    after.finish(&lease, SolveStatus::Converged).await.unwrap();
    assert_eq!(after.store.step(id, 0).await.unwrap().text().unwrap(), "a");
    assert_eq!(after.store.fields(id, 0, 0).await.unwrap().unwrap().bytes[..], b"A"[..]);
}

#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn a_lost_worker_s_job_is_run_by_another_process() {
    let dead = Subject::postgres().await;
    let alive = Subject::again(dead.place.clone(), Arc::clone(&dead.clock)).await;
    let id = dead.enqueue("x").await;
    let lost = dead.claim_one().await;
    assert!(alive.claim(1).await.is_empty());
    dead.clock.advance(SignedDuration::from_secs(31));
    let lease = alive.claim_one().await;
    assert!(matches!(
        dead.finish(&lost, SolveStatus::Converged).await,
        Err(StoreError::LeaseLost)
    ));
    alive.finish(&lease, SolveStatus::NotConverged).await.unwrap();
    assert_eq!(dead.get(id).await.state, JobState::NotConverged);
}

#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn several_processes_may_start_at_once_on_an_empty_database() {
    let first = Subject::postgres().await;
    let Place::Database(url) = &first.place else { panic!("a database") };
    let empty = Cluster::shared().database().await;
    assert_ne!(url, &empty);
    let place = Place::Database(empty);
    let starts =
        (0..4).map(|_| tokio::spawn(Subject::again(place.clone(), Arc::clone(&first.clock))));
    let mut nodes = Vec::new();
    for start in starts.collect::<Vec<_>>() {
        nodes.push(start.await.unwrap());
    }
    let id = nodes[0].enqueue("x").await;
    for node in &nodes {
        assert_eq!(node.get(id).await.id, id, "an id answers the same everywhere");
    }
}
