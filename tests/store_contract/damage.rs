//! Damaged rows are reported as damaged and do not affect other jobs.

use brinell::jobs::{FIELDS_PART, JobId, NewJob, StepResult, StoreError, Turn};
use brinell_solver::report::{FieldsReport, PerBody, encode_fields};
use brinell_solver::solver::SolveStatus;
use sqlx::{Connection, PgConnection, SqliteConnection};

use crate::subject::{ALL, Place, Subject, job, numbered, reported};

/// Changes rows behind the back of the store.
async fn execute(place: &Place, statement: &'static str, id: JobId) {
    match place {
        Place::Memory => panic!("memory is not shared"),
        Place::Directory(directory) => {
            let url = format!("sqlite://{}/brinell.db", directory.0.display());
            let mut database = SqliteConnection::connect(&url).await.unwrap();
            sqlx::query(statement).bind(id.uuid()).execute(&mut database).await.unwrap();
        }
        Place::Database(url) => {
            let mut database = PgConnection::connect(url).await.unwrap();
            sqlx::query(statement).bind(id.uuid()).execute(&mut database).await.unwrap();
        }
    }
}

#[tokio::test]
async fn damaged_rows_of_sqlite_are_told() {
    damaged_rows_are_told(&Subject::sqlite().await).await;
}

#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn damaged_rows_of_postgres_are_told() {
    damaged_rows_are_told(&Subject::postgres().await).await;
}

async fn damaged_rows_are_told(subject: &Subject) {
    let store = &subject.store;
    let [text, tags, sound] =
        [subject.enqueue("a").await, subject.enqueue("b").await, subject.enqueue("c").await];
    assert_eq!(store.check(true).await.unwrap(), Vec::<String>::new());
    execute(&subject.place, "UPDATE requests SET body = substr(body, 1, 9) WHERE job = $1", text)
        .await;
    execute(&subject.place, "UPDATE jobs SET tags = '{' WHERE id = $1", tags).await;
    assert!(matches!(store.request(text).await, Err(StoreError::Damaged(_))));
    assert!(matches!(store.get(tags).await, Err(StoreError::Damaged(_))));
    let found = store.check(true).await.unwrap();
    assert!(found.len() == 2 && found[0].starts_with(&format!("job {text}: ")), "{found:?}");
    assert!(found[1].starts_with(&format!("job {tags}: ")), "{found:?}");
    let (listed, _) = subject.page(ALL).await;
    assert_eq!(listed, [sound, text], "one damaged row does not hide the others");

    let claims = subject.claim(3).await;
    assert_eq!(claims.len(), 3, "the queue goes on");
    assert!(claims[0].request.is_empty() && !claims[2].request.is_empty());
    let step = |fields: &'static [u8]| StepResult {
        number: 0,
        report: brinell::jobs::Deflated::compress(b"{}").unwrap(),
        fields: Some(fields.into()),
    };
    let steps = [step(b"no arrays")];
    store.finish(&claims[2].lease, &[], &steps, reported(SolveStatus::Converged)).await.unwrap();
    let found = store.check(true).await.unwrap();
    assert!(found[2].starts_with(&format!("job {sound}: ")), "{found:?}");
}

#[tokio::test]
async fn damage_in_every_table_of_sqlite_is_found() {
    damage_in_every_table_is_found(&Subject::sqlite().await).await;
}

#[tokio::test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
async fn damage_in_every_table_of_postgres_is_found() {
    damage_in_every_table_is_found(&Subject::postgres().await).await;
}

/// A job with everything that a job can have.
async fn rich_job(subject: &Subject) -> JobId {
    let callback_url = Some("https://hooks.example/".to_owned());
    let id = subject
        .store
        .enqueue(NewJob { callback_url, ..job("x") }, Turn::free())
        .await
        .unwrap()
        .job
        .id;
    let lease = subject.claim_one().await;
    let fields = FieldsReport { nodes: vec![[0.0; 2]; 40_000], ..FieldsReport::default() };
    let fields = encode_fields(&PerBody { upper: Some(fields), lower: None }).unwrap();
    assert!(fields.len() > 2 * FIELDS_PART);
    let report = brinell::jobs::Deflated::compress(b"{}").unwrap();
    let steps = [StepResult { number: 0, report, fields: Some(fields.into()) }];
    subject
        .store
        .finish(&lease, &[numbered(1)], &steps, reported(SolveStatus::Converged))
        .await
        .unwrap();
    id
}

async fn damage_in_every_table_is_found(subject: &Subject) {
    let store = &subject.store;
    assert_eq!(store.check(true).await.unwrap(), Vec::<String>::new());
    for statement in [
        "UPDATE jobs SET state = 'lost' WHERE id = $1",
        "DELETE FROM requests WHERE job = $1",
        "UPDATE iterations SET records = substr(records, 1, 3) WHERE job = $1",
        "UPDATE reports SET body = substr(body, 1, 3) WHERE job = $1",
        "DELETE FROM result_steps WHERE job = $1",
        "UPDATE result_steps SET body = substr(body, 1, 14) WHERE job = $1",
        "DELETE FROM field_parts WHERE job = $1 AND first = 262144",
        "UPDATE field_parts SET body = substr(body, 1, 100) WHERE job = $1 AND first > 0",
        "UPDATE deliveries SET state = 'lost' WHERE job = $1",
    ] {
        let id = rich_job(subject).await;
        assert_eq!(store.check(true).await.unwrap(), Vec::<String>::new());
        execute(&subject.place, statement, id).await;
        let found = store.check(true).await.unwrap();
        let prefix = format!("job {id}: ");
        assert!(found.len() == 1 && found[0].starts_with(&prefix), "{statement}: {found:?}");
        execute(&subject.place, "DELETE FROM jobs WHERE id = $1", id).await;
    }
    let waiting = subject.enqueue("x").await;
    execute(&subject.place, "UPDATE jobs SET account = id WHERE id = $1", waiting).await;
    store.ping().await.unwrap();
    execute(&subject.place, "INSERT INTO health SELECT 1 FROM jobs WHERE id = $1", waiting).await;
    assert!(matches!(store.ping().await, Err(StoreError::Damaged(_))));
    let found = store.check(true).await.unwrap();
    let line = "table health: 2 rows instead of one";
    assert!(
        found.len() == 2 && found[0] == line && found[1].contains(&waiting.to_string()),
        "{found:?}"
    );
}

#[tokio::test]
async fn a_damaged_file_is_found() {
    let subject = Subject::sqlite().await;
    subject.enqueue("x").await;
    let lease = subject.claim_one().await;
    let report = brinell::jobs::Deflated::compress(b"{}").unwrap();
    let step = StepResult { number: 0, report, fields: Some(vec![7; 400_000].into()) };
    subject.store.finish(&lease, &[], &[step], reported(SolveStatus::Converged)).await.unwrap();
    let Subject { store, clock, place, .. } = subject;
    // The last connection empties the log into the database and removes it.
    store.close().await;
    drop(store);
    let Place::Directory(directory) = &place else { panic!("a directory") };
    let file = directory.0.join("brinell.db");
    assert!(!directory.0.join("brinell.db-wal").exists());
    let mut bytes = std::fs::read(&file).unwrap();
    let end = bytes.len();
    bytes[end - 100 * 4096..].fill(0xff);
    std::fs::write(&file, bytes).unwrap();
    let after = Subject::again(place.clone(), clock).await;
    assert!(!after.store.check(false).await.unwrap().is_empty());
}
