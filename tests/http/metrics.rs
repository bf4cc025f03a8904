//! Metrics for Prometheus, the dashboard that shows them, and the log.

use std::collections::BTreeSet;
use std::fs;
use std::net::TcpListener;

use serde_json::Value;

use crate::curl::curl;
use crate::in_process::{InProcess, job};
use crate::server::{Server, Target, example};

/// Names of the metrics in an exposition.
fn names(text: &str) -> BTreeSet<String> {
    let types = text.lines().filter_map(|line| line.strip_prefix("# TYPE "));
    types.filter_map(|line| line.split(' ').next()).map(str::to_owned).collect()
}

/// The value of a sample, by its name and labels as they are written.
fn sample(text: &str, name: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '))?;
    line.parse().ok()
}

/// A bit of everything that is measured.
fn exercise(target: &Target) {
    assert_eq!(target.post("/v1/solve", example().to_string()).status, 200);
    let id = target.submit(&example());
    target.wait_for(&id, &["succeeded"]);
    assert_eq!(target.get(&format!("{id}/events")).status, 200);
    assert_eq!(target.get("/nowhere").status, 404);
}

#[test]
fn jobs_and_requests_are_measured() {
    let server = Server::start();
    exercise(&server.target);
    let answer = server.target.get("/metrics");
    assert_eq!(answer.status, 200);
    assert!(
        answer
            .header("content-type")
            .is_some_and(|kind| kind.starts_with("text/plain; version=0.0.4"))
    );
    let text = String::from_utf8(answer.body).unwrap();
    let value = |name: &str| sample(&text, name).unwrap_or_else(|| panic!("no {name} in\n{text}"));
    let is = |name: &str, expected: f64| {
        assert!((value(name) - expected).abs() < 1e-9, "{name} {}", value(name));
    };
    is("brinell_queue_depth", 0.0);
    is("brinell_jobs_running", 0.0);
    is("brinell_event_streams", 0.0);
    is("brinell_jobs_total{outcome=\"succeeded\"}", 2.0);
    is("brinell_queue_wait_seconds_count", 2.0);
    is("brinell_solve_duration_seconds_count", 2.0);
    is("brinell_solve_duration_seconds_bucket{le=\"+Inf\"}", 2.0);
    is("brinell_solver_iterations_count", 2.0);
    assert!(value("brinell_solver_iterations_sum") > 2.0);
    assert!(value("brinell_solve_duration_seconds_sum") > 0.001);
    let lookups = |outcome: &str| {
        value(&format!("brinell_factor_cache_lookups_total{{outcome=\"{outcome}\"}}"))
    };
    assert!(
        lookups("hit") >= 1.0 && lookups("hit") >= lookups("miss"),
        "the second job finds what the first left"
    );
    assert!(value("brinell_factor_cache_bytes") > 1e5);
    let solve =
        "http_request_method=\"POST\",http_route=\"/v1/solve\",http_response_status_code=\"200\"";
    is(&format!("http_server_request_duration_seconds_count{{{solve}}}"), 1.0);
    assert!(text.contains("http_route=\"/v1/jobs/{id}\""), "routes are told by their template");
    assert!(!text.contains("nowhere") && !text.contains("0000-"), "addresses make no labels");
}

#[test]
fn no_body_is_cached_if_so_set() {
    let server = Server::start_with(&["--factor-cache", "0"]);
    exercise(&server.target);
    let answer = server.target.get("/metrics");
    let shown = names(std::str::from_utf8(&answer.body).unwrap());
    assert!(
        shown.contains("brinell_jobs_total") && !shown.contains("brinell_factor_cache_bytes"),
        "{shown:?}"
    );
}

#[test]
fn the_queue_is_seen_while_it_waits() {
    let service = InProcess::start(|_| ());
    let running = service.target.submit(&job("slow"));
    service.target.wait_for(&running, &["running"]);
    service.target.submit(&job("quick"));
    let text = String::from_utf8(service.target.get("/metrics").body).unwrap();
    assert_eq!(sample(&text, "brinell_queue_depth"), Some(1.0));
    assert_eq!(sample(&text, "brinell_jobs_running"), Some(1.0));
}

#[test]
fn metrics_can_have_a_port_of_their_own() {
    let free = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
    let server = Server::start_with(&["--metrics-listen", &free.to_string(), "--require-api-key"]);
    let answer = curl(&[&format!("http://{free}/metrics")]);
    assert_eq!(answer.status, 200);
    assert!(names(std::str::from_utf8(&answer.body).unwrap()).contains("brinell_queue_depth"));
    server.target.get("/metrics").problem(401, "unauthorized");
}

#[test]
fn the_dashboard_shows_what_there_is() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/deploy/grafana/brinell.json");
    let dashboard: Value = serde_json::from_slice(&fs::read(file).unwrap()).unwrap();
    let panels = dashboard["panels"].as_array().unwrap().iter();
    let targets = panels.flat_map(|panel| panel["targets"].as_array().unwrap());
    let mut asked = BTreeSet::new();
    for expression in targets.map(|target| target["expr"].as_str().unwrap()) {
        let words = expression.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
        let own =
            words.filter(|word| word.starts_with("brinell_") || word.starts_with("http_server_"));
        asked.extend(own.map(|word| {
            let endings = ["_bucket", "_sum", "_count"];
            endings.iter().find_map(|ending| word.strip_suffix(ending)).unwrap_or(word).to_owned()
        }));
    }
    let server = Server::start();
    exercise(&server.target);
    let shown = names(std::str::from_utf8(&server.target.get("/metrics").body).unwrap());
    assert_eq!(asked, shown, "the dashboard asks for what is measured, and for all of it");
}

#[test]
fn every_request_leaves_one_line_and_no_secret() {
    let mut server = Server::start_logging(&["--log-format", "json", "--log", "info"]);
    let id = server.target.submit(&example());
    server.target.wait_for(&id, &["succeeded"]);
    let id = id.rsplit('/').next().unwrap().to_owned();
    let secret = ["-H", "X-Request-Id: press-7", "-H", "Authorization: Basic brinell_secret"];
    let answer = server.target.post_with(
        "/v1/solve?wait=29.125",
        example().to_string(),
        &[&secret[..], &["-H", "Content-Type: application/json"]].concat(),
    );
    assert_eq!(answer.status, 200);
    server.target.get("/nowhere/at/all");
    server.signal("TERM");
    assert!(server.wait().success());
    let log = server.log();
    assert!(
        !log.contains("brinell_secret")
            && !log.contains("29.125")
            && !log.contains("young_modulus")
    );
    let lines: Vec<Value> = log.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let answered: Vec<&Value> =
        lines.iter().filter(|line| line["fields"]["message"] == "answered").collect();
    let of = |route: &str| {
        let found: Vec<_> =
            answered.iter().filter(|line| line["fields"]["route"] == route).collect();
        found
            .first()
            .map_or_else(|| panic!("no line of {route} in\n{log}"), |line| (found.len(), **line))
    };
    let (count, solve) = of("/v1/solve");
    assert_eq!(
        (count, &solve["span"]["id"], &solve["fields"]["status"]),
        (1, &"press-7".into(), &200.into())
    );
    assert_eq!(solve["fields"]["job"].as_str().map(str::len), Some(36));
    let (count, submitted) = of("/v1/jobs");
    assert_eq!((count, submitted["fields"]["job"].as_str()), (1, Some(id.as_str())));
    assert_eq!(of("/v1/jobs/{id}").1["fields"]["job"], id);
    let (count, lost) = of("none");
    assert_eq!((count, lost["fields"]["path"].as_str()), (1, Some("/nowhere/at/all")));
}
