//! Faces given by points that are finer than the mesh, or have corners: spikes, rough traces,
//! sharp profiles.

use brinell_solver::analytical::PowerIndenter;
use brinell_solver::inputs::{self, SolveError};
use brinell_solver::report::{self, Name, StepReport};
use brinell_solver::solver::{MeshedError, SolveStatus, Unobserved};
use serde_json::{Value, json};

use crate::problems::{assert_within, parse, report, solve};

fn steel() -> Value {
    json!({"young_modulus": 210_000.0, "poisson_ratio": 0.3})
}

fn on_block(points: &[[f64; 2]], force: f64, elements: u32) -> Value {
    json!({"analysis": "plane_strain", "load": {"force": force},
        "mesh": {"elements_per_half_width": elements},
        "upper": {"shape": {"type": "profile", "points": points, "depth": 20.0},
            "material": steel()},
        "lower": {"shape": {"type": "block", "width": 60.0, "depth": 30.0}, "material": steel()}})
}

fn with_interpolation(mut job: Value, interpolation: &str) -> Value {
    job["upper"]["shape"]["interpolation"] = json!(interpolation);
    job
}

fn step(job: &Value) -> StepReport {
    let step = report(job).steps.remove(0);
    assert_eq!(step.status, SolveStatus::Converged);
    step
}

#[test]
fn a_corner_in_the_contact_is_asked_about() {
    let points = [[0.0, 0.0], [10.0, -1.0]];
    let mut job = on_block(&points, 1.0, 20);
    job["upper"]["material"] = json!({"rigid": true});
    job["lower"]["shape"] = json!({"type": "block", "width": 800.0, "depth": 400.0});
    let modulus = 210_000.0 / 0.91;
    let indenter = PowerIndenter::new(1.0, 0.1, modulus);
    for (analysis, force) in
        [("plane_strain", indenter.line_force(1.0)), ("axisymmetric", indenter.force(1.0))]
    {
        job["analysis"] = json!(analysis);
        job["load"] = json!({"force": force});
        let refused = inputs::run(&parse(&job), &mut Unobserved).unwrap_err();
        assert!(
            matches!(refused, SolveError::Meshed(MeshedError::AmbiguousCorner { x, .. }) if x == 0.0),
            "{refused}"
        );
        let fault = report::preflight(&parse(&job)).unwrap_err().remove(0);
        assert_eq!(fault.pointer, "/upper/shape/interpolation");
        let sharp = step(&with_interpolation(job.clone(), "linear"));
        assert_within(sharp[Name::HalfWidth], 1.0, 1e-2);
        assert_within(sharp[Name::MeanPressure], 0.05 * modulus, 1e-2);
    }
}

/// A parabola with noise of an even spread between ±amplitude, by a linear congruential generator.
fn rough(n: i32, amplitude: f64) -> Vec<[f64; 2]> {
    let mut state = 12_345_u64;
    (-n..=n)
        .map(|k| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let noise = 2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0;
            let x = 10.0 * f64::from(k) / f64::from(n);
            [x, -x * x / 100.0 + amplitude * noise]
        })
        .collect()
}

/// The cost of a rough trace is known before it is solved, also where its highest summits could
/// bear the force alone and where it touches in parts that are narrower than the distance of its
/// points asks for.
#[test]
#[ignore = "full"]
fn a_rough_trace_costs_what_was_estimated() {
    for (n, amplitude, force, tolerance) in [
        (1000, 1e-4, 300.0, 0.2),
        (1000, 1e-6, 300.0, 0.2),
        (2000, 1e-4, 300.0, 0.2),
        (500, 2e-3, 300.0, 0.4),
        (250, 2e-3, 300.0, 0.4),
        (250, 4e-3, 300.0, 0.4),
        (500, 1e-3, 30.0, 0.4),
    ] {
        let job = with_interpolation(on_block(&rough(n, amplitude), force, 10), "smooth");
        let expected = report::preflight(&parse(&job)).unwrap().equations as f64;
        let solution = solve(&job);
        let found: usize =
            solution.steps[0].field.bodies.iter().flatten().map(|body| body.equations).sum();
        assert_within(found as f64, expected, tolerance);
    }
}

/// Half a micrometre of noise on points 2.5 µm apart: nothing under five million equations
/// resolves it, and that is said.
#[test]
fn a_very_rough_trace_is_known_to_be_dear() {
    let job = on_block(&rough(4000, 5e-4), 300.0, 20);
    let asked = report::preflight(&parse(&job)).unwrap_err().remove(0);
    assert_eq!(asked.pointer, "/upper/shape/interpolation");
    for interpolation in ["smooth", "linear"] {
        let job = with_interpolation(job.clone(), interpolation);
        let cost = report::preflight(&parse(&job)).unwrap();
        assert!((3_000_000..8_000_000).contains(&cost.equations), "{cost:?}");
    }
}

#[test]
fn a_trace_that_no_mesh_resolves_is_refused_with_the_size_it_needs() {
    let points: Vec<[f64; 2]> =
        rough(5000, 1e-3).into_iter().filter(|[x, _]| x.abs() < 9.0).collect();
    let job = with_interpolation(on_block(&points, 20_000.0, 20), "smooth");
    let refused = inputs::run(&parse(&job), &mut Unobserved).unwrap_err();
    assert!(
        matches!(refused, SolveError::Meshed(MeshedError::TraceTooFine { spacing, finest, .. }) if spacing < finest),
        "{refused}"
    );
    assert!(refused.to_string().contains("elements of"), "{refused}");
}

/// Teeth that a mesh of the density asked for has one element for are resolved, or said to be too
/// fine for it.
#[test]
#[ignore = "full"]
fn teeth_are_resolved_or_said() {
    let teeth: Vec<[f64; 2]> = (-100..=100)
        .map(|k| {
            let x = 0.1 * f64::from(k);
            [x, if k % 2 == 0 { 0.0 } else { 1e-3 } - x * x / 200.0]
        })
        .collect();
    let on =
        |elements: u32| step(&with_interpolation(on_block(&teeth, 1000.0, elements), "smooth"));
    let [coarse, fine, finer] = [5, 20, 30].map(on);
    let says = |step: &StepReport| step.validity.iter().any(|note| note.code == "coarse_mesh");
    assert!(coarse[Name::PeakPressure] < 0.7 * fine[Name::PeakPressure] && says(&coarse));
    let bar = fine.bar(Name::PeakPressure).unwrap();
    assert_within(fine[Name::PeakPressure], finer[Name::PeakPressure], bar);
    assert!(bar < 0.05 && fine.contact.patches.len() == finer.contact.patches.len(), "{bar}");
}
