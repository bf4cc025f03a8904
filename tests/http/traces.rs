//! The trace of a request goes with its job.

use std::time::Instant;

use serde_json::Value;

use crate::server::{DEADLINE, Server, example};

const TRACE: &str = "4bf92f3577b34da6a3ce929d0e0e4736";

/// Lines of the log that belong to the trace, by their message.
fn told(server: &Server) -> Vec<String> {
    let lines = server.log();
    let lines = lines.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let of_trace = lines.filter(|line| {
        let spans = line["spans"].as_array().into_iter().flatten();
        spans.chain([&line["span"]]).any(|span| span["trace_id"] == TRACE)
    });
    of_trace
        .map(|line| line["fields"]["message"].as_str().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn request_and_attempt_are_told_under_the_trace_of_the_client() {
    let server = Server::start_logging(&["--log", "info", "--log-format", "json"]);
    let header = format!("traceparent: 00-{TRACE}-00f067aa0ba902b7-01");
    for path in ["/v1/jobs?wait=30", "/v1/solve"] {
        let args = ["-H", "Content-Type: application/json", "-H", &header];
        assert_eq!(server.target.post_with(path, example().to_string(), &args).status, 200);
    }
    let nonsense = ["-H", "Content-Type: application/json", "-H", "traceparent: 00-x-y-z"];
    assert_eq!(server.target.post_with("/v1/solve", example().to_string(), &nonsense).status, 200);
    let started = Instant::now();
    loop {
        let told = told(&server);
        let count = |message| told.iter().filter(|line| *line == message).count();
        if ["queued", "started", "finished", "answered"].map(count) == [2; 4] {
            return;
        }
        assert!(started.elapsed() < DEADLINE, "{told:?}");
    }
}
