//! Lists, examples, closed forms, capacity, and removal of jobs.

use serde_json::{Value, json};

use crate::curl::{curl, pointers};
use crate::in_process::{InProcess, job};
use crate::server::{Server, Target, example};

fn page(target: &Target, query: &str) -> (Vec<String>, Value) {
    let answer = target.get(&format!("/v1/jobs?{query}"));
    assert_eq!(answer.status, 200, "{}", String::from_utf8_lossy(&answer.body));
    let list = answer.json();
    let address = |job: &Value| job["links"]["self"].as_str().unwrap().to_owned();
    (list["jobs"].as_array().unwrap().iter().map(address).collect(), list["next_cursor"].clone())
}

#[test]
fn jobs_are_listed_newest_first_page_by_page() {
    let service = InProcess::start(|_| ());
    let target = &service.target;
    let slow = target.submit(&job("slow"));
    target.wait_for(&slow, &["running"]);
    let mut jobs = vec![slow.clone()];
    for _ in 0..4 {
        jobs.push(target.submit(&job("quick")));
    }
    jobs.reverse();
    assert_eq!(page(target, ""), (jobs.clone(), Value::Null));
    let (first, cursor) = page(target, "limit=2");
    assert_eq!(first, jobs[..2]);
    let (second, cursor) = page(target, &format!("limit=2&cursor={}", cursor.as_str().unwrap()));
    assert_eq!(second, jobs[2..4]);
    let (third, cursor) = page(target, &format!("limit=2&cursor={}", cursor.as_str().unwrap()));
    assert_eq!((third.as_slice(), cursor), (&jobs[4..], Value::Null));
    assert_eq!(page(target, "status=running").0, std::slice::from_ref(&slow));
    assert_eq!(page(target, "status=queued&tag=test:quick&limit=1").0, jobs[..1]);
    assert!(page(target, "tag=test:none").0.is_empty());
    assert_eq!(
        page(target, "status=running&status=queued&sort=oldest&limit=2").0,
        [slow.clone(), jobs[3].clone()]
    );
    let id = |job: &String| job.rsplit('/').next().unwrap().to_owned();
    assert_eq!(
        page(target, &format!("id={}&id={}", id(&jobs[3]), id(&jobs[1]))).0,
        [jobs[1].clone(), jobs[3].clone()]
    );
    assert_eq!(
        page(target, "since=2001-01-01T00:00:00Z&tag=test:slow").0,
        std::slice::from_ref(&slow)
    );
    assert!(page(target, "until=2001-01-01T00:00:00Z").0.is_empty());
    for query in ["sort=up", "since=now", "until=2001-01-01", "id=x", &"tag=a:b&".repeat(9)] {
        target.get(&format!("/v1/jobs?{query}")).problem(400, "invalid-query");
    }
    for query in ["status=lost", "limit=0", "limit=101", "cursor=x", "tag=test", "stat=queued"] {
        target.get(&format!("/v1/jobs?{query}")).problem(400, "invalid-query");
    }
    service.solver.open_gate();
}

#[test]
fn a_job_without_a_title_is_called_by_what_it_is_about_and_found_by_it() {
    let server = Server::start();
    let mut named = example();
    named["title"] = "Press 7".into();
    named["tags"] = json!({"bench": "north"});
    let [plain, named] = [example(), named].map(|job| server.target.submit(&job));
    let description = "cylinder R 20 on cylinder R 20, 612.61 N/mm, bilinear";
    let look = |job: &str| server.target.get(job).json();
    let said = |job: &str| [&look(job)["title"], &look(job)["description"]].map(Value::to_string);
    assert_eq!(said(&plain), [description; 2].map(|text| json!(text).to_string()));
    assert_eq!(said(&named), ["Press 7", description].map(|text| json!(text).to_string()));
    assert_eq!(look(&plain)["units"], "mm_N_MPa");
    assert_eq!(look(&named)["tags"], json!({"bench": "north"}));
    assert_eq!(page(&server.target, "search=cylinder+612").0, [named.clone(), plain]);
    assert_eq!(page(&server.target, "search=press+R").0, [named]);
}

#[test]
fn a_tag_that_no_job_can_have_is_refused() {
    let server = Server::start();
    for tag in ["a:%00", "%00:a", "a"] {
        server.target.get(&format!("/v1/jobs?tag={tag}")).problem(400, "invalid-query");
    }
}

#[test]
fn finished_jobs_are_deleted() {
    let service = InProcess::start(|_| ());
    let target = &service.target;
    let delete = |job: &str| curl(&["-X", "DELETE", &format!("{}{job}", target.url)]);
    let slow = target.submit(&job("slow"));
    target.wait_for(&slow, &["running"]);
    delete(&slow).problem(409, "job-unfinished");
    service.solver.open_gate();
    target.wait_for(&slow, &["succeeded"]);
    assert_eq!(delete(&slow).status, 204);
    delete(&slow).problem(404, "job-not-found");
    target.get(&format!("{slow}/result")).problem(404, "job-not-found");
}

#[test]
fn hertz_answers_without_a_mesh() {
    let server = Server::start();
    let answer = server.target.post("/v1/hertz", example().to_string());
    assert_eq!(answer.status, 200);
    let hertz = answer.json();
    assert_eq!(
        (hertz["units"].as_str(), hertz["steps"][0]["yields"].as_bool()),
        (Some("mm_N_MPa"), Some(true))
    );
    assert!(hertz["yield_onset_force"].as_f64().is_some_and(|force| force > 0.0 && force < 612.0));

    let mut sweep = example();
    sweep["load"] = json!({"forces": [1.0, 10.0]});
    let hertz = server.target.post("/v1/hertz", sweep.to_string()).json();
    assert_eq!(hertz["steps"].as_array().unwrap().len(), 2);
    assert_eq!(hertz["steps"][0]["yields"], false);
    sweep["load"] = json!({"approach": 0.01});
    let problem = server.target.post("/v1/hertz", sweep.to_string()).problem(422, "invalid-job");
    assert_eq!(pointers(&problem), ["/load"]);
}

/// The record is exact: E 206 GPa beside a stated 210, yield at 500 MPa.
#[test]
fn a_tensile_test_is_a_table_of_a_job() {
    let server = Server::start();
    let rise = (0..40).map(|k| 12.5 * f64::from(k)).map(|s| json!([s / 206e3, s]));
    let flow = (0..40).map(|k| 1e-3 * f64::from(k)).map(|p| {
        let stress = 500.0 + 2000.0 * p;
        json!([p + stress / 206e3, stress])
    });
    let mut test = json!({"points": rise.chain(flow).collect::<Vec<_>>(),
        "young_modulus": 210e3, "measure": "true"});
    let post = |test: &Value| server.target.post("/v1/hardening-curves", test.to_string());
    let curve = post(&test).json();
    let first = curve["points"][0][1].as_f64().unwrap();
    assert!((first / 500.0 - 1.0).abs() < 2e-3, "{curve}");
    let mut job = example();
    job["lower"]["material"]["plasticity"] = json!({"law": "table", "points": curve["points"]});
    assert_eq!(server.target.post("/v1/validate", job.to_string()).status, 200);
    test["young_modulus"] = json!(-1);
    assert_eq!(pointers(&post(&test).problem(422, "invalid-job")), ["/young_modulus"]);
    test["young_modulus"] = json!(21e6);
    assert_eq!(pointers(&post(&test).problem(422, "invalid-job")), ["/points"]);
}

#[test]
fn every_example_is_accepted_as_it_is_served() {
    let server = Server::start();
    let examples = server.target.get("/v1/examples").json();
    let examples = examples["examples"].as_array().unwrap();
    assert!(examples.len() >= 3);
    for example in examples {
        let answer = server.target.post("/v1/validate", example["job"].to_string());
        assert_eq!(answer.status, 200, "{}", example["name"]);
    }
}

#[test]
fn capacity_tells_how_busy_the_queue_is() {
    let service = InProcess::start(|config| config.storage.queue_capacity = 7);
    let slow = service.target.submit(&job("slow"));
    service.target.wait_for(&slow, &["running"]);
    service.target.submit(&job("quick"));
    let capacity = service.target.get("/v1/capacity").json();
    assert_eq!(capacity["solvers"], 1);
    assert_eq!(capacity["queue"], json!({"queued": 1, "running": 1, "capacity": 7}));
    assert_eq!(capacity["limits"]["body_bytes"], 1 << 20);
    assert!(capacity["memory_bytes"].as_u64().is_some_and(|bytes| bytes > 1 << 20));
    service.solver.open_gate();
}
