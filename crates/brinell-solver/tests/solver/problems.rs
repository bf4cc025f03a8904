//! Jobs that several verification problems share.

use brinell_solver::inputs;
use brinell_solver::job::Job;
use brinell_solver::report::{self, Name, Report, StepReport};
use brinell_solver::solver::{Options, Solution, Unobserved};
use serde_json::{Value, json};

use crate::theory::by_deformation_theory;

/// Reference force of the paper's problem: elastic peak pressure of three yield stresses \[N/mm\].
pub const FORCE_3: f64 = 612.6106;
/// The same for four yield stresses.
pub const FORCE_4: f64 = 1089.0855;
/// The same for five yield stresses.
pub const FORCE_5: f64 = 1701.696;

/// A steel cylinder, 20 mm in radius.
pub fn cylinder(support: &str, plasticity: Value) -> Value {
    let mut material = json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3});
    if !plasticity.is_null() {
        material["plasticity"] = plasticity;
    }
    json!({"shape": {"type": "cylinder", "radius": 20.0}, "support": support,
        "material": material})
}

/// The hardening of the paper's problem.
pub fn bilinear() -> Value {
    json!({"law": "bilinear", "yield_stress": 500.0, "tangent_modulus": 10_500.0})
}

/// Two equal cylinders under a force.
pub fn two_cylinders(support: &str, plasticity: Value, force: f64) -> Value {
    let body = cylinder(support, plasticity);
    json!({"analysis": "plane_strain", "upper": body, "lower": body, "load": {"force": force}})
}

/// The paper's problem, clamped, with a coupling.
pub fn paper(force: f64, coupling: &str) -> Value {
    let mut job = two_cylinders("clamped", bilinear(), force);
    job["solver"] = json!({"theory": "deformation", "coupling": coupling});
    job
}

pub fn parse(job: &Value) -> Job {
    Job::from_value(&by_deformation_theory(job)).unwrap_or_else(|error| panic!("{error:?}"))
}

pub fn report(job: &Value) -> Report {
    report::run(&parse(job), &mut Unobserved).unwrap()
}

pub fn solve(job: &Value) -> Solution {
    inputs::run(&parse(job), &mut Unobserved).unwrap()
}

pub fn solve_with(job: &Value, options: Options<'_>) -> Solution {
    inputs::run_with(&parse(job), options, &mut Unobserved).unwrap()
}

/// Every figure that a solution has, to the last bit.
pub fn bits(solution: &Solution) -> Vec<u64> {
    let mut figures = Vec::new();
    for step in &solution.steps {
        figures.extend([
            step.figures.approach,
            step.figures.peak_pressure,
            step.contact_stiffness.unwrap_or(0.0),
            step.checks.residual,
        ]);
        figures.extend(
            step.field.pairs.iter().flat_map(|pair| [pair.force, pair.pressure, pair.gap]),
        );
        figures.extend(
            step.history.iter().flat_map(|record| [record.approach, record.equilibrium_residual]),
        );
        for body in step.field.bodies.iter().flatten() {
            figures.extend(body.stress.points.iter().flatten().flat_map(|point| point.stress));
        }
    }
    figures.into_iter().map(f64::to_bits).collect()
}

/// Asserts `|value / expected - 1| <= tolerance`.
#[track_caller]
pub fn assert_within(value: f64, expected: f64, tolerance: f64) {
    let error = value / expected - 1.0;
    assert!(error.abs() <= tolerance, "{value} is {:+.4} % off {expected}", 100.0 * error);
}

/// Asserts that a figure is the expected one within its error bar.
#[track_caller]
fn assert_in_bar(value: f64, expected: f64, bar: Option<f64>) {
    assert_within(value, expected, bar.unwrap());
}

/// Asserts that the peak pressure is the expected one within its error bar.
#[track_caller]
pub fn assert_peak(step: &StepReport, expected: f64) {
    let bar = step.bar(Name::PeakPressure);
    assert_in_bar(step[Name::PeakPressure], expected, bar);
}

/// Asserts that the half-width is the expected one within its error bar.
#[track_caller]
pub fn assert_width(step: &StepReport, expected: f64) {
    let bar = step.bar(Name::HalfWidth);
    assert_in_bar(step[Name::HalfWidth], expected, bar);
}

/// Asserts that the approach is the expected one within its error bar.
#[track_caller]
pub fn assert_approach(step: &StepReport, expected: f64) {
    let bar = step.bar(Name::Approach);
    assert_in_bar(step.approach().unwrap(), expected, bar);
}
