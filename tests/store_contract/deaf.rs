//! Clients that ask and do not read: their connections poll no body.

use std::time::Duration;

use axum::body::Body;
use axum::http::Request;
use axum::http::header::HOST;
use brinell::http::{HttpSettings, HttpState, router};
use futures_util::FutureExt;
use http_body_util::BodyExt;
use hyper::service::Service;
use hyper_util::service::TowerToHyperService;
use tokio::task::yield_now;
use tokio::time::timeout;

use crate::dropped::service;
use crate::subject::{Subject, iteration};

const DEAF: usize = 40;
const ITERATIONS: usize = 3000;
const SOON: Duration = Duration::from_secs(2);

pub async fn streams_that_nobody_reads_hold_no_reader(subject: &Subject) {
    let id = subject.enqueue("x").await;
    let lease = subject.claim_one().await;
    let records: Vec<_> = (1..=ITERATIONS).map(iteration).collect();
    subject.store.record_progress(&lease, &records).await.unwrap();
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
