//! Does every law, shape pairing, analysis and coupling converge? Prints a table of outcomes in Markdown.
//!
//! `cargo run --release --example outcomes`; a contact whose elastic peak pressure is 3, 4 and 5 yield stresses, ten
//! elements over the half-width, tolerance 1e-6. A number is the count of iterations, a word why there is no answer.

#![expect(clippy::print_stdout, reason = "printing is what it is for")]

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_solver::job::Job;
use brinell_solver::solver::{Interrupt, Observer, SolveStatus, run};
use serde_json::Value;

#[path = "../tests/support/contacts.rs"]
mod contacts;

use contacts::{ANALYSES, job, laws, pairs, surfaces};

const COUPLINGS: [&str; 4] = ["accelerated", "strong", "weak", "secant_stiffness"];

/// Ends a combination that takes longer than this.
const PATIENCE: Duration = Duration::from_secs(3);

struct Patience(Instant);

impl Observer for Patience {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.0.elapsed() > PATIENCE {
            return ControlFlow::Break(Interrupt::TimedOut);
        }
        ControlFlow::Continue(())
    }
}

fn outcome(job: &Value) -> String {
    let job = match Job::from_value(job) {
        Ok(job) => job,
        Err(error) => return format!("**{error:?}**"),
    };
    match run(&job, &mut Patience(Instant::now())) {
        Ok(solution) => match solution.steps.first() {
            Some(step) => match step.status {
                SolveStatus::Converged => step.history.len().to_string(),
                SolveStatus::TimedOut => format!("**over {} s**", PATIENCE.as_secs()),
                _ => format!("**no: {:.0e}**", step.equilibrium_residual),
            },
            None => "**no step**".to_owned(),
        },
        Err(error) => format!("**{}**", error.to_string().replace("**", "")),
    }
}

fn by_law() {
    let [cylinder, ..] = surfaces();
    println!("| analysis | law | p0/σ_y | {} |\n|---|---|---|---|---|---|---|", COUPLINGS.join(" | "));
    for analysis in ANALYSES {
        for (name, law) in &laws() {
            for ratio in [3.0, 4.0, 5.0] {
                let row = COUPLINGS
                    .map(|coupling| outcome(&job(analysis, coupling, law, [&cylinder, &cylinder], ratio)));
                println!("| {analysis} | {name} | {ratio} | {} |", row.join(" | "));
            }
        }
    }
}

fn by_shape() {
    let (law, surfaces) = (&laws()[0].1, surfaces());
    println!("\n| upper | lower | p0/σ_y | {} |\n|---|---|---|---|---|---|", ANALYSES.join(" | "));
    for pair in pairs(&surfaces) {
        for ratio in [3.0, 4.0, 5.0] {
            let row = ANALYSES.map(|analysis| outcome(&job(analysis, "accelerated", law, pair, ratio)));
            println!("| {} | {} | {ratio} | {} |", pair[0].name, pair[1].name, row.join(" | "));
        }
    }
}

fn main() {
    by_law();
    by_shape();
}
