//! The paper's method through the service: one word of a job.

use serde_json::{Value, json};

use crate::curl::{pointers, value};
use crate::server::Server;

const EXAMPLE: &str = include_str!("../../api/examples/paper_cylinders.json");

fn of_coupling(coupling: &str) -> Value {
    let mut job: Value = serde_json::from_str(EXAMPLE).unwrap();
    job["mesh"]["elements_per_half_width"] = json!(10);
    job["solver"]["coupling"] = json!(coupling);
    job
}

/// The elastic peak is three times the yield stress: plastic flow takes a fifth of it away.
#[track_caller]
fn assert_is_of_paper(result: &Value) {
    assert_eq!(result["status"], "converged");
    let step = &result["steps"][0];
    assert_eq!(step["status"], "converged");
    let pressure = step["contact"]["nodes"]["pressure"].as_array().unwrap();
    let largest = pressure.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    let peak = value(step, "peak_pressure");
    assert!(pressure.len() > 40 && (largest / peak - 1.0).abs() < 0.02, "{largest} {peak}");
    assert!((0.76..0.82).contains(&(peak / 1500.0)), "{peak}");
    assert!((0.0179..0.0180).contains(&value(step, "approach")), "{step}");
    let history = step["history"].as_array().unwrap();
    let sum = |key: &str| history.iter().map(|one| one[key].as_u64().unwrap()).sum::<u64>();
    // Each alternation is one simplex solve and one update of the initial stress.
    assert!(history.len() > 10, "{} iterations", history.len());
    assert!(sum("contact_pivots") > 10 * history.len() as u64, "{}", sum("contact_pivots"));
    assert_eq!(sum("initial_stress_updates"), history.len() as u64);
    assert_eq!(sum("factorizations"), 0, "the elastic stiffness is factorized once");
}

#[test]
fn the_example_is_solved_at_once_and_as_a_job() {
    let server = Server::start();
    let answer = server.target.post("/v1/solve", EXAMPLE.to_owned());
    assert_eq!(answer.status, 200, "{}", answer.json());
    assert_is_of_paper(&answer.json()["result"]);
    let queued = server.target.post("/v1/jobs", EXAMPLE.to_owned());
    assert_eq!(queued.status, 202, "{}", queued.json());
    let address = format!("{}?wait=30", queued.header("location").unwrap());
    let done = server.target.get(&address).json();
    assert_eq!(done["status"], "succeeded", "{done}");
    assert_is_of_paper(&done["result"]);
}

#[test]
fn the_couplings_that_the_paper_compares_have_its_answer() {
    let server = Server::start();
    let solve = |coupling: &str| {
        let answer = server.target.post("/v1/solve", of_coupling(coupling).to_string());
        assert_eq!(answer.status, 200, "{}", answer.json());
        let step = answer.json()["result"]["steps"][0].clone();
        assert_eq!(step["status"], "converged");
        value(&step, "peak_pressure")
    };
    let [strong, weak, secant] = ["strong", "weak", "secant_stiffness"].map(solve);
    assert!((weak / strong - 1.0).abs() < 1e-4 && (secant / strong - 1.0).abs() < 1e-4);
}

#[test]
fn all_else_beside_it_is_refused_field_by_field() {
    let server = Server::start();
    let mut job = of_coupling("accelerated");
    job["solver"]["theory"] = json!("flow");
    job["solver"]["contact"] = json!("active_set");
    let problem = server.target.post("/v1/validate", job.to_string()).problem(422, "invalid-job");
    let expected = ["/solver/contact", "/solver/coupling", "/solver/theory"];
    assert_eq!(pointers(&problem), expected, "{problem}");
}
