//! A report as plain text for a person, at most 80 columns wide.

mod bodies;
mod history;
mod number;
mod plot;

use std::fmt::Write;

use super::style::Style;
use brinell_solver::job::fields::Figure;
use brinell_solver::job::{Analysis, Job, Load, Quantity, Target};
use brinell_solver::report::{
    FlowReport, HertzReport, LoadReport, PlasticityReport, Report, StepReport, TargetReport, Timings,
};
use brinell_solver::solver::SolveStatus;
pub(super) use number::significant;

/// Widest line.
const WIDTH: usize = 80;

/// Lays a report out as text. `job` is what was asked.
pub fn table(job: &Job, report: &Report, style: Style) -> String {
    let page = Page { style, units: UnitNames::of(job), text: String::new() };
    page.lay_out(job, report)
}

/// How the figures' units are written.
#[derive(Debug, Clone, Copy)]
struct UnitNames {
    length: &'static str,
    stress: &'static str,
    force: &'static str,
}

impl UnitNames {
    fn of(job: &Job) -> Self {
        let is_axisymmetric = job.analysis == Analysis::Axisymmetric;
        let force = if is_axisymmetric { Quantity::Force } else { Quantity::LineForce };
        let [length, stress, force] =
            [Quantity::Length, Quantity::Stress, force].map(|q| q.symbol(job.units));
        Self { length, stress, force }
    }
}

/// The text so far.
struct Page {
    style: Style,
    units: UnitNames,
    text: String,
}

impl Page {
    fn lay_out(mut self, job: &Job, report: &Report) -> String {
        let analysis = report.analysis.replace('_', " ");
        let title = self.style.bold(&format!("Brinell {}", report.version));
        self.line(&format!("{title} · {analysis} · {}", report.units));
        for (name, body) in [("upper", &job.upper), ("lower", &job.lower)] {
            self.line(&wrapped(&format!("{name}  "), &bodies::describe(body, job.units), ", "));
        }
        if let Some(target) = &report.target {
            self.line("");
            self.target(job, target);
        }
        for step in &report.steps {
            self.line("");
            self.step(step);
        }
        self.line("");
        let mesh = &report.mesh;
        let half = if mesh.symmetric { " of one half" } else { "" };
        self.line(&format!(
            "mesh   {} elements, {} equations{half}, spacing {} {}, {} passes",
            mesh.elements,
            mesh.equations,
            significant(mesh.spacing, 3),
            self.units.length,
            mesh.passes
        ));
        self.line(&times(&report.timings_ms));
        self.style.spell(self.text)
    }

    /// The force that the job asked for by what it does.
    fn target(&mut self, job: &Job, target: &TargetReport) {
        let unit = match &job.load {
            Load::Target(Target { figure, .. }) => match figure.figure() {
                Figure::Quantity(quantity) => format!(" {}", quantity.symbol(job.units)),
                Figure::Pure(_) => String::new(),
            },
            _ => String::new(),
        };
        let bar = target
            .relative_error
            .map_or_else(String::new, |error| format!(" ± {} %", significant(100.0 * error, 2)));
        let force = self.style.bold(&format!("{} {}", significant(target.force, 7), self.units.force));
        let name = target.figure.replace('_', " ");
        let reached = significant(target.reached, 5);
        self.line(&format!("force for a {name} of {}{unit}: {force}{bar}", target.wanted));
        self.line(&self.style.dim(&format!("it is {reached}{unit} under this force")));
    }

    fn step(&mut self, step: &StepReport) {
        let load = match step.load {
            LoadReport::Force(force) => format!("force {} {}", significant(force, 7), self.units.force),
            LoadReport::Approach(approach) => {
                format!("approach {} {}", significant(approach, 7), self.units.length)
            }
        };
        let (count, style) = (step.history.len(), self.style);
        let count = format!("{count} iteration{}", if count == 1 { "" } else { "s" });
        let status = match step.status {
            SolveStatus::Converged => style.green(&format!("converged in {count}")),
            SolveStatus::NotConverged => style.red(&format!("NOT CONVERGED after {count}")),
            SolveStatus::Cancelled => style.yellow(&format!("cancelled after {count}")),
            SolveStatus::TimedOut => style.yellow(&format!("timed out after {count}")),
        };
        self.line(&format!("{load} · {status}"));
        self.line("");
        self.figures(step);
        let picture = plot::pressure(&step.contact, step.hertz.as_ref(), self.units, style);
        if !picture.is_empty() {
            self.line("");
            self.text.push_str(&picture);
        }
        self.line("");
        self.plastic_zone("upper", step.plasticity.upper.as_ref());
        self.plastic_zone("lower", step.plasticity.lower.as_ref());
        if let Some(flow) = &step.flow {
            self.flow(flow);
        }
        for note in &step.validity {
            let label = style.yellow("note ");
            let text = wrapped("note   ", &words(&note.message), " ");
            self.line(&text.replacen("note ", &label, 1));
        }
        if !step.history.is_empty() {
            self.line("");
            self.text.push_str(&history::history(&step.history, style));
        }
    }

    fn figures(&mut self, step: &StepReport) {
        let (contact, units) = (&step.contact, self.units);
        let error = step.estimated_error.as_ref();
        let hertz = step.hertz.as_ref();
        let strain = [&step.plasticity.upper, &step.plasticity.lower]
            .into_iter()
            .flatten()
            .map(|body| body.max_equivalent_plastic_strain)
            .fold(0.0, f64::max);
        self.line(&self.style.dim(&format!("{:27}{:>13}{:>13}{:>9}", "", "this contact", "Hertz", "ratio")));
        self.figure(
            ("peak pressure", units.stress),
            contact.peak_pressure,
            hertz.map(|hertz| hertz.peak_pressure),
            error.map(|error| error.peak_pressure),
        );
        let half_widths = hertz.map(|hertz| hertz.half_width);
        let error_of_width = error.map(|error| error.half_width);
        self.figure(("half-width", units.length), contact.half_width, half_widths, error_of_width);
        let mean = hertz.map(|hertz| std::f64::consts::FRAC_PI_4 * hertz.peak_pressure);
        self.figure(("mean pressure", units.stress), contact.mean_pressure, mean, None);
        let error_of_approach = error.map(|error| error.approach);
        self.figure(("approach", units.length), step.approach, None, error_of_approach);
        self.figure(("max plastic strain", "%"), 100.0 * strain, hertz.map(|_| 0.0), None);
        self.line(&self.style.dim(&wrapped("approach: ", &words(&step.approach_datum), " ")));
        if let Some(HertzReport { yield_onset_force: Some(onset), .. }) = hertz {
            let times = significant(contact.force / onset, 3);
            let onset = significant(*onset, 5);
            self.line(&format!("yield begins at {onset} {}; this force is {times} times that", units.force));
        }
        if let Some(limit) = hertz.and_then(|hertz| hertz.shakedown_pressure) {
            let limit = significant(limit, 5);
            self.line(&format!(
                "rolling freely, it shakes down up to a Hertz peak of {limit} {}",
                units.stress
            ));
        }
    }

    fn figure(&mut self, (name, unit): (&str, &str), value: f64, hertz: Option<f64>, error: Option<f64>) {
        let reference = hertz.map_or_else(|| "—".to_owned(), |hertz| significant(hertz, 5));
        let ratio = match hertz {
            Some(hertz) if hertz > 0.0 => format!("{:.3}", value / hertz),
            _ => String::new(),
        };
        // What is prescribed, or zero without contact, has no error.
        let error = error.filter(|error| *error > 0.0);
        let error =
            error.map_or_else(String::new, |error| format!("  ± {} %", significant(100.0 * error, 2)));
        let value = self.style.bold(&format!("{:>13}", significant(value, 5)));
        let line = format!("{name:21}{unit:>6}{value}{reference:>13}{ratio:>9}{error}");
        self.line(line.trim_end());
    }

    fn plastic_zone(&mut self, name: &str, zone: Option<&PlasticityReport>) {
        let text = match zone {
            None => "rigid".to_owned(),
            Some(zone) if !zone.yielded => "elastic throughout".to_owned(),
            Some(zone) => format!(
                "plastic zone {} {}²; strain up to {} % at x {}, depth {} {}",
                significant(zone.area, 3),
                self.units.length,
                significant(100.0 * zone.max_equivalent_plastic_strain, 3),
                significant(zone.position, 3),
                significant(zone.depth, 3),
                self.units.length
            ),
        };
        self.line(&format!("{name}  {text}"));
    }

    /// What flow theory knows: the dents, the work, and how the contact unloads.
    fn flow(&mut self, flow: &FlowReport) {
        let units = self.units;
        let surfaces = &flow.surfaces;
        for (name, surface) in [("upper", &surfaces.upper), ("lower", &surfaces.lower)] {
            let Some(surface) = surface else { continue };
            let reverse = if surface.yielded_in_reverse { "; yielded in reverse" } else { "" };
            self.line(&format!(
                "{name}  surface {} {} deep, pile-up {} at |x| {}{reverse}",
                significant(surface.depth, 4),
                units.length,
                significant(surface.pile_up, 3),
                significant(surface.pile_up_position, 3),
            ));
        }
        let energy = &flow.energy;
        let work = format!("{} {}", units.force, units.length);
        self.line(&format!(
            "work   {} {work}: elastic {}, dissipated {}, stored by backstress {}",
            significant(energy.work, 4),
            significant(energy.elastic, 3),
            significant(energy.dissipated, 3),
            significant(energy.stored, 3),
        ));
        if flow.unloading_stiffness > 0.0 {
            let stiffness = significant(flow.unloading_stiffness, 4);
            self.line(&format!("unloading stiffness {stiffness} {}/{}", units.force, units.length));
        }
    }

    fn line(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
    }
}

/// One line: the total and the phases that matter, the longest first.
fn times(timings: &Timings) -> String {
    let mut phases = [
        ("mesh", timings.mesh),
        ("assembly", timings.assembly),
        ("ordering", timings.ordering),
        ("symbolic", timings.symbolic),
        ("numeric", timings.numeric),
        ("flexibility", timings.flexibility),
        ("contact", timings.contact),
        ("plasticity", timings.plasticity),
        ("solves", timings.solves),
        ("output", timings.output),
    ];
    phases.sort_by(|(_, one), (_, other)| other.total_cmp(one));
    let mut text = format!("time   {} ms", significant(timings.total, 3));
    for (number, (name, time)) in phases.into_iter().filter(|(_, time)| *time > 0.0).take(4).enumerate() {
        let separator = if number == 0 { ": " } else { ", " };
        let _ = write!(text, "{separator}{name} {}", significant(time, 2));
    }
    text
}

fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

/// Items after a label, broken into lines that are indented like the first.
fn wrapped(label: &str, items: &[String], separator: &str) -> String {
    let indent = label.chars().count();
    let (mut text, mut column) = (label.to_owned(), indent);
    for (number, item) in items.iter().enumerate() {
        let width = item.chars().count();
        if number > 0 {
            if column + separator.len() + width > WIDTH {
                text.push_str(separator.trim_end());
                text.push('\n');
                text.push_str(&" ".repeat(indent));
                column = indent;
            } else {
                text.push_str(separator);
                column += separator.len();
            }
        }
        text.push_str(item);
        column += width;
    }
    text
}
