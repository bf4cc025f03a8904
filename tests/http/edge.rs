//! What holds for every request and every answer.

use std::io::{Read, Write};
use std::net::TcpStream;

use crate::curl::curl;
use crate::server::{Server, example};

/// Sends a head as it is and returns the first line of the answer.
fn status_of(server: &Server, head: &str) -> String {
    let mut stream = TcpStream::connect(server.target.url.strip_prefix("http://").unwrap()).unwrap();
    stream.write_all(head.as_bytes()).unwrap();
    let mut text = String::new();
    stream.read_to_string(&mut text).unwrap();
    text.lines().next().unwrap_or_default().to_owned()
}

#[test]
fn other_names_are_not_answered_to() {
    let server = Server::start();
    let url = format!("{}/v1/jobs", server.target.url);
    curl(&["-H", "Host: evil.example", &url]).problem(421, "unknown-host");
    assert_eq!(curl(&["-H", "Host: localhost:1", &url]).status, 200);
    for head in [
        "GET /livez HTTP/1.1\r\nConnection: close\r\n\r\n",
        "GET /livez HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\nConnection: close\r\n\r\n",
    ] {
        let status = status_of(&server, head);
        assert!(status.starts_with("HTTP/1.1 400"), "{status}");
    }
    let named = Server::start_with(&["--allowed-host", "brinell.example"]);
    let url = format!("{}/v1/jobs", named.target.url);
    assert_eq!(curl(&["-H", "Host: Brinell.example:443", &url]).status, 200);
}

#[test]
fn names_of_requests_are_short_and_printable() {
    let server = Server::start();
    let url = format!("{}/livez", server.target.url);
    let echoed = |id: &str| {
        let answer = curl(&["-H", &format!("x-request-id: {id}"), &url]);
        answer.header("x-request-id").unwrap().to_owned()
    };
    assert_eq!(echoed("press-7"), "press-7");
    let long = "x".repeat(129);
    assert_eq!(echoed(&long[1..]), long[1..]);
    assert_ne!(echoed(&long), long);
    assert_ne!(echoed("two words"), "two words");
}

#[test]
fn every_answer_keeps_browsers_from_guessing() {
    let server = Server::start();
    for path in ["/", "/livez", "/v1/jobs", "/nowhere", "/docs/", "/openapi.json", "/problems/internal"] {
        let answer = server.target.get(path);
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"), "{path}");
        assert!(answer.header("cache-control").is_some(), "{path}");
        assert!(
            answer.header("content-security-policy").is_some_and(|policy| policy.contains("default-src")),
            "{path}"
        );
    }
}

#[test]
fn a_solve_may_be_repeated_under_its_name() {
    let server = Server::start();
    let solve = |job: &str| {
        let key = ["-H", "Idempotency-Key: press-7", "-H", "Content-Type: application/json"];
        server.target.post_with("/v1/solve", job, &key)
    };
    let job = example().to_string();
    let (first, again) = (solve(&job), solve(&job));
    assert_eq!((first.status, again.status), (200, 200));
    assert_eq!(first.header("content-location"), again.header("content-location"));
    assert_eq!(first.body, again.body);
    solve(&job.replace("612.6106", "600.0")).problem(422, "idempotency-key-reused");
}
