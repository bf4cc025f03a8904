//! Measures how long a job continues after a request to stop: the longest times between two calls
//! of its observer.
//!
//! usage: `cargo run --release -p brinell-tools --bin checkpoints -- ELEMENTS [COUPLING]`,
//! elements over the half-width of the reference problem with two different bodies and all output,
//! 140 for about a million equations. Prints the longest times, in order, where they ended, and
//! how they divide into pieces of work that are timed; then stops the job at moments spread over
//! its course and prints how long each took to end. All times are processor times of the solving
//! thread (Linux), which other work on the machine does not lengthen.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::time::Duration;

use brinell_solver::job::{Job, JobError};
use brinell_solver::report;
use brinell_solver::solver::{Interrupt, IterationRecord, Observer};
use serde_json::{Value, json};

/// Jobs stopped.
const STOPS: u32 = 12;

/// Records the times of its calls; stops the job after a given time.
struct Watch {
    stop_at: Duration,
    asked: Vec<Duration>,
    timed: RefCell<Vec<Duration>>,
}

impl Watch {
    fn start(stop_at: Duration) -> Self {
        Self { stop_at, asked: vec![spent()], timed: RefCell::default() }
    }
}

impl Observer for Watch {
    fn on_iteration(&mut self, _: &IterationRecord) -> ControlFlow<Interrupt> {
        self.on_checkpoint()
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        let now = spent();
        self.asked.push(now);
        if now >= self.stop_at {
            ControlFlow::Break(Interrupt::Cancelled)
        } else {
            ControlFlow::Continue(())
        }
    }

    fn elapsed(&self) -> Duration {
        let now = spent();
        self.timed.borrow_mut().push(now);
        now
    }
}

/// Processor time of this thread.
fn spent() -> Duration {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    Duration::from_nanos(
        text.split(' ').next().and_then(|nanoseconds| nanoseconds.parse().ok()).unwrap_or(0),
    )
}

fn job(elements: u32, coupling: &str) -> Result<Job, JobError> {
    let mut job: Value =
        serde_json::from_str(include_str!("../../../api/examples/two_cylinders.json"))
            .unwrap_or_default();
    job["mesh"] = json!({"elements_per_half_width": elements});
    job["solver"] = json!({"theory": "deformation", "coupling": coupling});
    job["output"] = json!({"fields": true, "subsurface": true});
    job["lower"]["material"]["plasticity"]["yield_stress"] = json!(501.0);
    Job::from_json(job.to_string().as_bytes())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let elements = std::env::args().nth(1).ok_or("how many elements?")?.parse()?;
    let job = job(elements, &std::env::args().nth(2).unwrap_or_else(|| "accelerated".to_owned()))?;
    let mut watch = Watch::start(Duration::MAX);
    let report = report::run(&job, &mut watch)?;
    watch.asked.push(spent());
    let (begin, end) = (watch.asked[0], watch.asked[watch.asked.len() - 1]);
    let whole = end.saturating_sub(begin);
    println!(
        "{} equations, {:.2} s, asked {} times",
        report.mesh.equations,
        whole.as_secs_f64(),
        watch.asked.len() - 2
    );
    let mut gaps: Vec<(Duration, Duration)> = watch
        .asked
        .windows(2)
        .map(|pair| (pair[1].saturating_sub(pair[0]), pair[1].saturating_sub(begin)))
        .collect();
    gaps.sort();
    for (gap, end) in gaps.iter().rev().take(8) {
        let (from, to) = (begin + end.saturating_sub(*gap), begin + *end);
        let mut within = vec![from];
        within.extend(watch.timed.borrow().iter().filter(|time| **time > from && **time < to));
        within.push(to);
        let parts = within
            .windows(2)
            .map(|pair| format!("{:.0}", 1e3 * pair[1].saturating_sub(pair[0]).as_secs_f64()));
        let parts = parts.filter(|part| part != "0").collect::<Vec<_>>().join(" + ");
        println!(
            "  {:7.1} ms until {:6.2} s: {parts}",
            1e3 * gap.as_secs_f64(),
            end.as_secs_f64()
        );
    }
    for k in 1..=STOPS {
        let wait = whole * k / (STOPS + 1);
        let stop_at = spent() + wait;
        let mut watch = Watch::start(stop_at);
        let ended = report::run(&job, &mut watch).map(|report| report.status);
        let late = spent().saturating_sub(stop_at);
        println!(
            "told at {:6.2} s: ended {:7.1} ms later, {ended:?}",
            wait.as_secs_f64(),
            1e3 * late.as_secs_f64()
        );
    }
    Ok(())
}
