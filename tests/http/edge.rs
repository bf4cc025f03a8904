//! Checks and headers of every request and answer.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use crate::curl::curl;
use crate::server::{DEADLINE, Server, example};

/// Sends a head as it is and returns the first line of the answer.
fn status_of(server: &Server, head: &str) -> String {
    let mut stream =
        TcpStream::connect(server.target.url.strip_prefix("http://").unwrap()).unwrap();
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
    let whole = |host: &str| {
        let line = format!(
            "GET http://{host}/livez HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"
        );
        status_of(&server, &line)
    };
    assert!(
        whole("localhost").starts_with("HTTP/1.1 200")
            && whole("evil.example").starts_with("HTTP/1.1 421")
    );
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
    for path in
        ["/", "/livez", "/v1/jobs", "/nowhere", "/docs/", "/openapi.json", "/problems/internal"]
    {
        let answer = server.target.get(path);
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"), "{path}");
        assert!(answer.header("cache-control").is_some(), "{path}");
        assert!(
            answer
                .header("content-security-policy")
                .is_some_and(|policy| policy.contains("default-src")),
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

fn connect(server: &Server) -> TcpStream {
    let stream = TcpStream::connect(server.target.url.strip_prefix("http://").unwrap()).unwrap();
    stream.set_read_timeout(Some(DEADLINE)).unwrap();
    stream
}

const ASK: &[u8] = b"GET /livez HTTP/1.1\r\nHost: localhost\r\n\r\n";

#[test]
fn heads_are_read_up_to_the_documented_size() {
    let server = Server::start();
    for (kilobytes, status) in [(60, "HTTP/1.1 200 OK"), (70, "HTTP/1.1 431")] {
        let line = |number| format!("x-{number}: {}", "y".repeat(1012));
        let lines: Vec<String> = (0..kilobytes).map(line).collect();
        let lines = lines.join("\r\n");
        let head = format!(
            "GET /livez HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n{lines}\r\n\r\n"
        );
        let mut stream = connect(&server);
        // The answer may come before everything is sent.
        let _ = stream.write_all(head.as_bytes()).and_then(|()| stream.flush());
        let mut answer = [0; 12];
        stream.read_exact(&mut answer).unwrap();
        let answer = String::from_utf8(answer.to_vec()).unwrap();
        assert!(status.starts_with(&answer), "{kilobytes} kB: {answer}");
    }
}

#[test]
fn clients_beyond_the_bound_wait_for_a_connection() {
    let server = Server::start_with(&["--max-connections", "2"]);
    let mut answer = [0; 12];
    let mut taken = [connect(&server), connect(&server)];
    for stream in &mut taken {
        stream.write_all(ASK).unwrap();
        stream.read_exact(&mut answer).unwrap();
    }
    let mut third = connect(&server);
    third.write_all(ASK).unwrap();
    third.set_read_timeout(Some(Duration::from_millis(200))).unwrap();
    assert!(third.read_exact(&mut answer).is_err(), "there is no place");
    drop(taken);
    third.set_read_timeout(Some(DEADLINE)).unwrap();
    third.read_exact(&mut answer).unwrap();
    assert_eq!(&answer, b"HTTP/1.1 200");
}

#[test]
#[ignore = "full"]
fn connections_leave_files_for_the_store() {
    let server = Server::start_with_files(200, &[]);
    let idle: Vec<TcpStream> = (0..199).map(|_| connect(&server)).collect();
    let mut waiting = connect(&server);
    waiting.write_all(ASK).unwrap();
    waiting.set_read_timeout(Some(Duration::from_millis(200))).unwrap();
    let mut answer = [0; 12];
    assert!(waiting.read_exact(&mut answer).is_err(), "there is no place");
    let open = std::fs::read_dir(format!("/proc/{}/fd", server.id())).map(Iterator::count);
    assert!(open.is_ok_and(|open| open < 180), "all files are connections");
    drop(idle);
    waiting.set_read_timeout(Some(DEADLINE)).unwrap();
    waiting.read_exact(&mut answer).unwrap();
    assert_eq!(&answer, b"HTTP/1.1 200");
}

#[test]
fn unfinished_bodies_are_bounded_in_sum() {
    let server = Server::start_with(&["--max-body", "2048"]);
    let head = "POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: \
                application/json\r\nContent-Length: 2048\r\n\r\n";
    // More than 128 bodies of the largest size, none of which ever ends.
    let hanging: Vec<TcpStream> = (0..140)
        .map(|_| {
            let mut stream = connect(&server);
            stream.write_all(format!("{head}{}", " ".repeat(2047)).as_bytes()).unwrap();
            stream
        })
        .collect();
    let job = example().to_string();
    let started = std::time::Instant::now();
    let validate_until = |status| {
        let mut answer = server.target.post("/v1/validate", job.clone());
        while answer.status != status && started.elapsed() < DEADLINE {
            answer = server.target.post("/v1/validate", job.clone());
        }
        answer
    };
    let refused = validate_until(503);
    refused.problem(503, "too-many-bodies");
    assert!(refused.header("retry-after").is_some());
    drop(hanging);
    assert_eq!(validate_until(200).status, 200, "the room is free again");
}

#[test]
fn a_page_of_elsewhere_changes_nothing() {
    let server = Server::start_with(&["--cors-origin", "https://design.example"]);
    let job = server.target.submit(&example());
    let cancel = format!("{job}/cancel");
    let from = |origin: &str| {
        let args = ["-H", &format!("Origin: {origin}"), "-H", "Content-Type: application/json"];
        server.target.post_with(&cancel, "", &args)
    };
    for origin in ["https://evil.example", "null", "http://localhost:1"] {
        from(origin).problem(403, "forbidden");
    }
    for origin in ["https://design.example", &server.target.url] {
        assert_eq!(from(origin).status, 200, "{origin}");
    }
}
