//! `docs/case_hardened_roller.md`

use std::error::Error;
use std::fmt::Write;

use brinell_solver::report::{Name, StepReport, SubsurfaceReport};
use serde_json::{Value, json};

use super::example::{Computed, Example, answer, solve};

pub const EXAMPLE: Example = Example {
    document: "case_hardened_roller.md",
    blocks: &[("tilt", tilt), ("depth of the case", depth_of_the_case)],
};

const TILTS: [i32; 4] = [0, 1, 2, 3];

/// The roller tilted by so many mrad, with a case of that depth [mm].
fn tilted(job: &Value, tilt: i32, case: f64) -> Result<StepReport, Box<dyn Error>> {
    let mut job = job.clone();
    job["upper"]["shape"]["tilt"] = json!(tilt);
    job["upper"]["material"]["plasticity"]["over_depth"]["hardness"]["case_depth"] = json!(case);
    solve(&job)?.steps.pop().ok_or_else(|| "no step".into())
}

fn tilt(job: &Value) -> Computed {
    let mut table =
        "| tilt [mrad] | peak [MPa] | at y [mm] | pressure of the ends [MPa] | moment [N mm] |\n\
         |--:|--:|--:|--:|--:|\n"
            .to_owned();
    for tilt in TILTS {
        let step = tilted(job, tilt, 0.8)?;
        let along = step.contact.along.as_ref().ok_or("no roller")?;
        let [low, high] =
            [along.pressure.first(), along.pressure.last()].map(|end| end.copied().unwrap_or(0.0));
        let place = step.row(Name::PeakPressure).and_then(|row| row.place).ok_or("no place")?;
        writeln!(
            table,
            "| {tilt} | {:.0} | {:.2} | {low:.0}, {high:.0} | {:.0} |",
            step[Name::PeakPressure],
            place.y.unwrap_or(0.0),
            step[Name::Moment].round() + 0.0
        )?;
    }
    Ok(table)
}

/// The largest utilization along a normal of the roller, and its depth.
fn largest(line: Option<&SubsurfaceReport>) -> Option<(f64, f64)> {
    let line = line?;
    let points = line.utilization.as_ref()?.iter().copied().zip(line.depth.iter().copied());
    points.max_by(|(one, _), (other, _)| one.total_cmp(other))
}

fn depth_of_the_case(job: &Value) -> Computed {
    let mut table =
        "| tilt [mrad] | case [mm] | middle | depth | below the peak | depth | core | largest ε_p |\n\
         |--:|--:|--:|--:|--:|--:|--:|--:|\n"
            .to_owned();
    let shown = |found: Option<(f64, f64)>| {
        found.map_or_else(|| " | ".to_owned(), |(part, depth)| format!("{part:.3} | {depth:.2}"))
    };
    for case in [0.8, 0.4] {
        for tilt in TILTS {
            let step = tilted(job, tilt, case)?;
            let middle = step.subsurface.as_ref().and_then(|line| line.upper.as_ref());
            let below = step.subsurface_below_peak.as_ref();
            let below = below.and_then(|line| line.upper.as_ref());
            writeln!(
                table,
                "| {tilt} | {case} | {} | {} | {:.3} | {:.2} % |",
                shown(largest(middle)),
                shown(largest(below)),
                answer(&step, "core_utilization")?,
                100.0 * step.value(Name::MaxPlasticStrain).unwrap_or(0.0)
            )?;
        }
    }
    Ok(table)
}
