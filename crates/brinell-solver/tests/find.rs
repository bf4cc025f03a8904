//! Inputs that are sought, and tolerances: closed forms of Hertz, Lundberg's profile, and refusals.
#![expect(clippy::unwrap_used, reason = "a test that cannot go on says where")]

use std::f64::consts::PI;
use std::ops::ControlFlow;

use brinell_solver::job::{Job, JobError};
use brinell_solver::report::{self, Answer, ErrorBar, Name, Report, RunError};
use brinell_solver::solver::{Interrupt, IterationRecord, Observer, SolveStatus, Unobserved};
use serde_json::{Value, json};

/// E* of a rigid body on steel.
const MODULUS: f64 = 210_000.0 / (1.0 - 0.3 * 0.3);

fn solve(job: &Value) -> Report {
    let job = Job::from_value(job).unwrap_or_else(|error| panic!("{error:?} of {job}"));
    let report = report::run(&job, &mut Unobserved).unwrap();
    assert_eq!(report.status, SolveStatus::Converged);
    report
}

/// The fault of a job that is refused as it is read, or as it is solved.
fn refusal(job: &Value) -> String {
    let faults = match Job::from_value(job) {
        Err(JobError::Fields(faults)) => faults,
        Err(error) => panic!("{error:?}"),
        Ok(job) => match report::run(&job, &mut Unobserved) {
            Err(RunError::Input(faults)) => faults,
            other => panic!("{other:?}"),
        },
    };
    assert_eq!(faults.len(), 1, "{faults:?}");
    faults[0].to_string()
}

/// A rigid roller on an elastic block, whose datum is deep enough for half-planes.
fn line() -> Value {
    json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 20}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "block", "width": 400, "depth": 400},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": 500},
    })
}

/// A rigid ball on an elastic half-space.
fn ball() -> Value {
    json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": 100},
        "mesh": {"elements_per_half_width": 8},
    })
}

fn finding(mut job: Value, vary: &str, between: [f64; 2], until: &Value) -> Value {
    job["find"] = json!({"vary": vary, "between": between, "until": until});
    job
}

/// The row of the input, whose value is found.
fn input(report: &Report) -> (f64, &Answer) {
    let row = &report.answers[0];
    assert!(row.is(Name::InputFound), "{row:?}");
    (row.value.unwrap(), row)
}

#[track_caller]
fn assert_within(found: f64, exact: f64, bound: f64) {
    assert!((found / exact - 1.0).abs() <= bound, "{found} and not {exact} within {bound}");
}

#[test]
fn a_radius_is_that_of_hertz() {
    for (job, force, exact) in [
        (line(), 500.0, (|force, p0| force * MODULUS / (PI * p0 * p0)) as fn(f64, f64) -> f64),
        (ball(), 100.0, |force, p0| (6.0 * force * MODULUS.powi(2) / (PI * p0).powi(3)).sqrt()),
    ] {
        let until = json!({"peak_pressure": 1500});
        let report = solve(&finding(job, "/upper/shape/radius", [2.0, 200.0], &until));
        let (radius, row) = input(&report);
        let ErrorBar::Relative(error) = row.error else { panic!("{row:?}") };
        assert!(error < 0.05, "{row:?}");
        assert_within(radius, exact(force, 1500.0), error);
        assert_eq!((row.unit.as_str(), row.quantity), ("mm", report::Quantity::Length));
        let found = report.found.as_ref().unwrap();
        assert!(found.looks.value.len() <= 6, "{found:?}");
        // The steps are those of the job with it.
        assert_within(report.steps[0][Name::PeakPressure], 1500.0, 1e-3);
    }
}

/// The found value, put in, is the same answer to the last bit.
#[test]
fn the_value_that_is_told_is_the_job_that_is_solved() {
    let mut job = line();
    let until = json!({"half_width": 0.4});
    let found = solve(&finding(job.clone(), "/upper/shape/radius", [5.0, 100.0], &until));
    job["upper"]["shape"]["radius"] = json!(input(&found).0);
    assert_eq!(solve(&job).steps[0].answers, found.steps[0].answers);
}

#[test]
fn elasticities_are_the_exponents_of_hertz() {
    let inputs = ["/load/force", "/upper/shape/radius", "/lower/material/young_modulus"];
    for (mut job, exponents) in
        [(line(), [0.5, -0.5, 0.5]), (ball(), [1.0 / 3.0, -2.0 / 3.0, 2.0 / 3.0])]
    {
        let parts: serde_json::Map<_, _> =
            inputs.iter().map(|input| ((*input).to_owned(), json!(0.02))).collect();
        job["tolerances"] = parts.into();
        let told = solve(&job).tolerances.unwrap();
        let peak = told.name.iter().position(|name| name == "peak_pressure").unwrap();
        for (input, exponent) in inputs.iter().zip(exponents) {
            let at = told.inputs.iter().position(|one| one == input).unwrap();
            assert_within(told.elasticities[peak][at].unwrap(), exponent, 0.01);
        }
        // Of a power the smaller input changes more.
        let change = |exponent: &f64| (0.98_f64.powf(*exponent) - 1.0).abs();
        let squares = exponents.iter().map(|one| change(one).powi(2)).sum::<f64>().sqrt();
        assert_within(told.root_of_squares[peak].unwrap(), squares, 0.01);
        let sum = exponents.iter().map(change).sum::<f64>();
        assert_within(told.at_worst[peak].unwrap(), sum, 0.01);
        assert!(!told.text.is_empty());
    }
}

/// A force is found by the search of `load.target`.
#[test]
fn a_force_is_that_of_a_target() {
    let until = json!({"peak_pressure": 1500});
    let found = solve(&finding(line(), "/load/force", [10.0, 1e5], &until));
    let mut target = line();
    target["load"] = json!({"target": {"peak_pressure": 1500}});
    let target = solve(&target);
    assert_within(input(&found).0, target.answers[0].value.unwrap(), 1e-6);
    let error = |row: &Answer| row.error.bound().unwrap();
    assert_within(error(input(&found).1), error(&target.answers[0]), 0.1);
}

/// Ends, wanted value and input found are in the units of the job.
#[test]
fn numbers_are_in_the_units_of_the_job() {
    let found = |job, ends, peak| {
        let report =
            solve(&finding(job, "/upper/shape/radius", ends, &json!({"peak_pressure": peak})));
        let (radius, row) = input(&report);
        (radius, row.unit.clone())
    };
    let mut metres = ball();
    metres["units"] = json!("SI");
    metres["upper"]["shape"]["radius"] = json!(0.01);
    metres["lower"]["material"]["young_modulus"] = json!(2.1e11);
    let (in_metres, unit) = found(metres, [0.002, 0.2], 1.5e9);
    let (in_millimetres, _) = found(ball(), [2.0, 200.0], 1500.0);
    assert_eq!(unit, "m");
    assert_within(1000.0 * in_metres, in_millimetres, 1e-4);
}

/// Stops at an iteration, which is one of a trial, and notes the solves that are expected.
#[derive(Default)]
struct Stopping {
    iterations: usize,
    loads: usize,
}

impl Observer for Stopping {
    fn on_iteration(&mut self, _: &IterationRecord) -> ControlFlow<Interrupt> {
        panic!("an iteration of a trial is preliminary");
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.loads = record.increment.map_or(0, |at| at.loads);
        self.iterations += 1;
        if self.iterations == 2 {
            ControlFlow::Break(Interrupt::TimedOut)
        } else {
            ControlFlow::Continue(())
        }
    }
}

/// Limits hold for the whole search.
#[test]
fn a_search_stops_where_its_time_is_over() {
    let until = json!({"peak_pressure": 1500});
    let job = finding(ball(), "/upper/shape/radius", [2.0, 200.0], &until);
    let observer = &mut Stopping::default();
    let stopped = report::run(&Job::from_value(&job).unwrap(), observer);
    assert_eq!(stopped.unwrap_err(), RunError::Interrupted(Interrupt::TimedOut));
    assert_eq!((observer.iterations, observer.loads), (2, 7));
}

/// The half-width over Poisson's ratio has the elasticity -ν²/(1 - ν²), at most a 277th.
#[test]
fn a_figure_that_hardly_depends_on_the_input_tells_both_ends() {
    let mut job = line();
    job["lower"]["material"]["poisson_ratio"] = json!(0.06);
    let until = json!({"half_width": solve(&job).steps[0][Name::HalfWidth]});
    let report = solve(&finding(job, "/lower/material/poisson_ratio", [0.02, 0.45], &until));
    let row = &report.answers[0];
    assert_eq!(row.value, None, "{row:?}");
    let [low, high] = [row.at_least, row.at_most].map(Option::unwrap);
    assert!(low < 0.06 && high > 0.06, "{row:?}");
    let text = &report.found.as_ref().unwrap().text;
    assert!(text.contains("but tells it poorly: from "), "{text}");
    assert!(text.contains(" would tell it to ± "), "{text}");
}

/// Meshes of an accuracy differ from look to look.
#[test]
fn a_search_refuses_an_accuracy() {
    let mut job = finding(ball(), "/upper/shape/radius", [2.0, 200.0], &json!({"approach": 0.01}));
    job["mesh"] = json!({"accuracy": 0.02});
    assert!(refusal(&job).starts_with("/mesh/accuracy"), "{}", refusal(&job));
}

/// The cells of heights are given.
#[test]
fn heights_refuse_an_accuracy() {
    let mut job = ball();
    job["upper"]["surface"] =
        json!({"heights": vec![vec![0.0; 16]; 16], "spacing_x": 0.05, "spacing_y": 0.05});
    job["analysis"] = json!("three_dimensional");
    job["mesh"] = json!({"accuracy": 0.02});
    assert!(refusal(&job).contains("/mesh/accuracy"), "{}", refusal(&job));
}

/// Reciprocal figures take the ends and one secant.
#[test]
fn a_margin_takes_one_secant() {
    let mut job = ball();
    job["lower"]["material"]["plasticity"] =
        json!({"law": "bilinear", "yield_stress": 3000, "tangent_modulus": 10_500});
    let report = solve(&finding(job, "/load/force", [1.0, 1000.0], &json!({"margin": 2})));
    assert_eq!(report.found.unwrap().looks.value.len(), 3);
}

/// The best of Lundberg's profiles presses nearly as the even pressure of a line, below which the
/// peak of no profile falls. Its force is above that of the load: the logarithm is cut at the ends.
#[test]
#[ignore = "full"]
fn the_most_even_pressure_is_that_of_lundberg() {
    let mut job = ball();
    job["upper"]["shape"] = json!({"type": "roller", "radius": 5, "length": 10,
        "profile": "logarithmic", "design_force": 8000});
    job["load"] = json!({"force": 8000});
    let of_load = solve(&job).steps[0][Name::PeakPressure];
    let until = json!({"least": "peak_pressure"});
    let report = solve(&finding(job, "/upper/shape/design_force", [2000.0, 32_000.0], &until));
    let peak = report.steps[0][Name::PeakPressure];
    let even = (8000.0 * MODULUS / (PI * 5.0 * 10.0)).sqrt();
    assert!(peak < of_load && even < peak && peak < 1.03 * even, "{even}, {peak}, {of_load}");
    let force = report.found.unwrap().values[0];
    assert!((8000.0..16_000.0).contains(&force), "{force}");
}

#[test]
fn what_cannot_be_found_is_refused_by_its_field() {
    let peak = || json!({"peak_pressure": 1500});
    let radius = "/upper/shape/radius";
    let ends = [5.0, 50.0];
    let mut two = line();
    two["find"] = json!([{"vary": radius}, {"vary": "/load/force"}]);
    for (job, words) in [
        (two, "/find: must be "),
        (finding(line(), "/upper/shape/type", ends, &peak()), "/find/vary: \"/upper/shape/type\""),
        (finding(line(), "/mesh/elements_per_half_width", ends, &peak()), "/find/vary: "),
        (finding(line(), radius, [50.0, 5.0], &peak()), "/find/between: "),
        (finding(line(), radius, [-1.0, 5.0], &peak()), "/find/between/0: with -1"),
        (finding(line(), radius, ends, &json!({})), "/find/until: must have one figure"),
        (finding(line(), radius, ends, &json!({"peek": 1})), "/find/until/peek: unknown key"),
        (
            finding(line(), radius, ends, &json!({"peak_pressure": 1, "approach": 1})),
            "/find/until: must have only one figure",
        ),
        (
            finding(line(), radius, ends, &json!({"plastic_depth": 1})),
            "/find/until/plastic_depth: cannot be wanted",
        ),
        (
            finding(line(), radius, ends, &json!({"peak_pressure": 1e5})),
            "/find/until/peak_pressure: Peak pressure is ",
        ),
        (
            finding(line(), radius, ends, &json!({"hardness": 1})),
            "/find: with /upper/shape/radius",
        ),
    ] {
        let told = refusal(&job);
        assert!(told.starts_with(words), "{told}");
    }
    let mut zero = line();
    zero["lower"]["material"]["poisson_ratio"] = json!(0);
    zero["tolerances"] = json!({"/lower/material/poisson_ratio": 0.05});
    assert!(refusal(&zero).contains("is 0, of which a part is 0"));
    zero["tolerances"] = json!({"/upper/material/rigid": 0.05});
    assert!(refusal(&zero).starts_with("/tolerances/~1upper~1material~1rigid: "));
}
