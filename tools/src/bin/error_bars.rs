//! Counts how often the error bars hold, over random jobs of ordinary shapes, each against the
//! same job on a mesh four times as dense.
//!
//! `cargo run --release -p brinell-tools --bin error_bars -- 100 20261125 deformation` counts 100
//! jobs from the seed 20261125 under the theory `deformation`; `flow` counts those under flow
//! theory. Steps in which nothing yields are apart. Jobs are solved within a minute on each mesh.
//! With a fourth argument of any kind every figure is written as a line of JSON, for floors to be
//! fitted to.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use brinell_solver::job::Job;
use brinell_solver::report::{BodyErrors, PerBody, estimate_error};
use brinell_solver::solver::{self, Figures, Interrupt, Observer, SolveStatus, StepSolution};
use random_job::Random;
use serde_json::{Value, json};

/// Elements over the half-width of the jobs; those of the reference are so many times as many.
const MESHES: [u32; 4] = [6, 8, 10, 12];
const FINER: u64 = 4;
/// Most elements of a history.
const MOST_OF_FLOW: u64 = 8;
/// Seconds that a job may take.
const PATIENCE: u64 = 60;
/// Radius of a hole, beyond which it is free, over that of its pin.
const HOLE: f64 = 4.0;

/// Figures in the order of `Figures`, those of a body once.
const CONTACT: [&str; 4] = ["peak pressure", "half-width", "approach", "force"];
const BODY: [&str; 7] = [
    "largest plastic strain",
    "mean plastic strain",
    "plastic area",
    "dent",
    "pile-up",
    "residual stress",
    "utilization",
];

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

fn solve(job: &Job) -> Option<Vec<StepSolution>> {
    let solution = solver::run(job, &mut Patience(Instant::now())).ok()?;
    let is_solved = solution.interrupted.is_none()
        && solution.steps.iter().all(|step| step.status == SolveStatus::Converged);
    is_solved.then_some(solution.steps)
}

/// The next job of ordinary shapes under a theory.
fn next(random: &mut Random, theory: &str) -> Value {
    loop {
        let mut job = random_job::job(random, &MESHES);
        let is_flow = job["solver"]["theory"] == "flow";
        let shapes = [&job["upper"]["shape"]["type"], &job["lower"]["shape"]["type"]];
        let is_exotic =
            |shape: &&Value| ["wedge", "cone", "punch", "power"].iter().any(|name| *shape == name);
        if is_flow != (theory == "flow") || shapes.iter().any(is_exotic) {
            continue;
        }
        let is_pin_in_groove =
            job["analysis"] != "axisymmetric" && shapes == ["cylinder", "groove"];
        if is_pin_in_groove {
            let radius = job["lower"]["shape"]["radius"].as_f64().unwrap_or(1.0);
            job["lower"]["shape"] =
                json!({"type": "hole", "radius": radius, "outer_radius": HOLE * radius});
        }
        job["solver"]
            .as_object_mut()
            .map(|solver| (solver.remove("coupling"), solver.remove("contact")));
        let elements = job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10);
        job["mesh"]["elements_per_half_width"] =
            json!(if is_flow { elements.min(MOST_OF_FLOW) } else { elements });
        return job;
    }
}

/// The bars of all figures in the order of `Figures`, if there are any.
fn bars(job: &Job, step: &StepSolution) -> [Option<f64>; Figures::COUNT] {
    let Some(errors) = estimate_error(job, step) else { return [None; Figures::COUNT] };
    let of_body = |body: Option<BodyErrors>| {
        body.map_or([None; 7], |body| {
            let [largest, mean] =
                [body.max_equivalent_plastic_strain, body.mean_equivalent_plastic_strain];
            [
                largest,
                mean,
                body.area,
                body.depth,
                body.pile_up,
                body.least_stress,
                body.utilization,
            ]
        })
    };
    let PerBody { upper, lower } = errors.bodies.unwrap_or(PerBody { upper: None, lower: None });
    let contact = [errors.peak_pressure, errors.half_width, errors.approach, errors.force];
    let all: Vec<_> = contact.into_iter().chain(of_body(upper)).chain(of_body(lower)).collect();
    std::array::from_fn(|k| all[k])
}

fn yields(step: &StepSolution) -> bool {
    step.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0)
}

/// What is counted of one figure under one theory.
#[derive(Default)]
struct Counted {
    /// Bars beside errors.
    bars: Vec<[f64; 2]>,
    without: usize,
}

impl Counted {
    fn row(&self) -> String {
        let median = |of: fn(&[f64; 2]) -> f64| {
            let mut values: Vec<f64> = self.bars.iter().map(of).collect();
            values.sort_by(f64::total_cmp);
            values.get(values.len() / 2).copied().unwrap_or(0.0)
        };
        let held = self.bars.iter().filter(|[bar, error]| bar >= error).count();
        format!(
            "{:.0} % of {} | {:.1} % | {:.1} | {}",
            100.0 * held as f64 / self.bars.len().max(1) as f64,
            self.bars.len(),
            100.0 * median(|[bar, _]| *bar),
            median(|[bar, error]| bar / error),
            self.without
        )
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count: usize = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(100);
    let seed = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(20_261_125);
    let theory = arguments.next().unwrap_or_else(|| "deformation".to_owned());
    let is_verbose = arguments.next().is_some();
    let mut random = Random(seed);
    let mut counted: BTreeMap<(usize, bool), Counted> = BTreeMap::new();
    let (mut solved, mut steps) = (0, 0);
    for number in 0..count {
        eprint!("\r{number} of {count} jobs");
        let job = next(&mut random, &theory);
        let mut finer = job.clone();
        finer["mesh"]["elements_per_half_width"] =
            json!(FINER * job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10));
        let parse = |job: &Value| Job::from_json(job.to_string().as_bytes()).ok();
        let (Some(parsed), Some(parsed_finer)) = (parse(&job), parse(&finer)) else { continue };
        let Some((found, exact)) =
            solve(&parsed).and_then(|found| Some((found, solve(&parsed_finer)?)))
        else {
            continue;
        };
        solved += 1;
        let mut unknown_peaks_before = 0;
        for (mut step, exact) in found.into_iter().zip(&exact) {
            steps += 1;
            step.unknown_peaks_before = unknown_peaks_before;
            let bars = bars(&parsed, &step);
            unknown_peaks_before += usize::from(!step.increments.is_empty() && bars[0].is_none());
            let [found, exact] = [&step, exact].map(|step| step.figures().values());
            // Bodies alike are counted once.
            let is_shared = found[CONTACT.len()..CONTACT.len() + BODY.len()]
                == found[CONTACT.len() + BODY.len()..];
            let figures = CONTACT.len() + if is_shared { 1 } else { 2 } * BODY.len();
            for k in (0..figures)
                .filter(|k| exact[*k] != 0.0 && found[*k] != 0.0 && bars[*k] != Some(0.0))
            {
                let figure = if k < CONTACT.len() + BODY.len() { k } else { k - BODY.len() };
                let error = (exact[k] / found[k] - 1.0).abs().max(1e-12);
                let of_figure = counted.entry((figure, yields(&step))).or_default();
                match bars[k] {
                    Some(bar) => of_figure.bars.push([bar, error]),
                    None => of_figure.without += 1,
                }
                if is_verbose {
                    let coarse = step.coarse.map(|coarse| coarse.values()[k]);
                    let size = step.spacing / step.half_width().max(f64::MIN_POSITIVE);
                    println!(
                        "{}",
                        json!({"figure": CONTACT.iter().chain(&BODY).nth(figure), "bar": bars[k],
                            "error": error,
                            "found": found[k], "coarse": coarse, "exact": exact[k], "size": size,
                            "job": job})
                    );
                }
            }
        }
    }
    println!("\n{solved} of {count} jobs have two answers, with {steps} steps\n");
    println!(
        "| figure | | hold | median bar | over the error | without a bar \
         |\n|---|---|---|---|---|---|"
    );
    for ((figure, yields), of_figure) in counted {
        let name = CONTACT.iter().chain(&BODY).nth(figure).copied().unwrap_or_default();
        let kind = if yields { theory.as_str() } else { "nothing yields" };
        println!("| {name} | {kind} | {} |", of_figure.row());
    }
}
