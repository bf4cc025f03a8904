//! kill -9 of the only process.

use crate::client::{Client, small_job};
use crate::server::{Scratch, Server};

#[test]
#[ignore = "full"]
fn five_hundred_queued_jobs_survive_kill_9() {
    let data = Scratch::new();
    let args = ["--data-dir", data.0.to_str().unwrap(), "--workers", "4"];
    let mut server = Server::start_with(&args);
    let mut client = Client::connect(&server.target.url);
    let ids = client.submit_small_jobs(1000);
    let queue = client.wait_until_running(3);
    assert!(queue["queued"].as_u64() >= Some(500), "{queue}");
    server.signal("KILL");
    server.wait();
    drop(server);

    let server = Server::start_with(&args);
    let mut client = Client::connect(&server.target.url);
    client.wait_until_idle();
    client.assert_all_succeeded(&ids);
    let jobs = client.all_jobs();
    let again = jobs.values().filter(|job| job["attempts"] == 2).count();
    assert!((1..=4).contains(&again), "{again} jobs ran twice; {queue} at the kill");
    assert!(
        jobs.values().all(|job| job["attempts"].as_u64().is_some_and(|attempts| attempts <= 2))
    );
}

#[test]
#[ignore = "full"]
fn sigterm_gives_unfinished_jobs_back_to_the_queue() {
    let data = Scratch::new();
    let args = ["--data-dir", data.0.to_str().unwrap(), "--workers", "1", "--grace", "0.01"];
    let mut server = Server::start_with(&args);
    let mut client = Client::connect(&server.target.url);
    let ids: Vec<String> = (0..100).map(|number| client.submit(&small_job(number))).collect();
    server.signal("TERM");
    assert_eq!(server.wait().code(), Some(0));
    drop(server);

    let server = Server::start_with(&args);
    let mut client = Client::connect(&server.target.url);
    client.wait_until_idle();
    client.assert_all_succeeded(&ids);
}
