//! Workers whose lines to the database are slow, silent or late lose no job: the real program with
//! its own connections.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::client::{Client, small_job};
use crate::cluster::Cluster;
use crate::line::Line;
use crate::nodes::{WorkerProcess, database, service};
use crate::server::{Server, example};

/// Longest time for the jobs of a test. A worker whose server answers after 5 s starts in a minute.
const BOUND: Duration = Duration::from_secs(400);

/// Two workers on a line, and a service that no fault touches.
struct Fleet {
    line: Line,
    api: Server,
    _workers: [WorkerProcess; 2],
}

impl Fleet {
    fn start(solvers: usize, lease: &str) -> Self {
        let database = database(Cluster::shared());
        let api = service(&database, &["--no-workers"]);
        let line = Line::to(&database);
        let solvers = solvers.to_string();
        let start =
            || WorkerProcess::start_with(&line.url, &["--lease", lease, "--workers", &solvers]);
        let workers = [start(), start()];
        Self { line, api, _workers: workers }
    }

    /// Waits until the jobs have ended, and asserts that each has succeeded in its first attempt.
    fn assert_no_lease_is_lost(&self, ids: &[String]) {
        let mut client = Client::connect(&self.api.target.url);
        let begin = Instant::now();
        for id in ids {
            let job = loop {
                let (_, job) = client.get(&format!("/v1/jobs/{id}?wait=10"));
                if job["done"] == true {
                    break job;
                }
                assert!(begin.elapsed() < BOUND, "{job}");
            };
            assert_eq!(
                (&job["status"], &job["attempts"]),
                (&json!("succeeded"), &json!(1)),
                "{job}"
            );
        }
    }
}

/// A job whose three steps have fields of some 2 MB.
fn large_job() -> Value {
    let mut job = example();
    job["load"] = json!({"forces": [400, 500, 600]});
    job["mesh"] = json!({"elements_per_half_width": 28});
    job["output"] = json!({"fields": true});
    job
}

/// A step takes longer to write than a lease lasts, and a part of it less than a third of that.
#[test]
#[ignore = "full"]
fn no_lease_is_lost_through_a_slow_line() {
    for solvers in [1, 2, 4] {
        let fleet = Fleet::start(solvers, "6");
        let mut client = Client::connect(&fleet.api.target.url);
        fleet.line.set_rate(250_000);
        let mut ids: Vec<_> = (0..=2 * solvers).map(|_| client.submit(&large_job())).collect();
        ids.extend(client.submit_small_jobs(10));
        fleet.assert_no_lease_is_lost(&ids);
    }
}

/// The line falls silent again and again, for two thirds of what a lease has left after a beat.
#[test]
#[ignore = "full"]
fn no_lease_is_lost_through_a_line_that_falls_silent() {
    for solvers in [1, 2, 4] {
        let fleet = Fleet::start(solvers, "9");
        let mut client = Client::connect(&fleet.api.target.url);
        let mut ids: Vec<_> = (0..=2 * solvers).map(|_| client.submit(&large_job())).collect();
        ids.extend(client.submit_small_jobs(50));
        fleet.line.fall_silent(4, Duration::from_secs(4));
        fleet.assert_no_lease_is_lost(&ids);
    }
}

/// The fleets wait for most of the time, and do so at once.
#[test]
#[ignore = "full"]
fn no_lease_is_lost_to_a_server_that_answers_after_5_s() {
    let fleets = [1, 2, 4].map(|solvers| {
        let fleet = Fleet::start(solvers, "30");
        fleet.line.set_late(Duration::from_secs(5));
        let mut client = Client::connect(&fleet.api.target.url);
        let ids: Vec<_> =
            (0..2 * solvers).map(|number| client.submit(&small_job(number))).collect();
        (fleet, ids)
    });
    for (fleet, ids) in fleets {
        fleet.assert_no_lease_is_lost(&ids);
    }
}
