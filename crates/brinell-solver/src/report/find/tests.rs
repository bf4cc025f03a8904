//! Searches over made figures: the peak pressure of a solved job, another number in its place.

use serde_json::{Value, json};

use super::{Solve, run_each};
use crate::job::Job;
use crate::report::{Name, Report, RunError, StepReport, run_each as solve_plain};
use crate::solver::{Observer, Options, Unobserved};

/// Solves a job and puts a figure of the radius in place of the peak pressure.
fn made(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
    figure: fn(f64) -> f64,
) -> Result<Report, RunError> {
    let radius = job.number_at("/upper/shape/radius").unwrap();
    solve_plain(job, options, observer, &mut |number, mut step: StepReport| {
        for row in step.answers.iter_mut().filter(|row| row.is(Name::PeakPressure)) {
            row.value = Some(figure(radius));
        }
        on_step(number, step);
    })
}

/// The radius at which the figures have their optimum.
const BEST: f64 = 21.0;

fn jump(radius: f64) -> f64 {
    if radius < 31.0 { 100.0 } else { 200.0 }
}

fn bowl(radius: f64) -> f64 {
    100.0 * (1.0 + 4.0 * (radius / BEST).ln().powi(2))
}

fn flat(radius: f64) -> f64 {
    (radius / BEST - 1.0).max(0.0)
}

/// Looks for a radius between 5 and 80 by a made figure.
fn sought(until: &Value, solve: Solve) -> Result<Report, RunError> {
    let job = json!({
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
        "lower": {"shape": {"type": "flat"},
            "material": {"young_modulus": 210_000, "poisson_ratio": 0.3}},
        "load": {"force": 100},
        "mesh": {"elements_per_half_width": 4},
        "find": {"vary": "/upper/shape/radius", "between": [5, 80], "until": until},
    });
    let job = Job::from_value(&job).unwrap();
    run_each(&job, Options::default(), &mut Unobserved, &mut |_, _| {}, solve)
}

#[test]
fn a_figure_that_jumps_is_refused_with_both_sides() {
    let told = sought(&json!({"peak_pressure": 150}), |job, options, observer, on_step| {
        made(job, options, observer, on_step, jump)
    });
    let Err(RunError::Input(faults)) = told else { panic!("{told:?}") };
    let told = faults[0].to_string();
    assert!(
        told.starts_with("/find/until/peak_pressure: Peak pressure is 200 with 31."),
        "{told}"
    );
    assert!(told.contains(" and 100 with 30."), "{told}");
    assert!(told.ends_with(": it jumps over 150"), "{told}");
}

/// A figure with an optimum between the ends has its value twice.
#[test]
fn every_crossing_is_told() {
    let report = sought(&json!({"peak_pressure": 125}), |job, options, observer, on_step| {
        made(job, options, observer, on_step, bowl)
    });
    let found = report.unwrap().found.unwrap();
    let exact = [-0.25_f64, 0.25].map(|part| BEST * part.exp());
    assert_eq!(found.values.len(), 2, "{found:?}");
    for (value, exact) in found.values.iter().zip(exact) {
        assert!((value / exact - 1.0).abs() < 2e-3, "{found:?}");
    }
    assert!(found.text.contains(" Also with 26."), "{}", found.text);
}

/// The ± of an optimum is the distance at which the figure has left its bar, and that of a figure
/// which is 0 there is not known.
#[test]
fn an_optimum_is_as_sure_as_its_figure_is_bent() {
    let report = sought(&json!({"least": "peak_pressure"}), |job, options, observer, on_step| {
        made(job, options, observer, on_step, bowl)
    });
    let report = report.unwrap();
    let found = report.found.as_ref().unwrap();
    let bar = found.looks.error[0].unwrap();
    let exact = 0.5 * bar.sqrt();
    assert!((found.values[0] / BEST).ln().abs() < exact, "{found:?}");
    let error = report.answers[0].error.bound().unwrap();
    assert!((error / exact - 1.0).abs() < 0.1, "{error} and not {exact}");

    let report = sought(&json!({"least": "peak_pressure"}), |job, options, observer, on_step| {
        made(job, options, observer, on_step, flat)
    });
    let report = report.unwrap();
    assert_eq!(report.answers[0].error.bound(), None);
    assert!(report.answers[0].value.unwrap() <= BEST);
}
