//! Clients that do not read their answers, so that their connections do not poll the body.

use std::time::Duration;

use axum::body::Body;
use axum::http::Request;
use axum::http::header::HOST;
use brinell::http::{HttpSettings, HttpState, router};
use brinell::jobs::{Deflated, JobId, NewJob, Outcome, StepResult};
use brinell_solver::job::Job;
use brinell_solver::report::run_each;
use brinell_solver::solver::{Options, SolveStatus, Unobserved};
use futures_util::FutureExt;
use http_body_util::BodyExt;
use hyper::service::Service;
use hyper_util::service::TowerToHyperService;
use tokio::task::yield_now;
use tokio::time::timeout;

use crate::dropped::{JOB, service};
use crate::subject::{Subject, iteration, numbered};

const DEAF: usize = 40;
const ITERATIONS: usize = 3000;
const SOON: Duration = Duration::from_secs(2);

/// A history of three loads with fields, of which the second report and the fields of the third
/// are cut off.
async fn broken_result(subject: &Subject) -> JobId {
    let mut asked: serde_json::Value = serde_json::from_str(JOB).unwrap();
    asked["load"] = serde_json::json!({"forces": [200.0, 400.0, 600.0]});
    asked["mesh"] = serde_json::json!({"elements_per_half_width": 4});
    asked["output"] = serde_json::json!({"fields": true});
    let request = asked.to_string();
    let job = Job::from_json(request.as_bytes()).unwrap();
    let mut steps = Vec::new();
    let mut keep = |number, step| steps.push(StepResult::encode(number, step).unwrap());
    let report = run_each(&job, Options::default(), &mut Unobserved, &mut keep).unwrap();
    steps[1].report = Deflated::compress(b"{").unwrap();
    let fields = steps[2].fields.as_mut().unwrap();
    fields.truncate(fields.len() / 2);
    let id = subject.submit(NewJob::new(request.into())).await.unwrap().job.id;
    let lease = subject.claim_one().await;
    let report = serde_json::to_vec(&report).unwrap().into();
    let outcome = Outcome::Reported { status: SolveStatus::Converged, report };
    subject.store.finish(&lease, &[], &steps, outcome).await.unwrap();
    id
}

pub async fn a_file_breaks_off_where_its_result_does(subject: &Subject) {
    let id = broken_result(subject).await;
    let router = router(HttpState::new(service(subject), HttpSettings::default(), None));
    let asked = TowerToHyperService::new(router);
    // A summary reads all load steps for its columns before it begins.
    for (file, status, is_whole) in [
        ("field.vtu?step=1", 200, true),
        ("summary.csv", 500, true),
        ("pressure.csv", 200, false),
        ("field.vtu?step=3", 200, false),
        ("result?step=1", 200, true),
        ("result", 200, false),
    ] {
        let request = Request::get(format!("/v1/jobs/{id}/{file}")).header(HOST, "localhost");
        let answer = timeout(SOON, asked.call(request.body(Body::empty()).unwrap()))
            .await
            .unwrap()
            .unwrap();
        assert_eq!(answer.status(), status, "{file}");
        let body = timeout(SOON, answer.into_body().collect()).await.expect("an end");
        assert_eq!(body.is_ok(), is_whole, "{file}");
    }
}

pub async fn streams_that_nobody_reads_hold_no_reader(subject: &Subject) {
    let id = subject.enqueue("x").await;
    let lease = subject.claim_one().await;
    let records: Vec<_> = (1..=ITERATIONS).map(numbered).collect();
    subject.store.record_progress(&lease, &records, &iteration(ITERATIONS)).await.unwrap();
    let router = router(HttpState::new(service(subject), HttpSettings::default(), None));
    let asked = TowerToHyperService::new(router);
    let ask = || {
        let request = Request::get(format!("/v1/jobs/{id}/events")).header(HOST, "localhost");
        asked.call(request.body(Body::empty()).unwrap())
    };
    let mut deaf = Vec::new();
    for _ in 0..DEAF {
        let mut body = timeout(SOON, ask()).await.expect("an answer").unwrap().into_body();
        // As a connection does whose client takes the first bytes.
        for _ in 0..3 {
            let _ = body.frame().now_or_never();
            yield_now().await;
        }
        deaf.push(body);
    }
    for _ in 0..DEAF {
        timeout(SOON, subject.store.get(id)).await.expect("a reader is free").unwrap();
        yield_now().await;
    }
    // One that reads has everything.
    let mut body = timeout(SOON, ask()).await.expect("an answer").unwrap().into_body();
    let mut text = String::new();
    while text.matches("event: iteration").count() < ITERATIONS {
        let frame = timeout(SOON, body.frame()).await.expect("the next piece").unwrap().unwrap();
        text.push_str(std::str::from_utf8(frame.data_ref().unwrap()).unwrap());
    }
    assert!(text.contains(&format!("id: 1-{ITERATIONS}\n")));
}
