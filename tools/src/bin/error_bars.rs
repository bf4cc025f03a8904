//! Counts how often the error bars hold, over random jobs of the whole format, each against the same job on a mesh four times as dense.
//!
//! Steps are those in which nothing yields, those under deformation theory and those under flow theory, of jobs that are solved within a
//! minute on both meshes. Missed in silence is a figure beyond its bar in a step without a remark but those on the theory.
//!
//! `cargo run --release -p brinell-tools --bin error_bars -- 110 9002 deformation` counts 110 jobs from the seed 9002 under the
//! theory `deformation`; `flow` counts those under flow theory, `all` both, which is also what is counted without it. A fourth argument of
//! any kind prints the jobs whose bars do not hold or are more than 20 times too wide. Peaks that have no limit, which the answer says with
//! `sharp_corner`, are counted apart.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_solver::job::Job;
use brinell_solver::report::{self, Report, StepReport};
use brinell_solver::solver::{Interrupt, Observer, SolveStatus};
use random_job::Random;
use serde_json::{Value, json};

/// Elements over the half-width of the jobs; those of the reference are so many times as many.
const MESHES: [u32; 4] = [6, 8, 10, 12];
const FINER: u64 = 4;
/// Most elements of a history.
const MOST_OF_FLOW: u64 = 8;
/// Seconds that a job may take.
const PATIENCE: u64 = 60;
/// Remarks on the theory.
const THEORY: [&str; 4] = ["deformation_theory", "large_strain", "falling_loads", "bilinear_curve"];
const SEED: u64 = 20_261_122;

/// Half of the distance of the loads that the stiffness is compared with, in the logarithm.
const SPAN: f64 = 0.1;

/// The bar over the true error of each quantity of a step.
fn ratios(
    step: &StepReport,
    exact: &StepReport,
    slope: Option<f64>,
) -> Option<Vec<(&'static str, f64, f64)>> {
    let bar = step.estimated_error.as_ref()?;
    let mut all = Vec::new();
    let mut take = |quantity, bar: f64, found: f64, exact: f64| {
        // Where nothing touches any more pressure and width are exactly zero.
        if exact != 0.0 {
            all.push((quantity, bar, (found / exact - 1.0).abs().max(1e-12)));
        }
    };
    let is_unbounded = step.validity.iter().any(|note| note.code == "sharp_corner");
    let peak = if is_unbounded { "peak pressure without a limit" } else { "peak pressure" };
    take(peak, bar.peak_pressure, step.contact.peak_pressure, exact.contact.peak_pressure);
    take("half-width", bar.half_width, step.contact.half_width, exact.contact.half_width);
    if bar.force > 0.0 {
        let figure = if step.yield_onset.is_some() { "force of an onset" } else { "force" };
        take(figure, bar.force, step.contact.force, exact.contact.force);
    } else {
        take("approach", bar.approach, step.approach, exact.approach);
    }
    if let Some(slope) = slope {
        take("contact stiffness", bar.contact_stiffness, step.contact_stiffness.unwrap_or(0.0), slope);
    }
    Some(all)
}

/// Ends a job that takes too long.
struct Patience(Instant);

impl Observer for Patience {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.0.elapsed() > Duration::from_secs(PATIENCE) {
            return ControlFlow::Break(Interrupt::TimedOut);
        }
        ControlFlow::Continue(())
    }
}

fn solve(job: &Value) -> Option<Report> {
    let job = Job::from_json(job.to_string().as_bytes()).ok()?;
    let report = report::run(&job, &mut Patience(Instant::now()));
    report.ok().filter(|report| report.status == SolveStatus::Converged)
}

/// A bar beside the error.
struct Counted {
    bar: f64,
    error: f64,
    /// Whether the step has no remark but those on the theory.
    is_silent: bool,
}

/// What a step is of.
fn kind(step: &StepReport, is_flow: bool) -> &'static str {
    let zones = [&step.plasticity.upper, &step.plasticity.lower];
    match zones.into_iter().flatten().any(|zone| zone.yielded) {
        true if is_flow => "flow theory",
        true => "deformation theory",
        false => "nothing yields",
    }
}

/// dP/dα of a single force under deformation theory from answers on both sides of it, on the mesh of the reference.
fn slope(job: &Value) -> Option<f64> {
    let force = job["load"]["force"].as_f64()?;
    let mut sweep = job.clone();
    sweep["load"] = json!({"forces": [force * (-SPAN).exp(), force, force * SPAN.exp()]});
    let steps = solve(&sweep)?.steps;
    let [below, at, above] = steps.as_slice() else { return None };
    Some(2.0 * SPAN / (above.approach / below.approach).ln() * force / at.approach)
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(150);
    let seed = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(SEED);
    let theory = arguments.next().unwrap_or_else(|| "all".to_owned());
    let is_verbose = arguments.next().is_some();
    let mut random = Random(seed);
    let mut found: BTreeMap<(&str, &str), Vec<Counted>> = BTreeMap::new();
    let (mut jobs, mut unsolved, mut without_bars) = (0, 0, 0);
    while jobs < count {
        let mut job = random_job::job(&mut random, &MESHES);
        job["solver"].as_object_mut().map(|solver| (solver.remove("coupling"), solver.remove("contact")));
        let is_flow = job["solver"]["theory"] == "flow";
        let is_asked = theory == "all" || is_flow == (theory == "flow");
        if !is_asked {
            continue;
        }
        jobs += 1;
        eprint!("\r{jobs} of {count} jobs");
        let elements = job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10);
        let elements = if is_flow { elements.min(MOST_OF_FLOW) } else { elements };
        job["mesh"]["elements_per_half_width"] = json!(elements);
        let mut finer = job.clone();
        finer["mesh"]["elements_per_half_width"] = json!(elements * FINER);
        let Some((report, exact)) = solve(&job).and_then(|report| Some((report, solve(&finer)?))) else {
            unsolved += 1;
            continue;
        };
        let slope = slope(&finer);
        for (step, exact) in report.steps.iter().zip(&exact.steps) {
            let Some(all) = ratios(step, exact, slope) else {
                without_bars += 1;
                continue;
            };
            let is_silent = step.validity.iter().all(|note| THEORY.contains(&note.code.as_str()));
            for (quantity, bar, error) in all {
                if is_verbose && !(1.0..20.0).contains(&(bar / error)) {
                    println!("{quantity}: bar {bar:.1e}, error {error:.1e}\n{job}");
                }
                found.entry((quantity, kind(step, is_flow))).or_default().push(Counted {
                    bar,
                    error,
                    is_silent,
                });
            }
        }
    }
    eprintln!();
    println!("{jobs} jobs, {unsolved} of them without two answers, {without_bars} steps without bars\n");
    println!(
        "| quantity | steps | bars | hold | median bar | median of bar over error | missed in silence |\n|---|---|---|---|---|---|---|"
    );
    for ((quantity, kind), bars) in found {
        let median = |of: fn(&Counted) -> f64| {
            let mut values: Vec<f64> = bars.iter().map(of).collect();
            values.sort_by(f64::total_cmp);
            values[values.len() / 2]
        };
        let held = bars.iter().filter(|one| one.bar >= one.error).count();
        let silent = bars.iter().filter(|one| one.bar < one.error && one.is_silent).count();
        println!(
            "| {quantity} | {kind} | {} | {:.0} % | {:.1e} | {:.1} | {silent} |",
            bars.len(),
            100.0 * held as f64 / bars.len() as f64,
            median(|one| one.bar),
            median(|one| one.bar / one.error)
        );
    }
}
