//! The passes of a load that rolls as a table, its middle left out when it is long.

use super::number::significant;
use crate::cli::style::Style;
use brinell_solver::report::{BodyPassReport, PassReport, PerBody};

/// Longest table that is shown whole, and how much of a longer one is shown at each end.
const WHOLE: usize = 14;
const ENDS: usize = 6;

/// The passes, with the figures of the body that yields more.
pub(super) fn passes(passes: &[PassReport], length: &str, stress: &str, style: Style) -> String {
    let mut text = style.dim(&format!(
        "{:>4} {:>5} {:>10} {:>10} {:>11} {:>11} {:>9} {:>10}\n",
        "pass",
        "iter",
        "strain %",
        "net %",
        format!("forward {length}"),
        format!("track {length}"),
        format!("peak {stress}"),
        "loss"
    ));
    let left_out = if passes.len() > WHOLE { passes.len() - 2 * ENDS } else { 0 };
    for (index, pass) in passes.iter().enumerate() {
        if left_out > 0 && index == ENDS {
            text.push_str(&style.dim(&format!("   … {left_out} more\n")));
        }
        if left_out == 0 || index < ENDS || index >= ENDS + left_out {
            text.push_str(&row(pass));
        }
    }
    text
}

fn row(pass: &PassReport) -> String {
    let PerBody { upper, lower } = &pass.bodies;
    let bodies = [lower, upper].into_iter().flatten();
    let strained = bodies.reduce(|a, b| if b.largest_strain > a.largest_strain { b } else { a });
    let figure = |of: fn(&BodyPassReport) -> f64| {
        strained.map_or_else(|| "—".to_owned(), |body| significant(of(body), 4))
    };
    format!(
        "{:>4} {:>5} {:>10} {:>10} {:>11} {:>11} {:>9} {:>10}\n",
        pass.number,
        pass.iterations,
        figure(|body| 100.0 * body.largest_strain),
        figure(|body| 100.0 * body.net_strain),
        figure(|body| body.forward),
        figure(|body| body.groove_depth),
        significant(pass.peak_pressure, 5),
        significant(pass.loss, 3),
    )
}
