//! Large results: in parts, in a binary form, in ranges, and not sent twice.

use brinell_solver::report::{FieldArrays, StepReport};
use serde_json::json;

use crate::curl::{Answer, curl};
use crate::server::{Server, example};

fn sweep(fields: bool) -> serde_json::Value {
    let mut job = example();
    job["mesh"] = json!({"elements_per_half_width": 4});
    job["load"] = json!({"forces": [300.0, 600.0, 900.0]});
    job["output"] = json!({"fields": fields});
    job
}

struct Solved {
    server: Server,
    job: String,
}

impl Solved {
    fn new(fields: bool) -> Self {
        let server = Server::start();
        let job = server.target.submit(&sweep(fields));
        server.target.wait_for(&job, &["succeeded"]);
        Self { server, job }
    }

    fn get(&self, path: &str, args: &[&str]) -> Answer {
        let url = format!("{}{}{path}", self.server.target.url, self.job);
        curl(&[args, &[&url]].concat())
    }
}

#[test]
fn a_result_is_had_in_parts() {
    let solved = Solved::new(true);
    let whole = solved.get("/result", &[]).json();
    let steps = whole["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 3);
    assert!(steps.iter().all(|step| step["fields"]["upper"]["nodes"].is_array()));

    let light = solved.get("/result?fields=false", &[]).json();
    assert!(light["steps"].as_array().unwrap().iter().all(|step| step.get("fields").is_none()));
    assert_eq!(light["steps"][1]["contact"], steps[1]["contact"]);
    assert_eq!(light["load_approach"], whole["load_approach"]);

    let second = solved.get("/result?step=2", &[]).json();
    assert_eq!(second["steps"], json!([steps[1]]));
    for query in ["?step=4", "?step=0", "?fields=maybe", "?part=1"] {
        solved.get(&format!("/result{query}"), &[]).problem(400, "invalid-query");
    }
}

#[test]
fn a_compressed_result_is_the_same_result() {
    let solved = Solved::new(false);
    let plain = solved.get("/result", &[]);
    let compressed = solved.get("/result", &["--compressed"]);
    assert_eq!(compressed.header("content-encoding"), Some("gzip"));
    assert_eq!(compressed.body, plain.body);
    assert_ne!(compressed.header("etag"), plain.header("etag"), "a strong tag names bytes");
    for answer in [&plain, &compressed] {
        assert_eq!(answer.header("vary"), Some("accept-encoding"));
    }
    let known = format!("If-None-Match: {}", plain.header("etag").unwrap());
    let again = solved.get("/result", &["-H", &known]);
    assert_eq!((again.status, again.body.len()), (304, 0));
}

#[test]
fn fields_are_had_as_arrays_of_numbers() {
    let solved = Solved::new(true);
    let answer = solved.get("/fields/2", &[]);
    assert_eq!((answer.status, answer.header("content-type")), (200, Some("application/octet-stream")));
    let read = FieldArrays::read(&answer.body).unwrap().decode().unwrap();
    let step = solved.get("/result?step=2", &[]).json()["steps"][0].clone();
    let step: StepReport = serde_json::from_value(step).unwrap();
    let (read, expected) = (read.upper.unwrap(), step.fields.unwrap().upper.unwrap());
    assert_eq!(read.elements, expected.elements);
    let largest = expected.von_mises.iter().copied().fold(0.0, f64::max);
    for (single, double) in read.von_mises.iter().zip(&expected.von_mises) {
        assert!((single - double).abs() < 1e-6 * largest, "{single} for {double}");
    }

    let range = solved.get("/fields/2", &["-r", "0-7"]);
    assert_eq!((range.status, range.body.as_slice()), (206, &b"BRNFLD01"[..]));
    assert_eq!(range.header("content-range"), Some(format!("bytes 0-7/{}", answer.body.len()).as_str()));
    let beyond = solved.get("/fields/2", &["-r", "99999999-"]);
    assert_eq!(beyond.status, 416);
    let known = format!("If-None-Match: {}", answer.header("etag").unwrap());
    assert_eq!(solved.get("/fields/2", &["-H", &known]).status, 304);
    let compressed = solved.get("/fields/2", &["--compressed"]);
    assert_eq!((compressed.header("content-encoding"), compressed.body == answer.body), (None, true));

    for path in ["/fields/4", "/fields/0", "/fields/x"] {
        solved.get(path, &[]).problem(404, "not-found");
    }
    Solved::new(false).get("/fields/1", &[]).problem(409, "not-in-result");
}

#[test]
fn a_result_too_large_is_refused_with_its_estimate() {
    let server = Server::start_with(&["--max-result", "1"]);
    let mut job = sweep(true);
    job["load"] = json!({"forces": (1..=1000).map(f64::from).collect::<Vec<_>>()});
    let problem = server.target.post("/v1/jobs", job.to_string()).problem(422, "job-too-large");
    assert!(problem["estimate"]["result_bytes"].as_u64().is_some_and(|bytes| bytes > 100 << 20), "{problem}");
    assert_eq!(problem["limit_bytes"], 1 << 20);
    job["load"] = json!({"force": 600.0});
    assert_eq!(server.target.post("/v1/jobs", job.to_string()).status, 202);
}
