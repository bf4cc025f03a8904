//! Results that version 0.2.0 has stored: `tests/stored/version_0_2.db` has one, a ball that dents
//! a block and is taken away (flow theory, 4 elements over the half-width, with fields), as that
//! version left it, but for the year, 2100: results are kept for a week.

use std::path::Path;

use brinell_solver::report::Report;

use crate::server::Server;

#[test]
fn a_result_of_0_2_is_read_in_every_form() {
    let database = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/stored/version_0_2.db");
    let server = Server::start_on(&database);
    let jobs = server.target.get("/v1/jobs").json();
    let job = &jobs["jobs"][0];
    assert_eq!((&job["status"], &job["tags"]["part"]), (&"succeeded".into(), &"ball".into()));
    let job = format!("/v1/jobs/{}", job["id"].as_str().unwrap());

    let result = server.target.get(&format!("{job}/result"));
    let report: Report = serde_json::from_slice(&result.body).unwrap();
    assert_eq!((report.version.as_str(), report.steps.len()), ("0.2.0", 2));
    let pressure = report.steps[0].contact.peak_pressure;
    assert!((pressure - 1370.85).abs() < 0.01, "{pressure}");
    assert!(report.steps[1].flow.is_some(), "what is left");

    for part in [
        "/result?fields=summary",
        "/result?step=2",
        "/fields/1",
        "/field.vtu",
        "/pressure.csv",
        "/subsurface.csv",
        "/summary.csv",
        "/pressure.svg",
        "/depth.svg",
    ] {
        let answer = server.target.get(&format!("{job}{part}"));
        assert_eq!(answer.status, 200, "{part}: {}", String::from_utf8_lossy(&answer.body));
    }
    let archive = server.target.get(&format!("{job}/fields/2"));
    let files = zip::ZipArchive::new(std::io::Cursor::new(&archive.body[..])).unwrap();
    assert_eq!(files.len(), 18, "nine arrays of two bodies");
}
