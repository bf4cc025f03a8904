//! Submissions: waiting for the result, idempotency keys, priority.

use std::process::Command;

use crate::curl::{Answer, curl};
use crate::in_process::{InProcess, job};
use crate::server::Target;

const JSON: &str = "Content-Type: application/json";

fn submit(target: &Target, path: &str, body: &str, headers: &[&str]) -> Answer {
    let headers = headers.iter().flat_map(|header| ["-H", header]);
    let args: Vec<&str> = ["-H", JSON].into_iter().chain(headers).collect();
    target.post_with(path, body, &args)
}

#[test]
fn a_client_may_prefer_to_wait() {
    let service = InProcess::start(|_| ());
    let answer =
        submit(&service.target, "/v1/jobs", &job("quick").to_string(), &["Prefer: wait=30"]);
    assert_eq!((answer.status, answer.header("preference-applied")), (200, Some("wait=30")));
    assert_eq!(answer.json()["result"]["status"], "converged");
    assert_eq!(answer.header("content-location"), answer.json()["links"]["self"].as_str());

    let answer =
        submit(&service.target, "/v1/jobs", &job("slow").to_string(), &["Prefer: wait=0"]);
    assert_eq!((answer.status, answer.header("preference-applied")), (202, Some("wait=0")));
    let answer = submit(&service.target, "/v1/jobs", &job("quick").to_string(), &[]);
    assert_eq!((answer.status, answer.header("preference-applied")), (202, None));
    assert_eq!(answer.header("retry-after"), Some("1"));
    let queued = answer.header("location").unwrap().to_owned();
    service.solver.open_gate();
    for (query, header) in [("?wait=30", "Prefer: wait=1"), ("", "Prefer: wait=30")] {
        let waited = curl(&["-H", header, &format!("{}{queued}{query}", service.target.url)]);
        assert_eq!((waited.status, waited.header("retry-after")), (200, None));
        assert_eq!(waited.json()["result"]["status"], "converged");
        let applied = query.is_empty().then_some("wait=30");
        assert_eq!(waited.header("preference-applied"), applied);
    }
    let waited = submit(&service.target, "/v1/jobs?wait=30", &job_of("quick"), &[]);
    assert_eq!((waited.status, waited.json()["done"].as_bool()), (200, Some(true)));
    let failed =
        submit(&service.target, "/v1/jobs", &job("impossible").to_string(), &["Prefer: wait=30"]);
    failed.problem(422, "invalid-job");
}

fn job_of(behaviour: &str) -> String {
    job(behaviour).to_string()
}

#[test]
fn solve_waits_as_long_as_its_client_prefers() {
    let service = InProcess::start(|_| ());
    for (path, header) in [("/v1/solve?wait=0", "Accept: */*"), ("/v1/solve", "Prefer: wait=0")] {
        let answer = submit(&service.target, path, &job_of("slow"), &[header]);
        assert_eq!((answer.status, answer.header("retry-after")), (202, Some("1")));
        let job = answer.json();
        assert_eq!((&job["done"], &job["has_result"]), (&false.into(), &false.into()));
        assert!(job["links"].get("result").is_none() && job["links"]["cancel"].is_string());
    }
    service.solver.open_gate();
}

#[test]
fn every_parameter_at_fault_is_named() {
    let service = InProcess::start(|_| ());
    let path = "/v1/jobs?priority=high&wait=soon&prio=1&priority=2";
    let problem =
        submit(&service.target, path, &job_of("quick"), &[]).problem(400, "invalid-query");
    let faults: Vec<_> = problem["errors"].as_array().unwrap().iter().collect();
    let names: Vec<_> = faults.iter().map(|fault| fault["parameter"].as_str().unwrap()).collect();
    assert_eq!(names, ["prio", "priority", "priority", "wait"]);
    let codes: Vec<_> = faults.iter().map(|fault| fault["code"].as_str().unwrap()).collect();
    assert_eq!(codes, ["unknown_key", "duplicate_key", "out_of_range", "out_of_range"]);
}

#[test]
fn links_are_below_the_path_that_a_proxy_names() {
    let service = InProcess::start(|_| ());
    let answer =
        submit(&service.target, "/v1/jobs", &job_of("quick"), &["X-Forwarded-Prefix: /press"]);
    let location = answer.header("location").unwrap();
    assert!(location.starts_with("/press/v1/jobs/"), "{location}");
    assert_eq!(answer.json()["links"]["self"], location);
    let prefix = ["-H", "X-Forwarded-Prefix: /press"];
    let about = |path: &str| {
        curl(&[prefix.as_slice(), &[format!("{}{path}", service.target.url).as_str()]].concat())
    };
    assert_eq!(about("/openapi.json").json()["servers"][0]["url"], "/press");
    let problem = about("/v1/jobs/none").json();
    assert_eq!(problem["type"], "/press/problems/job-not-found");
}

#[test]
fn all_origins_need_keys() {
    let open = ["--cors-origin", "*", "--listen", "127.0.0.1:0", "--data-dir", ":memory:"];
    let refused = Command::new(env!("CARGO_BIN_EXE_brinell")).arg("serve").args(open).output();
    let refused = refused.unwrap();
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(!refused.status.success() && said.contains("--require-api-key"), "{said}");
}

#[test]
fn pages_of_a_named_origin_may_ask() {
    let origin = "Origin: https://design.example";
    let service = InProcess::start(|config| {
        config.cors_origin = vec!["https://design.example".parse().unwrap()];
    });
    let url = format!("{}/v1/capacity", service.target.url);
    let allowed = curl(&["-H", origin, &url]);
    assert_eq!(allowed.header("access-control-allow-origin"), Some("https://design.example"));
    let other = curl(&["-H", "Origin: https://elsewhere.example", &url]);
    assert_eq!(other.header("access-control-allow-origin"), None);
    let preflight = ["-X", "OPTIONS", "-H", origin, "-H", "Access-Control-Request-Method: POST"];
    let preflight = curl(&[preflight.as_slice(), &[url.as_str()]].concat());
    assert_eq!(
        (preflight.status, preflight.header("access-control-max-age")),
        (200, Some("3600"))
    );
    // `*` does not stand for this one.
    let wanted = [
        "-X",
        "OPTIONS",
        "-H",
        origin,
        "-H",
        "Access-Control-Request-Headers: authorization,prefer",
    ];
    let wanted = curl(&[wanted.as_slice(), &[url.as_str()]].concat());
    assert_eq!(wanted.header("access-control-allow-headers"), Some("authorization,prefer"));
    let closed = InProcess::start(|_| ());
    let url = format!("{}/v1/capacity", closed.target.url);
    let answer = curl(&["-H", origin, &url]);
    assert_eq!(
        (answer.header("access-control-allow-origin"), answer.header("vary")),
        (None, Some("accept-encoding"))
    );
    curl(&["-X", "OPTIONS", "-H", origin, &url]).problem(405, "method-not-allowed");
}

#[test]
fn the_same_key_and_body_are_the_same_job() {
    let service = InProcess::start(|_| ());
    let (body, key) = (job_of("slow"), "Idempotency-Key: press-7");
    let first = submit(&service.target, "/v1/jobs", &body, &[key]);
    assert_eq!((first.status, first.header("idempotency-replayed")), (202, None));
    let address = first.header("location").unwrap();
    let again = submit(&service.target, "/v1/jobs", &body, &[key]);
    assert_eq!((again.status, again.header("idempotency-replayed")), (202, Some("true")));
    assert_eq!(again.header("location"), Some(address));
    submit(&service.target, "/v1/jobs", &job_of("quick"), &[key])
        .problem(422, "idempotency-key-reused");
    submit(&service.target, "/v1/jobs", &body, &["Idempotency-Key: two words"])
        .problem(400, "invalid-header");
    assert_eq!(service.target.get("/v1/jobs").json()["jobs"].as_array().unwrap().len(), 1);

    service.solver.open_gate();
    service.target.wait_for(address, &["succeeded"]);
    for (path, has_result) in [("/v1/jobs", false), ("/v1/jobs?wait=0", true), ("/v1/solve", true)]
    {
        let done = submit(&service.target, path, &body, &[key]);
        assert_eq!(
            (done.status, done.header("idempotency-replayed")),
            (200, Some("true")),
            "{path}"
        );
        assert_eq!(
            (done.header("content-location"), done.header("location")),
            (Some(address), None),
            "{path}"
        );
        assert_eq!(done.json()["result"].is_object(), has_result, "{path}");
    }
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
        submit(&service.target, &path, &job("quick").to_string(), &[])
            .problem(400, "invalid-query");
    }
    service.solver.open_gate();
    service.target.wait_for(&ordinary, &["succeeded"]);
}
