//! Invalid input: the service refuses it, names every faulty field and continues.

use serde_json::{Value, json};

use crate::curl::{Answer, pointers};
use crate::server::{Server, Target, example};

const PATHS: [&str; 3] = ["/v1/jobs", "/v1/solve", "/v1/validate"];

/// The example with one value replaced (or a key added).
fn spoilt(changes: &[(&str, Value)]) -> String {
    let mut job = example();
    for (pointer, value) in changes {
        let (parent, key) = pointer.rsplit_once('/').unwrap();
        job.pointer_mut(parent).unwrap()[key] = value.clone();
    }
    job.to_string()
}

/// Sends a text everywhere jobs are taken, checks each answer and that the service lives on.
#[track_caller]
fn refused_everywhere(text: &str, check: impl Fn(Answer)) {
    let server = Server::start();
    for path in PATHS {
        check(server.target.post(path, text));
    }
    server.target.assert_alive();
}

/// Expects 422 with exactly these pointers, in the order of the document.
#[track_caller]
fn fields_at_fault(changes: &[(&str, Value)], expected: &[&str]) {
    refused_everywhere(&spoilt(changes), |answer| {
        let problem = answer.problem(422, "invalid-job");
        assert_eq!(pointers(&problem), expected, "{problem}");
        for error in problem["errors"].as_array().unwrap() {
            assert!(error["detail"].as_str().is_some_and(|detail| !detail.is_empty()));
        }
    });
}

#[track_caller]
fn not_json(text: &str) {
    refused_everywhere(text, |answer| {
        let problem = answer.problem(400, "invalid-json");
        assert!(
            problem["line"].as_u64().is_some() && problem["column"].as_u64().is_some(),
            "{problem}"
        );
    });
}

#[test]
fn a_number_for_a_list_is_told_how_to_write_it() {
    refused_everywhere(&spoilt(&[("/load", json!({"forces": 612.5}))]), |answer| {
        let problem = answer.problem(422, "invalid-job");
        let fault = json!({
            "pointer": "#/load/forces",
            "code": "wrong_type",
            "detail": "must be an array, got a number; write [612.5] for a list of one",
        });
        assert_eq!(problem["errors"], json!([fault]));
    });
}

#[test]
fn nan_is_not_json() {
    for none in ["NaN", "Infinity", "-Infinity", "1e999"] {
        not_json(&spoilt(&[("/upper/shape/radius", json!(12.5))]).replace("12.5", none));
    }
}

#[test]
fn truncated_json() {
    let text = example().to_string();
    not_json(&text[..text.len() / 2]);
    not_json("");
}

#[test]
fn negative_radius() {
    fields_at_fault(&[("/upper/shape/radius", json!(-20.0))], &["/upper/shape/radius"]);
}

#[test]
fn poisson_ratio_of_one_half() {
    fields_at_fault(
        &[("/lower/material/poisson_ratio", json!(0.5))],
        &["/lower/material/poisson_ratio"],
    );
}

#[test]
fn tangent_modulus_not_below_youngs_modulus() {
    let pointer = "/upper/material/plasticity/tangent_modulus";
    for modulus in [210_000.0, 300_000.0] {
        fields_at_fault(&[(pointer, json!(modulus))], &[pointer]);
    }
}

#[test]
fn zero_load() {
    fields_at_fault(&[("/load/force", json!(0.0))], &["/load/force"]);
}

#[test]
fn unknown_keys() {
    fields_at_fault(&[("/upper/shape/raduis", json!(20.0))], &["/upper/shape/raduis"]);
    fields_at_fault(&[("/colour", json!("red"))], &["/colour"]);
}

#[test]
fn wrong_type() {
    let pointer = "/upper/material/young_modulus";
    fields_at_fault(&[(pointer, json!("stiff"))], &[pointer]);
    fields_at_fault(&[("/lower/shape/radius", json!(null))], &["/lower/shape/radius"]);
}

#[test]
fn a_million_elements_per_half_width() {
    let pointer = "/mesh/elements_per_half_width";
    fields_at_fault(&[(pointer, json!(1_000_000))], &[pointer]);
}

#[test]
fn everything_at_once_is_reported_at_once() {
    let faults = [
        "/upper/shape/radius",
        "/upper/material/poisson_ratio",
        "/upper/material/plasticity/tangent_modulus",
        "/lower/shape/radius",
        "/load/force",
        "/mesh/elements_per_half_width",
    ];
    let values = [json!(-20.0), json!(0.5), json!(1e9), json!("wide"), json!(0), json!(1_000_000)];
    let changes: Vec<_> = faults.into_iter().zip(values).collect();
    refused_everywhere(&spoilt(&changes), |answer| {
        let problem = answer.problem(422, "invalid-job");
        let mut found = pointers(&problem);
        found.sort_unstable();
        let mut expected = faults;
        expected.sort_unstable();
        assert_eq!(found, expected, "{problem}");
    });
}

#[test]
fn json_that_is_no_object() {
    for text in ["[]", "null", "3", "\"job\""] {
        refused_everywhere(text, |answer| {
            assert_eq!(pointers(&answer.problem(422, "invalid-job")), [""]);
        });
    }
}

#[test]
fn a_hundred_megabytes() {
    let server = Server::start();
    let service = &server.target;
    let heap = || vec![b' '; 100_000_000];
    let refused = |answer: Answer| {
        assert_eq!(answer.problem(413, "body-too-large")["limit_bytes"], 1 << 20);
    };
    let json = "Content-Type: application/json";
    // Asking first, as curl does with large bodies; not asking; and not even saying how much will
    // come.
    refused(service.post("/v1/jobs", heap()));
    refused(service.post_with("/v1/solve", heap(), &["-H", json, "-H", "Expect:"]));
    let chunked = ["-H", json, "-H", "Expect:", "-H", "Transfer-Encoding: chunked"];
    refused(service.post_with("/v1/validate", heap(), &chunked));
    assert!(peak_memory_kib(&server) < 100_000, "the body was kept");
    service.assert_alive();
}

/// The largest resident size of the process, where the system reports it.
fn peak_memory_kib(server: &Server) -> u64 {
    let status =
        std::fs::read_to_string(format!("/proc/{}/status", server.id())).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or(0)
}

#[test]
fn a_body_just_over_the_limit_and_one_just_under() {
    let server = Server::start_with(&["--max-body", "5000"]);
    let padded = |length: usize| format!("{:length$}", example().to_string());
    server.target.post("/v1/solve", padded(5001)).problem(413, "body-too-large");
    assert_eq!(server.target.post("/v1/solve", padded(5000)).status, 200);
}

#[test]
fn other_content_types() {
    let server = Server::start();
    let job = example().to_string();
    let send =
        |target: &Target, header: &str| target.post_with("/v1/jobs", job.clone(), &["-H", header]);
    for header in [
        "Content-Type: text/plain",
        "Content-Type:",
        "Content-Type: application/x-www-form-urlencoded",
    ] {
        send(&server.target, header).problem(415, "unsupported-media-type");
    }
    assert_eq!(send(&server.target, "Content-Type: application/json; charset=utf-8").status, 202);
    server.target.assert_alive();
}
