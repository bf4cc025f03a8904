//! Room on the disk.

use crate::server::{Server, example};

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
    assert!(server.log().contains("the disk is full"));
}
