//! Large results: in parts, as an archive of arrays, and not sent twice.

use std::io::{Cursor, Read, Write};
use std::net::TcpStream;

use brinell_solver::report::StepReport;
use serde_json::json;
use zip::ZipArchive;

use crate::curl::{Answer, curl};
use crate::server::{Server, example};

fn sweep(fields: bool) -> serde_json::Value {
    let mut job = example();
    job["mesh"] = json!({"elements_per_half_width": 4});
    job["load"] = json!({"forces": [300.0, 600.0, 900.0]});
    job["output"] = json!({"fields": fields});
    job
}

struct Solved {
    server: Server,
    job: String,
}

impl Solved {
    fn new(fields: bool) -> Self {
        let server = Server::start();
        let job = server.target.submit(&sweep(fields));
        server.target.wait_for(&job, &["succeeded"]);
        Self { server, job }
    }

    fn get(&self, path: &str, args: &[&str]) -> Answer {
        let url = format!("{}{}{path}", self.server.target.url, self.job);
        curl(&[args, &[&url]].concat())
    }
}

#[test]
fn a_result_is_had_in_parts() {
    let solved = Solved::new(true);
    let whole = solved.get("/result", &[]).json();
    let steps = whole["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 3);
    assert!(steps.iter().all(|step| step["fields"]["upper"]["nodes"].is_array()));

    let light = solved.get("/result?fields=contact,subsurface,plasticity,history", &[]).json();
    assert!(light["steps"].as_array().unwrap().iter().all(|step| step.get("fields").is_none()));
    assert_eq!(light["steps"][1]["contact"], steps[1]["contact"]);
    assert_eq!(light["load_approach"], whole["load_approach"]);

    let second = solved.get("/result?step=2", &[]).json();
    assert_eq!(second["steps"], json!([steps[1]]));
    for query in ["?step=0", "?fields=maybe", "?part=1"] {
        solved.get(&format!("/result{query}"), &[]).problem(400, "invalid-query");
    }
    for args in [&[][..], &["-H", "Accept: text/csv"]] {
        for step in ["4", "18446744073709551615", "99999999999999999999999"] {
            solved.get(&format!("/result?step={step}"), args).problem(404, "step-not-found");
        }
    }
    let faults =
        solved.get(&format!("/result?{}", "x=1&".repeat(3000)), &[]).problem(400, "invalid-query");
    assert_eq!(faults["errors"].as_array().unwrap().len(), 50);
}

#[test]
fn the_parts_that_are_not_wanted_stay_behind() {
    let solved = Solved::new(true);
    let whole = solved.get("/result", &[]).json();
    let query = "/result?step=3&fields=fields,contact&subsurface_points=5";
    let part = solved.get(query, &[]);
    let (step, expected) = (&part.json()["steps"][0], &whole["steps"][2]);
    for kept in ["contact", "fields", "load", "answers", "shakedown"] {
        assert_eq!(step[kept], expected[kept], "{kept}");
    }
    assert!(step.get("subsurface").is_none() && step["history"] == json!([]));
    assert_eq!(step["plasticity"]["upper"]["outline"], json!([]));
    assert!(
        expected["plasticity"]["upper"]["outline"].as_array().is_some_and(|zone| !zone.is_empty())
    );

    let thin = solved.get("/result?fields=subsurface&subsurface_points=5", &[]);
    let compressed =
        solved.get("/result?fields=subsurface&subsurface_points=5", &["--compressed"]);
    assert_eq!(
        (compressed.header("content-encoding"), &compressed.body),
        (Some("gzip"), &thin.body)
    );
    for (step, whole) in
        thin.json()["steps"].as_array().unwrap().iter().zip(whole["steps"].as_array().unwrap())
    {
        let (depth, all) =
            (&step["subsurface"]["upper"]["depth"], &whole["subsurface"]["upper"]["depth"]);
        assert!(
            depth.as_array().unwrap().len() <= 5 && all.as_array().unwrap().len() > 5,
            "{depth} of {all}"
        );
        assert_eq!(depth[0], all[0]);
        assert_eq!(step["contact"]["nodes"]["pressure"], json!([]));
    }
    let summary = solved.get("/result?fields=summary", &[]);
    assert!(summary.body.len() < solved.get("/result", &[]).body.len() / 5);
    let waited = solved.get("?wait=0&fields=summary", &[]).json();
    assert_eq!(waited["result"], summary.json());
    assert_eq!(waited["result"]["steps"][2]["answers"], expected["answers"]);
    assert_eq!(waited["result"]["steps"][2]["contact"]["nodes"]["pressure"], json!([]));
    solved.get("?wait=0&fields=figures", &[]).problem(400, "invalid-query");

    let tags = [
        "",
        "?step=3",
        "?fields=summary",
        "?fields=subsurface",
        "?fields=subsurface&subsurface_points=5",
    ];
    let mut tags = tags.map(|query| {
        solved.get(&format!("/result{query}"), &[]).header("etag").unwrap().to_owned()
    });
    tags.sort_unstable();
    assert!(tags.windows(2).all(|pair| pair[0] != pair[1]), "{tags:?}");
}

/// Codings that leave the service a choice, or none.
#[test]
fn every_way_to_ask_for_a_coding_has_a_whole_answer() {
    let solved = Solved::new(false);
    let plain = solved.get("/result", &[]);
    for (accepted, coding) in
        [("*", Some("gzip")), ("*;q=0", None), ("identity;q=0", None), ("br", None)]
    {
        let accepted = format!("Accept-Encoding: {accepted}");
        for path in ["/result", "/result?fields=contact", "?wait=0", "/pressure.csv", "/request"] {
            // curl unpacks what it is sent.
            let answer = solved.get(path, &["--compressed", "-H", &accepted]);
            assert_eq!(
                (answer.status, answer.header("content-encoding")),
                (200, coding),
                "{accepted} {path}"
            );
            assert!(path != "/result" || answer.body == plain.body, "{accepted}");
        }
    }
}

#[test]
fn a_spreadsheet_has_a_row_for_each_step() {
    let solved = Solved::new(false);
    let csv = ["-H", "Accept: text/csv"];
    let table = solved.get("/result", &csv);
    assert_eq!(table.body, solved.get("/summary.csv", &[]).body);
    let text = String::from_utf8(table.body.clone()).unwrap();
    let rows: Vec<_> = text.lines().collect();
    assert_eq!((rows.len(), table.header("vary")), (4, Some("accept, accept-encoding")));
    let second = String::from_utf8(solved.get("/result?step=2", &csv).body).unwrap();
    assert_eq!(second.lines().collect::<Vec<_>>(), [rows[0], rows[2]]);
}

#[test]
fn the_job_and_its_result_come_as_one_text() {
    let solved = Solved::new(true);
    let whole = solved.get("/result", &[]).json();
    for args in [&[][..], &["--compressed"], &["-H", "If-None-Match: *"]] {
        let job = solved.get("?wait=0", args);
        assert_eq!((job.status, &job.json()["result"]), (200, &whole), "{args:?}");
    }
    let light = Solved::new(false);
    let job = light.get("?wait=0", &["--compressed"]);
    assert_eq!(job.header("content-encoding"), Some("gzip"));
    assert_eq!(job.json()["result"], light.get("/result", &[]).json());
    assert!(light.get("", &[]).json().get("result").is_none());
}

#[test]
fn a_compressed_result_is_the_same_result() {
    let solved = Solved::new(false);
    let plain = solved.get("/result", &[]);
    let compressed = solved.get("/result", &["--compressed"]);
    assert_eq!(compressed.header("content-encoding"), Some("gzip"));
    assert_eq!(compressed.body, plain.body);
    assert_ne!(compressed.header("etag"), plain.header("etag"), "a strong tag names bytes");
    for answer in [&plain, &compressed] {
        assert_eq!(answer.header("vary"), Some("accept, accept-encoding"));
    }
    let known = format!("If-None-Match: {}", plain.header("etag").unwrap());
    let again = solved.get("/result", &["-H", &known]);
    assert_eq!((again.status, again.body.len()), (304, 0));
}

fn archive(answer: &Answer) -> ZipArchive<Cursor<&[u8]>> {
    ZipArchive::new(Cursor::new(&answer.body[..])).unwrap()
}

/// The numbers of a file of an `.npz` archive, without its header; its checksum holds.
fn bytes_of(answer: &Answer, name: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    archive(answer).by_name(name).unwrap().read_to_end(&mut bytes).unwrap();
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    bytes.split_off(10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]])))
}

#[test]
fn fields_are_an_archive_of_arrays() {
    let solved = Solved::new(true);
    let answer = solved.get("/fields/2", &[]);
    assert_eq!(
        (answer.status, answer.header("content-type")),
        (200, Some("application/octet-stream"))
    );
    let step = solved.get("/result?step=2", &[]).json()["steps"][0].clone();
    let step: StepReport = serde_json::from_value(step).unwrap();
    let expected = step.fields.unwrap().upper.unwrap();
    let corners = bytes_of(&answer, "upper/elements.npy");
    let (corners, []) = corners.as_chunks() else { panic!("numbers of four bytes") };
    let corners: Vec<u32> = corners.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
    assert_eq!(corners, expected.elements.concat());
    let largest = expected.von_mises.iter().copied().fold(0.0, f64::max);
    let read = bytes_of(&answer, "upper/von_mises.npy");
    assert_eq!(read.len(), 4 * expected.von_mises.len());
    for (bytes, double) in read.as_chunks().0.iter().zip(&expected.von_mises) {
        let single = f64::from(f32::from_le_bytes(*bytes));
        assert!((single - double).abs() < 1e-6 * largest, "{single} for {double}");
    }

    let known = format!("If-None-Match: {}", answer.header("etag").unwrap());
    assert_eq!(solved.get("/fields/2", &["-H", &known]).status, 304);
    let compressed = solved.get("/fields/2", &["--compressed"]);
    assert_eq!(
        (compressed.header("content-encoding"), compressed.body == answer.body),
        (None, true)
    );

    let some = solved.get("/fields/2?arrays=von_mises,nodes", &[]);
    let names =
        ["upper/nodes.npy", "upper/von_mises.npy", "lower/nodes.npy", "lower/von_mises.npy"];
    assert_eq!(archive(&some).file_names().map(Result::unwrap).collect::<Vec<_>>(), names);
    assert_ne!(some.header("etag"), answer.header("etag"), "other bytes, another tag");
    let all = "nodes,elements,displacement,sigma_x,sigma_y,sigma_z,tau_xy,von_mises,\
               equivalent_plastic_strain";
    assert_eq!(solved.get(&format!("/fields/2?arrays={all}"), &[]).body, answer.body);
    for wrong in [
        "arrays=",
        "arrays=stress",
        "arrays=nodes,,nodes",
        "array=nodes",
        "arrays=nodes&arrays=nodes",
    ] {
        solved.get(&format!("/fields/2?{wrong}"), &[]).problem(400, "invalid-query");
    }

    for path in ["/fields/4", "/fields/0", "/fields/x"] {
        solved.get(path, &[]).problem(404, "step-not-found");
    }
    Solved::new(false).get("/fields/1", &[]).problem(409, "not-in-result");
}

#[test]
fn readers_who_do_not_read_hold_up_nobody() {
    let server = Server::start_with(&["--write-timeout", "600"]);
    let mut job = example();
    (job["mesh"], job["output"]) =
        (json!({"elements_per_half_width": 40}), json!({"fields": true}));
    let job = server.target.submit(&job);
    server.target.wait_for(&job, &["succeeded"]);
    let host = server.target.url.strip_prefix("http://").unwrap();
    let mut deaf = Vec::new();
    let paths = [
        "/result",
        "/fields/1",
        "?wait=1",
        "/field.vtu",
        "/pressure.csv",
        "/result?fields=contact",
    ];
    for path in paths.iter().cycle().take(60) {
        let mut stream = TcpStream::connect(host).unwrap();
        write!(stream, "GET {job}{path} HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
        let mut first = [0; 15];
        stream.read_exact(&mut first).unwrap();
        assert_eq!(&first, b"HTTP/1.1 200 OK");
        deaf.push(stream);
    }
    for path in paths.into_iter().chain(["/pressure.svg"]) {
        let url = format!("{}{job}{path}", server.target.url);
        assert_eq!(curl(&["--max-time", "25", &url]).status, 200, "{path}");
    }
}

#[test]
fn a_result_too_large_is_refused_with_its_estimate() {
    let server = Server::start_with(&["--max-result", "1"]);
    let mut job = sweep(true);
    job["load"] = json!({"forces": (1..=1000).map(f64::from).collect::<Vec<_>>()});
    let problem = server.target.post("/v1/jobs", job.to_string()).problem(422, "job-too-large");
    assert!(
        problem["estimate"]["result_bytes"].as_u64().is_some_and(|bytes| bytes > 100 << 20),
        "{problem}"
    );
    assert_eq!(problem["limit_bytes"], 1 << 20);
    job["load"] = json!({"force": 600.0});
    assert_eq!(server.target.post("/v1/jobs", job.to_string()).status, 202);
}
