//! Does every law, shape pairing, analysis and coupling converge? Prints a table of outcomes in
//! Markdown.
//!
//! `cargo run --release -p brinell-tools --bin outcomes`; a contact whose elastic peak pressure is
//! 3, 4 and 5 yield stresses, ten elements over the half-width, tolerance 1e-6. A number is the
//! count of iterations, a word why there is no answer. `cargo run --release -p brinell-tools --bin
//! outcomes flow` prints what flow theory makes of the same cylinders and spheres, up to the force
//! and back to none, beside deformation theory.

#![expect(clippy::print_stdout, reason = "printing is what it is for")]

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_solver::inputs::run;
use brinell_solver::job::Job;
use brinell_solver::report::{self, Name, Side, StepReport};
use brinell_solver::solver::{Interrupt, Observer, SolveStatus};
use serde_json::{Value, json};

#[path = "../../../crates/brinell-solver/tests/support/contacts.rs"]
mod contacts;

use contacts::{ANALYSES, job, laws, pairs, surfaces};

const COUPLINGS: [&str; 4] = ["accelerated", "strong", "weak", "secant_stiffness"];

/// Ends a combination that takes longer than this.
const PATIENCE: Duration = Duration::from_secs(3);

/// When it began, and for how long it may go on.
struct Patience(Instant, Duration);

impl Observer for Patience {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.0.elapsed() > self.1 {
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
    match run(&job, &mut Patience(Instant::now(), PATIENCE)) {
        Ok(solution) => match solution.steps.first() {
            Some(step) => match step.status {
                SolveStatus::Converged => step.history.len().to_string(),
                SolveStatus::TimedOut => format!("**over {} s**", PATIENCE.as_secs()),
                _ => format!("**no: {:.0e}**", step.checks.residual),
            },
            None => "**no step**".to_owned(),
        },
        Err(error) => format!("**{}**", error.to_string().replace("**", "")),
    }
}

fn by_law() {
    let [cylinder, ..] = surfaces();
    println!(
        "| analysis | law | p0/σ_y | {} |\n|---|---|---|---|---|---|---|",
        COUPLINGS.join(" | ")
    );
    for analysis in ANALYSES {
        for (name, law) in &laws() {
            for ratio in [3.0, 4.0, 5.0] {
                let row = COUPLINGS.map(|coupling| {
                    outcome(&job(analysis, coupling, law, [&cylinder, &cylinder], ratio))
                });
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
            let row =
                ANALYSES.map(|analysis| outcome(&job(analysis, "accelerated", law, pair, ratio)));
            println!("| {} | {} | {ratio} | {} |", pair[0].name, pair[1].name, row.join(" | "));
        }
    }
}

/// Up to the force and back to none by flow theory: increments and iterations, by how much
/// deformation theory differs, and what is left of the approach.
fn flow() {
    let [cylinder, ..] = surfaces();
    println!(
        "| analysis | law | p0/σ_y | increments | iterations up | back | peak of deformation \
         theory | its approach \
         | approach left | largest plastic strain | reverse yield \
         |\n|---|---|---|---|---|---|---|---|---|---|---|"
    );
    for analysis in ANALYSES {
        for (name, law) in &laws() {
            for ratio in [3.0, 4.0, 5.0] {
                let asked = job(analysis, "accelerated", law, [&cylinder, &cylinder], ratio);
                println!("| {analysis} | {name} | {ratio} | {} |", up_and_back(&asked));
            }
        }
    }
}

fn up_and_back(asked: &Value) -> String {
    let mut asked = asked.clone();
    asked["solver"]["theory"] = json!("deformation");
    let asked = &asked;
    let mut history = asked.clone();
    let force = asked["load"]["force"].clone();
    history["load"] = json!({"history": [{"force": force}, {"force": 0}]});
    history["solver"]["theory"] = json!("flow");
    let solved = |job: &Value| {
        let job = Job::from_value(job).map_err(|error| format!("{error:?}"))?;
        report::run(&job, &mut Patience(Instant::now(), 10 * PATIENCE))
            .map_err(|error| error.to_string())
    };
    let (flow, deformation) = match (solved(&history), solved(asked)) {
        (Ok(flow), Ok(deformation)) => (flow, deformation),
        (Err(error), _) | (_, Err(error)) => return format!("**{error}**"),
    };
    let ([up, back], [other]) = (flow.steps.as_slice(), deformation.steps.as_slice()) else {
        return "**no step**".to_owned();
    };
    if flow.status != SolveStatus::Converged {
        return format!("**{:?}, {:?}**", up.status, back.status);
    }
    let increments = up.increments.as_ref().map_or(0, |ends| ends.force.len());
    let reversed = back.of_body(Name::ReversePlasticStrain, Side::Upper);
    let strain = up.body(Name::MeanPlasticStrain, Side::Upper).unwrap_or(0.0);
    let approach = |step: &StepReport| step.approach().unwrap_or(f64::NAN);
    let differs = |a: f64, b: f64| 100.0 * (a / b - 1.0);
    format!(
        "{increments} | {} | {} | {:+.1} % | {:+.1} % | {:.1} % | {:.2} % | {}",
        up.history.len(),
        back.history.len(),
        differs(other[Name::PeakPressure], up[Name::PeakPressure]),
        differs(approach(other), approach(up)),
        100.0 * approach(back) / approach(up),
        100.0 * strain,
        if reversed.is_some() { "yes" } else { "no" },
    )
}

fn main() {
    if std::env::args().nth(1).is_some_and(|which| which == "flow") {
        flow();
        return;
    }
    by_law();
    by_shape();
}
