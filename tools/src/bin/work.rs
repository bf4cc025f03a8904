//! Compares the work of random jobs with other jobs of their size.
//!
//! `cargo run --release -p brinell-tools --bin work -- 300` solves 300 jobs and prints those that
//! took more than 20 times the median of theirs, with the remarks that say why; a second argument
//! is the seed.

#![expect(clippy::print_stdout, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::time::Instant;

use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::solver::Unobserved;
use random_job::Random;

const MESHES: [u32; 2] = [5, 8];

/// What a job took.
struct Taken {
    /// Seconds for each thousand equations of each load.
    time: f64,
    seconds: f64,
    /// Iterations, evaluations of the law and factorizations for each load, on the finest mesh.
    counts: [usize; 3],
    codes: Vec<String>,
    job: String,
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(300);
    let seed = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1);
    let mut random = Random(seed);
    let mut all = Vec::new();
    while all.len() < count.max(1) {
        let value = random_job::job(&mut random, &MESHES);
        let Ok(job) = Job::from_value(&value) else { continue };
        let start = Instant::now();
        let Ok(report) = report::run(&job, &mut Unobserved) else { continue };
        let seconds = start.elapsed().as_secs_f64();
        let steps = report.steps.len().max(1);
        let records = || report.steps.iter().flat_map(|step| &step.history);
        let counts = [
            records().count(),
            records().map(|record| record.initial_stress_updates).sum(),
            records().map(|record| record.factorizations).sum(),
        ];
        let codes =
            report.steps.iter().flat_map(|step| &step.validity).map(|note| note.code.clone());
        let mut codes: Vec<String> = codes.collect();
        codes.sort();
        codes.dedup();
        let equations = report.mesh.equations.max(1);
        let time = seconds / steps as f64 / equations as f64 * 1e3;
        all.push(Taken {
            time,
            seconds,
            counts: counts.map(|n| n.div_ceil(steps)),
            codes,
            job: value.to_string(),
        });
    }
    all.sort_by(|a, b| a.time.total_cmp(&b.time));
    let median = all[all.len() / 2].time;
    println!("median {median:.2e} s per thousand equations and load, {} jobs", all.len());
    for Taken { time, seconds, counts, codes, job } in all.iter().rev().take(40) {
        let [iterations, updates, factorizations] = counts;
        println!(
            "{:6.1} times: {seconds:6.2} s, {iterations} iterations, {updates} updates, \
             {factorizations} factorizations {codes:?}",
            time / median
        );
        if *time > 20.0 * median {
            println!("    {job}");
        }
    }
}
