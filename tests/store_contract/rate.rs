//! What PostgreSQL takes: claims a second, and the share of changes that touch no index (HOT).
//!
//! `cargo test --release --test store_contract rate -- --ignored --nocapture`

use std::sync::Arc;

use brinell::jobs::{ClaimRequest, JobNotifier, NewJob, Turn};
use brinell::store::{Store, StoreLimits, open_postgres};
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;
use sqlx::{Connection, PgConnection};
use tokio::time::Instant;

use crate::cluster::Cluster;
use crate::subject::{LEASE, Subject, iteration, numbered, reported};

const JOBS: usize = 1000;
const LIMITS: StoreLimits = StoreLimits { queue_capacity: 100_000, ..unbounded() };
/// What the table had until migration 8.
const BEFORE: &str = "CREATE INDEX jobs_running ON jobs (leased_until) WHERE state = 'running';
    ALTER TABLE jobs SET (fillfactor = 100)";

const fn unbounded() -> StoreLimits {
    StoreLimits {
        queue_capacity: 0,
        by_key: brinell::jobs::KeyLimits {
            queued: None,
            running: None,
            stored_bytes: None,
            priority: None,
        },
        min_free_bytes: 0,
    }
}

async fn open(url: &str) -> Arc<dyn Store> {
    open_postgres(url, 10, LIMITS, JobNotifier::new(), None).await.unwrap()
}

/// Hands out jobs one by one, writes of each what a worker writes of a job of a second, and ends
/// it. Returns how many.
async fn work(store: Arc<dyn Store>) -> usize {
    let request = ClaimRequest { ..Subject::request(1) };
    let mut done = 0;
    loop {
        let claims = store.claim(&request).await.unwrap().jobs;
        let Some(claim) = claims.first() else { return done };
        for number in 1..=3 {
            store
                .record_progress(&claim.lease, &[numbered(number)], &iteration(number))
                .await
                .unwrap();
        }
        store.heartbeat(&[claim.lease], LEASE).await.unwrap();
        store
            .finish(&claim.lease, &[numbered(4)], &[], reported(SolveStatus::Converged))
            .await
            .unwrap();
        done += 1;
    }
}

async fn measure(workers: usize, before: bool) {
    let url = Cluster::shared().database().await;
    let store = open(&url).await;
    let mut database = PgConnection::connect(&url).await.unwrap();
    if before {
        sqlx::raw_sql(BEFORE).execute(&mut database).await.unwrap();
    }
    for _ in 0..JOBS / 100 {
        let jobs = (0..100).map(|_| NewJob::new(Bytes::from_static(b"{}"))).collect();
        store.enqueue_all(jobs, Turn::free()).await.unwrap();
    }
    let mut stores = Vec::new();
    for _ in 0..workers {
        stores.push(open(&url).await);
    }
    let begin = Instant::now();
    let working: Vec<_> = stores.into_iter().map(|store| tokio::spawn(work(store))).collect();
    let mut done = 0;
    for worker in working {
        done += worker.await.unwrap();
    }
    let seconds = begin.elapsed().as_secs_f64();
    assert_eq!(done, JOBS);
    let changes =
        "SELECT n_tup_upd, n_tup_hot_upd FROM pg_stat_user_tables WHERE relname = 'jobs'";
    let hot = loop {
        let (all, hot): (i64, i64) =
            sqlx::query_as(changes).fetch_one(&mut database).await.unwrap();
        // Other sessions tell of theirs when they have nothing to do.
        if all >= i64::try_from(6 * JOBS).unwrap() {
            break hot as f64 / all as f64;
        }
    };
    println!(
        "{workers} workers, {}: {:.0} claims a second, each with six further changes; {:.0} % of \
         the changes of `jobs` are HOT",
        if before { "before migration 8" } else { "now" },
        done as f64 / seconds,
        100.0 * hot
    );
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[ignore = "measures"]
async fn claims_a_second() {
    measure(4, true).await;
    for workers in [1, 4, 16] {
        measure(workers, false).await;
    }
}
