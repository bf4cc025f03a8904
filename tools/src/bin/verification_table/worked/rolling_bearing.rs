//! `docs/rolling_bearing.md`

use std::fmt::Write;

use serde_json::Value;

use super::example::{Computed, Example, shipped, solve};

pub const EXAMPLE: Example =
    Example { document: "rolling_bearing.md", blocks: &[("passes", passes)] };

/// The first three passes and the last, of the lower body.
fn passes(_: &Value) -> Computed {
    let report = solve(&shipped("ball_runs_in")?)?;
    let rolled = report.steps.first().and_then(|step| step.rolling.as_ref()).ok_or("no passes")?;
    let mut table =
        "| pass | peak [MPa] | groove [µm] | pile-up [µm] | net strain | least σ_x, σ_z left [MPa] |\n\
         |---|---|---|---|---|---|\n"
            .to_owned();
    let last = rolled.passes.len() - 1;
    for pass in rolled.passes.iter().take(3).chain(rolled.passes.get(last.max(3))) {
        let body = pass.bodies.lower.as_ref().ok_or("the lower body yields")?;
        writeln!(
            table,
            "| {} | {:.1} | {:.4} | {:.4} | {:.1e} | {:.0}, {:.0} |",
            pass.number,
            pass.peak_pressure,
            1e3 * body.groove_depth,
            1e3 * body.pile_up,
            body.net_strain,
            body.least_sigma_x,
            body.least_sigma_z,
        )?;
    }
    Ok(table)
}
