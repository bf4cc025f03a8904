//! Hostile clients: the service refuses each and continues.

use std::fs;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Instant;

use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::json;

use crate::curl::{Answer, curl, parse};
use crate::in_process::{InProcess, job};
use crate::server::{DEADLINE, Server, Target, example};

/// A raw connection.
fn connect(target: &Target) -> TcpStream {
    let stream = TcpStream::connect(target.url.strip_prefix("http://").unwrap()).unwrap();
    stream.set_read_timeout(Some(DEADLINE)).unwrap();
    stream
}

/// Sends bytes and reads until the service closes the connection.
fn say(target: &Target, text: &[u8]) -> String {
    let mut stream = connect(target);
    // The service may close the connection before it has read all bytes.
    let _ = stream.write_all(text);
    hear(stream)
}

fn hear(mut stream: TcpStream) -> String {
    let mut heard = Vec::new();
    // A reset also closes the connection.
    let _ = stream.read_to_end(&mut heard);
    String::from_utf8_lossy(&heard).into_owned()
}

/// The statuses of all answers in the received bytes.
fn statuses(heard: &str) -> Vec<&str> {
    heard.split("HTTP/1.1 ").skip(1).map(|answer| &answer[..3]).collect()
}

#[test]
fn requests_that_can_be_read_in_two_ways() {
    let server = Server::start();
    let hidden = "GET /v1/capacity HTTP/1.1\r\nHost: localhost\r\n\r\n";
    for lengths in [
        "Content-Length: 5\r\nTransfer-Encoding: chunked\r\n",
        "Transfer-Encoding: chunked\r\nContent-Length: 5\r\n",
        "Content-Length: 5\r\nContent-Length: 6\r\n",
        "Content-Length: 5, 6\r\n",
        "Content-Length: +5\r\n",
        "Transfer-Encoding: identity, chunked, identity\r\n",
        "Transfer-Encoding: chunked\r\nTransfer-Encoding: xchunked\r\n",
        "Transfer-Encoding : chunked\r\n",
        "Content-Length: 0x5\r\n",
    ] {
        let head =
            "POST /v1/validate HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
        let heard =
            say(&server.target, format!("{head}{lengths}\r\n0\r\n\r\n{hidden}").as_bytes());
        let statuses = statuses(&heard);
        assert_eq!(statuses, ["400"], "{lengths:?} was answered by\n{heard}");
    }
    server.target.assert_alive();
}

#[test]
fn heads_too_large() {
    let server = Server::start();
    let head = "GET /livez HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n";
    let many = "X-A: b\r\n".repeat(200);
    let long = format!("X-Long: {}\r\n", "a".repeat(200_000));
    let url = format!("GET /{} HTTP/1.1\r\nHost: localhost\r\n", "a".repeat(200_000));
    for text in [format!("{head}{many}\r\n"), format!("{head}{long}\r\n")] {
        assert_eq!(statuses(&say(&server.target, text.as_bytes())), ["431"]);
    }
    let heard = say(&server.target, format!("{url}\r\n").as_bytes());
    assert!(["414", "431"].contains(&statuses(&heard)[0]), "{heard}");
    // One that never ends.
    let mut stream = connect(&server.target);
    stream.write_all(head.as_bytes()).unwrap();
    let line = b"X-Endless: \
                 aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\r\n";
    let taken = (0..1_000_000).take_while(|_| stream.write_all(line).is_ok()).count();
    assert!(taken < 1_000_000, "the service read on");
    server.target.assert_alive();
}

#[test]
fn json_nested_without_end() {
    let server = Server::start();
    for text in [
        "[".repeat(500_000),
        "{\"a\":".repeat(200_000),
        format!("{{\"upper\":{}", "[".repeat(900_000)),
    ] {
        server.target.post("/v1/jobs", text).problem(400, "invalid-json");
    }
    server.target.assert_alive();
}

#[test]
fn a_compressed_body_is_as_large_as_what_it_expands_to() {
    let server = Server::start();
    let zipped = |text: &[u8]| {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(text).unwrap();
        encoder.finish().unwrap()
    };
    let headers = ["-H", "Content-Type: application/json", "-H", "Content-Encoding: gzip"];
    let post = |body: Vec<u8>| server.target.post_with("/v1/solve", body, &headers);
    assert_eq!(post(zipped(example().to_string().as_bytes())).status, 200);
    let bomb = zipped(&vec![b' '; 50 << 20]);
    assert!(bomb.len() < 60_000);
    post(bomb).problem(413, "body-too-large");
    post(b"no gzip".to_vec()).problem(400, "invalid-json");
    let mut cut = zipped(example().to_string().as_bytes());
    cut.truncate(cut.len() / 2);
    post(cut).problem(400, "invalid-json");
    for coding in ["deflate", "br", "zstd", "identity, gzip"] {
        let coding = format!("Content-Encoding: {coding}");
        let headers = ["-H", "Content-Type: application/json", "-H", &coding];
        server
            .target
            .post_with("/v1/solve", example().to_string(), &headers)
            .problem(415, "unsupported-media-type");
    }
    let plain = ["-H", "Content-Type: application/json", "-H", "Content-Encoding: identity"];
    assert_eq!(server.target.post_with("/v1/solve", example().to_string(), &plain).status, 200);
}

#[test]
fn heads_and_bodies_that_do_not_come() {
    let patience = ["--header-timeout", "0.3", "--body-timeout", "0.3"];
    let server = Server::start_with(&patience);
    let started = Instant::now();
    let silent: Vec<_> = (0..50).map(|_| connect(&server.target)).collect();
    let mut half = connect(&server.target);
    half.write_all(b"GET /livez HTTP/1.1\r\nHost: localhost\r\nX-Slow: ").unwrap();
    for stream in silent.into_iter().chain([half]) {
        let heard = hear(stream);
        assert!(heard.is_empty() || statuses(&heard) == ["408"], "{heard}");
    }
    let head = "POST /v1/solve HTTP/1.1\r\nHost: localhost\r\nContent-Type: \
                application/json\r\nContent-Length: 1000\r\n\r\n{";
    let heard = say(&server.target, head.as_bytes());
    let answer: Answer = parse(heard.as_bytes()).unwrap();
    answer.problem(408, "body-timeout");
    assert!(started.elapsed() < DEADLINE / 12, "they were waited for");
    server.target.assert_alive();
}

/// Connections that the process has open, where the system tells.
fn sockets(server: &Server) -> usize {
    let files = fs::read_dir(format!("/proc/{}/fd", server.id())).into_iter().flatten().flatten();
    files
        .filter(|file| {
            fs::read_link(file.path())
                .is_ok_and(|link| link.to_string_lossy().starts_with("socket:"))
        })
        .count()
}

#[test]
fn clients_that_do_not_read_are_hung_up_on() {
    let server = Server::start_with(&["--write-timeout", "0.3"]);
    // Nobody is connected yet.
    let before = sockets(&server);
    let mut deaf = connect(&server.target);
    let _ = deaf.write_all(
        "GET /openapi.json HTTP/1.1\r\nHost: localhost\r\n\r\n".repeat(1000).as_bytes(),
    );
    let started = Instant::now();
    let until = |is_so: &dyn Fn(usize) -> bool| {
        while !is_so(sockets(&server)) {
            assert!(started.elapsed() < DEADLINE, "{before} sockets became {}", sockets(&server));
            std::thread::yield_now();
        }
    };
    until(&|now| now > before);
    until(&|now| now <= before);
    let document = server.target.get("/openapi.json").body.len();
    assert!(hear(deaf).len() < 1000 * document, "everything was sent");
    server.target.assert_alive();
}

#[test]
fn addresses_that_lead_astray() {
    let server = Server::start();
    let id = server.target.submit(&example());
    server.target.wait_for(&id, &["succeeded"]);
    for path in [
        "/../../etc/passwd",
        "/..%2f..%2fetc%2fpasswd",
        "/docs/../../../etc/passwd",
        "/docs/..%2f..%2f..%2fetc%2fpasswd",
        "/problems/..%2f..%2fCargo.toml",
        "/problems/%00",
        &format!("{id}/../../../../etc/passwd"),
        &format!("{id}/pressure.csv/../../x"),
        &format!("{id}/pressure.csv%00.svg"),
        &format!("{id}/..%2fresult"),
        &format!("{id}%00"),
        &format!("{id}/pressure.exe"),
        "/v1/jobs/..%2f..%2fbrinell-data%2fbrinell.sqlite",
        "//etc/passwd",
    ] {
        let answer = curl(&["--path-as-is", &format!("{}{path}", server.target.url)]);
        assert_eq!(answer.status, 404, "{path}");
        assert!(!String::from_utf8_lossy(&answer.body).contains("root:"));
    }
    server.target.assert_alive();
}

#[test]
fn event_streams_are_bounded() {
    let service = InProcess::start(|config| config.max_event_streams = 2);
    let id = service.target.submit(&job("slow"));
    service.target.wait_for(&id, &["running"]);
    let follow = || {
        let mut stream = connect(&service.target);
        write!(stream, "GET {id}/events HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
        let mut first = [0; 15];
        stream.read_exact(&mut first).unwrap();
        assert_eq!(&first, b"HTTP/1.1 200 OK");
        stream
    };
    let streams = [follow(), follow()];
    let refused = service.target.get(&format!("{id}/events"));
    assert_eq!(refused.header("retry-after"), Some("2"));
    refused.problem(503, "too-many-streams");
    assert_eq!(
        service.target.get(&id).json()["status"],
        json!("running"),
        "questions are still answered"
    );
    drop(streams);
    let started = Instant::now();
    service.solver.open_gate();
    while service.target.get(&format!("{id}/events")).status != 200 {
        assert!(started.elapsed() < DEADLINE, "places are not given back");
    }
}
