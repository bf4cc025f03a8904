//! The iteration history as a table: a line for every iteration, or for every increment of a load
//! that is divided.

use super::number::significant;
use super::text::folded;
use crate::cli::style::Style;
use crate::jobs::IterationRecord;

/// The history, its middle left out when it is long.
pub(super) fn history(records: &[IterationRecord], style: Style) -> String {
    let lines: Vec<&[IterationRecord]> = if records.iter().any(|record| record.increment.is_some())
    {
        records.chunk_by(|a, b| a.increment == b.increment).collect()
    } else {
        records.chunks(1).collect()
    };
    let is_divided = lines.len() < records.len();
    let head = format!(
        "{:>4} {:>5} {:>4} {:>4} {:>7} {:>7} {:>8} {:>7} {:>5} {:>11} {:>8}",
        if is_divided { "inc" } else { "iter" },
        if is_divided { "iter" } else { "pivot" },
        "upd",
        "fact",
        "Δu",
        "ΔR",
        "residual",
        "plastic",
        "pairs",
        "approach",
        "peak"
    );
    let shown = |index: usize| {
        let Some(last) = lines[index].last() else { return String::new() };
        let numbers = match &last.increment {
            Some(increment) if is_divided => [increment.number, lines[index].len()],
            _ => [last.iteration, last.contact_pivots],
        };
        row(numbers, lines[index], last)
    };
    format!("{}\n", style.dim(&head)) + &folded(lines.len(), style, shown)
}

/// The work of these iterations, and the state after the last of them.
fn row([number, count]: [usize; 2], line: &[IterationRecord], last: &IterationRecord) -> String {
    format!(
        "{:>4} {:>5} {:>4} {:>4} {:>7.1e} {:>7.1e} {:>8.1e} {:>7} {:>5} {:>11} {:>8}\n",
        number,
        count,
        line.iter().map(|record| record.initial_stress_updates).sum::<usize>(),
        line.iter().map(|record| record.factorizations).sum::<usize>(),
        last.displacement_change,
        last.force_change,
        last.equilibrium_residual,
        last.plastic_points,
        last.contact_pairs,
        significant(last.approach, 5),
        significant(last.peak_pressure, 5),
    )
}
