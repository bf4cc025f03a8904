//! A database that the first version left behind opens, and everything in it is there.

use std::collections::BTreeMap;

use brinell::jobs::{Idempotency, JobId, JobState, NewJob, Scope, Turn};
use brinell_solver::solver::SolveStatus;
use sqlx::{Connection, PgConnection, SqliteConnection};

use crate::subject::{ALL, Place, Subject, clock, job};

const SQLITE: &str = include_str!("first_version/sqlite.sql");
const POSTGRES: &str = include_str!("first_version/postgres.sql");

#[tokio::test]
async fn sqlite_of_the_first_version_opens() {
    let place = Subject::directory();
    let Place::Directory(directory) = &place else { panic!("a directory") };
    std::fs::create_dir_all(&directory.0).unwrap();
    let url = format!("sqlite://{}/brinell.db?mode=rwc", directory.0.display());
    let mut database = SqliteConnection::connect(&url).await.unwrap();
    sqlx::raw_sql(SQLITE).execute(&mut database).await.unwrap();
    database.close().await.unwrap();

    let subject = Subject::again(place, clock()).await;
    everything_is_there(&subject).await;
    // One process owns the directory: what was running was interrupted, and runs again at once.
    let next = subject.claims(brinell::jobs::ClaimRequest {
        memory: 1 << 30,
        free_memory: 1 << 30,
        ..Subject::request(1)
    });
    let lease = next.await.jobs[0].lease;
    assert_eq!(
        (subject.get(lease.job).await.tags["place"].as_str(), lease.attempt),
        ("running", 2)
    );
    subject.finish(&lease, SolveStatus::Converged).await.unwrap();
}

#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn postgres_of_the_first_version_opens() {
    let url = crate::cluster::Cluster::shared().database().await;
    let mut database = PgConnection::connect(&url).await.unwrap();
    sqlx::raw_sql(POSTGRES).execute(&mut database).await.unwrap();
    database.close().await.unwrap();
    everything_is_there(&Subject::again(Place::Database(url), clock()).await).await;
}

async fn everything_is_there(subject: &Subject) {
    let store = &subject.store;
    let page = store.list(&ALL).await.unwrap();
    let by_tag: BTreeMap<&str, (JobId, JobState)> = page
        .jobs
        .iter()
        .map(|job| (job.tags.values().next().unwrap().as_str(), (job.id, job.state)))
        .collect();
    let states: Vec<_> = by_tag.iter().map(|(tag, (_, state))| (*tag, *state)).collect();
    let expected = [
        ("NU-210", JobState::Succeeded),
        ("cancelled", JobState::Cancelled),
        ("queued", JobState::Queued),
        ("running", JobState::Running),
    ];
    assert_eq!(states, expected);

    let (done, _) = by_tag["NU-210"];
    let record = subject.get(done).await;
    assert!(record.finished_at > record.started_at && record.has_report && record.iterations > 5);
    assert_eq!(store.history(done, 0).await.unwrap().len(), record.iterations);
    // A result of that version has no rows; it is there, and refused where it is asked for.
    let head: serde_json::Value = serde_json::from_slice(&subject.head(done).await).unwrap();
    assert_eq!([&head["status"], &head["version"]], ["converged", "0.1.0"]);
    let request = store.request(done).await.unwrap();
    brinell_solver::job::Job::from_json(&request).expect("what was a job is a job");

    let digest =
        sha2::Digest::finalize(<sha2::Sha256 as sha2::Digest>::new_with_prefix(&request)).into();
    let again = NewJob {
        idempotency: Some(Idempotency { key: "press-7".to_owned(), digest }),
        ..job("x")
    };
    let replayed = store.enqueue(again, Turn::free()).await.unwrap();
    assert_eq!((replayed.replayed, replayed.job.id), (true, done));

    let keys = store.keys(None).await.unwrap();
    assert_eq!((keys.len(), keys[0].name.as_str(), keys[0].scope), (1, "first", Scope::Admin));
    assert_eq!(subject.get(by_tag["queued"].0).await.priority, 5);
}
