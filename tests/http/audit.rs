//! The audit log has a line for every change, with the key that made it.

use std::collections::BTreeSet;
use std::process::Command;
use std::time::Instant;

use serde_json::{Value, json};

use crate::curl::curl_with_input;
use crate::server::{DEADLINE, Scratch, Server, example};

/// Requests with methods other than GET that change nothing.
const HARMLESS: [&str; 4] =
    ["/v1/validate", "/v1/hertz", "/v1/hardening-curves", "/v1/batch/fetch"];

struct Audited {
    server: Server,
    data: Scratch,
    token: String,
}

impl Audited {
    fn start() -> Self {
        let data = Scratch::new();
        let place = data.0.to_str().unwrap();
        let server = Server::start_logging(&[
            "--require-api-key",
            "--data-dir",
            place,
            "--log",
            "info",
            "--log-format",
            "json",
        ]);
        let (token, _) = command(&data, &["key", "create", "press"]);
        Self { server, data, token }
    }

    fn ask(&self, method: &str, path: &str, body: &Value) -> (u16, Value) {
        let (header, url) = (
            format!("Authorization: Bearer {}", self.token),
            format!("{}{path}", self.server.target.url),
        );
        let args = [
            "-X",
            method,
            "-H",
            &header,
            "-H",
            "Content-Type: application/json",
            "--data-binary",
            "@-",
            &url,
        ];
        let answer = curl_with_input(&args, body.to_string().into());
        (answer.status, serde_json::from_slice(&answer.body).unwrap_or_default())
    }

    /// Lines of the log about changes, from the `after`-th on, once there are so many.
    #[track_caller]
    fn told(&self, after: usize, count: usize) -> Vec<Value> {
        let started = Instant::now();
        loop {
            let text = self.server.log();
            let lines = text.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
            let lines: Vec<Value> =
                lines.filter(|line| line["target"] == "brinell::audit").collect();
            if lines.len() >= after + count {
                return lines[after..].to_vec();
            }
            assert!(started.elapsed() < DEADLINE, "{lines:?}");
        }
    }
}

/// Runs the program on a data directory; standard output and log.
fn command(data: &Scratch, args: &[&str]) -> (String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_brinell"));
    let output =
        command.args(args).args(["--data-dir", data.0.to_str().unwrap()]).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap().trim().to_owned();
    assert!(output.status.success(), "{}", text(output.stderr));
    (text(output.stdout), text(output.stderr))
}

#[test]
fn every_request_that_changes_something_is_told_with_its_key() {
    let audited = Audited::start();
    let key = audited.token.split('_').nth(1).unwrap().to_owned();
    let mut sweep = example();
    sweep["load"] = json!({"forces": (0..500).map(|step| 300 + step).collect::<Vec<_>>()});
    let (_, one) = audited.ask("POST", "/v1/jobs?wait=30", &example());
    let id = one["id"].as_str().unwrap();
    let (_, running) = audited.ask("POST", "/v1/jobs", &sweep);
    let (mut before, mut asked) = (2, BTreeSet::from(["post /v1/jobs".to_owned()]));
    for (method, template, body, message, lines) in [
        ("POST", "/v1/solve", example(), "queued", 1),
        (
            "POST",
            "/v1/batch/submit",
            json!({"jobs": [{"job": example()}, {"job": example()}]}),
            "queued",
            2,
        ),
        ("POST", "/v1/batch/cancel", json!({"ids": [id]}), "asked to stop", 1),
        ("POST", "/v1/jobs/{id}/cancel", Value::Null, "asked to stop", 1),
        ("DELETE", "/v1/jobs/{id}", Value::Null, "removed", 1),
    ] {
        let target = if method == "DELETE" { id } else { running["id"].as_str().unwrap() };
        let (status, answer) = audited.ask(method, &template.replace("{id}", target), &body);
        assert!((200..300).contains(&status), "{template} {answer}");
        let told = audited.told(before, lines);
        assert_eq!(told.len(), lines, "{template}: {told:?}");
        for line in &told {
            let fields = &line["fields"];
            assert_eq!(fields["message"], message, "{template}");
            assert_eq!(fields["key"].as_str().unwrap().replace('-', ""), key, "{template}");
            assert!(fields["job"].is_string(), "{template}");
        }
        before += lines;
        asked.insert(format!("{} {template}", method.to_lowercase()));
    }
    let document = audited.server.target.get("/openapi.json").json();
    for (path, item) in document["paths"].as_object().unwrap() {
        for method in item.as_object().unwrap().keys().filter(|method| *method != "get") {
            let is_known =
                HARMLESS.contains(&path.as_str()) || asked.contains(&format!("{method} {path}"));
            assert!(is_known, "{method} {path} changes something, and no line is asked for here");
        }
    }
}

#[test]
fn every_command_that_changes_something_is_told() {
    let audited = Audited::start();
    let (listed, _) = command(&audited.data, &["key", "list"]);
    let id = listed.split(' ').next().unwrap();
    let file = audited.data.0.join("backup.db");
    let file = file.to_str().unwrap();
    for (args, message, named) in [
        (vec!["key", "create", "lathe"], "key made", "lathe"),
        (vec!["key", "limit", id, "--max-queued", "3"], "limits of a key set", id),
        (vec!["key", "rotate", id], "key rotated", id),
        (vec!["key", "revoke", id], "key revoked", id),
        (vec!["backup", file], "backup written", file),
    ] {
        let (_, log) = command(&audited.data, &args);
        let is_told =
            |line: &str| ["brinell::audit", message, named].iter().all(|word| line.contains(word));
        assert!(log.lines().any(is_told), "{args:?}: {log}");
    }
    let elsewhere = Scratch::new();
    let (_, log) = command(&elsewhere, &["restore", file]);
    assert!(log.contains("brinell::audit") && log.contains("backup restored"), "{log}");
}
