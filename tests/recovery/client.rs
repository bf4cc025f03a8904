//! A client that asks hundreds of questions over one connection.

use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::Instant;

use serde_json::{Value, json};

use crate::server::{DEADLINE, example};

/// One connection.
pub struct Client {
    stream: BufReader<TcpStream>,
}

impl Client {
    pub fn connect(url: &str) -> Self {
        let stream = TcpStream::connect(url.strip_prefix("http://").unwrap()).unwrap();
        stream.set_nodelay(true).unwrap();
        stream.set_read_timeout(Some(DEADLINE)).unwrap();
        Self { stream: BufReader::new(stream) }
    }

    pub fn get(&mut self, path: &str) -> (u16, Value) {
        self.ask("GET", path, "", "")
    }

    /// Queues a job and returns its id.
    #[track_caller]
    pub fn submit(&mut self, job: &Value) -> String {
        let (status, receipt) = self.ask("POST", "/v1/jobs", "", &job.to_string());
        assert_eq!(status, 202, "{receipt}");
        receipt["id"].as_str().unwrap().to_owned()
    }

    /// Queues small jobs, a hundred in one request, and returns their ids. One by one they may be
    /// solved as fast as they come.
    #[track_caller]
    pub fn submit_small_jobs(&mut self, count: usize) -> Vec<String> {
        let mut ids = Vec::new();
        while ids.len() < count {
            let hundred = ids.len()..count.min(ids.len() + 100);
            let jobs: Vec<Value> =
                hundred.map(|number| json!({"job": small_job(number)})).collect();
            let (status, answer) =
                self.ask("POST", "/v1/batch/submit", "", &json!({"jobs": jobs}).to_string());
            assert_eq!(status, 200, "{answer}");
            let receipts = answer["jobs"].as_array().unwrap();
            ids.extend(
                receipts.iter().map(|receipt| receipt["job"]["id"].as_str().unwrap().to_owned()),
            );
        }
        ids
    }

    /// Waits until so many jobs run at the same time, and returns the counts of the queue.
    #[track_caller]
    pub fn wait_until_running(&mut self, least: u64) -> Value {
        loop {
            let queue = self.get("/v1/capacity").1["queue"].take();
            if queue["running"].as_u64() >= Some(least) {
                return queue;
            }
            assert_ne!(queue["queued"], 0, "all jobs have ended before {least} were seen to run");
        }
    }

    pub fn ask(&mut self, method: &str, path: &str, headers: &str, body: &str) -> (u16, Value) {
        let length = body.len();
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: \
             application/json\r\nContent-Length: {length}\r\n\
             {headers}\r\n"
        );
        self.stream.get_mut().write_all((head + body).as_bytes()).unwrap();
        let (mut status, mut length, mut is_chunked) = (0, 0, false);
        loop {
            let mut line = String::new();
            self.stream.read_line(&mut line).unwrap();
            match line.trim_end().split_once(": ") {
                Some(("content-length", value)) => length = value.parse().unwrap(),
                Some(("transfer-encoding", "chunked")) => is_chunked = true,
                Some(_) => {}
                None if line.starts_with("HTTP/1.1 ") => status = line[9..12].parse().unwrap(),
                None => break,
            }
        }
        let mut body = vec![0; length];
        self.stream.read_exact(&mut body).unwrap();
        while is_chunked {
            let mut line = String::new();
            self.stream.read_line(&mut line).unwrap();
            let mut chunk = vec![0; usize::from_str_radix(line.trim_end(), 16).unwrap()];
            self.stream.read_exact(&mut chunk).unwrap();
            self.stream.read_line(&mut line).unwrap();
            is_chunked = !chunk.is_empty();
            body.append(&mut chunk);
        }
        (status, serde_json::from_slice(&body).unwrap_or(Value::Null))
    }

    /// Waits until no job is queued or running.
    #[track_caller]
    pub fn wait_until_idle(&mut self) {
        let started = Instant::now();
        loop {
            let (status, capacity) = self.get("/v1/capacity");
            let queue = &capacity["queue"];
            if status == 200 && queue["queued"] == 0 && queue["running"] == 0 {
                return;
            }
            assert!(started.elapsed() < 2 * DEADLINE, "still {queue}");
        }
    }

    /// Every job the service knows.
    #[track_caller]
    pub fn all_jobs(&mut self) -> BTreeMap<String, Value> {
        let mut jobs = BTreeMap::new();
        let mut cursor = String::new();
        loop {
            let (status, page) = self.get(&format!("/v1/jobs?limit=100{cursor}"));
            assert_eq!(status, 200);
            for job in page["jobs"].as_array().unwrap() {
                let twice = jobs.insert(job["id"].as_str().unwrap().to_owned(), job.clone());
                assert_eq!(twice, None, "listed twice");
            }
            match page["next_cursor"].as_str() {
                Some(next) => cursor = format!("&cursor={next}"),
                None => return jobs,
            }
        }
    }

    /// Asserts that exactly these jobs are known, that all have succeeded, and that each has its
    /// result.
    #[track_caller]
    pub fn assert_all_succeeded(&mut self, ids: &[String]) {
        let jobs = self.all_jobs();
        assert_eq!(jobs.len(), ids.len(), "lost, or taken in twice");
        for id in ids {
            let job = &jobs[id];
            assert_eq!(job["status"], "succeeded", "{job}");
            let (status, report) = self.get(&format!("/v1/jobs/{id}/result"));
            assert_eq!(
                (status, report["tags"]["number"].as_str()),
                (200, job["tags"]["number"].as_str())
            );
            let iterations = report["steps"][0]["history"].as_array().unwrap().len();
            assert_eq!(
                job["progress"]["iterations"], iterations,
                "the history is that of one attempt"
            );
        }
    }
}

/// A small job that knows its number.
pub fn small_job(number: usize) -> Value {
    let mut job = example();
    job["mesh"] = json!({"elements_per_half_width": 4});
    job["tags"] = json!({"number": number.to_string()});
    job
}
