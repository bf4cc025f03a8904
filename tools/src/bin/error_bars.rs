//! Fits the floors of the error bars to random jobs, and counts how often the bars hold.
//!
//! `cargo run --release -p brinell-tools --bin error_bars -- fit` solves two sets of random jobs,
//! each job beside itself on a finer mesh. It takes the smallest floors that cover the errors of
//! the first set, writes them to `brinell-method/src/floors.rs` and `docs/validity.md`, judges them by the
//! second set and writes `docs/notes/error_bars_counted.md`. A part of a set that has been solved
//! is kept under `target/error_bars`, in a folder of the program that solved it: a run that is
//! stopped goes on where it was.
//!
//! `error_bars -- job Judge Flow 0 2` prints the job of that part and number; bars that do not hold
//! are listed with theirs. `error_bars -- count 2` counts the bars of the first two parts of the
//! second set, and fails where fewer than 93 of 100 hold. Jobs are given up after a minute of the
//! processor on each mesh.

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "printing is what it is for")]

#[path = "../../../crates/brinell-solver/tests/support/random_job.rs"]
mod random_job;

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use brinell_solver::inputs;
use brinell_solver::job::Job;
use brinell_solver::report::{estimate_error, name_of, scales_of_floors, unknown_figures};
use brinell_solver::solver::floors::floors;
use brinell_solver::solver::{
    Figure, FigureSet, Interrupt, Observer, SolveStatus, Values, half_spaces,
};
use random_job::Random;
use rustix::time::{ClockId, clock_gettime};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Jobs of a part, and parts of a set by kind.
const JOBS: usize = 10;
const PARTS: [(Kind, usize); 3] =
    [(Kind::Deformation, 16), (Kind::Flow, 16), (Kind::HalfSpaces, 14)];
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

/// Parts of the errors of the first set that a floor covers: of all of a figure in an analysis, so
/// that 95 of 100 are covered beyond the set, and of each theory alone.
const COVERED: f64 = 0.97;
const COVERED_OF_THEORY: f64 = 0.95;
/// Smallest floor: closed forms and other programs tell what no finer mesh does.
const SMALLEST: f64 = 1e-3;
/// Least errors from which a floor follows.
const LEAST: usize = 40;
/// Part of the bars of a count that has to hold: thirty jobs tell 95 % to within 2 %.
const HOLDS: f64 = 0.93;

const CLASSES: [&str; 4] = ["plane strain", "plane stress", "revolution", "three dimensions"];

type Fault = Box<dyn Error + Send + Sync>;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    Deformation,
    Flow,
    HalfSpaces,
}

/// One of the sets: floors are fitted to the first and judged by the second.
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
    /// Place of the floor among those of the figure.
    class: usize,
    analysis: String,
    theory: String,
    load: String,
    /// The relative bar without its floor, and what the floor is multiplied by.
    bar: Option<[f64; 2]>,
    error: f64,
    /// Which job of which part.
    place: String,
}

impl Sample {
    /// The bar under a floor.
    fn bar(&self, floor: f64) -> Option<f64> {
        self.bar.map(|[base, scale]| base + floor * scale)
    }

    /// The smallest floor under which the bar holds.
    fn needed(&self) -> Option<f64> {
        let [base, scale] = self.bar?;
        let needed = (self.error - base) / scale;
        Some(if self.error <= base { 0.0 } else { needed }).filter(|needed| needed.is_finite())
    }
}

/// Floors by figure, in the order of `CLASSES`.
type Floors = BTreeMap<String, [Option<f64>; 4]>;

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

/// A step that is solved: its figures, their relative bars, what their floors are multiplied by,
/// and whether a body yields.
struct Solved {
    figures: Values,
    bars: Vec<Option<f64>>,
    scales: Option<Values>,
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
            let errors = half_spaces::errors(step, None);
            let bar = |(figure, side)| {
                let errors = errors.as_ref().filter(|_| is_known(figure, side))?;
                Some((errors.get(figure, side)? / step.figures.values().get(figure, side)?).abs())
            };
            Solved {
                figures: step.figures.values(),
                bars: places().map(bar).collect(),
                scales: Some(half_spaces::scales_of_floors(step)),
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
            scales: scales_of_floors(&step),
            yields: step.field.bodies.iter().flatten().any(|body| body.max_plastic_strain() > 0.0),
        }
    });
    is_solved.then(|| solved.collect())
}

/// The next job of ordinary shapes of a kind.
fn next(random: &mut Random, kind: Kind, number: usize) -> Value {
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
    let class = match analysis {
        "plane_stress" => 1,
        "axisymmetric" => 2,
        "three_dimensional" => 3,
        _ => 0,
    };
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
        let (Some(name), Some(floor)) = (name_of(figure), floors(figure)[class]) else { continue };
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
        let scale = found.scales.and_then(|scales| scales.get(figure, side));
        let bar = found.bars[k].zip(scale).map(|(bar, scale)| {
            let scale = scale / value.abs();
            [bar - floor * scale, scale]
        });
        compared.push(Sample {
            figure: name.to_owned(),
            class,
            analysis: analysis.to_owned(),
            theory: theory.to_owned(),
            load: load_of(job).to_owned(),
            bar,
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

/// The floors of this program.
fn present() -> Floors {
    let named = Figure::ALL.iter().filter_map(|figure| Some((name_of(*figure)?, *figure)));
    named.map(|(name, figure)| (name.to_owned(), floors(figure))).collect()
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

/// Rounds up to two digits.
fn rounded_up(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let unit = 10f64.powf(value.log10().floor() - 1.0);
    format!("{:.1e}", (value / unit - 1e-9).ceil() * unit).parse().unwrap_or(value)
}

/// The smallest floors that cover the samples of a figure in an analysis: all of them, and those
/// of each theory. A floor without samples stays.
fn fitted(samples: &[Sample], before: &Floors) -> Floors {
    let mut floors = before.clone();
    for (name, row) in &mut floors {
        for (class, floor) in row.iter_mut().enumerate() {
            let (mut all, mut theories) = (Vec::new(), BTreeMap::<&str, Vec<f64>>::new());
            for sample in samples.iter().filter(|s| s.figure == *name && s.class == class) {
                let Some(needed) = sample.needed() else { continue };
                all.push(needed);
                theories.entry(&sample.theory).or_default().push(needed);
            }
            let of_theories = theories.into_values().map(|needed| (needed, COVERED_OF_THEORY));
            let quantiles = of_theories
                .chain([(all, COVERED)])
                .filter(|(needed, _)| needed.len() >= LEAST)
                .map(|(needed, part)| quantile(needed, part));
            if let Some(largest) = quantiles.max_by(f64::total_cmp).filter(|_| floor.is_some()) {
                *floor = Some(rounded_up(largest.max(SMALLEST)));
            }
        }
    }
    floors
}

/// What is counted of the bars of some samples.
struct Counted {
    bars: Vec<[f64; 2]>,
    without: usize,
}

impl Counted {
    fn of<'a>(samples: impl Iterator<Item = &'a Sample>, floors: &Floors) -> Self {
        let mut counted = Self { bars: Vec::new(), without: 0 };
        for sample in samples {
            let floor = floors.get(&sample.figure).and_then(|row| row[sample.class]);
            match floor.and_then(|floor| sample.bar(floor)) {
                Some(bar) => counted.bars.push([bar, sample.error]),
                None => counted.without += 1,
            }
        }
        counted
    }

    fn held(&self) -> usize {
        self.bars.iter().filter(|[bar, error]| bar >= error).count()
    }

    fn median(&self, of: fn(&[f64; 2]) -> f64) -> f64 {
        quantile(self.bars.iter().map(of).collect(), 0.5)
    }

    /// Part that holds, median bar, median bar over error.
    fn cells(&self) -> String {
        format!(
            "{:.0} % | {:.2} % | {:.1}",
            100.0 * self.held() as f64 / self.bars.len().max(1) as f64,
            100.0 * self.median(|[bar, _]| *bar),
            self.median(|[bar, error]| bar / error)
        )
    }
}

/// The table of all figures by analysis and theory, under the floors before and after.
fn table(samples: &[Sample], before: &Floors, after: &Floors) -> String {
    let mut text =
        "| figure | analysis | theory | bars | hold | median bar | over the error | hold \
                    | median bar | over the error | without a bar |\n\
                    |---|---|---|---|---|---|---|---|---|---|---|\n"
            .to_owned();
    let mut groups: BTreeMap<[&str; 3], Vec<&Sample>> = BTreeMap::new();
    for sample in samples {
        let key = [&sample.figure, &sample.analysis, &sample.theory].map(String::as_str);
        groups.entry(key).or_default().push(sample);
    }
    let mut row = |names: [&str; 3], samples: &[&Sample]| {
        let [old, new] =
            [before, after].map(|floors| Counted::of(samples.iter().copied(), floors));
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            names.map(|name| name.replace('_', " ")).join(" | "),
            format_args!("{} | {}", new.bars.len(), old.cells()),
            new.cells(),
            new.without
        );
    };
    for (names, samples) in &groups {
        row(*names, samples);
    }
    for load in ["given", "sought", "history"] {
        let of_load: Vec<&Sample> = samples.iter().filter(|sample| sample.load == load).collect();
        row(["all", load, "all"], &of_load);
    }
    row(["all", "all", "all"], &samples.iter().collect::<Vec<_>>());
    text
}

/// Replaces what stands in a file between two texts.
fn replace(path: &Path, from: &str, to: &str, inner: &str) -> Result<(), Fault> {
    let text = fs::read_to_string(path)?;
    let missing = || format!("{} lacks {from:?} or {to:?}", path.display());
    let begin = text.find(from).ok_or_else(missing)? + from.len();
    let end = begin + text[begin..].find(to).ok_or_else(missing)?;
    Ok(fs::write(path, format!("{}{inner}{}", &text[..begin], &text[end..]))?)
}

/// Writes floors to the solver and to the table of the document; to neither where a row is missing.
fn write_floors(floors: &Floors) -> Result<(), Fault> {
    let mut code = String::from("\n");
    let document = Path::new("docs/validity.md");
    let mut text = fs::read_to_string(document)?;
    for figure in Figure::ALL {
        let row = name_of(*figure).and_then(|name| floors.get(name)).copied().unwrap_or_default();
        let cells = row.map(|floor| match floor {
            Some(floor) => format!("Some({floor:?})"),
            None => "None".to_owned(),
        });
        let _ = writeln!(code, "        Figure::{figure:?} => [{}],", cells.join(", "));
        let Some(name) = name_of(*figure) else { continue };
        let cells = row.map(|floor| floor.map_or_else(String::new, |floor| floor.to_string()));
        let begin = format!("\n| {name} | ");
        let rows: Vec<&str> = text.split(&begin).collect();
        let [before, after] = rows[..] else {
            return Err(format!("{} rows of {name}", rows.len() - 1).into());
        };
        let rest = after.splitn(5, " | ").nth(4).ok_or("a row without cells")?;
        text = format!("{before}{begin}{} | {rest}", cells.join(" | "));
    }
    let source = Path::new("crates/brinell-method/src/floors.rs");
    replace(source, "match figure {", "    }\n}", &code)?;
    Ok(fs::write(document, text)?)
}

fn fit() -> Result<ExitCode, Fault> {
    let started = Instant::now();
    let all: Vec<Part> =
        [Set::Fit, Set::Judge].into_iter().flat_map(|set| parts(set, usize::MAX)).collect();
    let split = parts(Set::Fit, usize::MAX).len();
    solved(&all)?;
    let [first, second] = [&all[..split], &all[split..]].map(solved);
    let (before, after) = (present(), fitted(&first?, &present()));
    write_floors(&after)?;
    let second = second?;
    let counted = table(&second, &before, &after);
    let mut changed = String::new();
    for (name, row) in &after {
        for (class, (old, new)) in before[name].iter().zip(row).enumerate() {
            if let (Some(old), Some(new)) = (old, new) {
                let _ = writeln!(changed, "| {name} | {} | {old} | {new} |", CLASSES[class]);
            }
        }
    }
    let note = format!(
        "# Error bars, counted\n\n`cargo run --release -p brinell-tools --bin error_bars -- fit` \
         writes this file. [What it does](error_bars.md).\n\n{} errors of a set of random jobs that \
         no floor was fitted to, by figure, analysis and theory. The first three columns of figures \
         are under the floors before, the next three under those after.\n\n{counted}\n## \
         Floors\n\n| figure | | before | after |\n|---|---|---|---|\n{changed}",
        second.len(),
    );
    fs::write("docs/notes/error_bars_counted.md", &note)?;
    println!("{note}\n{:.0} s", started.elapsed().as_secs_f64());
    Ok(ExitCode::SUCCESS)
}

fn count(most: usize) -> Result<ExitCode, Fault> {
    let samples = solved(&parts(Set::Judge, most))?;
    println!("{}", table(&samples, &present(), &present()));
    let counted = Counted::of(samples.iter(), &present());
    let holds = counted.held() as f64 >= HOLDS * counted.bars.len() as f64;
    for sample in samples.iter().filter(|sample| {
        let floor = present()[&sample.figure][sample.class].unwrap_or_default();
        sample.bar(floor).is_some_and(|bar| bar < sample.error)
    }) {
        let Sample { figure, theory, error, place, .. } = sample;
        println!("{place}: {figure}, {theory}, off by {:.1} %", 100.0 * error);
    }
    println!("{} of {} bars hold", counted.held(), counted.bars.len());
    Ok(if holds && !counted.bars.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn main() -> Result<ExitCode, Fault> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["fit"] => fit(),
        ["count"] => count(usize::MAX),
        ["count", most] => count(most.parse()?),
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
        _ => Err("usage: error_bars fit | count [parts] | job set kind part number".into()),
    }
}
