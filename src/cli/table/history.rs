//! The iteration history as a table.

use super::number::significant;
use crate::cli::style::Style;
use crate::jobs::IterationRecord;

/// Longest table that is shown whole, and how much of a longer one is shown at each end.
const WHOLE: usize = 12;
const ENDS: usize = 5;

/// The history, its middle left out when it is long.
pub(super) fn history(records: &[IterationRecord], style: Style) -> String {
    let head = format!(
        "{:>4} {:>5} {:>4} {:>4} {:>8} {:>8} {:>8} {:>7} {:>5} {:>9} {:>8}",
        "iter", "pivot", "upd", "fact", "Δu", "ΔR", "residual", "plastic", "pairs", "approach", "peak"
    );
    let mut text = format!("{}\n", style.dim(&head));
    let left_out = if records.len() > WHOLE { records.len() - 2 * ENDS } else { 0 };
    for (index, record) in records.iter().enumerate() {
        if left_out > 0 && index == ENDS {
            text.push_str(&style.dim(&format!("   … {left_out} more\n")));
        }
        if left_out == 0 || index < ENDS || index >= ENDS + left_out {
            text.push_str(&row(record));
        }
    }
    text
}

fn row(record: &IterationRecord) -> String {
    format!(
        "{:>4} {:>5} {:>4} {:>4} {:>8.1e} {:>8.1e} {:>8.1e} {:>7} {:>5} {:>9} {:>8}\n",
        record.iteration,
        record.contact_pivots,
        record.initial_stress_updates,
        record.factorizations,
        record.displacement_change,
        record.force_change,
        record.equilibrium_residual,
        record.plastic_points,
        record.contact_pairs,
        significant(record.approach, 5),
        significant(record.peak_pressure, 5),
    )
}
