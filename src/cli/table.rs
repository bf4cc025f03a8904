//! A report as plain text for a person, at most 80 columns wide.

mod bodies;
mod hardness;
mod history;
mod number;
mod passes;
mod plot;
mod sweep;
mod text;

use std::fmt::Write;

use super::style::Style;
use brinell_solver::job::fields::NumberKind;
use brinell_solver::job::{Job, Load, Quantity, Target, TargetFigure, measure_of};
use brinell_solver::report::{
    Answer, FlowReport, LoadReport, Mark, Name, PlasticityReport, Report, StepReport,
    TargetReport, Timings,
};
use brinell_solver::solver::SolveStatus;
pub(super) use number::significant;
use text::{Names, WIDTH, words, wrapped};

/// Lays a report out as text. `job` is what was asked. Of a long sweep it shows a line for each
/// load, or one `step` as a whole.
pub fn table(job: &Job, report: &Report, step: Option<usize>, style: Style) -> String {
    let page = Page { style, names: Names::of(job), text: String::new(), said: Vec::new() };
    page.lay_out(job, report, step)
}

/// The text so far.
struct Page {
    style: Style,
    names: Names,
    text: String,
    /// Remarks and datums already written: a remark that holds for every step appears once.
    said: Vec<String>,
}

impl Page {
    fn lay_out(mut self, job: &Job, report: &Report, step: Option<usize>) -> String {
        let analysis = report.analysis.replace('_', " ");
        let title = self.style.bold(&format!("Brinell {}", report.version));
        let theory = report.theory.as_deref();
        let theory = theory.map_or_else(String::new, |theory| format!(" · {theory} theory"));
        self.line(&format!("{title} · {analysis}{theory} · {}", report.units));
        if let Some(target) = &report.target {
            self.target(job, target);
            self.line("");
        }
        if let Some(hardness) = &report.hardness {
            let Names { length, stress, .. } = self.names;
            self.text.push_str(&hardness::hardness(hardness, length, stress, self.style));
            for note in &hardness.remarks {
                self.line(&wrapped("note   ", &words(&note.message), " "));
            }
            self.line("");
        }
        for (name, body) in [("upper", &job.upper), ("lower", &job.lower)] {
            self.line(&wrapped(&format!("{name}  "), &bodies::describe(body, job), ", "));
        }
        let is_sweep = matches!(job.load, Load::Forces(_) | Load::Approaches(_));
        if step.is_none() && is_sweep && report.steps.len() > sweep::WHOLE {
            self.sweep(&report.steps);
        } else {
            for (at, shown) in report.steps.iter().enumerate() {
                if step.is_none_or(|step| step == at) {
                    self.line("");
                    self.step(shown);
                }
            }
        }
        self.line("");
        let mesh = &report.mesh;
        let half = if mesh.symmetric { " of one half" } else { "" };
        let elements = if self.names.is_three_dimensional { "cells" } else { "elements" };
        self.line(&format!(
            "mesh   {} {elements}, {} equations{half}, spacing {} {}, {} solves",
            mesh.elements,
            mesh.equations,
            significant(mesh.spacing, 3),
            self.names.length,
            mesh.passes
        ));
        self.line(&times(&report.timings_ms));
        self.style.spell(self.text)
    }

    /// A line for each load, and of each kind of remark that of the last load that has it.
    fn sweep(&mut self, steps: &[StepReport]) {
        self.line("");
        self.text.push_str(&sweep::sweep(steps, self.names, self.style));
        self.line("");
        let mut kinds = Vec::new();
        for note in steps.iter().rev().flat_map(|step| &step.validity) {
            if !kinds.contains(&&note.code) {
                kinds.push(&note.code);
                self.remark(&note.message);
            }
        }
        self.line(&self.style.dim("--step N shows one load as a whole"));
    }

    /// The force that the job asked for by what it does.
    fn target(&mut self, job: &Job, target: &TargetReport) {
        let Load::Target(Target { figure, .. }) = &job.load else { return };
        let unit = match measure_of(*figure) {
            NumberKind::Quantity(quantity) => format!(" {}", quantity.symbol(job.units)),
            NumberKind::Pure(_) => String::new(),
        };
        let when = match figure {
            TargetFigure::PermanentApproach | TargetFigure::DentDepth => {
                "when this force is taken away"
            }
            _ => "under this force",
        };
        let force =
            self.style.bold(&format!("{} {}", significant(target.force, 7), self.names.force));
        let name = target.figure.replace('_', " ");
        let reached = significant(target.reached, 5);
        self.line(&format!("force for a {name} of {}{unit}: {force}", target.wanted));
        self.line(&self.style.dim(&format!("it is {reached}{unit} {when}")));
    }

    fn step(&mut self, step: &StepReport) {
        let load = match step.load {
            LoadReport::Force(force) => {
                format!("force {} {}", significant(force, 7), self.names.force)
            }
            LoadReport::Approach(approach) => {
                format!("approach {} {}", significant(approach, 7), self.names.length)
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
        if let Some(verdict) = &step.verdict {
            let text = wrapped("", &words(&verdict.text), " ");
            let text = match verdict.mark {
                Mark::Bad => style.red(&text),
                Mark::Attention => style.yellow(&text),
                Mark::Good => style.green(&text),
                Mark::Unknown => text,
            };
            self.line(&text);
            self.line("");
        }
        self.answers(step);
        let picture = plot::pressure(step, self.names, style);
        if !picture.is_empty() {
            self.line("");
            self.text.push_str(&picture);
        }
        self.line("");
        if step.rolling.is_none() {
            self.plastic_zone("upper", step.plasticity.upper.as_ref());
            self.plastic_zone("lower", step.plasticity.lower.as_ref());
        }
        if let Some(flow) = &step.flow {
            self.flow(flow);
        }
        if let Some(rolling) = &step.rolling {
            let Names { length, stress, .. } = self.names;
            self.text.push_str(&passes::passes(&rolling.passes, length, stress, style));
            self.line("");
        }
        for note in &step.validity {
            self.remark(&note.message);
        }
        if !step.history.is_empty() {
            self.line("");
            self.text.push_str(&history::history(&step.history, style));
        }
    }

    /// Writes a remark unless it is there.
    fn remark(&mut self, message: &str) {
        if self.said.iter().any(|said| said == message) {
            return;
        }
        self.said.push(message.to_owned());
        let label = self.style.yellow("note ");
        let text = wrapped("note   ", &words(message), " ");
        self.line(&text.replacen("note ", &label, 1));
    }

    /// Writes the answers, each with its elastic reference or its place, and its error bar. A
    /// force that is sought stands under its own name alone.
    fn answers(&mut self, step: &StepReport) {
        let shown = || step.answers.iter().filter(|row| !row.detail);
        let is_onset = shown().any(|row| row.is(Name::FirstYieldForce));
        if shown().any(|row| row.elastic.is_some()) {
            let head = format!("{:34}{:>12}{:>11}{:>8}", "", "this contact", "Hertz", "ratio");
            self.line(&self.style.dim(&head));
        }
        for answer in shown() {
            if !is_onset || !answer.is(Name::Force) {
                self.answer(answer);
            }
        }
        if let Some(whole) = &step.three_dimensional
            && whole.orientation != 0.0
        {
            let angle = significant(whole.orientation, 4);
            self.line(&format!(
                "the x of these figures is the x of the job turned by {angle}° towards its y"
            ));
        }
        if let Some(angle) = step.contact.half_angle.filter(|angle| *angle > 0.0) {
            self.line(&format!(
                "it touches over {}° to each side, along the arc",
                significant(angle, 3)
            ));
        }
        if !self.said.contains(&step.approach_datum) {
            self.line(&self.style.dim(&wrapped("approach: ", &words(&step.approach_datum), " ")));
            self.said.push(step.approach_datum.clone());
        }
    }

    fn answer(&mut self, answer: &Answer) {
        let is_part = matches!(answer.quantity, Quantity::Strain | Quantity::Ratio);
        let (factor, unit) = if is_part { (100.0, "%") } else { (1.0, answer.unit.as_str()) };
        let shown = |value: f64| significant(factor * value, 5);
        let value = answer.value.map_or_else(|| "—".to_owned(), shown);
        let plain = format!("{value:>12}");
        let value = self.style.bold(&plain);
        let mut label = answer.label.clone();
        // Names of scales keep their capitals.
        if label.chars().nth(1).is_some_and(char::is_lowercase)
            && let Some(first) = label.get_mut(..1)
        {
            first.make_ascii_lowercase();
        }
        // A prescribed figure has no error.
        let error = answer.error.bound().filter(|error| *error > 0.0);
        let limit = |value: f64| format!("{} {unit}", significant(factor * value, 3));
        let bound = match (answer.at_least, answer.at_most) {
            (Some(least), Some(most)) => {
                format!("  {} to {}", significant(factor * least, 3), limit(most))
            }
            (Some(least), None) => format!("  ≥ {}", limit(least)),
            (None, Some(most)) => format!("  ≤ {}", limit(most)),
            (None, None) => String::new(),
        };
        let bound = bound.trim_end().to_owned();
        let error =
            error.map_or(bound, |error| format!("  ± {} %", significant(100.0 * error, 2)));
        let beside = match (answer.elastic, answer.value, &answer.place) {
            (Some(elastic), value, _) => {
                let ratio = value.filter(|_| elastic > 0.0);
                let ratio = ratio.map(|value| format!("{:.3}", value / elastic));
                format!("{:>11}{:>8}{error}", shown(elastic), ratio.unwrap_or_default())
            }
            (None, Some(_), Some(place)) if error.is_empty() => {
                let y = place.y.map_or_else(String::new, |y| format!(", y {}", significant(y, 3)));
                format!(
                    "  at {} {}{y}, depth {}",
                    self.names.abscissa(),
                    significant(place.x, 3),
                    significant(place.depth, 3)
                )
            }
            (None, ..) if error.is_empty() => String::new(),
            (None, ..) => format!("{:>19}{error}", ""),
        };
        let name = format!("{label:28}{unit:>6}");
        if answer.value.is_none() && !answer.text.is_empty() {
            let label = format!("{name}{plain}  ");
            return self.line(&wrapped(&label, &words(&answer.text), " "));
        }
        let width = format!("{name}{plain}{beside}").trim_end().chars().count();
        if width <= WIDTH {
            self.line(format!("{name}{value}{beside}").trim_end());
        } else {
            self.line(&format!("{name}{value}"));
            self.line(&format!("{:>WIDTH$}", beside.trim()));
        }
    }

    fn plastic_zone(&mut self, name: &str, zone: Option<&PlasticityReport>) {
        let text = match zone {
            None => "rigid".to_owned(),
            Some(zone) if !zone.yielded => "elastic throughout".to_owned(),
            Some(zone) => self.yielded(zone),
        };
        self.line(&wrapped(&format!("{name}  "), &words(&text), " "));
    }

    /// How much has yielded, and where most; a strain without a limit has no place.
    fn yielded(&self, zone: &PlasticityReport) -> String {
        let length = self.names.length;
        let size = zone.volume.map_or_else(
            || format!("{} {length}²", significant(zone.area, 3)),
            |volume| format!("{} {length}³", significant(volume, 3)),
        );
        let Some(strain) = zone.max_equivalent_plastic_strain else {
            let mean = significant(100.0 * zone.mean_equivalent_plastic_strain, 3);
            return format!("plastic zone {size}; mean strain {mean} %");
        };
        let [strain, x, depth] =
            [100.0 * strain, zone.position, zone.depth].map(|figure| significant(figure, 3));
        let place = match zone.position_y {
            Some(y) => format!("x {x}, y {}", significant(y, 3)),
            None => format!("{} {x}", self.names.abscissa()),
        };
        format!("plastic zone {size}; strain up to {strain} % at {place}, depth {depth} {length}")
    }

    /// Writes which surfaces yielded in reverse, and the work.
    fn flow(&mut self, flow: &FlowReport) {
        let surfaces = &flow.surfaces;
        for (name, surface) in [("upper", &surfaces.upper), ("lower", &surfaces.lower)] {
            if surface.as_ref().is_some_and(|surface| surface.yielded_in_reverse) {
                self.line(&format!("{name}  yielded in reverse"));
            }
        }
        let energy = &flow.energy;
        let stored = if energy.stored > 0.0 {
            format!(", stored by backstress {}", significant(energy.stored, 3))
        } else {
            String::new()
        };
        let text = format!(
            "{} {}: elastic {}, dissipated {}{stored}",
            significant(energy.work, 4),
            self.names.work,
            significant(energy.elastic, 3),
            significant(energy.dissipated, 3),
        );
        self.line(&wrapped("work   ", &words(&text), " "));
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
    for (number, (name, time)) in
        phases.into_iter().filter(|(_, time)| *time > 0.0).take(4).enumerate()
    {
        let separator = if number == 0 { ": " } else { ", " };
        let _ = write!(text, "{separator}{name} {}", significant(time, 2));
    }
    text
}
