//! Counts how often the error bars of random jobs hold.
//!
//! `cargo run --release -p brinell-tools --bin error_bars -- count` solves a set of random jobs, each
//! beside itself on a finer mesh, and prints how many bars hold by figure and analysis, ordinary jobs
//! apart from odd ones; bars that do not hold are listed with their job. `count 2` takes the first two
//! parts of each kind; it fails where fewer than 93 of 100 hold. `count 2 Fit` counts the set on which
//! the bounds (`brinell-method/src/bounds.rs`) were chosen. A part that has been solved is kept under
//! `target/error_bars`, in a folder of the program that solved it: a run that is stopped goes on where
//! it was. `error_bars -- job Judge Flow 0 2` prints the job of that part and number. Jobs are given up
//! after a minute of the processor on each mesh.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use brinell_solver::inputs;
use brinell_solver::job::{Job, Load};
use brinell_solver::report::{estimate_error, name_of, unknown_figures};
use brinell_solver::solver::{
    Figure, FigureSet, Interrupt, Observer, SolveStatus, Values, half_spaces,
};
use random_job::Random;
use rustix::time::{ClockId, clock_gettime};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Jobs of a part, and parts of a set by kind.
const JOBS: usize = 10;
const PARTS: [(Kind, usize); 4] =
    [(Kind::Ordinary, 16), (Kind::Deformation, 16), (Kind::Flow, 16), (Kind::HalfSpaces, 14)];
/// Elements over the half-width of the jobs in two dimensions; those of the reference are so many
/// times as many.
const MESHES: [u32; 4] = [6, 8, 10, 12];
const FINER: u64 = 4;
/// Most elements of a history.
const MOST_OF_FLOW: u64 = 8;
/// Cells over a semi-axis of the jobs in three dimensions; those of the reference are so many
/// times as many.
const CELLS: [u64; 4] = [4, 5, 6, 8];
const FINER_CELLS: u64 = 3;
/// Processor time that a job may take on a mesh.
const PATIENCE: Duration = Duration::from_mins(1);
/// Radius of a hole, beyond which it is free, over that of its pin.
const HOLE: f64 = 4.0;

/// Part of the bars of a count that has to hold: thirty jobs tell 95 % to within 2 %.
const HOLDS: f64 = 0.93;

type Fault = Box<dyn Error + Send + Sync>;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    /// One smooth summit on 10 or 20 elements, by either theory.
    Ordinary,
    Deformation,
    Flow,
    HalfSpaces,
}

/// One of the sets: bounds are chosen by the first and judged by the second.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Set {
    Fit,
    Judge,
}

/// Some jobs of a set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Part {
    set: Set,
    kind: Kind,
    number: usize,
}

/// A figure of a step beside the same figure on a finer mesh.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Sample {
    figure: String,
    analysis: String,
    theory: String,
    load: String,
    /// The relative bar.
    bar: Option<f64>,
    error: f64,
    /// Which job of which part.
    place: String,
}

impl Sample {
    fn is_ordinary(&self) -> bool {
        self.place.contains("Ordinary")
    }

    fn holds(&self) -> bool {
        self.bar.is_none_or(|bar| bar >= self.error)
    }
}

/// Ends a job that takes too long. The time is of the processor: a busy machine gives up no more
/// jobs than an idle one.
struct Patience(Duration);

impl Patience {
    fn new() -> Self {
        Self(time_of_thread())
    }
}

fn time_of_thread() -> Duration {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), u32::try_from(time.tv_nsec).unwrap_or_default())
}

impl Observer for Patience {
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        if time_of_thread().saturating_sub(self.0) > PATIENCE {
            return ControlFlow::Break(Interrupt::TimedOut);
        }
        ControlFlow::Continue(())
    }
}

/// A step that is solved: its figures, their relative bars, and whether a body yields.
struct Solved {
    figures: Values,
    bars: Vec<Option<f64>>,
    yields: bool,
}

/// Figures and sides in the order of `Values`.
fn places() -> impl Iterator<Item = (Figure, usize)> {
    Figure::ALL.iter().flat_map(|figure| {
        (0..if figure.is_of_body() { 2 } else { 1 }).map(|side| (*figure, side))
    })
}

/// Solves a job; `None` where a load does not converge or takes too long.
fn solve(job: &Value) -> Option<Vec<Solved>> {
    let job = Job::from_json(job.to_string().as_bytes()).ok()?;
    if let Some(problem) = inputs::half_spaces(&job) {
        let sought = match &job.load {
            Load::Target(target) => Some(target.figure),
            _ => None,
        };
        let mut steps = Vec::new();
        let run = half_spaces::run_each(&problem, &mut Patience::new(), &mut steps).ok()?;
        let is_solved = run.interrupted.is_none()
            && steps.iter().all(|step: &half_spaces::HalfSpaceStep| {
                step.status == SolveStatus::Converged && step.search.missed.is_none()
            });
        let mut unknown = FigureSet::default();
        let solved = steps.iter_mut().map(|step| {
            step.path.unknown_before = unknown;
            let [void, left] = unknown_figures(&job, &problem, step);
            if !step.path.increments.is_empty() {
                unknown = left;
            }
            let is_known = |figure, side| {
                !void.has(figure, side)
                    && (figure != Figure::LeastStress || step.figures.force <= 0.0)
            };
            let errors = half_spaces::errors(step, sought);
            let bar = |(figure, side)| {
                let errors = errors.as_ref().filter(|_| is_known(figure, side))?;
                Some((errors.get(figure, side)? / step.figures.values().get(figure, side)?).abs())
            };
            Solved {
                figures: step.figures.values(),
                bars: places().map(bar).collect(),
                yields: step.figures.values().largest(Figure::MaxPlasticStrain) > Some(0.0),
            }
        });
        return is_solved.then(|| solved.collect());
    }
    let solution = inputs::run(&job, &mut Patience::new()).ok()?;
    let is_solved = solution.interrupted.is_none()
        && solution.steps.iter().all(|step| step.status == SolveStatus::Converged);
    let mut unknown = FigureSet::default();
    let solved = solution.steps.into_iter().map(|mut step| {
        step.path.unknown_before = unknown;
        let (errors, left) = estimate_error(&job, &step);
        if !step.path.increments.is_empty() {
            unknown = left;
        }
        let bars: Vec<_> =
            places().map(|(figure, side)| errors.as_ref()?.of_figure(figure, side)).collect();
        Solved {
            figures: step.figures.values(),
            bars,
            yields: step.field.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0),
        }
    });
    is_solved.then(|| solved.collect())
}

/// The next job of ordinary shapes of a kind.
fn next(random: &mut Random, kind: Kind, number: usize) -> Value {
    if kind == Kind::Ordinary {
        return random_job::ordinary(random, [10, 20][number % 2]);
    }
    if kind == Kind::HalfSpaces {
        let mut job = random_job::half_spaces(random);
        let cells = CELLS[number % CELLS.len()];
        job["mesh"]["elements_per_half_width"] = json!(cells);
        if number % 5 == 3 {
            random_job::put_roller(random, &mut job);
        }
        // Dents and residual stress are what random jobs seldom leave.
        let load = &job["load"];
        let is_single = load["force"].is_number() || load["approach"].is_number();
        if is_single && !number.is_multiple_of(3) {
            job["load"] = json!({"history": [load, {"force": 0}]});
            job["solver"]["theory"] = json!("flow");
        }
        return job;
    }
    loop {
        let mut job = random_job::job(random, &MESHES);
        let is_flow = job["solver"]["theory"] == "flow";
        let shapes = [&job["upper"]["shape"]["type"], &job["lower"]["shape"]["type"]];
        let is_exotic =
            |shape: &&Value| ["wedge", "cone", "punch", "power"].iter().any(|name| *shape == name);
        if is_flow != (kind == Kind::Flow) || shapes.iter().any(is_exotic) {
            continue;
        }
        let is_pin_in_groove =
            job["analysis"] != "axisymmetric" && shapes == ["cylinder", "groove"];
        if is_pin_in_groove {
            let radius = job["lower"]["shape"]["radius"].as_f64().unwrap_or(1.0);
            job["lower"]["shape"] =
                json!({"type": "hole", "radius": radius, "outer_radius": HOLE * radius});
        }
        if let Some(solver) = job["solver"].as_object_mut() {
            solver.remove("coupling");
            solver.remove("contact");
        }
        let elements = job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10);
        job["mesh"]["elements_per_half_width"] =
            json!(if is_flow { elements.min(MOST_OF_FLOW) } else { elements });
        return job;
    }
}

/// Replaces the force of a job by the figure that it gives, in millimetres and megapascals.
fn sought(job: &mut Value, found: &[Solved], number: usize) {
    let (Some(step), true) = (found.first(), job["load"]["force"].is_number()) else { return };
    if job["units"] == "SI" {
        return;
    }
    let target = if number.is_multiple_of(2) {
        json!({"half_width": step.figures.get(Figure::HalfWidth, 0)})
    } else {
        json!({"peak_pressure": step.figures.get(Figure::PeakPressure, 0)})
    };
    job["load"] = json!({"target": target});
}

fn load_of(job: &Value) -> &'static str {
    let load = &job["load"];
    if load["history"].is_array() {
        "history"
    } else if load["onset"].is_boolean() || load["target"].is_object() {
        "sought"
    } else {
        "given"
    }
}

/// The jobs of a part, all with given loads.
fn jobs(part: Part) -> Vec<Value> {
    let mut hasher = DefaultHasher::new();
    part.hash(&mut hasher);
    let mut random = Random(hasher.finish());
    (0..JOBS).map(|number| next(&mut random, part.kind, number)).collect()
}

/// Solves a part.
fn samples(part: Part) -> Vec<Sample> {
    let mut all = Vec::new();
    for (number, mut job) in jobs(part).into_iter().enumerate() {
        if number % 3 == 0
            && part.kind != Kind::Ordinary
            && let Some(found) = solve(&job)
        {
            sought(&mut job, &found, number);
        }
        let mut finer = job.clone();
        let by = if part.kind == Kind::HalfSpaces { FINER_CELLS } else { FINER };
        finer["mesh"]["elements_per_half_width"] =
            json!(by * job["mesh"]["elements_per_half_width"].as_u64().unwrap_or(10));
        let Some((found, exact)) = solve(&job).and_then(|found| Some((found, solve(&finer)?)))
        else {
            continue;
        };
        let place = format!("{:?} {:?} {} {number}", part.set, part.kind, part.number);
        for (found, exact) in found.iter().zip(&exact) {
            all.extend(compare(&job, found, exact, &place));
        }
    }
    all
}

/// The figures of a step beside those on a finer mesh.
fn compare(job: &Value, found: &Solved, exact: &Solved, place: &str) -> Vec<Sample> {
    let analysis = job["analysis"].as_str().unwrap_or_default();
    let theory = match job["solver"]["theory"].as_str() {
        _ if !found.yields => "nothing yields",
        Some("flow") => "flow",
        _ => "deformation",
    };
    let is_shared = Figure::ALL
        .iter()
        .all(|figure| found.figures.get(*figure, 0) == found.figures.get(*figure, 1));
    let mut compared = Vec::new();
    for (k, (figure, side)) in places().enumerate() {
        let Some(name) = name_of(figure) else { continue };
        let [value, truth] = [found, exact].map(|step| step.figures.get(figure, side));
        let (Some(value), Some(truth)) = (value, truth) else { continue };
        // Bodies alike are counted once. Nothing is said of what is prescribed, or zero.
        let is_prescribed =
            found.bars[k] == Some(0.0) || !job["load"]["target"][figure.name()].is_null();
        if value == 0.0 || truth == 0.0 || is_prescribed || side == 1 && is_shared {
            continue;
        }
        if analysis == "three_dimensional"
            && figure == Figure::LeastStress
            && found.bars[k].is_none()
        {
            continue;
        }
        compared.push(Sample {
            figure: name.to_owned(),
            analysis: analysis.to_owned(),
            theory: theory.to_owned(),
            load: load_of(job).to_owned(),
            bar: found.bars[k],
            error: (truth / value - 1.0).abs().max(1e-12),
            place: place.to_owned(),
        });
    }
    compared
}

/// Where the parts are kept that this program has solved.
fn folder() -> Result<PathBuf, Fault> {
    let mut hasher = DefaultHasher::new();
    fs::read(std::env::current_exe()?)?.hash(&mut hasher);
    let folder = PathBuf::from(format!("target/error_bars/{:016x}", hasher.finish()));
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

/// Solves the parts that are not there yet, two at a time, and returns the samples of all.
fn solved(parts: &[Part]) -> Result<Vec<Sample>, Fault> {
    let folder = folder()?;
    let file =
        |part: &Part| folder.join(format!("{:?}-{:?}-{}.json", part.set, part.kind, part.number));
    let missing: Vec<Part> = parts.iter().copied().filter(|part| !file(part).exists()).collect();
    let begun = AtomicUsize::new(0);
    let work = || -> Result<(), Fault> {
        loop {
            let Some(part) = missing.get(begun.fetch_add(1, Ordering::Relaxed)) else {
                return Ok(());
            };
            let started = Instant::now();
            let found = serde_json::to_string(&samples(*part))?;
            // A part is there as a whole or not at all.
            let unfinished = file(part).with_extension("unfinished");
            fs::write(&unfinished, found)?;
            fs::rename(&unfinished, file(part))?;
            eprintln!("{part:?}: {:.0} s", started.elapsed().as_secs_f64());
        }
    };
    thread::scope(|scope| {
        let other = scope.spawn(work);
        work()?;
        other.join().map_err(|_| "a job ended the thread that solved it")?
    })?;
    let mut all = Vec::new();
    for part in parts {
        let file = file(part);
        let samples: Vec<Sample> =
            serde_json::from_str(&fs::read_to_string(&file)?).map_err(|error| {
                format!("{}: {error}; without it, it is solved anew", file.display())
            })?;
        all.extend(samples);
    }
    Ok(all)
}

/// The parts of a set, of each kind so many at most.
fn parts(set: Set, most: usize) -> Vec<Part> {
    let of_kind = |(kind, count): (Kind, usize)| {
        (0..count.min(most)).map(move |number| Part { set, kind, number })
    };
    PARTS.into_iter().flat_map(of_kind).collect()
}

fn quantile(mut values: Vec<f64>, part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let count = values.len() as f64;
    let reaches = |place: usize| (place + 1) as f64 >= part * count;
    values
        .into_iter()
        .enumerate()
        .find(|(place, _)| reaches(*place))
        .map_or(0.0, |(_, value)| value)
}

/// What holds of some samples: bars, part that holds, median bar, median error, and median and 95th
/// percentile of the bar over the error, and how many have no bar.
fn cells(samples: &[&Sample]) -> String {
    let bars: Vec<_> =
        samples.iter().filter_map(|sample| Some((sample.bar?, sample.error))).collect();
    let held = bars.iter().filter(|(bar, error)| bar >= error).count();
    let of = |part: f64, value: fn(&(f64, f64)) -> f64| {
        quantile(bars.iter().map(value).collect(), part)
    };
    let ratio = |(bar, error): &(f64, f64)| bar / error;
    format!(
        "{} | {:.0} % | {:.2} % | {:.2} % | {:.1} | {:.0} | {}",
        bars.len(),
        100.0 * held as f64 / bars.len().max(1) as f64,
        100.0 * of(0.5, |(bar, _)| *bar),
        100.0 * of(0.5, |(_, error)| *error),
        of(0.5, ratio),
        of(0.95, ratio),
        samples.len() - bars.len()
    )
}

/// The table of all figures by analysis.
fn table(samples: &[&Sample]) -> String {
    let mut text =
        "| figure | analysis | bars | hold | median bar | median error | bar over error \
                    | 95th percentile | without a bar |\n|---|---|---|---|---|---|---|---|---|\n"
            .to_owned();
    let mut groups: BTreeMap<[&str; 2], Vec<&Sample>> = BTreeMap::new();
    for sample in samples {
        groups.entry([&sample.figure, &sample.analysis]).or_default().push(sample);
    }
    let mut row = |names: [&str; 2], samples: &[&Sample]| {
        let names = names.map(|name| name.replace('_', " ")).join(" | ");
        let _ = writeln!(text, "| {names} | {} |", cells(samples));
    };
    for (names, samples) in &groups {
        row(*names, samples);
    }
    for load in ["given", "sought", "history"] {
        let of_load: Vec<_> = samples.iter().copied().filter(|one| one.load == load).collect();
        row(["all", load], &of_load);
    }
    row(["all", "all"], samples);
    text
}

fn count(most: usize, set: Set) -> Result<ExitCode, Fault> {
    let samples = solved(&parts(set, most))?;
    let (ordinary, odd): (Vec<_>, Vec<_>) = samples.iter().partition(|one| one.is_ordinary());
    println!("Ordinary jobs\n\n{}\nOdd jobs\n\n{}", table(&ordinary), table(&odd));
    for Sample { figure, theory, error, place, .. } in samples.iter().filter(|one| !one.holds()) {
        println!("{place}: {figure}, {theory}, off by {:.1} %", 100.0 * error);
    }
    let bars = samples.iter().filter(|one| one.bar.is_some());
    let held = bars.clone().filter(|one| one.holds()).count();
    println!("{held} of {} bars hold", bars.clone().count());
    let holds = held > 0 && held as f64 >= HOLDS * bars.count() as f64;
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn main() -> Result<ExitCode, Fault> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["count"] => count(usize::MAX, Set::Judge),
        ["count", most] => count(most.parse()?, Set::Judge),
        ["count", most, "Fit"] => count(most.parse()?, Set::Fit),
        ["job", set, kind, part, number] => {
            let is_part = |found: &Part| {
                [format!("{:?}", found.set), format!("{:?}", found.kind)] == [set, kind]
                    && found.number.to_string() == part
            };
            let all = [Set::Fit, Set::Judge].into_iter().flat_map(|set| parts(set, usize::MAX));
            let part = all.into_iter().find(is_part).ok_or("no such part")?;
            println!("{}", jobs(part).get(number.parse::<usize>()?).ok_or("no such job")?);
            Ok(ExitCode::SUCCESS)
        }
        _ => Err("usage: error_bars count [parts [Fit]] | job set kind part number".into()),
    }
}
