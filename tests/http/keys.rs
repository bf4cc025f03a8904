//! API keys: made on the command line, asked for over HTTP.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::process::Command;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use crate::curl::{Answer, curl, curl_with_input};
use crate::server::{DEADLINE, Scratch, Server, example};

/// A service that requires keys.
struct Guarded {
    server: Server,
    data: Scratch,
}

impl Guarded {
    fn start() -> Self {
        let data = Scratch::new();
        let server =
            Server::start_with(&["--require-api-key", "--data-dir", data.0.to_str().unwrap()]);
        Self { server, data }
    }

    /// Runs `brinell key` beside the service.
    fn key(&self, args: &[&str]) -> String {
        let output = Command::new(env!("CARGO_BIN_EXE_brinell"))
            .arg("key")
            .args(args)
            .args(["--data-dir", self.data.0.to_str().unwrap()])
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap().trim().to_owned()
    }

    fn ask(&self, token: &str, method: &str, path: &str) -> Answer {
        let (header, url) = (format!("Authorization: Bearer {token}"), self.url(path));
        curl(&["-X", method, "-H", &header, &url])
    }

    fn post(&self, token: &str, path: &str) -> Answer {
        let (header, url) = (format!("Authorization: Bearer {token}"), self.url(path));
        let args =
            ["-H", &header, "-H", "Content-Type: application/json", "--data-binary", "@-", &url];
        curl_with_input(&args, example().to_string().into())
    }

    /// Asks until a solve is refused for a reason: the last refusal stands for a moment.
    fn refuses(&self, token: &str, reason: &str) {
        let deadline = Instant::now() + DEADLINE;
        loop {
            let problem = self.post(token, "/v1/solve").problem(429, "quota-exceeded");
            if problem["detail"].as_str().unwrap().starts_with(reason) {
                return;
            }
            assert!(Instant::now() < deadline, "{problem}");
        }
    }

    fn url(&self, path: &str) -> String {
        format!("{}{path}", self.server.target.url)
    }
}

/// Bodies of one key that may be under way at a time.
const BODIES: usize = 32;

#[test]
fn one_body_too_many_of_a_key_is_its_own_doing() {
    let guarded = Guarded::start();
    let [one, other] = ["one", "other"].map(|name| guarded.key(&["create", name]));
    let address = guarded.server.target.url.strip_prefix("http://").unwrap();
    let begin = || {
        let mut stream = TcpStream::connect(address).unwrap();
        let head = format!(
            "POST /v1/jobs HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {one}\r\n\
             Content-Type: application/json\r\nContent-Length: 1000\r\n\r\n{{"
        );
        stream.write_all(head.as_bytes()).unwrap();
        stream
    };
    let mut begun: Vec<TcpStream> = (0..BODIES).map(|_| begin()).collect();
    let deadline = Instant::now() + DEADLINE;
    while guarded.post(&one, "/v1/validate").status == 200 {
        assert!(Instant::now() < deadline, "all bodies have arrived");
        // On a busy machine the first have been given up by now.
        begun.push(begin());
    }
    let refused = guarded.post(&one, "/v1/validate");
    assert!(refused.header("retry-after").is_some());
    refused.problem(429, "too-many-jobs");
    assert_eq!(guarded.post(&other, "/v1/validate").status, 200);
    drop(begun);
    while guarded.post(&one, "/v1/validate").status == 429 {
        assert!(Instant::now() < deadline, "the key's connections are closed");
    }
}

#[test]
fn without_a_good_key_nothing_under_v1_is_answered() {
    let guarded = Guarded::start();
    let target = &guarded.server.target;
    for path in ["/v1/jobs", "/v1/capacity", "/v1/jobs/none"] {
        let answer = target.get(path);
        answer.problem(401, "unauthorized");
        assert_eq!(answer.header("www-authenticate"), Some("Bearer"));
        guarded.ask("brinell_x_y", "GET", path).problem(401, "unauthorized");
    }
    target.post("/v1/solve", example().to_string()).problem(401, "unauthorized");
    assert_eq!((target.get("/livez").status, target.get("/readyz").status), (200, 200));
    let token = guarded.key(&["create", "press"]);
    let guessed = format!("{}0", &token[..token.len() - 1]);
    let other = if guessed == token { format!("{}1", &token[..token.len() - 1]) } else { guessed };
    guarded.ask(&other, "GET", "/v1/jobs").problem(401, "unauthorized");
    assert_eq!(guarded.ask(&token, "GET", "/v1/jobs").status, 200);
    let listed = guarded.key(&["list"]);
    assert!(listed.contains("press") && !listed.contains(&token[token.len() - 32..]), "{listed}");
    guarded.key(&["revoke", listed.split(' ').next().unwrap()]);
    guarded.ask(&token, "GET", "/v1/jobs").problem(401, "unauthorized");
}

#[test]
fn jobs_are_visible_to_their_key_and_to_administrators() {
    let guarded = Guarded::start();
    let [mine, other, reader, admin] = [
        guarded.key(&["create", "mine"]),
        guarded.key(&["create", "other"]),
        guarded.key(&["create", "reader", "--scope", "read"]),
        guarded.key(&["create", "admin", "--scope", "admin"]),
    ];
    let accepted = guarded.post(&mine, "/v1/jobs");
    assert_eq!(accepted.status, 202);
    let job = accepted.header("location").unwrap();
    let finished = format!("{job}?wait=30");
    assert_eq!(guarded.ask(&mine, "GET", &finished).json()["status"], "succeeded");
    assert_eq!(guarded.ask(&admin, "GET", &format!("{job}/result")).status, 200);
    for token in [&other, &reader] {
        guarded.ask(token, "GET", job).problem(404, "job-not-found");
        guarded.ask(token, "GET", &format!("{job}/result")).problem(404, "job-not-found");
        guarded.ask(token, "GET", &format!("{job}/events")).problem(404, "job-not-found");
    }
    let count =
        |token| guarded.ask(token, "GET", "/v1/jobs").json()["jobs"].as_array().unwrap().len();
    assert_eq!([count(&mine), count(&other), count(&admin)], [1, 0, 1]);
    guarded.post(&reader, "/v1/jobs").problem(403, "forbidden");
    assert_eq!(guarded.post(&reader, "/v1/validate").status, 200);
    guarded.ask(&other, "DELETE", job).problem(404, "job-not-found");
    assert_eq!(guarded.ask(&mine, "DELETE", job).status, 204);
}

#[test]
fn a_key_has_quotas_and_an_end() {
    let guarded = Guarded::start();
    let token = guarded.key(&["create", "press", "--max-queued", "0", "--max-priority", "3"]);
    let problem = guarded.post(&token, "/v1/jobs?priority=4").problem(429, "quota-exceeded");
    assert_eq!(problem["detail"], "jobs of this API key may have priority 3 at most");
    assert_eq!(problem["quota"], "priority");
    let problem = guarded.post(&token, "/v1/jobs").problem(429, "quota-exceeded");
    assert_eq!(problem["detail"], "this API key may have 0 jobs waiting, and has them");
    assert_eq!(problem["quota"], "queued_jobs");
    let listed = guarded.key(&["list"]);
    assert!(listed.ends_with("press, queued <= 0, priority <= 3"), "{listed}");
    let id = listed.split(' ').next().unwrap();
    guarded.key(&["limit", id, "--max-stored", "0"]);
    guarded.refuses(&token, "the results of this API key may take 0 bytes");

    let next = guarded.key(&["rotate", id]);
    for token in [&token, &next] {
        assert_eq!(guarded.ask(token, "GET", "/v1/jobs").status, 200);
    }
    let last = guarded.key(&["rotate", id, "--overlap", "0"]);
    for token in [&token, &next] {
        guarded.ask(token, "GET", "/v1/jobs").problem(401, "unauthorized");
    }
    guarded.key(&["limit", id]);
    let job = guarded.post(&last, "/v1/jobs");
    assert_eq!(job.status, 202, "its limits are those of the service again");
    // The key ends, its job does not.
    guarded.key(&["limit", id, "--expires", "2001-01-01T00:00:00Z"]);
    guarded.ask(&last, "GET", "/v1/jobs").problem(401, "unauthorized");
    assert!(guarded.key(&["list"]).contains("expired"));
    let admin = guarded.key(&["create", "admin", "--scope", "admin"]);
    let finished = format!("{}?wait=30", job.header("location").unwrap());
    assert_eq!(guarded.ask(&admin, "GET", &finished).json()["status"], "succeeded");
}

#[test]
fn streams_and_waits_end_with_their_key() {
    let guarded = Guarded::start();
    let token = guarded.key(&["create", "press", "--max-running", "0"]);
    let id = guarded.key(&["list"]).split(' ').next().unwrap().to_owned();
    let job = guarded.post(&token, "/v1/jobs").header("location").unwrap().to_owned();
    let begin = Instant::now();
    let (waited, events) = thread::scope(|scope| {
        let wait = scope.spawn(|| guarded.ask(&token, "GET", &format!("{job}?wait=50")));
        let authority = guarded.server.target.url.strip_prefix("http://").unwrap();
        let mut stream = TcpStream::connect(authority).unwrap();
        let head = format!(
            "GET {job}/events HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nAuthorization: \
             Bearer {token}\r\n\r\n"
        );
        stream.write_all(head.as_bytes()).unwrap();
        let mut first = [0; 12];
        stream.read_exact(&mut first).unwrap();
        guarded.key(&["revoke", &id]);
        let mut rest = Vec::new();
        stream.read_to_end(&mut rest).unwrap();
        (wait.join().unwrap(), first)
    });
    assert_eq!(&events, b"HTTP/1.1 200");
    waited.problem(401, "unauthorized");
    assert!(begin.elapsed() < Duration::from_secs(40), "{:?}", begin.elapsed());
}

/// Every operation that the interface declares, asked by everybody.
#[test]
fn every_route_asks_for_the_key_that_it_needs() {
    const OPEN: [&str; 4] = ["/livez", "/readyz", "/openapi.json", "/problems/{name}"];
    const HARMLESS: [&str; 4] =
        ["/v1/validate", "/v1/hertz", "/v1/hardening-curves", "/v1/batch/fetch"];
    let guarded = Guarded::start();
    let scopes = ["read", "write", "monitor", "admin"];
    let tokens = scopes.map(|scope| guarded.key(&["create", scope, "--scope", scope]));
    let document = guarded.server.target.get("/openapi.json").json();
    let mut asked = 0;
    for (path, operations) in document["paths"].as_object().unwrap() {
        let url =
            path.replace("{id}", "0197e1f0-0000-7000-8000-000000000000").replace("{step}", "1");
        for method in operations.as_object().unwrap().keys().filter(|name| *name != "parameters") {
            let method = method.to_uppercase();
            let is_open = OPEN.contains(&path.as_str());
            let changes = method != "GET" && !HARMLESS.contains(&path.as_str());
            for (scope, token) in scopes.iter().zip(&tokens) {
                let status = guarded.ask(token, &method, &url).status;
                let may = is_open || !changes || ["write", "admin"].contains(scope);
                assert_eq!(status == 403, !may, "{scope} {method} {path}: {status}");
                assert_ne!(status, 401, "{scope} {method} {path}");
            }
            for token in ["", "brinell_x_y"] {
                let status = guarded.ask(token, &method, &url).status;
                assert_eq!(status == 401, !is_open, "{token:?} {method} {path}: {status}");
            }
            asked += 1;
        }
    }
    assert!(asked > 25, "{asked} operations");
}

#[test]
fn a_key_that_is_sent_counts_where_none_is_required() {
    let data = Scratch::new();
    let server = Server::start_with(&["--data-dir", data.0.to_str().unwrap()]);
    let guarded = Guarded { server, data };
    let reader = guarded.key(&["create", "reader", "--scope", "read"]);
    guarded.post(&reader, "/v1/jobs").problem(403, "forbidden");
    guarded.ask("brinell_x_y", "GET", "/v1/jobs").problem(401, "unauthorized");
    let job = guarded.server.target.submit(&example());
    guarded.ask(&reader, "GET", &job).problem(404, "job-not-found");
    let monitor = guarded.key(&["create", "monitor", "--scope", "monitor"]);
    assert_eq!(guarded.ask(&monitor, "GET", &job).status, 200);
    guarded.ask(&monitor, "DELETE", &job).problem(403, "forbidden");
}

#[test]
fn a_head_of_any_size_is_not_read() {
    let server = Server::start();
    let mut stream =
        TcpStream::connect(server.target.url.strip_prefix("http://").unwrap()).unwrap();
    stream.set_read_timeout(Some(DEADLINE)).unwrap();
    let head = format!("GET /livez HTTP/1.1\r\nHost: localhost\r\n{}\r\n", "X: y\r\n".repeat(200));
    stream.write_all(head.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    assert!(answer.starts_with("HTTP/1.1 431"), "{answer}");
    server.target.assert_alive();
}

/// While one key waits, each other one has two turns at most.
#[test]
#[ignore = "full"]
fn forty_keys_that_check_without_end_hold_up_nobody() {
    let guarded = Guarded::start();
    let mut sweep = example();
    sweep["load"] = serde_json::json!({"forces": (1..=1000).collect::<Vec<_>>()});
    let text = sweep.to_string();
    let host = guarded.server.target.url.strip_prefix("http://").unwrap();
    let (over, checked) = (AtomicBool::new(false), AtomicU32::new(0));
    let check = |token: String| {
        let head = format!(
            "POST /v1/validate HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {token}\r\n\
             Content-Type: application/json\r\nContent-Length: {}\r\n\r\n",
            text.len()
        );
        let mut stream = TcpStream::connect(host).unwrap();
        while !over.load(Ordering::Relaxed) {
            stream.write_all(head.as_bytes()).unwrap();
            stream.write_all(text.as_bytes()).unwrap();
            let mut answer = [0; 4096];
            let read = stream.read(&mut answer).unwrap();
            assert!(answer[..read].starts_with(b"HTTP/1.1 200 OK"));
            checked.fetch_add(1, Ordering::Relaxed);
        }
    };
    let greedy: Vec<_> =
        (0..40).map(|number| guarded.key(&["create", &format!("greedy {number}")])).collect();
    let modest = guarded.key(&["create", "modest"]);
    let turns = thread::scope(|scope| {
        for token in greedy {
            scope.spawn(|| check(token));
        }
        let ask = |_| {
            let before = checked.load(Ordering::Relaxed);
            assert_eq!(guarded.post(&modest, "/v1/validate").status, 200);
            checked.load(Ordering::Relaxed) - before
        };
        let turns: Vec<_> = (0..21).map(ask).collect();
        over.store(true, Ordering::Relaxed);
        turns
    });
    let most = turns.iter().copied().max();
    assert!(most <= Some(2 * 40), "checks of others while one waits: {turns:?}");
}

/// Each holds a piece of a result until its client reads that.
#[test]
fn a_key_waits_for_its_own_readers_who_do_not_read_and_others_do_not() {
    let guarded = Guarded::start();
    let [deaf, other] =
        ["deaf", "other"].map(|name| guarded.key(&["create", name, "--scope", "admin"]));
    let mut job = example();
    job["mesh"] = serde_json::json!({"elements_per_half_width": 40});
    job["output"] = serde_json::json!({"fields": true});
    let header = format!("Authorization: Bearer {other}");
    let json = ["-H", "Content-Type: application/json", "--data-binary", "@-"];
    let url = guarded.url("/v1/solve?fields=summary");
    let solve = [&["-H", &header][..], &json, &[&url]].concat();
    let solved = curl_with_input(&solve, job.to_string().into());
    let path = format!("{}/result", solved.header("content-location").unwrap());
    let host = guarded.server.target.url.strip_prefix("http://").unwrap();
    let open = |token: &str| {
        let mut stream = TcpStream::connect(host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(15))).unwrap();
        let head =
            format!("GET {path} HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {token}\r\n");
        write!(stream, "{head}Connection: close\r\n\r\n").unwrap();
        let mut first = [0; 15];
        stream.read_exact(&mut first).unwrap();
        assert_eq!(&first, b"HTTP/1.1 200 OK");
        stream
    };
    let held: Vec<_> = (0..32).map(|_| open(&deaf)).collect();
    let length = |mut stream: TcpStream| stream.read_to_end(&mut Vec::new());
    let whole = length(open(&other)).unwrap();
    let further = open(&deaf);
    further.set_read_timeout(Some(Duration::from_secs(1))).unwrap();
    let mut waiting = Vec::new();
    assert!(
        (&further).read_to_end(&mut waiting).is_err() && waiting.len() < 1000,
        "{}",
        waiting.len()
    );
    drop(held);
    further.set_read_timeout(Some(Duration::from_secs(15))).unwrap();
    assert_eq!(waiting.len() + length(further).unwrap(), whole);
}
