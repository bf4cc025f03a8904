//! A job from submission to result.

use serde_json::json;

use crate::curl::pointers;
use crate::server::{Server, example};

#[test]
fn a_job_is_queued_followed_and_fetched() {
    let server = Server::start();
    let service = &server.target;
    let mut job = example();
    job["tags"] = json!({"bearing": "NU-210"});

    let accepted = service.post("/v1/jobs", job.to_string());
    assert_eq!(accepted.status, 202);
    let receipt = accepted.json();
    let location = accepted.header("location").expect("a Location");
    assert_eq!(receipt["links"]["self"], location);
    assert!(location.ends_with(receipt["id"].as_str().unwrap()));

    let finished = service.wait_for(location, &["succeeded"]);
    assert_eq!(finished["tags"]["bearing"], "NU-210");
    assert_eq!(finished["attempts"], 1);
    assert!(finished["progress"]["iterations"].as_u64().is_some_and(|count| count > 0));
    for time in ["created_at", "started_at", "finished_at"] {
        assert!(finished[time].as_str().is_some_and(|time| time.ends_with('Z')), "{time}");
    }

    let result = service.get(finished["links"]["result"].as_str().unwrap());
    assert_eq!((result.status, result.header("content-type")), (200, Some("application/json")));
    let report = result.json();
    assert_eq!(report["status"], "converged");
    assert!(crate::curl::value(&report["steps"][0], "peak_pressure") > 1000.0);
    assert!(report["steps"][0]["history"].as_array().is_some_and(|history| !history.is_empty()));
}

#[test]
fn solve_answers_with_the_result() {
    let server = Server::start();
    let answer = server.target.post("/v1/solve", example().to_string());
    assert_eq!((answer.status, answer.header("content-type")), (200, Some("application/json")));
    let address = answer.header("content-location").expect("where the job stays").to_owned();
    let job = answer.json();
    assert_eq!(server.target.get(&format!("{address}?wait=0")).json(), job);
    assert_eq!(server.target.get(job["links"]["result"].as_str().unwrap()).json(), job["result"]);
    assert_eq!(
        (&job["status"], &job["result"]["status"]),
        (&"succeeded".into(), &"converged".into())
    );
    assert_eq!((&job["done"], &job["has_result"]), (&true.into(), &true.into()));
    assert!(job["expires_at"].as_str() > job["finished_at"].as_str());
    for (name, link) in job["links"].as_object().unwrap() {
        let answer = server.target.get(link.as_str().unwrap());
        assert_eq!(answer.status, 200, "{name}");
    }
}

/// Links are to what the job has: those of flow theory are on its jobs alone, and all of them
/// answer.
#[test]
fn links_are_to_what_there_is() {
    let server = Server::start();
    let of_flow = ["increments_csv", "surface_csv", "surface_svg"];
    let mut flow = example();
    flow["solver"] = json!({"theory": "flow", "increments": 2});
    flow["output"] = json!({"subsurface": false, "fields": true});
    let mut one = example();
    one["solver"] = json!({"theory": "deformation"});
    let mut sweep = one.clone();
    sweep["load"] = json!({"forces": [300, 500]});
    let mut same = one.clone();
    same["load"] = json!({"forces": [300, 300]});
    for (job, is_flow, has_curve) in
        [(flow, true, true), (one, false, false), (sweep, false, true), (same, false, false)]
    {
        let answer = server.target.post("/v1/solve", job.to_string()).json();
        let links = answer["links"].as_object().unwrap();
        assert!(of_flow.iter().all(|name| links.contains_key(*name) == is_flow), "{links:?}");
        assert_eq!(links.contains_key("load_approach_svg"), has_curve);
        assert_eq!(links.contains_key("field_vtu"), is_flow);
        assert_eq!(links.contains_key("subsurface_csv"), !is_flow);
        for (name, link) in links {
            assert_eq!(server.target.get(link.as_str().unwrap()).status, 200, "{name}");
        }
    }
}

#[test]
fn validate_estimates_without_solving() {
    let server = Server::start();
    let answer = server.target.post("/v1/validate", example().to_string());
    assert_eq!(answer.status, 200);
    let verdict = answer.json();
    assert_eq!(verdict["valid"], true);
    assert!(verdict["estimate"]["equations"].as_u64().is_some_and(|count| count > 1000));
    assert!(verdict["estimate"]["bytes"].as_u64().is_some_and(|bytes| bytes > 100_000));

    let mut bad = example();
    bad["load"]["force"] = json!(-1.0);
    let problem = server.target.post("/v1/validate", bad.to_string()).problem(422, "invalid-job");
    assert_eq!(pointers(&problem), ["/load/force"]);
}

#[test]
fn a_job_too_large_is_refused_with_its_estimate() {
    let server = Server::start_with(&["--max-job-memory", "1"]);
    let mut job = example();
    job["mesh"]["elements_per_half_width"] = json!(80);
    for path in ["/v1/jobs", "/v1/solve", "/v1/validate"] {
        let problem = server.target.post(path, job.to_string()).problem(422, "job-too-large");
        assert!(problem["estimate"]["bytes"].as_u64().is_some_and(|bytes| bytes > 1 << 20));
        assert!(problem["estimate"]["equations"].as_u64().is_some_and(|count| count > 1000));
        assert_eq!(problem["limit_bytes"], 1 << 20);
    }
}

#[test]
fn cancelling_a_finished_job_changes_nothing() {
    let server = Server::start();
    let job = server.target.submit(&example());
    server.target.wait_for(&job, &["succeeded"]);
    let answer = server.target.post(&format!("{job}/cancel"), "");
    assert_eq!((answer.status, answer.json()["status"].as_str()), (200, Some("succeeded")));
}
