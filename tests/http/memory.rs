//! The memory budget of the solvers.

use std::num::NonZeroUsize;

use serde_json::json;

use crate::in_process::{InProcess, job};
use crate::server::{Server, example};

#[test]
fn a_job_above_the_budget_is_refused_with_its_estimate() {
    let server = Server::start_with(&["--memory-limit", "8"]);
    assert_eq!(server.target.get("/v1/capacity").json()["memory_bytes"], 8 << 20);
    let mut large = example();
    large["mesh"] = json!({"elements_per_half_width": 80});
    for path in ["/v1/jobs", "/v1/solve", "/v1/validate"] {
        let problem = server.target.post(path, large.to_string()).problem(422, "job-too-large");
        assert_eq!(problem["limit_bytes"], 8 << 20, "the budget binds where --max-job-memory would not");
        assert!(problem["estimate"]["bytes"].as_u64().is_some_and(|bytes| bytes > 8 << 20));
    }
    let mut small = example();
    small["mesh"] = json!({"elements_per_half_width": 4});
    assert_eq!(server.target.post("/v1/solve", small.to_string()).json()["status"], "converged");
}

/// How many of four equal jobs two solvers work on at once, with room for so many tenths of a job.
fn most_at_once(tenths: u64) -> usize {
    let estimate = InProcess::start(|_| ()).target.post("/v1/validate", job("meet").to_string());
    let bytes = estimate.json()["estimate"]["bytes"].as_u64().unwrap();
    let mebibytes = u32::try_from((tenths * bytes / 10) >> 20).unwrap();
    let service = InProcess::start(|config| {
        config.work.workers = NonZeroUsize::new(2);
        config.work.memory_limit = Some(mebibytes);
    });
    let jobs: Vec<String> = (0..4).map(|_| service.target.submit(&job("meet"))).collect();
    for id in &jobs {
        service.target.wait_for(id, &["succeeded"]);
    }
    service.solver.most_at_once()
}

#[test]
fn jobs_are_admitted_within_the_budget() {
    assert_eq!(most_at_once(15), 1, "room for one: the second solver stays free");
    assert_eq!(most_at_once(25), 2);
}
