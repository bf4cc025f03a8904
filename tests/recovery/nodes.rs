//! Several processes on one PostgreSQL.

use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Instant;

use serde_json::Value;
use tokio::runtime::Runtime;

use crate::client::Client;
use crate::cluster::Cluster;
use crate::curl::spawn_curl;
use crate::server::{DEADLINE, Server, example};

pub fn database(cluster: &Cluster) -> String {
    Runtime::new().unwrap().block_on(cluster.database())
}

pub fn service(database: &str, more: &[&str]) -> Server {
    Server::start_with(&[&["--database-url", database, "--lease", "2"], more].concat())
}

/// A running `brinell worker`.
pub struct WorkerProcess(Child);

impl WorkerProcess {
    fn start(database: &str) -> Self {
        Self::start_with(database, &["--lease", "2", "--workers", "2"])
    }

    pub fn start_with(database: &str, more: &[&str]) -> Self {
        let child = Command::new(env!("CARGO_BIN_EXE_brinell"))
            .args(["worker", "--database-url", database])
            .args(more)
            .env("BRINELL_LOG", "warn")
            .stdin(Stdio::null())
            .spawn();
        Self(child.expect("the binary starts"))
    }
}

impl Drop for WorkerProcess {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
fn a_job_is_the_same_on_every_node() {
    let database = database(Cluster::shared());
    let (here, there) =
        (service(&database, &["--no-workers"]), service(&database, &["--no-workers"]));
    let id = here.target.submit(&example());
    assert_eq!(there.target.get(&id).json()["status"], "queued");
    let follower = spawn_curl(&[&format!("{}{id}/events", there.target.url)]);
    let waiting = spawn_curl(&[&format!("{}{id}?wait=50", there.target.url)]);
    let cancelled = here.target.submit(&example());
    there.target.post(&format!("{cancelled}/cancel"), "");
    assert_eq!(here.target.get(&cancelled).json()["status"], "cancelled");

    let _worker = WorkerProcess::start(&database);
    let finished = here.target.wait_for(&id, &["succeeded"]);
    let text = String::from_utf8(waiting.wait_with_output().unwrap().stdout).unwrap();
    assert!(text.contains("\"status\":\"succeeded\""), "{text}");
    let text = String::from_utf8(follower.wait_with_output().unwrap().stdout).unwrap();
    let iterations = finished["progress"]["iterations"].as_u64().unwrap();
    assert_eq!(text.matches("event: iteration").count() as u64, iterations);
    let result = format!("{id}/result");
    assert_eq!(here.target.get(&result).body, there.target.get(&result).body);
}

#[test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
fn a_running_job_is_cancelled_from_another_node() {
    let database = database(Cluster::shared());
    let (solving, asking) =
        (service(&database, &["--workers", "1"]), service(&database, &["--no-workers"]));
    let mut long = example();
    long["mesh"]["elements_per_half_width"] = 160.into();
    let id = asking.target.submit(&long);
    asking.target.wait_for(&id, &["running"]);
    asking.target.post(&format!("{id}/cancel"), "");
    let stopped = solving.target.wait_for(&id, &["cancelled", "succeeded"]);
    assert_eq!(stopped["cancel_requested"], true);
}

#[test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
fn the_same_idempotency_key_on_two_nodes_at_the_same_instant_is_one_job() {
    let database = database(Cluster::shared());
    let nodes = [service(&database, &["--no-workers"]), service(&database, &["--no-workers"])];
    for round in 0..20 {
        let header = format!("Idempotency-Key: round-{round}\r\n");
        let ask = |node: &Server| {
            let (mut client, header) = (Client::connect(&node.target.url), header.clone());
            thread::spawn(move || client.ask("POST", "/v1/jobs", &header, &example().to_string()))
        };
        let answers: Vec<(u16, Value)> = nodes
            .iter()
            .map(ask)
            .collect::<Vec<_>>()
            .into_iter()
            .map(|asked| asked.join().unwrap())
            .collect();
        assert_eq!((answers[0].0, answers[1].0), (202, 202), "{answers:?}");
        assert_eq!(answers[0].1["id"], answers[1].1["id"]);
    }
    assert_eq!(Client::connect(&nodes[0].target.url).all_jobs().len(), 20);
}

#[test]
#[ignore = "full"]
fn a_killed_worker_s_jobs_are_run_by_the_other() {
    let database = database(Cluster::shared());
    let api = service(&database, &["--no-workers"]);
    let mut client = Client::connect(&api.target.url);
    let ids = client.submit_small_jobs(300);
    let (mut doomed, _other) = (WorkerProcess::start(&database), WorkerProcess::start(&database));
    client.wait_until_running(3);
    doomed.0.kill().unwrap();
    doomed.0.wait().unwrap();
    client.wait_until_idle();
    client.assert_all_succeeded(&ids);
}

#[test]
#[ignore = "full"]
fn nodes_outlive_a_restart_of_the_database() {
    let mut cluster = Cluster::start();
    let database = database(&cluster);
    let api = service(&database, &["--workers", "2"]);
    let _worker = WorkerProcess::start(&database);
    let mut client = Client::connect(&api.target.url);
    let ids = client.submit_small_jobs(300);
    client.wait_until_running(1);
    cluster.restart();
    client.wait_until_idle();
    client.assert_all_succeeded(&ids);
    api.target.assert_alive();
}

/// Told to try again, whoever waits would hand the job in twice.
#[test]
#[cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
fn a_job_that_was_taken_in_is_not_refused_when_the_database_goes_away() {
    let cluster = Cluster::start();
    let database = database(&cluster);
    let api = service(&database, &["--no-workers"]);
    let (job, url) = (example().to_string(), format!("{}/v1/jobs?wait=50", api.target.url));
    let as_json = ["-H", "Content-Type: application/json", "--data-binary", &job];
    let waiting =
        spawn_curl(&[&as_json[..], &["-w", " %{http_code} %header{location}", &url]].concat());
    let is_taken_in = || {
        api.target.get("/v1/jobs").json()["jobs"].as_array().is_some_and(|jobs| !jobs.is_empty())
    };
    let started = Instant::now();
    while !is_taken_in() {
        assert!(started.elapsed() < DEADLINE, "the job is not taken in");
    }
    drop(cluster);
    let text = String::from_utf8(waiting.wait_with_output().unwrap().stdout).unwrap();
    assert!(text.contains("\"status\":\"queued\"") && text.contains(" 202 /v1/jobs/"), "{text}");
}
