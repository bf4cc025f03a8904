//! Does every law, shape pairing, analysis and coupling converge? Prints a table of outcomes in Markdown.
//!
//! `cargo run --release --example outcomes`; a contact whose elastic peak pressure is 3, 4 and 5 yield stresses, ten
//! elements over the half-width, tolerance 1e-6. A number is the count of iterations, a word why there is no answer.

#![expect(clippy::print_stdout, reason = "printing is what it is for")]

use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell::model::Job;
use brinell::solve::{Interrupt, Observer, SolveStatus, run};
use serde_json::{Value, json};

const ANALYSES: [&str; 3] = ["plane_strain", "plane_stress", "axisymmetric"];
const COUPLINGS: [&str; 4] = ["accelerated", "strong", "weak", "secant_stiffness"];
const YIELD: f64 = 500.0;

/// Ends a combination that takes longer than this.
const PATIENCE: Duration = Duration::from_secs(3);

struct Patience(Instant);

impl Observer for Patience {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.0.elapsed() > PATIENCE {
            return ControlFlow::Break(Interrupt::TimedOut);
        }
        ControlFlow::Continue(())
    }
}

fn laws() -> [(&'static str, Value); 7] {
    [
        ("bilinear", json!({"law": "bilinear", "yield_stress": YIELD, "tangent_modulus": 10_500.0})),
        ("perfectly plastic", json!({"law": "bilinear", "yield_stress": YIELD, "tangent_modulus": 0.0})),
        (
            "ramberg_osgood",
            json!({"law": "ramberg_osgood", "reference_stress": YIELD, "offset": 0.3, "exponent": 5.0}),
        ),
        ("table", json!({"law": "table", "points": [[0.0, YIELD], [0.005, 600.0], [0.05, 700.0]]})),
        ("swift", json!({"law": "swift", "yield_stress": YIELD, "strain_offset": 0.005, "exponent": 0.2})),
        ("ludwik", json!({"law": "ludwik", "yield_stress": YIELD, "coefficient": 800.0, "exponent": 0.5})),
        ("voce", json!({"law": "voce", "yield_stress": YIELD, "saturation_stress": 800.0, "rate": 30.0})),
    ]
}

/// Every shape with its curvature.
fn shapes() -> [(&'static str, Value, f64); 4] {
    let points: Vec<[f64; 2]> =
        (-800..=800).map(|k| f64::from(k) * 0.025).map(|x| [x, -x * x / 50.0]).collect();
    [
        ("cylinder", json!({"type": "cylinder", "radius": 20.0}), 1.0 / 20.0),
        ("block", json!({"type": "block", "width": 60.0, "depth": 30.0}), 0.0),
        ("groove", json!({"type": "groove", "radius": 50.0, "width": 60.0, "depth": 30.0}), -1.0 / 50.0),
        ("profile", json!({"type": "profile", "points": points, "depth": 20.0}), 1.0 / 25.0),
    ]
}

/// The force whose elastic peak pressure is `ratio` yield stresses.
fn force(analysis: &str, ratio: f64, curvature: f64) -> f64 {
    let (peak, radius) = (ratio * YIELD, 1.0 / curvature);
    let plane_strain = 210_000.0 / 1.82;
    match analysis {
        "plane_strain" => PI * radius * peak.powi(2) / plane_strain,
        "plane_stress" => PI * radius * peak.powi(2) / 105_000.0,
        _ => (PI * peak).powi(3) * (radius / plane_strain).powi(2) / 6.0,
    }
}

fn job(analysis: &str, coupling: &str, law: &Value, shapes: [&Value; 2], force: f64) -> Value {
    let body = |shape: &Value| {
        json!({"shape": shape, "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3,
            "plasticity": law}})
    };
    json!({"analysis": analysis, "upper": body(shapes[0]), "lower": body(shapes[1]), "load": {"force": force},
        "mesh": {"elements_per_half_width": 10}, "solver": {"coupling": coupling, "tolerance": 1e-6}})
}

fn outcome(job: &Value) -> String {
    let job = match Job::from_value(job) {
        Ok(job) => job,
        Err(error) => return format!("**{error:?}**"),
    };
    match run(&job, &mut Patience(Instant::now())) {
        Ok(solution) => match solution.steps.first() {
            Some(step) => match step.status {
                SolveStatus::Converged => step.history.len().to_string(),
                SolveStatus::TimedOut => format!("**over {} s**", PATIENCE.as_secs()),
                _ => format!("**no: {:.0e}**", step.equilibrium_residual),
            },
            None => "**no step**".to_owned(),
        },
        Err(error) => format!("**{}**", error.to_string().replace("**", "")),
    }
}

fn by_law() {
    let cylinder = shapes()[0].1.clone();
    println!("| analysis | law | p0/σ_y | {} |\n|---|---|---|---|---|---|---|", COUPLINGS.join(" | "));
    for analysis in ANALYSES {
        for (name, law) in laws() {
            for ratio in [3.0, 4.0, 5.0] {
                let force = force(analysis, ratio, 0.1);
                let row: Vec<String> = COUPLINGS
                    .iter()
                    .map(|coupling| outcome(&job(analysis, coupling, &law, [&cylinder, &cylinder], force)))
                    .collect();
                println!("| {analysis} | {name} | {ratio} | {} |", row.join(" | "));
            }
        }
    }
}

fn by_shape() {
    let law = &laws()[0].1;
    println!("\n| upper | lower | p0/σ_y | {} |\n|---|---|---|---|---|---|", ANALYSES.join(" | "));
    for (upper, a, one) in shapes() {
        for (lower, b, other) in shapes() {
            if one + other <= 0.0 {
                continue;
            }
            for ratio in [3.0, 4.0, 5.0] {
                let row: Vec<String> = ANALYSES
                    .iter()
                    .map(|analysis| {
                        let force = force(analysis, ratio, one + other);
                        outcome(&job(analysis, "accelerated", law, [&a, &b], force))
                    })
                    .collect();
                println!("| {upper} | {lower} | {ratio} | {} |", row.join(" | "));
            }
        }
    }
}

fn main() {
    by_law();
    by_shape();
}
