//! Prints the reports of seeded random jobs, one line of JSON for each, without times, to compare
//! the answers of two versions of the solver.
//!
//! `cargo run --release -p brinell-tools --bin answers 200 > before.jsonl`. A second word chooses
//! other jobs: `three_dimensional` contacts of half-spaces, `hardness` hardness tests, `rolling`,
//! `rolling_near_traction` and `rolling_balls` loads that roll, with the seconds of each, `find`
//! inputs that are sought for a figure that one hidden input has. With names of files of jobs instead of the count those are solved, and the seconds of each are told. With
//! `--jobs` last it prints the jobs.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

use std::time::Instant;

use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::solver::Unobserved;
use serde_json::{Value, json};

#[path = "answers/find.rs"]
mod find;
#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

/// Elements over the half-width.
const ELEMENTS: [u32; 4] = [4, 6, 8, 12];
/// Members that differ from run to run.
const TIMES: [&str; 2] = ["timings_ms", "elapsed_ms"];

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let count = arguments.first().map_or(Ok(200), |first| first.parse());
    if count.is_err() {
        for file in &arguments {
            let start = Instant::now();
            println!("{}", answer(&std::fs::read(file)?));
            eprintln!("{:7.2} s  {file}", start.elapsed().as_secs_f64());
        }
        return Ok(());
    }
    let has = |name: &str| arguments.iter().any(|argument| argument == name);
    if has("find") {
        find::searches(count.unwrap_or_default(), |seed| {
            let random = &mut random_job::Random(seed);
            let job = if random.happens(0.3) {
                random_job::in_three_dimensions(random)
            } else {
                random_job::in_millimetres(random, &ELEMENTS)
            };
            let choices = [(); 2].map(|()| random.count(1 << 32));
            (job, choices, random.between(0.0, 1.0))
        });
        return Ok(());
    }
    let in_three = has("three_dimensional");
    let rolls = [
        ("rolling", random_job::Rolls::Lines),
        ("rolling_near_traction", random_job::Rolls::NearTraction),
        ("rolling_balls", random_job::Rolls::Balls),
    ];
    let rolls = rolls.into_iter().find(|(name, _)| has(name)).map(|(_, rolls)| rolls);
    let prints_jobs = arguments.last().is_some_and(|argument| argument == "--jobs");
    for seed in 0..count.unwrap_or_default() {
        let random = &mut random_job::Random(seed);
        let job = if let Some(rolls) = rolls {
            random_job::rolling(random, rolls)
        } else if has("hardness") {
            random_job::hardness(random)
        } else if in_three {
            random_job::in_three_dimensions(random)
        } else {
            random_job::job(random, &ELEMENTS)
        };
        let text = job.to_string();
        let start = Instant::now();
        println!("{}", if prints_jobs { job } else { answer(text.as_bytes()) });
        if rolls.is_some() && !prints_jobs {
            eprintln!("{:7.2} s  seed {seed}", start.elapsed().as_secs_f64());
        }
    }
    Ok(())
}

fn answer(text: &[u8]) -> Value {
    let job = match Job::from_json(text) {
        Ok(job) => job,
        Err(errors) => return json!({"refused": format!("{errors:?}")}),
    };
    match report::run(&job, &mut Unobserved) {
        Ok(report) => {
            let mut report = serde_json::to_value(&report).unwrap_or_default();
            strip_times(&mut report);
            report
        }
        Err(error) => json!({"failed": error.to_string()}),
    }
}

fn strip_times(value: &mut Value) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(strip_times),
        Value::Object(members) => {
            members.retain(|name, _| !TIMES.contains(&name.as_str()));
            members.values_mut().for_each(strip_times);
        }
        _ => {}
    }
}
