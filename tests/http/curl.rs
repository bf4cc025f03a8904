//! `curl` as a library. Where it is not installed, [`stand_in`](crate::stand_in) takes its place.

use std::io::Write;
use std::process::{Child, Command, Stdio};
use std::thread;

use serde_json::Value;

use crate::stand_in;

/// One answer.
#[derive(Debug, Clone)]
pub struct Answer {
    pub status: u16,
    pub headers: Vec<(String, String)>,
    pub body: Vec<u8>,
}

impl Answer {
    pub fn header(&self, name: &str) -> Option<&str> {
        self.headers.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|error| {
            panic!("{error} in {} {:?}", self.status, String::from_utf8_lossy(&self.body))
        })
    }

    /// Asserts that this is a well-formed problem of that type and status, and returns it.
    #[track_caller]
    pub fn problem(&self, status: u16, name: &str) -> Value {
        let text = String::from_utf8_lossy(&self.body);
        assert_eq!(self.status, status, "{text}");
        assert_eq!(self.header("content-type"), Some("application/problem+json"), "{text}");
        assert!(self.header("x-request-id").is_some_and(|id| !id.is_empty()));
        let problem = self.json();
        assert_eq!(problem["type"], format!("/problems/{name}"));
        assert_eq!(problem["status"], status);
        assert!(problem["title"].as_str().is_some_and(|title| !title.is_empty()));
        assert!(problem["detail"].as_str().is_some_and(|detail| !detail.is_empty()));
        let instance = format!("/requests/{}", self.header("x-request-id").unwrap_or_default());
        assert_eq!(problem["instance"], instance);
        for error in problem["errors"].as_array().into_iter().flatten() {
            assert!(error["code"].as_str().is_some_and(|code| !code.is_empty()), "{error}");
        }
        problem
    }
}

/// JSON pointers of the fields a problem names.
pub fn pointers(problem: &Value) -> Vec<&str> {
    let errors = problem["errors"].as_array().map(Vec::as_slice).unwrap_or_default();
    let pointers = errors.iter().map(|error| error["pointer"].as_str().expect("a pointer"));
    pointers.map(|pointer| pointer.strip_prefix('#').expect("a fragment")).collect()
}

/// Runs `curl` with these arguments.
pub fn curl(args: &[&str]) -> Answer {
    curl_with_input(args, Vec::new())
}

/// Runs `curl` with these arguments and this standard input.
pub fn curl_with_input(args: &[&str], input: Vec<u8>) -> Answer {
    let mut child = spawn_curl(args);
    let mut stdin = child.stdin.take().expect("a pipe");
    // A server that refuses early makes curl stop reading; that is the server's right.
    let feeder = thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("curl runs");
    feeder.join().expect("the feeder ends");
    parse(&output.stdout).unwrap_or_else(|| {
        panic!("curl {args:?}: {} {}", output.status, String::from_utf8_lossy(&output.stderr))
    })
}

/// Starts `curl` without waiting for it.
pub fn spawn_curl(args: &[&str]) -> Child {
    let always = ["--silent", "--show-error", "--include", "--max-time", "60", "--noproxy", "*"];
    let args = [&always, args].concat();
    let program = if cfg!(no_curl) { stand_in::command } else { installed };
    program(&args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("this test needs curl: install it")
}

fn installed(args: &[&str]) -> Command {
    let mut curl = Command::new("curl");
    curl.args(args);
    curl
}

/// Reads the last head and the body of what `curl --include` printed.
pub fn parse(mut text: &[u8]) -> Option<Answer> {
    text = &text[text.windows(5).position(|five| five == b"HTTP/")?..];
    loop {
        let end = text.windows(4).position(|four| four == b"\r\n\r\n")?;
        let head = std::str::from_utf8(&text[..end]).ok()?;
        let body = &text[end + 4..];
        let mut lines = head.lines();
        let status: u16 = lines.next()?.split(' ').nth(1)?.parse().ok()?;
        if status < 200 {
            text = body;
            continue;
        }
        let header = |line: &str| {
            let (key, value) = line.split_once(':')?;
            Some((key.to_ascii_lowercase(), value.trim().to_owned()))
        };
        return Some(Answer {
            status,
            headers: lines.filter_map(header).collect(),
            body: body.to_vec(),
        });
    }
}

/// The first row of a name in the answers of a step.
pub fn row<'a>(step: &'a serde_json::Value, name: &str) -> &'a serde_json::Value {
    let rows = step["answers"].as_array().unwrap();
    rows.iter().find(|row| row["name"] == name).unwrap_or_else(|| panic!("no {name} in {rows:?}"))
}

/// The value of that row.
#[track_caller]
pub fn value(step: &serde_json::Value, name: &str) -> f64 {
    row(step, name)["value"].as_f64().unwrap()
}
