//! Compares contact stiffnesses with differences of the approach under loads of ±1, ±3 and ±10 %,
//! each load a job of its own, over random jobs of the whole format; the last difference counts.
//!
//! `cargo run --release -p brinell-tools --bin contact_stiffness -- 80` counts 80 jobs; a second
//! argument is the seed, a third of any kind prints every job that is beyond one per cent. Files
//! of jobs in place of a number are compared one by one.

#![expect(clippy::print_stdout, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::collections::BTreeMap;

use brinell_solver::job::Job;
use brinell_solver::report::{self, Name};
use brinell_solver::solver::{SolveStatus, Unobserved};
use random_job::Random;
use serde_json::{Value, json};

const MESHES: [u32; 3] = [10, 14, 20];
const SEED: u64 = 20_261_122;
/// Halves of the distance of the loads of a difference, over the load.
const STEPS: [f64; 3] = [0.01, 0.03, 0.1];

/// The force of the last load of a job, which decides over its stiffness.
fn last_force(job: &Value) -> Option<f64> {
    let load = &job["load"];
    let last = |list: &Value| list.as_array().and_then(|list| list.last().cloned());
    load["force"]
        .as_f64()
        .or_else(|| last(&load["forces"])?.as_f64())
        .or_else(|| last(&load["history"])?["force"].as_f64())
        .filter(|force| *force > 0.0)
}

/// The job with its last force multiplied by so much; single where loads do not depend on those
/// before.
fn at(job: &Value, factor: f64) -> Option<Value> {
    let force = factor * last_force(job)?;
    let mut job = job.clone();
    if let Some(history) = job["load"]["history"].as_array_mut() {
        let last = history.last()?.clone();
        // The curve has a corner where a load returns to what it was.
        if history.iter().filter(|load| **load == last).count() > 1 {
            return None;
        }
        *history.last_mut()? = json!({"force": force});
    } else {
        job["load"] = json!({"force": force});
    }
    job["output"] =
        json!({"subsurface": false, "contact_stiffness": (factor - 1.0).abs() < f64::EPSILON});
    Some(job)
}

/// What is compared.
struct Compared {
    kind: String,
    stiffness: f64,
    bar: f64,
    /// Differences over ±1, ±3 and ±10 %.
    slopes: [f64; 3],
    codes: Vec<String>,
}

fn compare(job: &Value) -> Option<Compared> {
    let force = last_force(job)?;
    let solve = |factor: f64| {
        let job = Job::from_json(at(job, factor)?.to_string().as_bytes()).ok()?;
        let report = report::run(&job, &mut Unobserved)
            .ok()
            .filter(|r| r.status == SolveStatus::Converged)?;
        report.steps.into_iter().last()
    };
    let step = solve(1.0)?;
    let bar = step.bar(Name::ContactStiffness)?;
    let mut slopes = [0.0; 3];
    for (slope, by) in slopes.iter_mut().zip(STEPS) {
        *slope =
            2.0 * by * force / (solve(1.0 + by)?.approach()? - solve(1.0 - by)?.approach()?);
    }
    // A strain without a limit has no value.
    let strains = step.answers.iter().filter(|row| row.is(Name::MaxPlasticStrain));
    let plastic = strains.map(|row| row.value.unwrap_or(1.0)).fold(0.0, f64::max);
    let theory = if job["solver"]["theory"] == "flow" { "flow" } else { "deformation" };
    let analysis = job["analysis"].as_str().unwrap_or("plane_strain").replace('_', " ");
    let kind = if plastic > 0.0 { format!("{analysis}, {theory}") } else { "elastic".to_owned() };
    let codes = step.validity.iter().map(|note| note.code.clone()).collect();
    Some(Compared { kind, stiffness: step.value(Name::ContactStiffness)?, bar, slopes, codes })
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut found: BTreeMap<String, Vec<[f64; 2]>> = BTreeMap::new();
    let mut take = |job: &Value, is_verbose: bool, name: &str| -> bool {
        let Some(Compared { kind, stiffness, bar, slopes, codes }) = compare(job) else {
            return false;
        };
        let errors = slopes.map(|slope| stiffness / slope - 1.0);
        // Differences over less scatter with the approach, which depends on the mesh by a few
        // thousandths.
        let error = errors[2].abs();
        if is_verbose {
            let [one, three, ten] = errors.map(|error| 100.0 * error);
            let (told, bar) = (if error > bar { "MISSED" } else { "" }, 100.0 * bar);
            println!(
                "{name} {kind}: K {stiffness:.5e} {one:+.2} % {three:+.2} % {ten:+.2} %, bar \
                 {bar:.2} % {told} {codes:?}"
            );
            if error > 0.01 {
                println!("  {job}");
            }
        }
        found.entry(kind).or_default().push([error, bar / error.max(1e-12)]);
        true
    };
    let count: usize = arguments.first().map_or(Ok(80), |n| n.parse()).unwrap_or(0);
    let seed = arguments.get(1).and_then(|n| n.parse().ok()).unwrap_or(SEED);
    let mut random = Random(seed);
    let mut done = 0;
    while done < count {
        let mut job = random_job::job(&mut random, &MESHES);
        job["solver"].as_object_mut().map(|solver| {
            (solver.remove("coupling"), solver.remove("contact"), solver.remove("increments"))
        });
        let is_verbose = arguments.len() > 2;
        done += usize::from(take(&job, is_verbose, &format!("{done}")));
    }
    for name in arguments.iter().filter(|_| count == 0) {
        let job =
            std::fs::read_to_string(name).ok().and_then(|text| serde_json::from_str(&text).ok());
        if !job.is_some_and(|job| take(&job, true, name)) {
            println!("{name}: no answer");
        }
    }
    println!(
        "| jobs | count | within 1 % | within 3 % | worst | bars that hold | not 20 times too \
         wide |\n|---|---|---|---|---|---|---|"
    );
    for (kind, all) in found {
        let n = all.len() as f64;
        let share = |holds: &dyn Fn(&[f64; 2]) -> bool| {
            100.0 * all.iter().filter(|r| holds(r)).count() as f64 / n
        };
        println!(
            "| {kind} | {n} | {:.0} % | {:.0} % | {:.1} % | {:.0} % | {:.0} % |",
            share(&|[error, _]| *error <= 0.01),
            share(&|[error, _]| *error <= 0.03),
            100.0 * all.iter().map(|[error, _]| *error).fold(0.0, f64::max),
            share(&|[_, ratio]| *ratio >= 1.0),
            share(&|[_, ratio]| *ratio <= 20.0),
        );
    }
}
