//! Requirements of HTTP.

use std::process::Command;

use crate::curl::curl;
use crate::server::{Server, example};

#[test]
fn unknown_addresses_and_methods_are_problems() {
    let server = Server::start();
    let service = &server.target;
    for path in ["/v1", "/v1/job", "/v1/jobs/x/y/z", "/%FF"] {
        service.get(path).problem(404, "not-found");
    }
    for path in ["/v1/jobs/none", "/v1/jobs/%FF", "/v1/jobs/0197e1f0-0000-7000-8000-000000000000"]
    {
        service.get(path).problem(404, "job-not-found");
        service.get(&format!("{path}/result")).problem(404, "job-not-found");
        service.post(&format!("{path}/cancel"), "").problem(404, "job-not-found");
    }
    let answer = service.get("/v1/solve");
    answer.problem(405, "method-not-allowed");
    assert_eq!(answer.header("allow"), Some("POST"));
    curl(&["-X", "DELETE", &format!("{}/livez", service.url)]).problem(405, "method-not-allowed");
    service.assert_alive();
}

#[test]
fn queries_are_checked() {
    let server = Server::start();
    let job = server.target.submit(&example());
    for query in ["wait=soon", "wait=-1", "wait=NaN", "wiat=1"] {
        server.target.get(&format!("{job}?{query}")).problem(400, "invalid-query");
    }
    assert_eq!(server.target.get(&format!("{job}?wait=1e300")).status, 200);
}

#[test]
fn every_kind_of_problem_explains_itself() {
    let server = Server::start();
    for kind in brinell::http::ProblemType::ALL {
        let answer = server.target.get(&kind.uri());
        assert_eq!(answer.status, 200);
        assert!(String::from_utf8(answer.body).unwrap().starts_with(kind.title()));
    }
    server.target.get("/problems/none").problem(404, "not-found");
}

#[test]
fn request_ids_are_given_or_kept() {
    let server = Server::start();
    let own = server.target.get("/livez");
    assert!(own.header("x-request-id").is_some_and(|id| id.len() == 36));
    let kept = curl(&["-H", "X-Request-Id: press-7", &format!("{}/livez", server.target.url)]);
    assert_eq!(kept.header("x-request-id"), Some("press-7"));
}

#[test]
fn results_are_compressed_for_those_who_ask() {
    let server = Server::start();
    let json = ["-H", "Content-Type: application/json"];
    let plain = server.target.post_with("/v1/solve", example().to_string(), &json);
    assert_eq!(plain.header("content-encoding"), None);
    let zipped = [json.as_slice(), &["-H", "Accept-Encoding: gzip"]].concat();
    let zipped = server.target.post_with("/v1/solve", example().to_string(), &zipped);
    assert_eq!(zipped.header("content-encoding"), Some("gzip"));
    assert!(zipped.body.len() < plain.body.len() / 2);
    let unzipped = [json.as_slice(), &["--compressed"]].concat();
    let unzipped = server.target.post_with("/v1/solve", example().to_string(), &unzipped);
    assert_eq!(unzipped.json()["result"]["status"], "converged");
}

#[test]
fn the_program_asks_itself_whether_it_is_well() {
    let server = Server::start();
    let listens = server.target.url.strip_prefix("http://").unwrap();
    for args in [
        &["healthcheck", "--listen", listens][..],
        &["healthcheck", "--live", "--listen", listens],
    ] {
        let asked = Command::new(env!("CARGO_BIN_EXE_brinell")).args(args).output().unwrap();
        assert!(asked.status.success(), "{}", String::from_utf8_lossy(&asked.stderr));
    }
}
