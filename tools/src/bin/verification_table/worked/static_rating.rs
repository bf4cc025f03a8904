//! `docs/static_rating.md`

use std::error::Error;
use std::fmt::Write;

use brinell_solver::report::Name;
use serde_json::{Value, json};

use super::example::{Computed, Example, answer, hertz, pressed, shipped, solve};

pub const EXAMPLE: Example = Example {
    document: "static_rating.md",
    blocks: &[
        ("limits", limits),
        ("dents on a flat", dents_on_a_flat),
        ("limit in the groove", limit_in_the_groove),
        ("dents in the groove", dents_in_the_groove),
    ],
};

/// Diameter of the rolling elements [mm].
const DIAMETER: f64 = 10.0;

/// The force that leaves the dent of the standard, Hertz's peak and the real peak; and the relative
/// error of the force.
fn limit(job: &Value) -> Result<([f64; 3], Option<f64>), Box<dyn Error>> {
    let report = solve(job)?;
    let (found, step) =
        (report.answers.first().ok_or("no force")?, report.steps.first().ok_or("no step")?);
    let force = found.value.ok_or("no force")?;
    Ok(([force, hertz(step)?, step[Name::PeakPressure]], found.error.bound()))
}

fn limits(_: &Value) -> Computed {
    let ([line, line_hertz, line_peak], _) = limit(&shipped("static_rating_roller")?)?;
    let ([ball, ball_hertz, ball_peak], _) = limit(&shipped("static_rating_ball")?)?;
    Ok(format!(
        "| | force | Hertz's peak pressure [MPa] | of the standard | real peak pressure [MPa] |\n\
         |---|--:|--:|--:|--:|\n\
         | roller | {line:.0} N/mm | {line_hertz:.0} | 4000 | {line_peak:.0} |\n\
         | ball | {ball:.0} N | {ball_hertz:.0} | 4200 | {ball_peak:.0} |\n"
    ))
}

/// A row: Hertz's peak, the force and the dent over the diameter.
fn dent(job: &Value, force: f64) -> Computed {
    let [under, after] = pressed(job, force)?;
    let left = answer(&after, "permanent_approach")? / DIAMETER;
    Ok(format!("{:.0} | {force} | {left:.2e}", hertz(&under)?))
}

fn dents(jobs: &[(&str, Value, &[f64])]) -> Computed {
    let mut table = "| | Hertz's peak pressure [MPa] | force | permanent approach / D |\n\
                     |---|--:|--:|--:|\n"
        .to_owned();
    for (name, job, forces) in jobs {
        for force in *forces {
            writeln!(table, "| {name} | {} |", dent(job, *force)?)?;
        }
    }
    Ok(table)
}

fn dents_on_a_flat(_: &Value) -> Computed {
    dents(&[
        (
            "roller [N/mm]",
            shipped("static_rating_roller")?,
            &[1764.3, 2178.2, 2401.4, 2880.6, 3681.1],
        ),
        ("ball [N]", shipped("static_rating_ball")?, &[452.7, 621.0, 718.9, 944.5, 1364.4]),
    ])
}

fn limit_in_the_groove(job: &Value) -> Computed {
    let mut table =
        "| cells | force [N] | error of the force | Hertz's peak [MPa] | real peak [MPa] |\n\
                     |--:|--:|--:|--:|--:|\n"
            .to_owned();
    for cells in [6, 10, 14] {
        let mut job = job.clone();
        job["mesh"] = json!({"elements_per_half_width": cells});
        let ([force, hertz, peak], bar) = limit(&job)?;
        let bar =
            bar.map_or_else(|| "not known".to_owned(), |bar| format!("{:.1} %", 100.0 * bar));
        writeln!(table, "| {cells} | {force:.0} | {bar} | {hertz:.0} | {peak:.0} |")?;
    }
    Ok(table)
}

fn dents_in_the_groove(job: &Value) -> Computed {
    dents(&[("ball [N]", job.clone(), &[4269.1, 5856.1, 6779.1, 7794.4, 8906.3])])
}
