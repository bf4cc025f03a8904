//! Handing jobs in: waiting for the result, repeating a submission, urgency.

use serde_json::json;

use crate::curl::Answer;
use crate::in_process::{InProcess, job};
use crate::server::{Server, Target, example};

const JSON: &str = "Content-Type: application/json";

fn submit(target: &Target, path: &str, body: &str, headers: &[&str]) -> Answer {
    let headers = headers.iter().flat_map(|header| ["-H", header]);
    let args: Vec<&str> = ["-H", JSON].into_iter().chain(headers).collect();
    target.post_with(path, body, &args)
}

#[test]
fn a_client_may_prefer_to_wait() {
    let service = InProcess::start(|_| ());
    let answer = submit(&service.target, "/v1/jobs", &job("quick").to_string(), &["Prefer: wait=30"]);
    assert_eq!((answer.status, answer.header("preference-applied")), (200, Some("wait=30")));
    assert_eq!(answer.json()["status"], "converged");
    assert!(answer.header("content-location").is_some_and(|address| address.ends_with("/result")));

    let answer = submit(&service.target, "/v1/jobs", &job("slow").to_string(), &["Prefer: wait=0"]);
    assert_eq!((answer.status, answer.header("preference-applied")), (202, Some("wait=0")));
    let answer = submit(&service.target, "/v1/jobs", &job("quick").to_string(), &[]);
    assert_eq!((answer.status, answer.header("preference-applied")), (202, None));
    service.solver.open_gate();
    let failed = submit(&service.target, "/v1/jobs", &job("impossible").to_string(), &["Prefer: wait=30"]);
    failed.problem(422, "invalid-job");
}

#[test]
fn the_same_key_and_body_are_the_same_job() {
    let server = Server::start();
    let (body, key) = (example().to_string(), "Idempotency-Key: press-7");
    let first = submit(&server.target, "/v1/jobs", &body, &[key]);
    assert_eq!((first.status, first.header("idempotency-replayed")), (202, None));
    let again = submit(&server.target, "/v1/jobs", &body, &[key]);
    assert_eq!((again.status, again.header("idempotency-replayed")), (202, Some("true")));
    assert_eq!(again.header("location"), first.header("location"));
    let mut other = example();
    other["tags"] = json!({"other": "body"});
    submit(&server.target, "/v1/jobs", &other.to_string(), &[key]).problem(422, "idempotency-key-reused");
    submit(&server.target, "/v1/jobs", &body, &["Idempotency-Key: two words"]).problem(400, "invalid-header");
    assert_eq!(server.target.get("/v1/jobs").json()["jobs"].as_array().unwrap().len(), 1);
}

#[test]
fn urgent_jobs_go_first() {
    let service = InProcess::start(|_| ());
    let running = service.target.submit(&job("slow"));
    service.target.wait_for(&running, &["running"]);
    let ordinary = service.target.submit(&job("quick"));
    let urgent = submit(&service.target, "/v1/jobs?priority=5", &job("quick").to_string(), &[]);
    let urgent = urgent.header("location").unwrap().to_owned();
    assert_eq!(service.target.get(&ordinary).json()["queue_position"], 1);
    let first = service.target.get(&urgent).json();
    assert_eq!((first["queue_position"].as_u64(), first["priority"].as_i64()), (Some(0), Some(5)));
    for query in ["priority=high", "priority=101", "prio=1"] {
        let path = format!("/v1/jobs?{query}");
        submit(&service.target, &path, &job("quick").to_string(), &[]).problem(400, "invalid-query");
    }
    service.solver.open_gate();
    service.target.wait_for(&ordinary, &["succeeded"]);
}
