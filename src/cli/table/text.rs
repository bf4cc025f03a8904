//! Units, words and lines of a table.

use crate::cli::style::Style;
use brinell_solver::job::{Analysis, Job, Quantity};

/// Widest line.
pub(super) const WIDTH: usize = 80;
/// How much of a long table is shown at each end.
const ENDS: usize = 5;

/// Lines of a table, its middle left out when it is long.
pub(super) fn folded(count: usize, style: Style, line: impl Fn(usize) -> String) -> String {
    let left_out = if count > 2 * ENDS + 2 { ENDS..count - ENDS } else { 0..0 };
    let shown = (0..count).filter(|index| !left_out.contains(index));
    let with_note = |index| {
        let note = if index > 0 && index == left_out.end {
            style.dim(&format!("   … {} more\n", left_out.len()))
        } else {
            String::new()
        };
        note + &line(index)
    };
    shown.map(with_note).collect()
}

/// How units and figures are written, which depends on whether the bodies are turned about an
/// axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Names {
    pub length: &'static str,
    pub stress: &'static str,
    pub force: &'static str,
    pub is_round: bool,
}

impl Names {
    pub fn of(job: &Job) -> Self {
        let is_round = job.analysis == Analysis::Axisymmetric;
        let force = job.analysis.force().quantity();
        let [length, stress, force] =
            [Quantity::Length, Quantity::Stress, force].map(|quantity| job.units.symbol(quantity));
        Self { length, stress, force, is_round }
    }

    /// Places along the surface.
    pub fn abscissa(self) -> &'static str {
        if self.is_round { "r" } else { "x" }
    }
}

/// Words of a text.
pub(super) fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(str::to_owned).collect()
}

/// Items after a label, broken into lines that are indented like the first.
pub(super) fn wrapped(label: &str, items: &[String], separator: &str) -> String {
    let indent = label.chars().count();
    let (mut text, mut column) = (label.to_owned(), indent);
    for (number, item) in items.iter().enumerate() {
        let width = item.chars().count();
        // What separates an item from the next one stays on its line.
        let rest = if number + 1 < items.len() { separator.trim_end().len() } else { 0 };
        if number > 0 {
            if column + separator.len() + width + rest > WIDTH {
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
