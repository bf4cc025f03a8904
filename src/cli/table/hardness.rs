//! The answer of a hardness test as a table.

use std::fmt::Write;

use super::number::significant;
use super::text::{words, wrapped};
use crate::cli::style::Style;
use brinell_solver::report::HardnessReport;

/// The number with its bar and its bias, then what was measured.
pub(super) fn hardness(
    found: &HardnessReport,
    length: &str,
    stress: &str,
    style: Style,
) -> String {
    let percent = |part: f64| significant(100.0 * part, 2);
    let points = || found.number_error.map(|error| format!(" ± {}", significant(error, 2)));
    let bar = found.relative_error.map(|error| format!(" ± {} %", percent(error)));
    let bar = bar.or_else(points).unwrap_or_default();
    let (value, unit) = match found.number {
        Some(number) => (number, String::new()),
        None => (found.mean_pressure, format!(" {stress}")),
    };
    let value = style.bold(&format!("{}{unit}", significant(value, 4)));
    let mut text = format!("{}  {value}{bar}\n", found.test);
    if let (Some(bias), Some(source)) = (found.bias, &found.bias_source) {
        let bias = if bias < 0.0 { percent(bias) } else { format!("+{}", percent(bias)) };
        text.push_str(&wrapped(
            "       ",
            &words(&format!("mean pressure {bias} % against {source}")),
            " ",
        ));
        text.push('\n');
    }
    let pharr = found.oliver_pharr.as_ref();
    let rows = [
        ("diameter under load", Some(found.diameter), length),
        ("depth under load", Some(found.depth), length),
        ("depth that is left", found.permanent_depth, length),
        ("pile-up of the edge", Some(found.pile_up), length),
        ("mean pressure", Some(found.mean_pressure), stress),
        ("flow stress at Tabor's strain", found.flow_stress, stress),
        ("mean pressure over it", found.constraint, ""),
        ("Meyer's exponent", found.meyer_exponent, ""),
        ("E* by Oliver and Pharr", pharr.map(|pharr| pharr.reduced_modulus), stress),
        ("hardness by Oliver and Pharr", pharr.map(|pharr| pharr.indentation_hardness), stress),
    ];
    for (label, value, unit) in rows {
        if let Some(value) = value {
            let value = significant(value, 5);
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{label:30}{unit:>5}{value:>12}");
        }
    }
    text
}
