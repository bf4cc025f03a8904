//! Results of steps.

use std::sync::Arc;

use brinell::jobs::{
    Deflated, FIELDS_PART, FieldsReader, JobFailure, KeyLimits, NewJob, Outcome, Retention,
    StepResult, StoreError,
};
use brinell_solver::report::{FieldsReport, PerBody, encode_fields};
use brinell_solver::solver::SolveStatus;
use bytes::Bytes;
use jiff::SignedDuration;

use crate::quotas::key;
use crate::subject::{ALL, HEAD, Subject, job, reported};

fn step(number: usize, name: &str, fields: Option<&'static [u8]>) -> StepResult {
    StepResult {
        number,
        report: Deflated::compress(name.as_bytes()).unwrap(),
        fields: fields.map(Bytes::from_static),
    }
}

pub async fn steps_are_kept_as_they_are_finished(subject: &Subject) {
    let store = &subject.store;
    let id = subject.enqueue("x").await;
    let lease = subject.claim_one().await;
    store.record_steps(&lease, &[step(0, "a", Some(b"A"))]).await.unwrap();
    store.record_steps(&lease, &[step(1, "b", Some(b"B")), step(2, "c", None)]).await.unwrap();
    assert_eq!(store.result(id).await.unwrap(), None, "a running job has no result");
    store
        .finish(&lease, &[], &[step(3, "d", None)], reported(SolveStatus::Converged))
        .await
        .unwrap();

    let head = store.result(id).await.unwrap().unwrap();
    assert_eq!((&head.report[..], head.steps, head.has_fields, head.attempt), (HEAD, 4, true, 1));
    for (number, (text, fields)) in
        [("a", Some("A")), ("b", Some("B")), ("c", None), ("d", None)].into_iter().enumerate()
    {
        assert_eq!(store.step(id, number).await.unwrap().text().unwrap(), text);
        let part = store.fields(id, number, 0).await.unwrap();
        assert_eq!(part.as_ref().map(|part| &part.bytes[..]), fields.map(str::as_bytes));
    }
    assert!(matches!(store.step(id, 4).await, Err(StoreError::NotFound)));
    assert!(matches!(store.fields(id, 4, 0).await, Err(StoreError::NotFound)));
    store.delete(id).await.unwrap();
    assert!(matches!(store.step(id, 0).await, Err(StoreError::NotFound)));
}

pub async fn fields_are_read_part_by_part(subject: &Subject) {
    let side = 40_000;
    let nodes: Vec<[f64; 2]> = (0..side).map(|k| [f64::from(k), 0.5 * f64::from(k)]).collect();
    let written = FieldsReport { displacement: nodes.clone(), nodes, ..FieldsReport::default() };
    let written = PerBody { upper: Some(written), lower: None };
    let bytes = Bytes::from(encode_fields(&written).unwrap());
    assert!(bytes.len() > 4 * FIELDS_PART);
    let id = subject.enqueue("x").await;
    let lease = subject.claim_one().await;
    let step = StepResult {
        number: 0,
        report: Deflated::compress(b"a").unwrap(),
        fields: Some(bytes.clone()),
    };
    subject.store.finish(&lease, &[], &[step], reported(SolveStatus::Converged)).await.unwrap();

    for at in [0, 1, FIELDS_PART - 1, FIELDS_PART, 3 * FIELDS_PART + 5, bytes.len() - 1] {
        let part = subject.store.fields(id, 0, at).await.unwrap().unwrap();
        assert_eq!(part.first, at / FIELDS_PART * FIELDS_PART);
        assert_eq!(part.bytes, bytes[part.first..bytes.len().min(part.first + FIELDS_PART)]);
    }
    let mut reader = FieldsReader::open(Arc::clone(&subject.store), id, 0).await.unwrap().unwrap();
    for range in
        [0..1, 10..10, FIELDS_PART - 3..2 * FIELDS_PART + 7, 5..FIELDS_PART, 0..bytes.len()]
    {
        assert_eq!(reader.bytes(range.clone()).await.unwrap(), bytes[range]);
    }
    let end = bytes.len();
    assert!(matches!(reader.bytes(end..end + 1).await, Err(StoreError::Damaged(_))));
    let mut json = Vec::new();
    for piece in reader.layout().json() {
        let source = reader.bytes(piece.source()).await.unwrap();
        json.extend(piece.write(&source));
    }
    assert_eq!(json, serde_json::to_vec(&written).unwrap());
}

pub async fn a_later_attempt_begins_without_steps(subject: &Subject) {
    let store = &subject.store;
    let id = subject.enqueue("x").await;
    let lost = subject.claim_one().await;
    store
        .record_steps(&lost, &[step(0, "a", Some(b"A")), step(1, "b", Some(b"B"))])
        .await
        .unwrap();
    store.release(&[lost]).await.unwrap();
    assert!(matches!(
        store.record_steps(&lost, &[step(2, "c", None)]).await,
        Err(StoreError::LeaseLost)
    ));
    let lease = subject.claim_one().await;
    store
        .finish(&lease, &[], &[step(0, "d", None)], reported(SolveStatus::Converged))
        .await
        .unwrap();
    let head = store.result(id).await.unwrap().unwrap();
    assert_eq!((head.steps, head.has_fields, head.attempt), (1, false, 2));
    assert_eq!(store.step(id, 0).await.unwrap().text().unwrap(), "d");
}

pub async fn steps_that_begin_anew_take_the_place_of_others(subject: &Subject) {
    let store = &subject.store;
    for anew in [vec![step(0, "c", None)], vec![step(0, "c", None), step(1, "d", Some(b"D"))]] {
        let id = subject.enqueue("x").await;
        let lease = subject.claim_one().await;
        store
            .record_steps(&lease, &[step(0, "a", Some(b"A")), step(1, "b", Some(b"B"))])
            .await
            .unwrap();
        // A write whose answer was lost is made again.
        for _ in 0..2 {
            store.record_steps(&lease, &[step(2, "b", Some(b"B"))]).await.unwrap();
        }
        assert_eq!(store.step(id, 2).await.unwrap().text().unwrap(), "b");
        let (first, rest) = anew.split_at(1);
        if !rest.is_empty() {
            store.record_steps(&lease, first).await.unwrap();
        }
        let last = if rest.is_empty() { first } else { rest };
        store.finish(&lease, &[], last, reported(SolveStatus::Converged)).await.unwrap();
        assert_eq!(store.result(id).await.unwrap().unwrap().steps, anew.len());
        for kept in &anew {
            assert_eq!(store.step(id, kept.number).await.unwrap(), kept.report);
            let fields = store.fields(id, kept.number, 0).await.unwrap();
            assert_eq!(fields.map(|part| part.bytes), kept.fields);
        }
        assert!(matches!(store.step(id, anew.len()).await, Err(StoreError::NotFound)));
    }
    let stored = Retention { stored_bytes: Some(0), ..Retention::default() };
    assert_eq!(store.sweep(&stored).await.unwrap(), 2);
}

pub async fn a_job_without_a_report_keeps_no_steps(subject: &Subject) {
    let store = &subject.store;
    let id = subject.enqueue("x").await;
    let lease = subject.claim_one().await;
    store.record_steps(&lease, &[step(0, "a", Some(b"A"))]).await.unwrap();
    store
        .finish(&lease, &[], &[step(1, "b", None)], Outcome::Failed(JobFailure::solver("no")))
        .await
        .unwrap();
    assert_eq!(store.result(id).await.unwrap(), None);
    assert!(matches!(store.step(id, 0).await, Err(StoreError::NotFound)));
}

pub async fn the_oldest_results_make_room(subject: &Subject) {
    let mut ids = Vec::new();
    for _ in 0..4 {
        ids.push(subject.enqueue("x").await);
        let lease = subject.claim_one().await;
        let report = Deflated::compress(b"{}").unwrap();
        let step = |number| StepResult {
            number,
            report: report.clone(),
            fields: Some(vec![0; 500].into()),
        };
        // A write whose answer was lost is made again, and counts once.
        for number in [0, 1, 1] {
            subject.store.record_steps(&lease, &[step(number)]).await.unwrap();
        }
        subject.store.finish(&lease, &[], &[], reported(SolveStatus::Converged)).await.unwrap();
        subject.clock.advance(SignedDuration::from_secs(1));
    }
    let waiting = subject.enqueue("x").await;
    let keep = |bytes| Retention { stored_bytes: Some(bytes), ..Retention::default() };
    assert_eq!(subject.store.sweep(&keep(1 << 20)).await.unwrap(), 0);
    assert_eq!(subject.store.sweep(&keep(2500)).await.unwrap(), 2);
    assert_eq!(subject.page(ALL).await.0, [waiting, ids[3], ids[2]]);
    assert_eq!(subject.store.sweep(&keep(0)).await.unwrap(), 2);
    assert_eq!(subject.page(ALL).await.0, [waiting]);
}

pub async fn a_key_makes_room_for_itself_alone(subject: &Subject) {
    let limits = KeyLimits { stored_bytes: Some(1 << 20), ..KeyLimits::default() };
    let [light, heavy] = [key(subject, limits).await, key(subject, limits).await];
    let mut ids = Vec::new();
    for key in [light, heavy, heavy, heavy] {
        let new = NewJob { submitter: Some(key), ..job("x") };
        ids.push(subject.submit(new).await.unwrap().job.id);
        let lease = subject.claim_one().await;
        let report = Deflated::compress(b"{}").unwrap();
        let step = StepResult { number: 0, report, fields: Some(vec![0; 1000].into()) };
        subject
            .store
            .finish(&lease, &[], &[step], reported(SolveStatus::Converged))
            .await
            .unwrap();
        subject.clock.advance(SignedDuration::from_secs(1));
    }
    let retention = Retention { stored_bytes: Some(2500), ..Retention::default() };
    assert_eq!(subject.store.sweep(&retention).await.unwrap(), 2);
    assert_eq!(
        subject.page(ALL).await.0,
        [ids[3], ids[0]],
        "the oldest of the key that has the most"
    );
}
