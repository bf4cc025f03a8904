//! Going down in order.

use crate::in_process::{InProcess, job};
use crate::server::{DEADLINE, Server, example};
use std::time::Instant;

#[test]
fn sigterm_ends_an_idle_service_with_success() {
    for signal in ["TERM", "INT"] {
        let mut server = Server::start();
        server.target.assert_alive();
        server.signal(signal);
        assert_eq!(server.wait().code(), Some(0), "{signal}");
    }
}

#[test]
fn while_draining_jobs_finish_new_ones_are_refused_and_questions_answered() {
    let service = InProcess::start(|_| ());
    let target = service.target.clone();
    let running = target.submit(&job("slow"));
    let queued = target.submit(&job("quick"));
    target.wait_for(&running, &["running"]);
    service.stop.cancel();
    let started = Instant::now();
    while target.get("/readyz").status == 200 {
        assert!(started.elapsed() < DEADLINE, "still ready");
    }
    let refused = target.get("/readyz");
    refused.problem(503, "shutting-down");
    assert!(refused.header("retry-after").is_some());
    assert_eq!(target.get("/livez").status, 200);
    target.post("/v1/jobs", example().to_string()).problem(503, "shutting-down");
    assert_eq!(target.wait_for(&running, &["running"])["status"], "running");
    assert_eq!(target.wait_for(&queued, &["queued"])["queue_position"], 0);
    service.solver.open_gate();
    service.wait();
}

#[test]
fn what_is_left_after_the_grace_time_is_cancelled() {
    let service = InProcess::start(|config| config.grace = std::time::Duration::from_millis(50));
    let running = service.target.submit(&job("slow"));
    service.target.wait_for(&running, &["running"]);
    service.stop.cancel();
    service.wait();
}
