//! `docs/rolling_bearing.md`

use std::collections::BTreeMap;
use std::fmt::Write;

use brinell_solver::report::{Course, Name};
use serde_json::Value;

use super::example::{Computed, Example, shipped, solve};

pub const EXAMPLE: Example =
    Example { document: "rolling_bearing.md", blocks: &[("passes", passes)] };

/// The first three passes and the last, of the lower body.
fn passes(_: &Value) -> Computed {
    let report = solve(&shipped("ball_runs_in")?)?;
    let passes = report.steps.first().and_then(|step| step.passes.as_ref()).ok_or("no passes")?;
    let mut table =
        "| pass | peak [MPa] | groove [µm] | pile-up [µm] | net strain | least σ_x, σ_z left [MPa] |\n\
         |---|---|---|---|---|---|\n"
            .to_owned();
    let last = passes.number.len().saturating_sub(1);
    for k in (0..=last).filter(|k| *k < 3 || *k == last) {
        let of = |columns: &BTreeMap<String, Course>, name: Name| {
            let word: &str = name.into();
            columns.get(word).and_then(|course| course.value.get(k).copied())
        };
        let of_pass = of(&passes.contact, Name::PeakPressure).ok_or("no pass")?;
        let body = |name: Name| of(&passes.lower, name).ok_or("the lower body yields");
        writeln!(
            table,
            "| {} | {:.1} | {:.4} | {:.4} | {:.1e} | {:.0}, {:.0} |",
            k + 1,
            of_pass,
            1e3 * body(Name::TrackDepth)?,
            1e3 * body(Name::PileUp)?,
            body(Name::NetStrain)?,
            body(Name::LeastSigmaX)?,
            body(Name::LeastSigmaZ)?,
        )?;
    }
    Ok(table)
}
