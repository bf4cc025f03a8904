//! Jobs of three dimensions, from job to report on one thread: `cargo bench --bench
//! three_dimensions`.
//!
//! Medians, least times, the shares of the phases, and the largest memory of the process so far.
//! `-- NAME` runs the cases whose names begin so.
#![expect(clippy::unwrap_used, reason = "a benchmark that cannot go on says where")]

use std::time::{Duration, Instant};

use brinell_solver::job::Job;
use brinell_solver::report::{self, Report, Timings};
use brinell_solver::solver::{Observer, SolveStatus};
use serde_json::{Value, json};

/// Force under which Hertz's peak pressure on a ball of 10 mm is four yield stresses \[N\].
const OF_BALL: f64 = 77.63053;
/// The same of an ellipsoid of 10 and 20 mm.
const OF_ELLIPSOID: f64 = 148.0;

fn main() {
    let named: Vec<String> =
        std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    println!(
        "{:<21} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} s {:>7} MB",
        "case", "median", "least", "kernels", "contact", "law", "spectra", "output", "memory",
    );
    for (name, runs, job) in cases() {
        if named.is_empty() || named.iter().any(|word| name.starts_with(word.as_str())) {
            measure(name, runs, &Job::from_value(&job).unwrap());
        }
    }
}

fn cases() -> [(&'static str, usize, Value); 7] {
    let plastic = json!({"law": "bilinear", "yield_stress": 500, "tangent_modulus": 10_500});
    let history = json!({"history": [{"force": OF_BALL}, {"force": 0}]});
    let flow = json!({"theory": "flow"});
    let ball = |load: &Value, plasticity: &Value, cells: u32, solver: &Value| {
        let mut job = json!({
            "analysis": "three_dimensional",
            "upper": {"shape": {"type": "sphere", "radius": 10}, "material": {"rigid": true}},
            "lower": {
                "shape": {"type": "flat"},
                "material": {"young_modulus": 210_000, "poisson_ratio": 0.3},
            },
            "load": load, "mesh": {"elements_per_half_width": cells}, "solver": solver,
        });
        if !plasticity.is_null() {
            job["lower"]["material"]["plasticity"] = plasticity.clone();
        }
        job
    };
    let force = json!({"force": OF_BALL});
    let by_deformation = json!({"theory": "deformation"});
    let deformation = ball(&force, &plastic, 10, &by_deformation);
    let on_axes = ball(&history, &plastic, 10, &flow);
    let fine = ball(&history, &plastic, 20, &flow);
    // Its initial stress is in no axes of the contact.
    let mut general = on_axes.clone();
    general["upper"]["shape"] =
        json!({"type": "curved", "radius_x": 10, "radius_y": 20, "rotation": 30});
    general["lower"]["material"]["initial_stress"] =
        json!([{"depth": 0, "sigma_x": -200, "sigma_z": 0}]);
    general["load"] = json!({"history": [{"force": OF_ELLIPSOID}, {"force": 0}]});
    [
        ("deformation", 7, deformation),
        ("flow on axes", 5, on_axes),
        ("flow, general", 5, general),
        ("flow, 20 cells", 3, fine),
        ("elastic, 10 cells", 7, ball(&force, &Value::Null, 10, &json!({}))),
        ("elastic, 60 cells", 3, ball(&force, &Value::Null, 60, &json!({}))),
        ("deformation, 40 cells", 1, ball(&force, &plastic, 40, &by_deformation)),
    ]
}

struct Clock(Instant);

impl Observer for Clock {
    fn elapsed(&self) -> Duration {
        self.0.elapsed()
    }
}

fn measure(name: &str, runs: usize, job: &Job) {
    let mut runs: Vec<(f64, Report)> = (0..runs).map(|_| timed(job)).collect();
    runs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (median, report) = &runs[runs.len() / 2];
    let Timings { flexibility, contact, plasticity, solves, output, .. } = report.timings_ms;
    println!(
        "{name:<21} {median:>8.3} {:>8.3} {:>8.3} {:>8.3} {:>8.3} {:>8.3} {:>8.3}   {:>7.0}",
        runs[0].0,
        1e-3 * flexibility,
        1e-3 * contact,
        1e-3 * plasticity,
        1e-3 * solves,
        1e-3 * output,
        largest_memory(),
    );
}

/// Most that the process has held \[MB\]; not a number where the system does not say.
fn largest_memory() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes =
        line.and_then(|line| line.trim().strip_suffix(" kB")?.trim().parse::<f64>().ok());
    kilobytes.map_or(f64::NAN, |kilobytes| 1.024e-3 * kilobytes)
}

fn timed(job: &Job) -> (f64, Report) {
    let mut clock = Clock(Instant::now());
    let report = report::run(job, &mut clock).unwrap();
    assert!(report.steps.iter().all(|step| step.status == SolveStatus::Converged));
    (clock.elapsed().as_secs_f64(), report)
}
