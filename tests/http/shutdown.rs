//! Orderly shutdown.

use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::curl::{curl, parse, spawn_curl};
use crate::in_process::{InProcess, job};
use crate::server::{DEADLINE, Scratch, Server, example};

#[test]
fn sigterm_ends_an_idle_service_with_success() {
    for signal in ["TERM", "INT"] {
        let mut server = Server::start();
        server.target.assert_alive();
        server.signal(signal);
        assert_eq!(server.wait().code(), Some(0), "{signal}");
    }
}

#[test]
fn a_service_with_a_once_key_answers_to_it_alone_and_ends_with_its_standard_input() {
    let secret = "fedcba9876543210fedcba9876543210";
    let mut child = Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args(["serve", "--listen", "127.0.0.1:0", "--data-dir", ":memory:", "--log", "warn"])
        .args(["--once-key-env", "THE_KEY", "--exit-with-stdin"])
        .env("THE_KEY", secret)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the binary starts");
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
    let jobs = format!("{}/v1/jobs", line.trim().strip_prefix("brinell listening on ").unwrap());
    let ask = |token: &str| curl(&["-H", &format!("Authorization: Bearer {token}"), &jobs]);
    curl(&[&jobs]).problem(401, "unauthorized");
    ask(&secret[1..]).problem(401, "unauthorized");
    assert_eq!(ask(secret).status, 200);
    assert!(child.try_wait().unwrap().is_none());
    drop(child.stdin.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[test]
fn while_draining_jobs_finish_new_ones_are_refused_and_questions_answered() {
    let service = InProcess::start(|_| ());
    let target = service.target.clone();
    let running = target.submit(&job("slow"));
    let queued = target.submit(&job("quick"));
    target.wait_for(&running, &["running"]);
    service.stop.cancel();
    let started = Instant::now();
    while target.get("/readyz").status == 200 {
        assert!(started.elapsed() < DEADLINE, "still ready");
    }
    let refused = target.get("/readyz");
    refused.problem(503, "shutting-down");
    assert!(refused.header("retry-after").is_some());
    assert_eq!(target.get("/livez").status, 200);
    target.post("/v1/jobs", example().to_string()).problem(503, "shutting-down");
    assert_eq!(target.wait_for(&running, &["running"])["status"], "running");
    assert_eq!(target.wait_for(&queued, &["queued"])["queue_position"], 0);
    service.solver.open_gate();
    service.wait();
}

#[test]
fn a_job_that_outlasts_the_grace_time_is_queued_again() {
    let directory = Scratch::new();
    let start = || {
        InProcess::start(|config| {
            // Nobody takes the job for abandoned while this test waits.
            config.work.lease = 10 * DEADLINE;
            config.work.grace = Duration::from_millis(50);
            config.storage.database_url = None;
            config.storage.data_dir.clone_from(&directory.0);
        })
    };
    let service = start();
    let id = service.target.submit(&job("slow"));
    service.target.wait_for(&id, &["running"]);
    service.stop.cancel();
    service.wait();
    let service = start();
    service.solver.open_gate();
    assert_eq!(
        service.target.wait_for(&id, &["succeeded"])["attempts"],
        2,
        "its lease was given back"
    );
}

#[test]
fn clients_that_wait_are_answered_before_connections_close() {
    let directory = Scratch::new();
    let service = InProcess::start(|config| {
        config.work.grace = Duration::from_millis(200);
        config.storage.data_dir.clone_from(&directory.0);
    });
    let target = service.target.clone();
    let id = target.submit(&job("slow"));
    target.wait_for(&id, &["running"]);
    let waits = spawn_curl(&[&format!("{}{id}?wait=60", target.url)]);
    let solve = job("slow").to_string();
    let json = "Content-Type: application/json";
    let solves =
        spawn_curl(&["-H", json, "--data-binary", &solve, &format!("{}/v1/solve", target.url)]);
    while target.get("/v1/jobs").json()["jobs"].as_array().map(Vec::len) != Some(2) {}
    service.stop.cancel();
    let waited = parse(&waits.wait_with_output().unwrap().stdout).expect("an answer");
    assert_eq!(waited.status, 200);
    assert!(["running", "queued"].contains(&waited.json()["status"].as_str().unwrap()));
    let solved = parse(&solves.wait_with_output().unwrap().stdout).expect("an answer");
    assert_eq!((solved.status, solved.json()["status"].as_str()), (202, Some("queued")));
    service.wait();
}

#[test]
fn a_second_signal_stops_at_once() {
    let mut server = Server::start();
    let address = server.target.url.strip_prefix("http://").unwrap().to_owned();
    // A client that never finishes its request holds the shutdown up.
    let mut client = TcpStream::connect(&address).unwrap();
    let head = "POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: \
                application/json\r\nContent-Length: 9\r\n\r\n{";
    client.write_all(head.as_bytes()).unwrap();
    server.target.assert_alive();
    server.signal("TERM");
    let started = Instant::now();
    while TcpStream::connect(&address).is_ok() {
        assert!(started.elapsed() < DEADLINE, "still listening");
    }
    server.signal("TERM");
    assert_eq!(server.wait().code(), Some(130));
}
