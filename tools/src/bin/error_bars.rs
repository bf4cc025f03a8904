//! Writes the figures of random jobs beside those of meshes of half and of four times the density, one step a line.
//!
//! `cargo run --release -p brinell-tools --bin error_bars -- 100 20261125 deformation`

#![recursion_limit = "256"]
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_solver::job::Job;
use brinell_solver::solver::{
    self, Interrupt, Observer, SolveStatus, StepSolution,
};
use random_job::Random;
use serde_json::{Value, json};

/// Elements over the half-width of the jobs; those of the reference are so many times as many.
const MESHES: [u32; 4] = [6, 8, 10, 12];
const FINER: u64 = 4;
/// Most elements of a history.
const MOST_OF_FLOW: u64 = 8;
/// Seconds that a job may take.
const PATIENCE: u64 = 25;

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

fn solve(job: &Value) -> Option<Vec<StepSolution>> {
    let job = Job::from_json(job.to_string().as_bytes()).ok()?;
    let solution = solver::run(&job, &mut Patience(Instant::now())).ok()?;
    let is_solved = solution.interrupted.is_none()
        && solution.steps.iter().all(|step| step.status == SolveStatus::Converged);
    is_solved.then_some(solution.steps)
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(150);
    let seed = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(1);
    let theory = arguments.next().unwrap_or_else(|| "all".to_owned());
    let mut random = Random(seed);
    let (mut jobs, mut unsolved) = (0, 0);
    let start = Instant::now();
    while jobs < count {
        let mut job = random_job::job(&mut random, &MESHES);
        job["solver"].as_object_mut().map(|solver| (solver.remove("coupling"), solver.remove("contact")));
        let is_flow = job["solver"]["theory"] == "flow";
        if theory != "all" && is_flow != (theory == "flow") {
            continue;
        }
        jobs += 1;
        // Grooves become holes now and then.
        if job["upper"]["shape"]["type"] == "cylinder" && job["lower"]["shape"]["type"] == "groove" && jobs % 2 == 0 && job["analysis"] != "axisymmetric" {
            let radius = job["lower"]["shape"]["radius"].as_f64().unwrap_or(1.0);
            job["lower"]["shape"] = json!({"type": "hole", "radius": radius, "outer_radius": 4.0 * radius});
        }
        let elements = job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10);
        let elements = if is_flow { elements.min(MOST_OF_FLOW) } else { elements };
        job["mesh"]["elements_per_half_width"] = json!(elements);
        let mut finer = job.clone();
        finer["mesh"]["elements_per_half_width"] = json!(elements * FINER);
        let Some((found, exact)) = solve(&job).and_then(|found| Some((found, solve(&finer)?))) else {
            unsolved += 1;
            continue;
        };
        eprint!("\r{jobs} jobs, {unsolved} unsolved, {:.0} s", start.elapsed().as_secs_f64());
        let Ok(parsed) = Job::from_json(job.to_string().as_bytes()) else { continue };
        for (k, (step, exact)) in found.iter().zip(&exact).enumerate() {
            let flows = step.bodies.iter().flatten().any(|body| {
                let q = body.stress.points.iter().flatten().map(|p| p.largest_von_mises).fold(0.0, f64::max);
                body.max_plastic_strain() > q / (3.0 * body.model.elastic().shear)
            });
            let yields = step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0);
            let vm = step.bodies.each_ref().map(|body| body.as_ref().map_or(0.0, |body| body.stress.points.iter().flatten().map(|p| p.largest_von_mises).fold(0.0, f64::max)));
            let unbounded = step.bodies.each_ref().map(|body| body.as_ref().is_some_and(|body| {
                let strain = body.max_plastic_strain();
                strain > 0.0 && body.model.hardening().is_some_and(|law| law.slope(strain) <= 0.0)
            }));
            println!("{}", json!({
                "seed": seed, "number": jobs, "step": k, "flow": is_flow, "analysis": job["analysis"],
                "upper": job["upper"]["shape"]["type"], "lower": job["lower"]["shape"]["type"],
                "exponent": [&job["upper"]["shape"]["exponent"], &job["lower"]["shape"]["exponent"]],
                "prescribed": match step.load { brinell_solver::contact::ContactLoad::Force(_) => "force", brinell_solver::contact::ContactLoad::Approach(_) => "approach" },
                "onset": job["load"]["onset"], "onset_error": step.onset_error,
                "spacing": step.spacing, "reached": step.reached, "reached_exact": exact.reached, "touches": step.patch.is_some(),
                "corners": step.loaded_corners.len(), "edge": step.rounded_edge.is_some(), "tip": step.rounded_tip.is_some(), "collapsed": step.has_collapsed,
                "corners_exact": exact.loaded_corners.len(), "edge_exact": exact.rounded_edge.is_some(), "tip_exact": exact.rounded_tip.is_some(),
                "parts": step.parts.iter().map(|p| [p.left, p.right]).collect::<Vec<_>>(), "peak_position": step.peak_position, "middle": step.middle, "symmetric": step.symmetric,
                "unresolved": step.unresolved, "conforming": step.conforming.is_some(), "mean": step.mean_pressure(), "vm": vm, "shear": step.bodies.each_ref().map(|body| body.as_ref().map_or(1.0, |body| body.model.elastic().shear)), "bars": brinell_solver::report::estimate_error(&parsed, step), "unbounded": unbounded,
                "yields": yields, "flows": flows, "stiffness": [step.contact_stiffness, exact.contact_stiffness],
                "depth": step.bodies.each_ref().map(|body| body.as_ref().map_or(0.0, |body| body.depth())),
                "found": step.figures().values(), "coarse": step.coarse.map(|c| c.values()),
                "increments": step.increment_error.map(|c| c.values()), "exact": exact.figures().values(),
                "job": job,
            }));
        }
    }
    eprintln!();
}
