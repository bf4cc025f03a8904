//! Slow, stopped, impossible and faulty jobs: the failure of one does not affect others.

use std::time::{Duration, Instant};

use serde_json::json;

use crate::curl::{parse, pointers, spawn_curl};
use crate::in_process::{InProcess, job};
use crate::server::{DEADLINE, Scratch, Target};

#[track_caller]
fn assert_well(target: &Target) {
    assert_eq!(target.post("/v1/solve", job("quick").to_string()).json()["status"], "succeeded");
}

#[test]
fn a_panic_fails_its_job_alone_and_keeps_its_secrets() {
    let service = InProcess::start(|_| ());
    let answer = service.target.post("/v1/solve", job("panic").to_string());
    answer.problem(500, "internal");
    assert!(!String::from_utf8_lossy(&answer.body).contains("secret"));
    let id = service.target.submit(&job("panic"));
    let failed = service.target.wait_for(&id, &["failed"]);
    assert_eq!(failed["error"]["type"], "/problems/internal");
    assert!(!failed.to_string().contains("secret"));
    service.target.get(&format!("{id}/result")).problem(409, "no-result");
    assert_well(&service.target);
}

#[test]
fn no_nan_leaves() {
    let service = InProcess::start(|_| ());
    let problem =
        service.target.post("/v1/solve", job("nan").to_string()).problem(500, "solve-failed");
    assert!(
        problem["detail"].as_str().unwrap().contains("does not read back as it was written"),
        "{problem}"
    );
    assert_well(&service.target);
}

#[test]
fn input_that_turns_out_impossible_is_the_clients_fault() {
    let service = InProcess::start(|_| ());
    let problem = service
        .target
        .post("/v1/solve", job("impossible").to_string())
        .problem(422, "invalid-job");
    assert_eq!(pointers(&problem), ["/load/force"]);
    let id = service.target.submit(&job("impossible"));
    let failed = service.target.wait_for(&id, &["failed"]);
    assert_eq!(pointers(&failed["error"]), ["/load/force"]);
    let problem = service.target.get(&format!("{id}/result")).problem(409, "no-result");
    assert_eq!(pointers(&problem), ["/load/force"]);
}

#[test]
fn a_solver_that_gives_up_says_why() {
    let service = InProcess::start(|_| ());
    let problem =
        service.target.post("/v1/solve", job("fail").to_string()).problem(500, "solve-failed");
    assert_eq!(problem["detail"], "the matrix is not positive definite");
}

#[test]
fn not_converging_is_an_answer() {
    let service = InProcess::start(|_| ());
    let answer = service.target.post("/v1/solve", job("not_converged").to_string());
    assert_eq!((answer.status, answer.json()["status"].as_str()), (200, Some("not_converged")));
    let id = service.target.submit(&job("not_converged"));
    service.target.wait_for(&id, &["not_converged"]);
    assert_eq!(service.target.get(&format!("{id}/result")).status, 200);
}

#[test]
fn solve_past_its_limit_becomes_a_job() {
    let service = InProcess::start(|config| config.solve_limit = Duration::from_millis(50));
    let answer = service.target.post("/v1/solve", job("slow").to_string());
    assert_eq!(answer.status, 202);
    let id = answer.header("location").unwrap().to_owned();
    service.target.get(&format!("{id}/result")).problem(409, "job-unfinished");
    service.solver.open_gate();
    service.target.wait_for(&id, &["succeeded"]);
}

#[test]
fn solve_past_its_limit_survives_the_process() {
    let directory = Scratch::new();
    let start = |solve_limit| {
        InProcess::start(|config| {
            config.solve_limit = solve_limit;
            config.work.grace = Duration::from_millis(50);
            config.storage.data_dir.clone_from(&directory.0);
        })
    };
    let service = start(DEADLINE);
    let answered = service.target.post("/v1/solve", job("quick").to_string());
    let address = answered.header("content-location").unwrap().to_owned();
    service.stop.cancel();
    service.wait();

    let service = start(Duration::from_millis(50));
    assert_eq!(service.target.get(&format!("{address}?wait=0")).body, answered.body);
    let accepted = service.target.post("/v1/solve", job("slow").to_string());
    let id = accepted.header("location").unwrap().to_owned();
    assert_eq!(accepted.status, 202);
    service.target.wait_for(&id, &["running"]);
    service.stop.cancel();
    service.wait();

    let service = start(DEADLINE);
    service.solver.open_gate();
    assert_eq!(service.target.wait_for(&id, &["succeeded"])["attempts"], 2);
}

#[test]
fn a_waiting_client_hears_of_the_end() {
    let service = InProcess::start(|_| ());
    let id = service.target.submit(&job("slow"));
    let waiting = spawn_curl(&[&format!("{}{id}?wait=50", service.target.url)]);
    service.target.wait_for(&id, &["running"]);
    service.solver.open_gate();
    let answer = parse(&waiting.wait_with_output().unwrap().stdout).unwrap();
    assert_eq!(answer.json()["status"], "succeeded");
}

#[test]
fn cancelling_stops_running_and_queued_jobs_and_keeps_progress() {
    let service = InProcess::start(|_| ());
    let (running, queued) =
        (service.target.submit(&job("slow")), service.target.submit(&job("slow")));
    service.target.wait_for(&running, &["running"]);
    assert_eq!(service.target.wait_for(&queued, &["queued"])["queue_position"], 0);
    let answer = service.target.post(&format!("{queued}/cancel"), "");
    assert_eq!((answer.status, answer.json()["status"].as_str()), (200, Some("cancelled")));
    let answer = service.target.post(&format!("{running}/cancel"), "");
    assert_eq!((answer.status, answer.json()["cancel_requested"].as_bool()), (200, Some(true)));
    let stopped = service.target.wait_for(&running, &["cancelled"]);
    assert!(stopped["progress"]["latest"]["iteration"].as_u64().is_some_and(|count| count > 0));
    assert_eq!(service.target.get(&format!("{running}/result")).json()["status"], "cancelled");
    service.target.get(&format!("{queued}/result")).problem(409, "no-result");
    assert_well(&service.target);
}

#[test]
fn a_client_that_hangs_up_cancels_its_solve() {
    let service = InProcess::start(|_| ());
    let mut client = spawn_curl(&[
        "-H",
        "Content-Type: application/json",
        "--data-binary",
        &job("slow").to_string(),
        &format!("{}/v1/solve", service.target.url),
    ]);
    // The one slot is taken by the client's job once another has to queue behind it.
    let started = Instant::now();
    let behind = loop {
        let other = service.target.submit(&job("quick"));
        let state = service.target.get(&other).json();
        if state["status"] == "queued"
            && service.target.get(&format!("{other}?wait=0.2")).json()["status"] == "queued"
        {
            break other;
        }
        assert!(started.elapsed() < DEADLINE, "the client's job does not start");
    };
    client.kill().unwrap();
    client.wait().unwrap();
    service.target.wait_for(&behind, &["succeeded"]);
}

#[test]
fn a_job_past_its_deadline_is_stopped() {
    let service = InProcess::start(|config| config.work.job_timeout = Duration::from_millis(20));
    let id = service.target.submit(&job("slow"));
    service.target.wait_for(&id, &["timed_out"]);
    assert_eq!(service.target.get(&format!("{id}/result")).json()["status"], "timed_out");
    assert_well(&service.target);
}

/// A full disk does not hold a solver for ever.
#[test]
fn a_job_whose_steps_are_not_taken_ends_at_its_deadline() {
    let service = InProcess::start(|config| {
        config.storage.keep_memory = 4;
        config.work.job_timeout = Duration::from_secs(3);
    });
    let mut flood = job("flood");
    flood["output"] = json!({"fields": true});
    flood["mesh"] = json!({"elements_per_half_width": 4});
    let id = service.target.submit(&flood);
    let failed = service.target.wait_for(&id, &["failed"]);
    assert_eq!(
        failed["error"]["detail"],
        "results of steps could not be stored: the disk is full"
    );
    service.target.get(&format!("{id}/result")).problem(409, "no-result");
    assert_well(&service.target);
}

#[test]
fn a_full_queue_asks_to_come_back() {
    let service = InProcess::start(|config| config.storage.queue_capacity = 1);
    let running = service.target.submit(&job("slow"));
    service.target.wait_for(&running, &["running"]);
    let queued = service.target.submit(&job("quick"));
    for path in ["/v1/jobs", "/v1/solve"] {
        let answer = service.target.post(path, job("quick").to_string());
        answer.problem(429, "queue-full");
        assert!(
            answer.header("retry-after").is_some_and(|seconds| seconds.parse::<u32>().is_ok())
        );
    }
    assert_eq!(
        service.target.get("/readyz").status,
        200,
        "a full queue is no reason to be taken out of service"
    );
    service.solver.open_gate();
    service.target.wait_for(&queued, &["succeeded"]);
    assert_well(&service.target);
}
