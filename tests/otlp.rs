//! Spans, as a collector gets them. Built with the feature: `cargo test --features otlp --test
//! otlp`.
#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on says where"
)]

#[path = "http/curl.rs"]
#[expect(dead_code, reason = "shared with the HTTP tests")]
mod curl;
#[path = "http/server.rs"]
#[expect(dead_code, reason = "shared with the HTTP tests")]
mod server;
#[path = "http/stand_in.rs"]
mod stand_in;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpListener;
use std::sync::mpsc::{Receiver, channel};
use std::thread;

use server::{DEADLINE, Server, example};

/// Takes what is sent to `/v1/traces` on this port.
fn collector() -> (u16, Receiver<Vec<u8>>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    let (sender, received) = channel();
    thread::spawn(move || {
        for stream in listener.incoming() {
            let mut reader = BufReader::new(stream.unwrap());
            let (mut length, mut line) = (0, String::new());
            reader.read_line(&mut line).unwrap();
            assert!(line.starts_with("POST /v1/traces "), "{line}");
            while !line.trim_end().is_empty() {
                line.clear();
                reader.read_line(&mut line).unwrap();
                let (name, value) = line.split_once(':').unwrap_or_default();
                if name.eq_ignore_ascii_case("content-length") {
                    length = value.trim().parse().unwrap();
                }
            }
            let mut body = vec![0; length];
            reader.read_exact(&mut body).unwrap();
            let _ = reader.get_mut().write_all(b"HTTP/1.1 200 Good\r\nContent-Length: 0\r\n\r\n");
            let _ = sender.send(body);
        }
    });
    (port, received)
}

#[test]
fn request_and_attempt_are_sent_in_the_trace_of_the_client() {
    let (port, received) = collector();
    let endpoint = format!("http://127.0.0.1:{port}");
    let mut server = Server::start_with(&["--otlp-endpoint", &endpoint]);
    let trace = "4bf92f3577b34da6a3ce929d0e0e4736";
    let header = format!("traceparent: 00-{trace}-00f067aa0ba902b7-01");
    let args = ["-H", "Content-Type: application/json", "-H", &header];
    assert_eq!(server.target.post_with("/v1/solve", example().to_string(), &args).status, 200);
    // What has been collected is sent at the end.
    server.signal("TERM");
    assert!(server.wait().success());
    let body = received.recv_timeout(DEADLINE).unwrap();
    let count = |part: &[u8]| body.windows(part.len()).filter(|window| *window == part).count();
    assert_eq!(
        (count(b"\x2a\x07request"), count(b"\x2a\x07attempt")),
        (1, 1),
        "names, as protobuf has them"
    );
    let id: Vec<u8> =
        (0..32).step_by(2).map(|k| u8::from_str_radix(&trace[k..k + 2], 16).unwrap()).collect();
    assert!(count(&id) >= 2 && count(b"brinell") >= 1);
}
