//! The memory budget of the solvers.

use std::num::NonZeroUsize;
use std::process::Command;

use serde_json::{Value, json};

use crate::in_process::{InProcess, job};
use crate::server::{Scratch, Server, example};

#[test]
fn a_job_above_the_budget_is_refused_with_its_estimate() {
    // A quarter is for small jobs.
    let server = Server::start_with(&["--memory-limit", "80"]);
    assert_eq!(server.target.get("/v1/capacity").json()["memory_bytes"], 80 << 20);
    let mut large = example();
    large["mesh"] = json!({"elements_per_half_width": 80});
    for path in ["/v1/jobs", "/v1/solve", "/v1/validate"] {
        let problem = server.target.post(path, large.to_string()).problem(422, "job-too-large");
        assert_eq!(
            problem["limit_bytes"],
            60 << 20,
            "the budget binds where --max-job-memory would not"
        );
        assert!(problem["estimate"]["bytes"].as_u64().is_some_and(|bytes| bytes > 60 << 20));
    }
    let mut small = example();
    small["mesh"] = json!({"elements_per_half_width": 4});
    assert_eq!(
        server.target.post("/v1/solve", small.to_string()).json()["result"]["status"],
        "converged"
    );
}

/// Flow theory holds increments to the end of the job, but no steps.
#[test]
fn a_history_is_refused_for_what_it_holds() {
    let server = Server::start_with(&["--memory-limit", "400"]);
    let verdict = |loads: usize, fields: bool, solver: Value| {
        let mut history = example();
        let load = |step: usize| json!({"force": 600.0 * step as f64 / loads as f64});
        history["load"] = json!({"history": (1..=loads).map(load).collect::<Vec<_>>()});
        (history["solver"], history["output"]) = (solver, json!({"fields": fields}));
        server.target.post("/v1/validate", history.to_string())
    };
    let flow = json!({"theory": "flow"});
    assert_eq!(verdict(300, true, flow).status, 200);
    verdict(1, false, json!({"theory": "flow", "increments": 10_000}))
        .problem(422, "job-too-large");
}

/// Six histories of ten thousand increments, which no estimate calls long.
#[test]
fn a_key_leaves_a_place_to_others_whatever_it_hands_in() {
    let data = Scratch::new();
    let service = InProcess::start(|config| config.storage.data_dir = data.0.clone());
    let key = |name: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_brinell"));
        let output =
            command.args(["key", "create", name, "--data-dir"]).arg(&data.0).output().unwrap();
        format!("Authorization: Bearer {}", String::from_utf8(output.stdout).unwrap().trim())
    };
    let [greedy, modest] = ["greedy", "modest"].map(key);
    let post = |key: &str, path: &str, job: &Value| {
        let headers = ["-H", key, "-H", "Content-Type: application/json"];
        service.target.post_with(path, job.to_string(), &headers)
    };
    let mut long = job("slow");
    long["solver"] = json!({"theory": "flow", "increments": 10_000});
    let queued: Vec<_> = (0..6).map(|_| post(&greedy, "/v1/jobs?priority=100", &long)).collect();
    let first = queued[0].header("location").unwrap();
    service.target.wait_for(first, &["running"]);
    for _ in 0..3 {
        assert_eq!(post(&modest, "/v1/solve", &job("quick")).status, 200);
        let queued = post(&modest, "/v1/jobs", &job("quick"));
        service.target.wait_for(queued.header("location").unwrap(), &["succeeded"]);
    }
    assert_eq!(service.target.get(first).json()["status"], "running");
    for job in &queued[1..] {
        assert_eq!(service.target.get(job.header("location").unwrap()).json()["status"], "queued");
    }
    service.solver.open_gate();
}

#[test]
fn a_job_that_takes_more_memory_than_there_is_fails_and_says_so() {
    let service = InProcess::start(|config| config.work.memory_limit = Some(16));
    let mut fine = job("understated");
    fine["mesh"] = json!({"elements_per_half_width": 40});
    let mut long = job("understated");
    (long["mesh"], long["output"]) =
        (json!({"elements_per_half_width": 4}), json!({"fields": false}));
    long["load"] = json!({"history": [{"force": 700.0}, {"force": 0.0}]});
    long["solver"] = json!({"theory": "flow", "increments": 10_000});
    let ball = json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"}, "material": {
            "young_modulus": 210_000, "poisson_ratio": 0.3,
            "plasticity": {"law": "bilinear", "yield_stress": 500, "tangent_modulus": 5000}}},
        "load": {"force": 200},
        "mesh": {"elements_per_half_width": 16},
        "tags": {"test": "understated"},
    });
    for greedy in [fine, long, ball] {
        let id = service.target.submit(&greedy);
        let failed = service.target.wait_for(&id, &["failed"]);
        let detail = failed["error"]["detail"].as_str().unwrap();
        assert!(detail.contains("MiB for bodies and increments"), "{detail}");
        service.target.get(&format!("{id}/result")).problem(409, "no-result");
    }
    let mut small = job("understated");
    small["mesh"] = json!({"elements_per_half_width": 4});
    let id = service.target.submit(&small);
    service.target.wait_for(&id, &["succeeded"]);
}

/// A job that needs several times as much memory as a small one.
fn large_job() -> Value {
    let mut large = job("slow");
    large["mesh"] = json!({"elements_per_half_width": 50});
    large
}

/// A service with three solvers, and room for so many tenths of a large job.
fn with_room_for(tenths: u64) -> InProcess {
    let estimate = InProcess::start(|_| ()).target.post("/v1/validate", large_job().to_string());
    let bytes = estimate.json()["estimate"]["bytes"].as_u64().unwrap();
    let mebibytes = u32::try_from((tenths * bytes / 10) >> 20).unwrap();
    InProcess::start(|config| {
        config.work.workers = NonZeroUsize::new(3);
        config.work.memory_limit = Some(mebibytes);
    })
}

#[test]
fn a_job_waits_until_there_is_memory_for_it() {
    let service = with_room_for(20);
    let target = &service.target;
    let first = target.submit(&large_job());
    target.wait_for(&first, &["running"]);
    let second = target.submit(&large_job());
    // A small job that goes before the second. Whoever takes it up has two solvers free, and comes
    // to the second too.
    let mut small = job("quick");
    small["mesh"] = json!({"elements_per_half_width": 4});
    let answer = target.post("/v1/jobs?priority=1", small.to_string());
    target.wait_for(answer.header("location").unwrap(), &["succeeded"]);
    assert_eq!(
        target.get(&second).json()["status"],
        "queued",
        "there is no room beside the first"
    );
    service.solver.open_gate();
    target.wait_for(&second, &["succeeded"]);
}

#[test]
fn jobs_that_fit_beside_each_other_run_at_the_same_time() {
    let service = with_room_for(30);
    let jobs = [(); 2].map(|()| service.target.submit(&large_job()));
    for id in &jobs {
        service.target.wait_for(id, &["running"]);
    }
    service.solver.open_gate();
    for id in &jobs {
        service.target.wait_for(id, &["succeeded"]);
    }
}
