//! The ends of jobs, announced to receivers.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpListener;
use std::sync::mpsc::{Receiver as Requests, channel};
use std::thread;
use std::time::{Duration, Instant};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use brinell::config::ServeConfig;
use brinell::jobs::TraceParent;
use hmac::{Hmac, KeyInit, Mac};
use serde_json::{Value, json};
use sha2::Sha256;

use crate::in_process::{InProcess, job};
use crate::server::{DEADLINE, Target};
use crate::tls::file;

const SECRET: &str = "MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw";

/// What a receiver was told.
struct Told {
    path: String,
    headers: Vec<(String, String)>,
    body: Vec<u8>,
}

impl Told {
    fn header(&self, name: &str) -> &str {
        self.headers.iter().find(|(key, _)| key == name).map_or("", |(_, value)| value)
    }

    /// What the announcement says, whose signature is in order.
    #[track_caller]
    fn verified(&self) -> Value {
        let mut mac = Hmac::<Sha256>::new_from_slice(&STANDARD.decode(SECRET).unwrap()).unwrap();
        mac.update(
            format!("{}.{}.", self.header("webhook-id"), self.header("webhook-timestamp"))
                .as_bytes(),
        );
        mac.update(&self.body);
        let signature = format!("v1,{}", STANDARD.encode(mac.finalize().into_bytes()));
        assert_eq!(self.header("webhook-signature"), signature);
        serde_json::from_slice(&self.body).unwrap()
    }
}

/// Listens on loopback and answers one request after the other in these words.
struct Receiver {
    port: u16,
    told: Requests<Told>,
}

impl Receiver {
    fn start(answers: Vec<&'static str>) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        let (sender, told) = channel();
        thread::spawn(move || {
            for answer in answers {
                let (stream, _) = listener.accept().unwrap();
                let mut reader = BufReader::new(stream);
                let mut lines = Vec::new();
                loop {
                    let mut line = String::new();
                    reader.read_line(&mut line).unwrap();
                    match line.trim_end() {
                        "" => break,
                        line => lines.push(line.to_owned()),
                    }
                }
                let path = lines
                    .first()
                    .and_then(|line| line.split(' ').nth(1))
                    .unwrap_or_default()
                    .to_owned();
                let pair = |line: &String| {
                    let (name, value) = line.split_once(": ")?;
                    Some((name.to_ascii_lowercase(), value.to_owned()))
                };
                let headers: Vec<_> = lines.iter().filter_map(pair).collect();
                let length = headers.iter().find(|(name, _)| name == "content-length");
                let mut body = vec![0; length.map_or(0, |(_, length)| length.parse().unwrap())];
                reader.read_exact(&mut body).unwrap();
                let _ = write!(reader.get_mut(), "HTTP/1.1 {answer}\r\nContent-Length: 0\r\n\r\n");
                let _ = sender.send(Told { path, headers, body });
            }
        });
        Self { port, told }
    }

    #[track_caller]
    fn next(&self) -> Told {
        self.told.recv_timeout(DEADLINE).unwrap()
    }
}

/// A service that calls hosts on this machine, again after a moment.
fn calling(config: &mut ServeConfig) {
    config.webhooks.webhook_hosts = vec!["127.0.0.1".to_owned()];
    config.webhooks.webhook_secrets = vec![format!("whsec_{SECRET}").parse().unwrap()];
    config.webhooks.webhook_allow_private = true;
    config.webhooks.webhook_retry = Duration::from_millis(20);
}

/// Hands a job in, to be announced at an address.
#[track_caller]
fn submit(target: &Target, job: &Value, url: &str) -> String {
    let answer = target.post(&format!("/v1/jobs?callback_url={url}"), job.to_string());
    assert_eq!(answer.status, 202, "{}", String::from_utf8_lossy(&answer.body));
    answer.header("location").unwrap().to_owned()
}

/// The announcement of a job once it is in this state.
#[track_caller]
fn callback(target: &Target, job: &str, state: &str) -> Value {
    let started = Instant::now();
    loop {
        let callback = target.get(job).json()["callback"].clone();
        if callback["state"] == state {
            return callback;
        }
        assert!(started.elapsed() < DEADLINE, "still {callback}");
    }
}

#[test]
fn an_announcement_is_signed_and_repeated_until_it_is_taken() {
    let service = InProcess::start(calling);
    let receiver =
        Receiver::start(vec!["500 No", "302 Found\r\nLocation: /elsewhere", "204 Good"]);
    let url = format!("http://127.0.0.1:{}/press?x=1", receiver.port);
    let trace = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";
    let answer = service.target.post_with(
        &format!("/v1/jobs?callback_url={url}"),
        job("slow").to_string(),
        &["-H", "Content-Type: application/json", "-H", &format!("traceparent: {trace}")],
    );
    let address = answer.header("location").unwrap();
    assert_eq!(answer.json()["callback"]["state"], "waiting");
    service.solver.open_gate();
    let told: Vec<Told> = (0..3).map(|_| receiver.next()).collect();
    for one in &told {
        let said = one.verified();
        assert_eq!((one.path.as_str(), &said["type"]), ("/press?x=1", &json!("job.finished")));
        assert_eq!(
            (&said["data"]["status"], &said["data"]["has_result"]),
            (&json!("succeeded"), &json!(true))
        );
        assert_eq!(said["data"]["job"], address);
        assert_eq!(one.header("webhook-id"), told[0].header("webhook-id"));
        let sent: TraceParent = one.header("traceparent").parse().unwrap();
        let given: TraceParent = trace.parse().unwrap();
        assert!(sent.trace_id == given.trace_id && sent.span_id != given.span_id);
    }
    let callback = callback(&service.target, address, "delivered");
    assert_eq!((&callback["attempts"], &callback["last_status"]), (&json!(3), &json!(204)));
    assert_eq!(callback["id"], told[0].header("webhook-id"));
    assert!(callback["delivered_at"].is_string() && callback["last_error"].is_null());
}

#[test]
fn every_end_is_announced() {
    let service = InProcess::start(calling);
    let receiver = Receiver::start(vec!["200 Good"; 4]);
    let url = format!("http://127.0.0.1:{}/", receiver.port);
    let running = submit(&service.target, &job("slow"), &url);
    service.target.wait_for(&running, &["running"]);
    let queued = submit(&service.target, &job("slow"), &url);
    let body = json!({"jobs": [
        {"job": job("fail"), "callback_url": url}, {"job": job("quick"), "callback_url": "x"}]});
    service.target.post("/v1/batch/submit", body.to_string()).problem(422, "invalid-batch");
    let body = json!({"jobs": [{"job": job("fail"), "callback_url": url}]});
    assert_eq!(service.target.post("/v1/batch/submit", body.to_string()).json()["accepted"], 1);
    for job in [&queued, &running] {
        service.target.post(&format!("{job}/cancel"), "");
    }
    let mut ends: Vec<String> = (0..3)
        .map(|_| receiver.next().verified()["data"]["status"].as_str().unwrap().to_owned())
        .collect();
    ends.sort();
    assert_eq!(ends, ["cancelled", "cancelled", "failed"]);
    let listed = service.target.get("/v1/jobs").json();
    assert!(listed["jobs"][0].get("callback").is_none(), "lists are brief");
}

#[test]
fn a_receiver_that_wants_no_more_is_left_alone() {
    let service = InProcess::start(calling);
    let receiver = Receiver::start(vec!["410 Gone"]);
    let job =
        submit(&service.target, &job("quick"), &format!("http://127.0.0.1:{}/", receiver.port));
    receiver.next();
    let callback = callback(&service.target, &job, "failed");
    assert_eq!((&callback["attempts"], &callback["last_status"]), (&json!(1), &json!(410)));
    assert!(callback["next_attempt_at"].is_null());
}

#[test]
fn only_hosts_of_the_list_may_be_named() {
    let silent = InProcess::start(|_| ());
    let refused = |target: &Target, url: &str| {
        let path = format!("/v1/jobs?priority=x&callback_url={url}");
        let problem = target.post(&path, job("quick").to_string()).problem(400, "invalid-query");
        let errors = problem["errors"].as_array().unwrap();
        let named: Vec<_> =
            errors.iter().map(|error| error["parameter"].as_str().unwrap()).collect();
        assert_eq!(named, ["priority", "callback_url"]);
        errors[1]["detail"].as_str().unwrap().to_owned()
    };
    assert!(refused(&silent.target, "https://hooks.example/").contains("--webhook-host"));
    let service = InProcess::start(|config| {
        calling(config);
        config.webhooks.webhook_allow_private = false;
    });
    assert!(refused(&service.target, "https://hooks.example/").contains("host"));
    assert!(refused(&service.target, "http://127.0.0.1/").contains("https"));
    assert!(refused(&service.target, "https://127.0.0.1/").contains("not public"));
    assert!(refused(&service.target, "file:///etc/passwd").contains("https"));
}

/// The name is allowed, and points to this machine.
#[test]
fn a_name_that_points_inside_is_not_called() {
    let service = InProcess::start(|config| {
        calling(config);
        config.webhooks.webhook_hosts = vec!["localhost".to_owned()];
        config.webhooks.webhook_allow_private = false;
        config.webhooks.webhook_retry = Duration::from_hours(1);
    });
    let inside = TcpListener::bind("127.0.0.1:0").unwrap();
    inside.set_nonblocking(true).unwrap();
    let url = format!("https://localhost:{}/", inside.local_addr().unwrap().port());
    let job = submit(&service.target, &job("quick"), &url);
    let started = Instant::now();
    loop {
        let callback = service.target.get(&job).json()["callback"].clone();
        if let Some(error) = callback["last_error"].as_str() {
            assert_eq!(error, "the host has no address that may be called");
            assert!(callback["state"] == "pending" && callback["next_attempt_at"].is_string());
            break;
        }
        assert!(started.elapsed() < DEADLINE, "still {callback}");
    }
    assert!(inside.accept().is_err(), "nobody has called");
}

/// The receiver is another service, which takes an announcement for a job that is none.
#[test]
fn receivers_are_who_their_certificate_says() {
    let receiver = InProcess::start(|config| {
        config.tls.tls_cert = Some(file("first.cert.pem"));
        config.tls.tls_key = Some(file("first.key.pem"));
    });
    let url = receiver.target.url.replace("http://127.0.0.1", "https://localhost");
    for (authority, status, error) in [
        ("first.cert.pem", json!(422), "the receiver answered 422 Unprocessable Entity"),
        ("second.cert.pem", Value::Null, "no secure connection"),
    ] {
        let service = InProcess::start(|config| {
            calling(config);
            config.webhooks.webhook_hosts = vec!["localhost".to_owned()];
            config.webhooks.webhook_ca = Some(file(authority));
            config.webhooks.webhook_retry = Duration::from_hours(1);
        });
        let job = submit(&service.target, &job("quick"), &format!("{url}/v1/hertz"));
        let started = Instant::now();
        let callback = loop {
            let callback = service.target.get(&job).json()["callback"].clone();
            if callback["last_error"].is_string() {
                break callback;
            }
            assert!(started.elapsed() < DEADLINE, "still {callback}");
        };
        assert!(callback["last_error"].as_str().unwrap().starts_with(error), "{callback}");
        assert_eq!(callback["last_status"], status);
    }
}
