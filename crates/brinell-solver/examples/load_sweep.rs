//! A steel cylinder pressed onto a steel block in ten steps, far beyond yield: the load–approach
//! curve, with Hertz beside it. `cargo run --release -p brinell-solver --example load_sweep`

use std::error::Error;
use std::io::{Write, stderr};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::report::Name;
use brinell_solver::solver::{Interrupt, IterationRecord, Observer};
use serde_json::json;

/// Keeps the time, tells of each iteration, and stops a solve that takes a minute.
struct Watch {
    started: Instant,
}

impl Observer for Watch {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        let line = format!(
            "iteration {}, residual {:.1e}",
            record.iteration, record.equilibrium_residual
        );
        // Progress that cannot be shown is no reason to stop.
        let _ = writeln!(stderr(), "{line}");
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if self.elapsed() > Duration::from_mins(1) {
            ControlFlow::Break(Interrupt::TimedOut)
        } else {
            ControlFlow::Continue(())
        }
    }

    fn elapsed(&self) -> Duration {
        self.started.elapsed()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let steel = json!({
        "young_modulus": 210_000.0,
        "poisson_ratio": 0.3,
        "plasticity": {"law": "swift", "yield_stress": 500.0, "strain_offset": 0.002, "exponent": 0.15},
    });
    let job = Job::from_value(&json!({
        "analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": 20.0}, "material": steel},
        "lower": {"shape": {"type": "block", "width": 80.0, "depth": 40.0}, "material": steel},
        "load": {"forces": (1..=10).map(|k| 200.0 * f64::from(k)).collect::<Vec<_>>()},
        "output": {"subsurface": false},
    }))?;
    let report = report::run(&job, &mut Watch { started: Instant::now() })?;

    println!(
        "{:>8} {:>10} {:>10} {:>10} {:>12} {:>10}",
        "P", "approach", "peak", "Hertz", "zone", "status"
    );
    println!("{:>8} {:>10} {:>10} {:>10} {:>12}", "N/mm", "mm", "MPa", "MPa", "mm²");
    for step in &report.steps {
        let zones = step.answers.iter().filter(|row| row.is(Name::PlasticArea));
        let area: f64 = zones.filter_map(|row| row.value).sum();
        let hertz = step.elastic(Name::PeakPressure).unwrap_or(f64::NAN);
        println!(
            "{:8.0} {:10.5} {:10.1} {:10.1} {:12.5} {:>10?}",
            step[Name::Force],
            step.approach().unwrap_or_default(),
            step[Name::PeakPressure],
            hertz,
            area,
            step.status
        );
    }
    Ok(())
}
