//! Balls and ellipses that roll, as jobs: figures of `docs/theory_rolling.md`, symmetries, refusals.

use brinell_solver::job::{Job, JobError};
use brinell_solver::report::{
    BodyPassReport, Report, RollingReport, StepReport, TrackVerdict, preflight, run,
};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

const YOUNG: f64 = 210_000.0;

fn steel(tangent_modulus: f64) -> Value {
    json!({
        "young_modulus": YOUNG, "poisson_ratio": 0.3,
        "plasticity": {
            "law": "bilinear", "yield_stress": 500.0, "tangent_modulus": tangent_modulus,
        },
    })
}

/// A rigid ball of 10 mm on a flat track; members of `rolling` are those of the load.
fn ball(tangent_modulus: f64, rolling: &Value) -> Value {
    let mut load = json!({"force": 52.006_39, "passes": 1, "until": "passes"});
    for (key, value) in rolling.as_object().unwrap() {
        load[key] = value.clone();
    }
    json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10.0}, "material": {"rigid": true}},
        "lower": {
            "shape": {"type": "flat"},
            "material": steel(tangent_modulus),
        },
        "load": {"rolling": load},
        "solver": {"theory": "flow"},
    })
}

fn report(job: &Value) -> Report {
    run(&Job::from_value(job).unwrap(), &mut Unobserved).unwrap()
}

fn step(job: &Value) -> StepReport {
    report(job).steps.remove(0)
}

fn rolling(step: &StepReport) -> &RollingReport {
    step.rolling.as_ref().unwrap()
}

fn body(step: &StepReport, pass: usize) -> BodyPassReport {
    rolling(step).passes[pass - 1].bodies.lower.unwrap()
}

#[track_caller]
fn near(found: f64, expected: f64, relative: f64) {
    assert!((found / expected - 1.0).abs() < relative, "{found} for {expected}");
}

/// The ball of the prototype at 3.5 times the yield stress, 10 cells a semi-axis. Its groove is 1.7 %
/// deeper, because its ring ends: tests of `brinell-halfspace` sum as it does.
#[test]
fn a_ball_rolls_a_groove() {
    let start = std::time::Instant::now();
    let step = step(&ball(10_500.0, &json!({"passes": 3})));
    println!("{:?}", start.elapsed());
    println!("{}", serde_json::to_string_pretty(&step.rolling).unwrap());
    println!("{:?} {:?}", step.verdict, step.validity);
    for answer in &step.answers {
        println!("{answer:?}");
    }
    assert_eq!(step.status, SolveStatus::Converged);
    for (pass, groove) in [(1, 0.4069), (2, 0.4194), (3, 0.4239)] {
        near(body(&step, pass).groove_depth, 1e-3 * 0.983 * groove, 0.005);
    }
    near(body(&step, 1).largest_strain, 8.61e-3, 0.01);
    near(body(&step, 1).least_sigma_x, -350.3, 0.005);
    near(body(&step, 1).least_sigma_z, -267.8, 0.005);
    near(step.approach.unwrap(), 1.636e-3, 0.003);
    let found = rolling(&step);
    assert_eq!(found.verdict, TrackVerdict::Undecided);
    let first = found.passes[0].plastic_work;
    for pass in &found.passes {
        assert!(pass.energy_gap * pass.plastic_work < 0.03 * first, "{pass:?}");
    }
    near(found.passes[0].loss, found.passes[0].rolling_force / step.contact.force, 1e-9);
}
