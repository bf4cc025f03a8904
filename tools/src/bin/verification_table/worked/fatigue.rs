//! `docs/fatigue.md`

use std::fmt::Write;

use brinell_solver::report::{FatigueCriterion, Name, StepReport};
use serde_json::{Value, json};

use super::example::{Computed, Example, shipped, solve};

pub const EXAMPLE: Example = Example {
    document: "fatigue.md",
    blocks: &[("raceway", raceway), ("rail", rail), ("flank", flank)],
};

const CRITERIA: [FatigueCriterion; 3] =
    [FatigueCriterion::DangVan, FatigueCriterion::Crossland, FatigueCriterion::OrthogonalShear];

/// The value of a row of the lower body by a criterion, and the depth of its place.
fn by(step: &StepReport, name: Name, criterion: FatigueCriterion) -> Option<(f64, f64)> {
    let of = step.answers.iter().find(|row| {
        row.is(name)
            && row.at.and_then(|at| at.criterion) == Some(criterion)
            && !row.label.contains("upper")
    });
    Some((of?.value?, of?.place.map_or(0.0, |place| place.depth)))
}

/// Utilization and depth of all criteria as cells of a table.
fn cells(step: &StepReport) -> String {
    let cell = |criterion: FatigueCriterion| match by(step, Name::FatigueUtilization, criterion) {
        Some((value, depth)) => format!(" {:.0} %, {depth:.3} |", 100.0 * value),
        None => " – |".to_owned(),
    };
    CRITERIA.map(cell).concat()
}

/// The raceway before and after it has run in.
fn raceway(_: &Value) -> Computed {
    let mut job = shipped("ball_runs_in")?;
    job["lower"]["material"]["fatigue"] = json!({"torsion": 480, "bending": 800});
    let report = solve(&job)?;
    let step = report.steps.first().ok_or("no step")?;
    let mut table = "| criterion | elastic | run in | depth [mm] | of residual stress | life |\n\
                     |---|--:|--:|--:|--:|--:|\n"
        .to_owned();
    for (criterion, word) in
        CRITERIA.into_iter().zip(["Dang Van", "Crossland", "orthogonal shear"])
    {
        let row = step.answers.iter().find(|row| {
            row.is(Name::FatigueUtilization)
                && row.at.and_then(|at| at.criterion) == Some(criterion)
        });
        let row = row.ok_or("no utilization")?;
        let (value, elastic) = (row.value.unwrap_or_default(), row.elastic.unwrap_or_default());
        let part = by(step, Name::FatigueOfResidualStress, criterion).map_or(0.0, |part| part.0);
        let life = step.answers.iter().find(|row| {
            row.is(Name::RelativeLife) && row.at.and_then(|at| at.criterion) == Some(criterion)
        });
        let life = life.and_then(|life| life.at_least.zip(life.at_most));
        let life =
            life.map_or_else(String::new, |(least, most)| format!("{least:.1} to {most:.1}"));
        writeln!(
            table,
            "| {word} | {:.0} % | {:.0} % | {:.3} | {:.0} % | {life} |",
            100.0 * elastic,
            100.0 * value,
            row.place.map_or(0.0, |place| place.depth),
            100.0 * part,
        )?;
    }
    writeln!(table, "\n> {}", step.verdict.text)?;
    Ok(table)
}

/// A rail under more and more traction.
fn rail(_: &Value) -> Computed {
    let mut job = shipped("rail_under_driven_wheel")?;
    job["lower"]["material"]["fatigue"] = json!({"torsion": 250, "bending": 400});
    let mut table =
        "| friction | becomes | Dang Van, depth [mm] | Crossland | orthogonal shear |\n\
                     |--:|---|--:|--:|--:|\n"
            .to_owned();
    for friction in [0.0, -0.1, -0.2, -0.3] {
        job["load"]["rolling"]["friction"] = json!(friction);
        let report = solve(&job)?;
        let step = report.steps.first().ok_or("no step")?;
        let level: &str = step.verdict.level.into();
        writeln!(table, "| {friction} | {} |{}", level.replace('_', " "), cells(step))?;
    }
    Ok(table)
}

/// A flank with and without the residual stress of its case.
fn flank(_: &Value) -> Computed {
    let mut job = shipped("rolled_hardened_roller")?;
    job["lower"]["material"]["fatigue"] = json!({"from_hardness": true});
    let mut table =
        "| force [N/mm] | Hertz [MPa] | residual stress | Dang Van, depth [mm] | Crossland | orthogonal shear |\n\
         |--:|--:|---|--:|--:|--:|\n"
            .to_owned();
    for force in [270.0, 400.0, 800.0] {
        job["load"]["rolling"]["force"] = json!(force);
        for is_stressed in [true, false] {
            let mut job = job.clone();
            if !is_stressed {
                job["lower"]["material"]["initial_stress"] = json!([]);
            }
            let report = solve(&job)?;
            let step = report.steps.first().ok_or("no step")?;
            let hertz = step.elastic(Name::PeakPressure).unwrap_or_default();
            let word = if is_stressed { "of the case" } else { "none" };
            writeln!(table, "| {force} | {hertz:.0} | {word} |{}", cells(step))?;
        }
    }
    Ok(table)
}
