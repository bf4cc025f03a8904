//! Disk space and files of the store.

use std::process::Command;

use sqlx::Connection;

use crate::server::{Scratch, Server, example};

#[test]
fn below_the_reserve_no_job_is_accepted_and_readiness_says_so() {
    let server = Server::start_logging(&["--min-free-disk", "4294967295"]);
    let target = &server.target;
    for path in ["/v1/jobs", "/v1/solve"] {
        let answer = target.post(path, example().to_string());
        let problem = answer.problem(507, "insufficient-storage");
        assert_eq!(problem["detail"], "the disk is full");
        assert!(answer.header("retry-after").is_some());
    }
    target.get("/readyz").problem(507, "insufficient-storage");
    assert_eq!(target.get("/livez").status, 200);
    assert_eq!(target.get("/v1/jobs").json()["jobs"].as_array().map(Vec::len), Some(0));
    server.has_logged(&["the disk is full"]);
}

/// Jobs are their owner's, also beneath a permissive umask.
#[cfg(unix)]
#[test]
fn nobody_else_reads_the_database() {
    use std::os::unix::fs::PermissionsExt as _;
    let data = Scratch::new();
    let server = Server::start_with(&["--data-dir", data.0.to_str().unwrap()]);
    server.target.submit(&example());
    for name in ["brinell.db", "brinell.db-wal", "brinell.db-shm"] {
        let mode = data.0.join(name).metadata().unwrap().permissions().mode();
        assert_eq!(mode & 0o077, 0, "{name}: {mode:o}");
    }
}

/// Whoever keeps `brinell.db` keeps all jobs.
#[test]
#[ignore = "full"]
fn a_stop_leaves_everything_in_one_file() {
    let data = Scratch::new();
    let path = data.0.to_str().unwrap();
    for _ in 0..4 {
        let mut server = Server::start_with(&["--data-dir", path]);
        for _ in 0..15 {
            server.target.submit(&example());
        }
        server.signal("TERM");
        assert!(server.wait().success());
        assert!(!data.0.join("brinell.db-wal").exists());
    }
}

/// What is written to a file without a name ends with the process.
#[test]
fn no_job_is_accepted_once_the_files_are_gone_or_others() {
    for (file, is_replaced) in
        [("brinell.db", false), ("brinell.db", true), ("brinell.db-wal", false)]
    {
        let data = Scratch::new();
        let server = Server::start_logging(&["--data-dir", data.0.to_str().unwrap()]);
        server.target.submit(&example());
        std::fs::remove_file(data.0.join(file)).unwrap();
        if is_replaced {
            std::fs::write(data.0.join(file), "").unwrap();
        }
        server.target.post("/v1/jobs", example().to_string()).problem(503, "store-unavailable");
        server.target.get("/readyz").problem(503, "store-unavailable");
        let said = if is_replaced { "was replaced while it was open" } else { "No such file" };
        server.has_logged(&[said, file]);
    }
}

/// Runs a command of the program.
fn run(args: &[&str]) -> (bool, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_brinell")).args(args).output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8(text).unwrap())
}

#[test]
fn a_backup_is_made_beside_the_service_and_restored_elsewhere() {
    let (data, other) = (Scratch::new(), Scratch::new());
    let path = |scratch: &Scratch| scratch.0.to_str().unwrap().to_owned();
    let (here, there) = (path(&data), path(&other));
    let file = format!("{there}/backup");
    let elsewhere = format!("{there}/data");
    let (done, said) = run(&["backup", &file, "--data-dir", &elsewhere]);
    assert!(!done && said.contains("there is no database"), "{said}");

    let server = Server::start_with(&["--data-dir", &here]);
    let answer = server.target.post("/v1/solve", example().to_string());
    let job = answer.header("content-location").unwrap().to_owned();
    let result = server.target.get(&format!("{job}/result")).body;
    // What an interrupted backup has left is no backup and does not stop the next.
    std::fs::write(format!("{file}.partial"), "half of it").unwrap();
    let (done, said) = run(&["backup", &file, "--data-dir", &here]);
    assert!(done, "{said}");
    assert!(!std::fs::exists(format!("{file}.partial")).unwrap());
    let (done, said) = run(&["backup", &file, "--data-dir", &here]);
    assert!(!done && said.contains("exist"), "{said}");
    assert_eq!(run(&["check", "--data-dir", &here]), (true, "no damage found\n".to_owned()));
    let (done, said) = run(&["restore", &file, "--data-dir", &here]);
    assert!(!done && said.contains("in use by another process"), "{said}");
    drop(server);
    let (done, said) = run(&["restore", &file, "--data-dir", &here]);
    assert!(!done && said.contains("exists"), "{said}");

    let whole = std::fs::read(&file).unwrap();
    let half = format!("{there}/half");
    std::fs::write(&half, &whole[..whole.len() / 2]).unwrap();
    for bad in [&half, &format!("{there}/none"), &"Cargo.toml".to_owned()] {
        let (done, said) = run(&["restore", bad, "--data-dir", &elsewhere]);
        assert!(!done && said.contains("cannot be restored"), "{bad}: {said}");
    }
    let (done, said) = run(&["restore", &file, "--data-dir", &elsewhere]);
    assert!(done, "{said}");
    let restored = Server::start_with(&["--data-dir", &elsewhere]);
    assert_eq!(restored.target.get(&format!("{job}/result")).body, result);
    restored.target.assert_alive();
}

#[test]
fn a_backup_of_a_newer_version_is_refused() {
    let data = Scratch::new();
    let path = data.0.to_str().unwrap();
    let file = format!("{path}/newer");
    drop(Server::start_with(&["--data-dir", path]));
    assert!(run(&["backup", &file, "--data-dir", path]).0);
    sql(&file, "UPDATE _sqlx_migrations SET version = 9999 WHERE version = 1");
    let (done, said) = run(&["restore", &file, "--data-dir", &format!("{path}/data")]);
    assert!(!done && said.contains("a newer version"), "{said}");
}

#[test]
fn a_damaged_row_is_told_as_such() {
    let data = Scratch::new();
    let path = data.0.to_str().unwrap();
    let server = Server::start_logging(&["--data-dir", path]);
    let job = server.target.submit(&example());
    server.target.wait_for(&job, &["succeeded"]);
    sql(
        &format!("{path}/brinell.db"),
        "UPDATE result_steps SET body = x'00'; UPDATE requests SET body = x'00'",
    );
    server.target.get(&format!("{job}/request")).problem(500, "damaged-record");
    server.has_logged(&["a row of the store is damaged"]);
    let (done, said) = run(&["check", "--data-dir", path]);
    assert!(!done && said.starts_with("job "), "{said}");
}

/// Changes a database behind the back of the service.
fn sql(file: &str, statements: &'static str) {
    let runtime = tokio::runtime::Runtime::new().unwrap();
    runtime.block_on(async {
        let mut database =
            sqlx::SqliteConnection::connect(&format!("sqlite://{file}")).await.unwrap();
        sqlx::raw_sql(statements).execute(&mut database).await.unwrap();
        database.close().await.unwrap();
    });
}
