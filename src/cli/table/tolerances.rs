//! What tolerances of inputs do to the figures, a line for each that answers the job.

use super::number::significant;
use crate::cli::style::Style;
use brinell_solver::report::{Answer, TolerancesReport};

/// The figures that have a row which answers the job. `rows` are those of the last step.
pub(super) fn tolerances(told: &TolerancesReport, rows: &[Answer], style: Style) -> String {
    let mut text = String::new();
    for (number, (input, part)) in told.inputs.iter().zip(&told.relative).enumerate() {
        let part = significant(100.0 * part, 3);
        text.push_str(&style.dim(&format!("({}) {input} ± {part} %\n", number + 1)));
    }
    let inputs = (1..=told.inputs.len()).map(|number| format!("{:>8}", format!("({number})")));
    let inputs: String = inputs.collect();
    let head = format!("{:34}{:>12}{:>12}{inputs}\n", "± % by tolerances", "squares", "at worst");
    text.push_str(&style.dim(&head));
    for (at, name) in told.name.iter().enumerate() {
        if !rows.iter().any(|row| row.name == *name && !row.detail) {
            continue;
        }
        let shown = |value: Option<f64>, factor: f64| {
            value.map_or_else(|| "—".to_owned(), |value| significant(factor * value, 3))
        };
        let elasticities = told.elasticities[at].iter();
        let elasticities: Vec<_> =
            elasticities.map(|one| format!(" {:>7}", shown(*one, 1.0))).collect();
        let (squares, worst) = (told.root_of_squares[at], told.at_worst[at]);
        let [squares, worst] = [squares, worst].map(|value| shown(value, 100.0));
        let label = &told.label[at];
        let line = format!("{label:34}{squares:>12}{worst:>12}{}\n", elasticities.concat());
        text.push_str(&line);
    }
    text
}
