//! Results that older programs have stored, as they left them, but for the year, 2100: results are
//! kept for a week. `version_0_2.db` has one of 0.2.0, a ball that dents a block and is taken away
//! (flow theory, 4 elements over the half-width, with fields), and `before_rows.db` one of 0.3.0 in
//! the making, 03fb8848, two cylinders on 4 elements. Their figures are no rows: the job is there to
//! be solved again.

use std::path::Path;

use crate::server::Server;

fn is_solved_again(database: &str, part: &str) {
    let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/stored");
    let server = Server::start_on(&stored.join(database));
    let jobs = server.target.get("/v1/jobs").json();
    let job = &jobs["jobs"][0];
    assert_eq!((&job["status"], &job["tags"]["part"]), (&"succeeded".into(), &part.into()));
    let job = format!("/v1/jobs/{}", job["id"].as_str().unwrap());
    for part in ["/result", "/result?step=1", "/fields/1", "/summary.csv", "/pressure.svg"] {
        let answer = server.target.get(&format!("{job}{part}"));
        let text = String::from_utf8_lossy(&answer.body);
        assert_eq!(answer.status, 409, "{part}: {text}");
        assert!(text.contains("solve the job again"), "{part}: {text}");
    }
    let request = server.target.get(&format!("{job}/request"));
    assert_eq!(request.status, 200, "the job that is solved again");
    let again = server.target.post("/v1/solve", request.body);
    assert_eq!(again.json()["status"], "succeeded");
}

#[test]
fn a_job_of_0_2_is_solved_again() {
    is_solved_again("version_0_2.db", "ball");
}

#[test]
fn a_job_before_rows_is_solved_again() {
    is_solved_again("before_rows.db", "roller");
}
