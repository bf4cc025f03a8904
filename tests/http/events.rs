//! Jobs as server-sent events.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::curl::{curl, parse, spawn_curl};
use crate::in_process::{InProcess, job};
use crate::server::{DEADLINE, Server, example};

/// One event.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    pub name: String,
    pub id: Option<String>,
    pub data: Value,
}

pub fn events(text: &[u8]) -> Vec<Event> {
    let text = std::str::from_utf8(text).unwrap();
    let field = |block: &str, name: &str| {
        let prefix = format!("{name}: ");
        block.lines().find_map(|line| line.strip_prefix(&prefix)).map(str::to_owned)
    };
    let blocks = text.split("\n\n").filter(|block| block.contains("data: "));
    blocks
        .map(|block| Event {
            name: field(block, "event").unwrap(),
            id: field(block, "id"),
            data: serde_json::from_str(&field(block, "data").unwrap()).unwrap(),
        })
        .collect()
}

#[test]
fn a_finished_job_replays_its_history_and_ends() {
    let server = Server::start();
    let id = server.target.submit(&example());
    server.target.wait_for(&id, &["succeeded"]);
    let finished = server.target.get(&id).json();
    let url = format!("{}{id}/events", server.target.url);
    let answer = curl(&[&url]);
    assert_eq!((answer.status, answer.header("content-type")), (200, Some("text/event-stream")));
    assert_eq!(answer.header("x-accel-buffering"), Some("no"));
    let all = events(&answer.body);
    let (last, iterations) = all.split_last().unwrap();
    let count = usize::try_from(finished["progress"]["iterations"].as_u64().unwrap()).unwrap();
    assert_eq!(iterations.len(), count);
    for (number, event) in iterations.iter().enumerate() {
        assert_eq!(
            (event.name.as_str(), &event.id),
            ("iteration", &Some(format!("1-{}", number + 1)))
        );
    }
    assert_eq!(iterations[count - 1].data, finished["progress"]["latest"]);
    assert_eq!((last.name.as_str(), &last.id), ("state", &Some(format!("1-{count}-end"))));
    assert_eq!(last.data, finished);

    let resumed = curl(&["-H", "Last-Event-ID: 1-2", &url]);
    assert_eq!(events(&resumed.body), all[2..]);
    let nonsense = curl(&["-H", "Last-Event-ID: nonsense", &url]);
    assert_eq!(events(&nonsense.body), all);
    assert_eq!(curl(&["-H", &format!("Last-Event-ID: 1-{count}-end"), &url]).status, 204);
    server.target.get("/v1/jobs/none/events").problem(404, "job-not-found");
}

#[test]
fn a_running_job_is_followed_to_its_end() {
    let service = InProcess::start(|_| ());
    let (running, queued) =
        (service.target.submit(&job("slow")), service.target.submit(&job("quick")));
    service.target.wait_for(&running, &["running"]);
    let mut follower =
        spawn_curl(&["--no-buffer", &format!("{}{queued}/events", service.target.url)]);
    let mut stdout = BufReader::new(follower.stdout.take().unwrap());
    let mut seen = String::new();
    while !seen.contains("\"status\":\"queued\"") {
        assert_ne!(stdout.read_line(&mut seen).unwrap(), 0, "{seen}");
    }
    let running = spawn_curl(&[&format!("{}{running}/events", service.target.url)]);
    service.solver.open_gate();
    stdout.read_to_string(&mut seen).unwrap();
    follower.wait().unwrap();
    let body = parse(seen.as_bytes()).unwrap().body;
    let states: Vec<Value> =
        events(&body).into_iter().map(|event| event.data["status"].clone()).collect();
    assert_eq!(states.first().unwrap(), "queued");
    assert_eq!(states.last().unwrap(), "succeeded");
    let body = parse(&running.wait_with_output().unwrap().stdout).unwrap().body;
    let all = events(&body);
    let iterations = all.iter().filter(|event| event.name == "iteration");
    let numbers: Vec<u64> =
        iterations.map(|event| event.data["iteration"].as_u64().unwrap()).collect();
    assert!(!numbers.is_empty());
    assert!(
        numbers.iter().zip(1..).all(|(number, expected)| *number == expected),
        "in order, none lost"
    );
    assert_eq!(all.last().unwrap().data["status"], "succeeded");
}

#[test]
fn a_job_shows_the_progress_of_its_preliminary_solve() {
    let service = InProcess::start(|_| ());
    let id = service.target.submit(&job("preliminary"));
    let mut follower = spawn_curl(&["--no-buffer", &format!("{}{id}/events", service.target.url)]);
    let mut stdout = BufReader::new(follower.stdout.take().unwrap());
    let mut seen = String::new();
    // Three states: the job runs, and two moments of the preliminary solve.
    while seen.matches("\"status\":\"running\"").count() < 3 {
        assert_ne!(stdout.read_line(&mut seen).unwrap(), 0, "{seen}");
    }
    let progress = service.target.get(&id).json()["progress"].clone();
    assert_eq!(progress["iterations"], 0);
    assert!(progress["latest"]["iteration"].as_u64().unwrap() > 1, "{progress}");
    service.solver.open_gate();
    stdout.read_to_string(&mut seen).unwrap();
    follower.wait().unwrap();
    let all = events(&parse(seen.as_bytes()).unwrap().body);
    let shown = all.iter().filter(|event| event.data["status"] == "running");
    let moments: Vec<u64> =
        shown.filter_map(|event| event.data["progress"]["latest"]["iteration"].as_u64()).collect();
    assert!(moments.len() > 1 && moments.is_sorted(), "{moments:?}");
    assert_eq!(all.iter().filter(|event| event.name == "iteration").count(), 1);
    let end = &all.last().unwrap().data;
    assert_eq!((&end["status"], &end["progress"]["iterations"]), (&"succeeded".into(), &1.into()));
}

#[test]
#[ignore = "full"]
fn a_hundred_followers_and_one_that_never_reads() {
    let service = InProcess::start(|_| ());
    let id = service.target.submit(&job("slow"));
    service.target.wait_for(&id, &["running"]);
    let address = service.target.url.strip_prefix("http://").unwrap();
    let follow = || {
        let mut stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(DEADLINE)).unwrap();
        write!(stream, "GET {id}/events HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
            .unwrap();
        stream
    };
    let _deaf = follow();
    let followers: Vec<TcpStream> = (0..100).map(|_| follow()).collect();
    let started = Instant::now();
    while service.target.get(&id).json()["progress"]["iterations"].as_u64().unwrap() < 300 {
        assert!(started.elapsed() < DEADLINE);
    }
    service.solver.open_gate();
    let finished = service.target.wait_for(&id, &["succeeded"]);
    let iterations = finished["progress"]["iterations"].as_u64().unwrap();
    for mut follower in followers {
        let mut text = String::new();
        follower.read_to_string(&mut text).unwrap();
        assert!(text.contains("\"status\":\"succeeded\""));
        assert_eq!(text.matches("event: iteration").count() as u64, iterations);
    }
    assert!(started.elapsed() < Duration::from_secs(30), "the deaf one slows the others");
}
