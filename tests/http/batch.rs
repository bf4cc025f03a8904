//! Several jobs in one request.

use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::{Value, json};

use crate::curl::{Answer, curl, pointers};
use crate::in_process::{InProcess, job};
use crate::server::{Server, Target, example};

fn submit(target: &Target, jobs: &[Value], header: &str) -> Answer {
    let body = json!({ "jobs": jobs }).to_string();
    target.post_with(
        "/v1/batch/submit",
        body,
        &["-H", "Content-Type: application/json", "-H", header],
    )
}

/// The items of an answer.
#[track_caller]
fn items(answer: &Answer) -> Vec<Value> {
    assert_eq!(answer.status, 200, "{}", String::from_utf8_lossy(&answer.body));
    let answer = answer.json();
    let items = answer["jobs"].as_array().unwrap().clone();
    let refused = items.iter().filter(|item| item["problem"].is_object()).count();
    assert_eq!(
        (&answer["accepted"], &answer["refused"]),
        (&json!(items.len() - refused), &json!(refused))
    );
    items
}

fn ids_of(items: &[Value]) -> Vec<Value> {
    items.iter().map(|item| item["job"]["id"].clone()).collect()
}

#[test]
fn each_job_is_answered_as_by_itself() {
    let service = InProcess::start(|_| ());
    let mut wrong = example();
    wrong["upper"]["shape"]["radius"] = json!(-1.0);
    wrong["lower"]["colour"] = json!("red");
    let jobs = [
        json!({"job": job("slow"), "priority": 7}),
        json!({"job": wrong}),
        json!({"job": 3}),
        json!({"job": job("quick"), "priority": null}),
    ];
    let answered = items(&submit(&service.target, &jobs, "Accept: */*"));
    let statuses: Vec<_> = answered.iter().map(|item| item["status"].as_u64().unwrap()).collect();
    assert_eq!(statuses, [202, 422, 422, 202]);
    assert_eq!(answered[0]["job"]["priority"], 7);
    let problem = &answered[1]["problem"];
    assert_eq!(problem["type"], "/problems/invalid-job");
    assert_eq!(pointers(problem), ["/lower/colour", "/upper/shape/radius"]);
    assert_eq!(answered[2]["problem"]["errors"][0]["code"], "wrong_type");

    let unknown = brinell::jobs::JobId::generate();
    let ids = json!({"ids": [answered[3]["job"]["id"], unknown, answered[0]["job"]["id"]]});
    let cancelled = items(&service.target.post("/v1/batch/cancel", ids.to_string()));
    assert_eq!(cancelled[1]["problem"]["type"], "/problems/job-not-found");
    assert_eq!((&cancelled[1]["status"], &cancelled[1]["id"]), (&json!(404), &ids["ids"][1]));
    assert!(cancelled[0]["job"]["cancel_requested"].as_bool().unwrap());
    assert_eq!(cancelled[2]["id"], ids["ids"][2]);
    service.target.wait_for(answered[0]["job"]["links"]["self"].as_str().unwrap(), &["cancelled"]);
}

#[test]
fn a_request_of_the_wrong_form_does_nothing() {
    let service = InProcess::start(|_| ());
    let many = vec![json!({"job": job("quick")}); 101];
    for (jobs, pointer) in
        [(many, "/jobs"), (vec![json!({"job": job("quick"), "prio": 1})], "/jobs/0/prio")]
    {
        let problem = submit(&service.target, &jobs, "Accept: */*").problem(422, "invalid-batch");
        assert_eq!(pointers(&problem), [pointer]);
    }
    for path in ["submit", "cancel", "fetch"] {
        service
            .target
            .post(&format!("/v1/batch/{path}"), "{\"jobs\": [")
            .problem(400, "invalid-json");
        service.target.post(&format!("/v1/batch/{path}"), "[]").problem(422, "invalid-batch");
    }
    assert_eq!(service.target.get("/v1/jobs").json()["jobs"], json!([]));
}

#[test]
fn the_same_batch_under_the_same_key_is_the_same_jobs() {
    let service = InProcess::start(|_| ());
    let key = "Idempotency-Key: press-7";
    let mut jobs =
        vec![json!({"job": job("quick")}), json!({"job": job("other"), "idempotency_key": "own"})];
    let first = items(&submit(&service.target, &jobs, key));
    let again = items(&submit(&service.target, &jobs, key));
    assert_eq!(ids_of(&first), ids_of(&again));
    assert!(
        again.iter().all(|item| item["replayed"] == true)
            && first.iter().all(|item| item["replayed"].is_null())
    );
    jobs[0] = json!({"job": job("third")});
    let changed = items(&submit(&service.target, &jobs, key));
    assert_eq!(changed[0]["problem"]["type"], "/problems/idempotency-key-reused");
    assert_eq!(changed[1]["job"]["id"], first[1]["job"]["id"]);
}

#[test]
fn a_full_queue_refuses_the_jobs_that_do_not_fit() {
    let service = InProcess::start(|config| config.storage.queue_capacity = 3);
    let running = service.target.submit(&job("slow"));
    service.target.wait_for(&running, &["running"]);
    let jobs = vec![json!({"job": job("slow")}); 5];
    let answered = items(&submit(&service.target, &jobs, "Idempotency-Key: x"));
    let statuses: Vec<_> = answered.iter().map(|item| item["status"].as_u64().unwrap()).collect();
    assert_eq!(statuses, [202, 202, 202, 429, 429]);
    assert_eq!(answered[4]["problem"]["type"], "/problems/queue-full");
    service.solver.open_gate();
    for item in &answered[..3] {
        service.target.wait_for(item["job"]["links"]["self"].as_str().unwrap(), &["succeeded"]);
    }
    let again = items(&submit(&service.target, &jobs, "Idempotency-Key: x"));
    assert_eq!(ids_of(&again[..3]), ids_of(&answered[..3]), "what was refused has left no trace");
    assert_eq!(again[4]["status"], 202);
}

#[test]
fn jobs_are_fetched_with_the_parts_of_their_results_that_are_wanted() {
    let server = Server::start();
    let mut sweep = example();
    sweep["load"] = json!({"forces": [300.0, 400.0]});
    sweep["output"] = json!({"fields": true, "subsurface": true});
    let answered = items(&submit(
        &server.target,
        &[json!({"job": sweep}), json!({"job": example()})],
        "Accept: */*",
    ));
    let ids = ids_of(&answered);
    for item in &answered {
        server.target.wait_for(item["job"]["links"]["self"].as_str().unwrap(), &["succeeded"]);
    }
    let asked = json!({"ids": [ids[0], brinell::jobs::JobId::generate(), ids[1]]}).to_string();
    let fetched = items(&server.target.post("/v1/batch/fetch", asked.clone()));
    let result =
        server.target.get(&format!("/v1/jobs/{}/result", ids[0].as_str().unwrap())).json();
    assert_eq!(fetched[0]["job"]["result"], result);
    assert_eq!(fetched[1]["problem"]["type"], "/problems/job-not-found");
    assert_eq!(
        (&fetched[2]["job"]["id"], &fetched[2]["job"]["result"]["status"]),
        (&ids[1], &json!("converged"))
    );

    let parts = items(&server.target.post("/v1/batch/fetch?step=2&fields=contact", asked));
    let result = server
        .target
        .get(&format!("/v1/jobs/{}/result?step=2&fields=contact", ids[0].as_str().unwrap()));
    assert_eq!(parts[0]["job"]["result"], result.json());
    assert_eq!(parts[2]["problem"]["type"], "/problems/step-not-found");
}

#[test]
fn a_job_that_is_removed_meanwhile_does_not_touch_the_others() {
    let service = InProcess::start(|_| ());
    let jobs: Vec<Value> = (0..30).map(|_| json!({"job": job("quick")})).collect();
    let answered = items(&submit(&service.target, &jobs, "Accept: */*"));
    let ids = ids_of(&answered);
    let addresses: Vec<&str> =
        answered.iter().map(|item| item["job"]["links"]["self"].as_str().unwrap()).collect();
    for address in &addresses {
        service.target.wait_for(address, &["succeeded"]);
    }
    let asked = json!({"ids": ids}).to_string();
    let are_left = AtomicBool::new(true);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            for address in &addresses {
                curl(&["-X", "DELETE", &format!("{}{address}", service.target.url)]);
            }
            are_left.store(false, Ordering::Relaxed);
        });
        while are_left.load(Ordering::Relaxed) {
            let fetched = items(&service.target.post("/v1/batch/fetch", asked.clone()));
            assert_eq!(fetched.len(), ids.len(), "the answer is whole");
        }
    });
    let fetched = items(&service.target.post("/v1/batch/fetch", asked));
    assert!(fetched.iter().all(|item| item["problem"]["type"] == "/problems/job-not-found"));
}
