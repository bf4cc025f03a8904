//! The real binary on a free port.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdout, Command, ExitStatus, Stdio};
use std::time::Instant;

use serde_json::Value;

use crate::curl::{Answer, curl, curl_with_input};

#[path = "../support/deadline.rs"]
mod deadline;
pub use deadline::DEADLINE;

/// The reference problem as a JSON value, for tests to change.
pub fn example() -> Value {
    serde_json::from_str(include_str!("../../api/examples/two_cylinders.json"))
        .expect("the example is JSON")
}

/// The address of a service, with requests to it.
#[derive(Debug, Clone)]
pub struct Target {
    pub url: String,
}

impl Target {
    pub fn get(&self, path: &str) -> Answer {
        curl(&[&format!("{}{path}", self.url)])
    }

    pub fn post(&self, path: &str, body: impl Into<Vec<u8>>) -> Answer {
        self.post_with(path, body, &["-H", "Content-Type: application/json"])
    }

    pub fn post_with(&self, path: &str, body: impl Into<Vec<u8>>, args: &[&str]) -> Answer {
        let url = format!("{}{path}", self.url);
        let args = [args, &["--data-binary", "@-", &url]].concat();
        curl_with_input(&args, body.into())
    }

    /// Queues a job and returns its address.
    #[track_caller]
    pub fn submit(&self, job: &Value) -> String {
        let answer = self.post("/v1/jobs", job.to_string());
        assert_eq!(answer.status, 202, "{}", answer.json());
        answer.header("location").expect("a Location").to_owned()
    }

    /// Waits until the job is in one of these states and returns it.
    #[track_caller]
    pub fn wait_for(&self, job: &str, states: &[&str]) -> Value {
        let started = Instant::now();
        loop {
            let answer = self.get(&format!("{job}?wait=0.05"));
            assert_eq!(answer.status, 200);
            let document = answer.json();
            if states.iter().any(|state| document["status"] == *state) {
                return document;
            }
            assert!(started.elapsed() < DEADLINE, "still {document}");
        }
    }

    /// Asserts that the service answers and solves.
    #[track_caller]
    pub fn assert_alive(&self) {
        assert_eq!(self.get("/livez").status, 200);
        assert_eq!(self.get("/readyz").status, 200);
        let answer = self.post("/v1/solve", example().to_string());
        assert_eq!(answer.status, 200, "{}", String::from_utf8_lossy(&answer.body));
        assert_eq!(answer.json()["result"]["status"], "converged");
    }
}

/// A directory that is removed in the end.
#[derive(Debug)]
pub struct Scratch(pub PathBuf);

impl Scratch {
    pub fn new() -> Self {
        let name = format!("brinell-test-{}", brinell::jobs::JobId::generate());
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        std::fs::create_dir_all(&path).expect("a scratch directory can be made");
        Self(path)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A running `brinell serve`.
pub struct Server {
    pub target: Target,
    child: Child,
    data: Scratch,
    // Kept open: a service whose standard output is closed would be another test.
    _stdout: BufReader<ChildStdout>,
}

impl Server {
    pub fn start() -> Self {
        Self::start_with(&[])
    }

    /// With a data directory of its own, unless the arguments say otherwise.
    pub fn start_with(args: &[&str]) -> Self {
        Self::start_in(Scratch::new(), args, Stdio::inherit())
    }

    /// With its log kept for [`Server::log`].
    pub fn start_logging(args: &[&str]) -> Self {
        let data = Scratch::new();
        let log = File::create(data.0.join("log")).expect("a file can be made");
        Self::start_in(data, args, log.into())
    }

    /// On a copy of a database that another version has written.
    pub fn start_on(database: &Path) -> Self {
        let data = Scratch::new();
        std::fs::copy(database, data.0.join("brinell.db")).expect("a database can be copied");
        Self::start_in(data, &[], Stdio::inherit())
    }

    /// Under a limit on open files.
    pub fn start_with_files(files: u32, args: &[&str]) -> Self {
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("ulimit -n {files} && exec \"$0\" \"$@\"")]);
        shell.arg(env!("CARGO_BIN_EXE_brinell"));
        Self::spawn(shell, Scratch::new(), args, Stdio::inherit())
    }

    fn start_in(data: Scratch, args: &[&str], log: Stdio) -> Self {
        Self::spawn(Command::new(env!("CARGO_BIN_EXE_brinell")), data, args, log)
    }

    fn spawn(mut command: Command, data: Scratch, args: &[&str], log: Stdio) -> Self {
        let mut child = command
            .args(["serve", "--listen", "127.0.0.1:0"])
            .args(args)
            .env("BRINELL_DATA_DIR", &data.0)
            .env("BRINELL_LOG", "warn")
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(log)
            .spawn()
            .expect("the binary starts");
        let mut stdout = BufReader::new(child.stdout.take().expect("a pipe"));
        let mut line = String::new();
        stdout.read_line(&mut line).expect("the service says where it listens");
        let url =
            line.trim().strip_prefix("brinell listening on ").expect("an address").to_owned();
        Self { target: Target { url }, child, data, _stdout: stdout }
    }

    /// What it has logged so far, if that is kept.
    pub fn log(&self) -> String {
        std::fs::read_to_string(self.data.0.join("log")).expect("the log is kept")
    }

    /// Waits for a line of the log with these parts: an answer may leave before its line is written.
    #[track_caller]
    pub fn has_logged(&self, parts: &[&str]) {
        let started = Instant::now();
        loop {
            let log = self.log();
            if log.lines().any(|line| parts.iter().all(|part| line.contains(part))) {
                return;
            }
            assert!(started.elapsed() < DEADLINE, "no line with {parts:?} in\n{log}");
            std::thread::yield_now();
        }
    }

    /// The process.
    pub fn id(&self) -> u32 {
        self.child.id()
    }

    /// Sends a signal by name.
    pub fn signal(&self, name: &str) {
        let sent = Command::new("kill").args(["-s", name, &self.child.id().to_string()]).status();
        assert!(sent.expect("kill runs").success());
    }

    /// Waits for the process to end.
    #[track_caller]
    pub fn wait(&mut self) -> ExitStatus {
        let started = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().expect("the child can be asked") {
                return status;
            }
            assert!(started.elapsed() < DEADLINE, "the service does not end");
            std::thread::yield_now();
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
