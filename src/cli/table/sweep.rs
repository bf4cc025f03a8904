//! The loads of a sweep as a table of one line each.

use super::number::significant;
use super::text::Names;
use crate::cli::style::Style;
use brinell_solver::report::{Name, StepReport};
use brinell_solver::solver::SolveStatus;

/// Most loads that are shown one below the other, each as a whole.
pub(super) const WHOLE: usize = 3;

/// The main figures of each load.
pub(super) fn sweep(steps: &[StepReport], names: Names, style: Style) -> String {
    let Names { length, stress, force, .. } = names;
    let of = |name: &str, unit: &str| format!("{name} {unit}");
    let mut text = style.dim(&format!(
        "{:>4} {:>13} {:>12} {:>10} {:>13} {:>8}\n",
        "step",
        of("force", force),
        of("approach", length),
        of("peak", stress),
        of("half-width", length),
        "strain %",
    ));
    for (number, step) in (1..).zip(steps) {
        text.push_str(&row(number, step, style));
    }
    text
}

fn row(number: usize, step: &StepReport, style: Style) -> String {
    let shown =
        |figure: Option<f64>| figure.map_or_else(|| "—".to_owned(), |it| significant(it, 5));
    let status = match step.status {
        SolveStatus::Converged => String::new(),
        SolveStatus::NotConverged => style.red("  NOT CONVERGED"),
        SolveStatus::Cancelled => style.yellow("  cancelled"),
        SolveStatus::TimedOut => style.yellow("  timed out"),
    };
    format!(
        "{number:>4} {:>13} {:>12} {:>10} {:>13} {:>8}{status}\n",
        shown(step.value(Name::Force)),
        shown(step.value(Name::Approach)),
        shown(step.value(Name::PeakPressure)),
        shown(step.value(Name::HalfWidth).or(step.value(Name::SemiAxisA))),
        shown(step.value(Name::MaxPlasticStrain).map(|strain| 100.0 * strain)),
    )
}
