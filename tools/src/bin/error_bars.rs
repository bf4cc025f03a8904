//! Counts how often the error bars hold, over random jobs of the whole format, each against the same job on a finer mesh.
//!
//! `cargo run --release -p brinell-tools --bin error_bars -- 110 9002 deformation` counts 110 jobs from the seed 9002 under the
//! theory `deformation`; `flow` counts those under flow theory, `all` both, which is also what is counted without it. A fourth argument of
//! any kind prints the jobs whose bars do not hold or are more than 20 times too wide. Peaks that have no limit, which the answer says with
//! `sharp_corner`, are counted apart.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::collections::BTreeMap;

use brinell_solver::job::Job;
use brinell_solver::report::{self, Report, StepReport};
use brinell_solver::solver::{SolveStatus, Unobserved};
use random_job::Random;
use serde_json::{Value, json};

/// Elements over the half-width of the jobs; those of the reference are so many times as many.
const MESHES: [u32; 4] = [8, 10, 12, 14];
const FINER: u64 = 4;
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
        take("force", bar.force, step.contact.force, exact.contact.force);
    } else {
        take("approach", bar.approach, step.approach, exact.approach);
    }
    if let Some(slope) = slope {
        take("contact stiffness", bar.contact_stiffness, step.contact_stiffness, slope);
    }
    Some(all)
}

fn solve(job: &Value) -> Option<Report> {
    let job = Job::from_json(job.to_string().as_bytes()).ok()?;
    report::run(&job, &mut Unobserved).ok().filter(|report| report.status == SolveStatus::Converged)
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
    let mut found: BTreeMap<(&str, String), Vec<f64>> = BTreeMap::new();
    let mut jobs = 0;
    while jobs < count {
        let mut job = random_job::job(&mut random, &MESHES);
        job["solver"].as_object_mut().map(|solver| (solver.remove("coupling"), solver.remove("contact")));
        let is_flow = job["solver"]["theory"] == "flow";
        let is_asked = theory == "all" || is_flow == (theory == "flow");
        if job["load"]["onset"].is_boolean() || !is_asked {
            continue;
        }
        let Some(report) = solve(&job) else { continue };
        let mut finer = job.clone();
        let elements = job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10);
        finer["mesh"]["elements_per_half_width"] = json!(elements * if is_flow { FINER / 2 } else { FINER });
        let Some(exact) = solve(&finer) else { continue };
        let slope = slope(&finer);
        let analysis = if is_flow { "flow theory".to_owned() } else { report.analysis.replace('_', " ") };
        for (step, exact) in report.steps.iter().zip(&exact.steps) {
            let Some(all) = ratios(step, exact, slope) else { continue };
            for (quantity, bar, error) in all {
                if is_verbose && !(1.0..20.0).contains(&(bar / error)) {
                    println!("{quantity}: bar {bar:.1e}, error {error:.1e}\n{job}");
                }
                found.entry((quantity, analysis.clone())).or_default().push(bar / error);
            }
        }
        jobs += 1;
        eprint!("\r{jobs} of {count} jobs");
    }
    eprintln!();
    println!(
        "| quantity | jobs | bars | hold | not 20 times too wide | median width |\n|---|---|---|---|---|---|"
    );
    for ((quantity, analysis), mut ratios) in found {
        ratios.sort_by(f64::total_cmp);
        let n = ratios.len() as f64;
        let share = |holds: fn(f64) -> bool| 100.0 * ratios.iter().filter(|r| holds(**r)).count() as f64 / n;
        println!(
            "| {quantity} | {analysis} | {n} | {:.0} % | {:.0} % | {:.1} |",
            share(|r| r >= 1.0),
            share(|r| r <= 20.0),
            ratios[ratios.len() / 2]
        );
    }
}
