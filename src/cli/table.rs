//! A report as plain text for a person, at most 80 columns wide.

mod bodies;
mod history;
mod number;
mod passes;
mod plot;
mod sweep;
mod text;
mod tolerances;

use std::fmt::Write;

use super::style::Style;
use brinell_solver::job::{Job, Load, Quantity};
use brinell_solver::report::{
    Answer, AnswerBody, ErrorBar, LoadReport, Mark, Name, Report, StepReport, Timings,
};
use brinell_solver::solver::SolveStatus;
pub(super) use number::significant;
use text::{Names, WIDTH, words, wrapped};

/// Lays a report out as text. `job` is what was asked; a search shows the job that it found. Of a
/// long sweep it shows a line for each load, or one `step` as a whole.
pub fn table(job: &Job, report: &Report, step: Option<usize>, style: Style) -> String {
    let found = report.found.as_ref();
    let found = found.and_then(|found| job.varied(&found.vary, *found.values.first()?).ok());
    let job = found.as_ref().unwrap_or(job);
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
        if !report.answers.is_empty() {
            self.rows(&report.answers);
            if let Some(found) = &report.found {
                self.line(&wrapped("", &words(&found.text), " "));
            }
        }
        for note in &report.validity {
            self.remark(&note.message);
        }
        if !(report.answers.is_empty() && report.validity.is_empty()) {
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
        if let (Some(told), Some(last)) = (&report.tolerances, report.steps.last()) {
            self.line("");
            self.text.push_str(&tolerances::tolerances(told, &last.answers, self.style));
            self.line(&wrapped("", &words(&told.text), " "));
        }
        self.line("");
        let mesh = &report.mesh;
        let half = if mesh.symmetric { " of one half" } else { "" };
        let elements = if mesh.cells.is_some() { "cells" } else { "elements" };
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
        let verdict = &step.verdict;
        let text = wrapped("", &words(&verdict.text), " ");
        let text = match verdict.mark {
            Mark::Bad => style.red(&text),
            Mark::Attention => style.yellow(&text),
            Mark::Good => style.green(&text),
            Mark::Unknown => text,
        };
        self.line(&text);
        self.line("");
        self.rows(&step.answers);
        let picture = plot::pressure(step, self.names, style);
        if !picture.is_empty() {
            self.line("");
            self.text.push_str(&picture);
        }
        self.line("");
        if let Some(passes) = &step.passes {
            let Names { length, stress, .. } = self.names;
            self.text.push_str(&passes::passes(passes, length, stress, style));
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

    /// Writes the rows that answer the job, each with its elastic reference or its place, and its
    /// error bar; how many more there are, and from where the approach is counted.
    fn rows(&mut self, rows: &[Answer]) {
        let shown = || rows.iter().filter(|row| !row.detail);
        if shown().any(|row| row.elastic.is_some()) {
            let head = format!("{:34}{:>12}{:>11}{:>8}", "", "this contact", "Hertz", "ratio");
            self.line(&self.style.dim(&head));
        }
        for row in shown() {
            self.answer(row);
        }
        let approach = rows.iter().find(|row| row.is(Name::Approach) && !row.text.is_empty());
        if let Some(approach) = approach.filter(|row| !self.said.contains(&row.text)) {
            let text = wrapped("approach: ", &words(&approach.text), " ");
            self.line(&self.style.dim(&text));
            self.said.push(approach.text.clone());
        }
        let more = rows.len() - shown().count();
        if more > 0 {
            let rows = if more == 1 { "row" } else { "rows" };
            self.line(&self.style.dim(&format!("{more} more {rows}: --format json")));
        }
    }

    fn answer(&mut self, answer: &Answer) {
        let is_part = matches!(answer.quantity, Quantity::Strain | Quantity::Ratio);
        let (factor, unit) = if is_part { (100.0, "%") } else { (1.0, answer.unit.as_str()) };
        let shown = |value: f64| significant(factor * value, 5);
        let value = answer.value.map_or_else(|| "—".to_owned(), shown);
        let plain = format!("{value:>12}");
        let value = self.style.bold(&plain);
        let limit = |value: f64| format!("{} {unit}", significant(factor * value, 3));
        let bound = match (answer.at_least, answer.at_most) {
            (Some(least), Some(most)) => {
                format!("  {} to {}", significant(factor * least, 3), limit(most))
            }
            (Some(least), None) => format!("  ≥ {}", limit(least)),
            (None, Some(most)) => format!("  ≤ {}", limit(most)),
            (None, None) => String::new(),
        };
        let error = match answer.error {
            ErrorBar::Relative(error) => format!("  ± {} %", significant(100.0 * error, 2)),
            ErrorBar::Word(_) => bound.trim_end().to_owned(),
        };
        let beside = match (answer.elastic, answer.value, &answer.place) {
            (Some(elastic), value, _) => {
                let ratio = value.filter(|_| elastic > 0.0);
                let ratio = ratio.map(|value| format!("{:.3}", value / elastic));
                format!("{:>11}{:>8}{error}", shown(elastic), ratio.unwrap_or_default())
            }
            (None, Some(_), Some(place)) if error.is_empty() => {
                let y = place.y.map_or_else(String::new, |y| format!(", y {}", significant(y, 3)));
                let body = match (answer.body, place.body) {
                    (None, AnswerBody::Upper) if place.depth > 0.0 => ", upper",
                    (None, AnswerBody::Lower) if place.depth > 0.0 => ", lower",
                    _ => "",
                };
                format!(
                    "  at {} {}{y}, depth {}{body}",
                    self.names.abscissa(),
                    significant(place.x, 3),
                    significant(place.depth, 3)
                )
            }
            (None, ..) if error.is_empty() => String::new(),
            (None, ..) => format!("{:>19}{error}", ""),
        };
        let label = &answer.label;
        let width = 34_usize.saturating_sub(label.chars().count()).max(unit.chars().count() + 1);
        let name = format!("{label}{unit:>width$}");
        if let (None, Some(reason)) = (answer.value, &answer.reason) {
            let label = format!("{name}{plain}  ");
            return self.line(&wrapped(&label, &words(reason), " "));
        }
        let width = format!("{name}{plain}{beside}").trim_end().chars().count();
        if width <= WIDTH {
            self.line(format!("{name}{value}{beside}").trim_end());
        } else {
            self.line(&format!("{name}{value}"));
            self.line(&format!("{:>WIDTH$}", beside.trim()));
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
    for (number, (name, time)) in
        phases.into_iter().filter(|(_, time)| *time > 0.0).take(4).enumerate()
    {
        let separator = if number == 0 { ": " } else { ", " };
        let _ = write!(text, "{separator}{name} {}", significant(time, 2));
    }
    text
}
