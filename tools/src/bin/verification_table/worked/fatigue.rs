//! `docs/fatigue.md`

use std::fmt::Write;

use brinell_solver::report::{Answer, AnswerBody, FatigueCriterion, Name, StepReport};
use serde_json::{Value, json};

use super::example::{Computed, Example, shipped, solve};

pub const EXAMPLE: Example = Example {
    document: "fatigue.md",
    blocks: &[("raceway", raceway), ("rail", rail), ("flank", flank)],
};

const CRITERIA: [(FatigueCriterion, &str); 3] = [
    (FatigueCriterion::DangVan, "Dang Van"),
    (FatigueCriterion::Crossland, "Crossland"),
    (FatigueCriterion::OrthogonalShear, "orthogonal shear"),
];

/// A row of the lower body by a criterion.
fn row(step: &StepReport, name: Name, criterion: FatigueCriterion) -> Option<&Answer> {
    step.answers.iter().find(|row| {
        row.is(name)
            && row.at.and_then(|at| at.criterion) == Some(criterion)
            && row.body != Some(AnswerBody::Upper)
    })
}

/// Utilization and depth by all criteria as cells of a table, by the rule of the verdict.
fn cells(step: &StepReport) -> String {
    let cell = |(criterion, _): (FatigueCriterion, &str)| {
        let used = row(step, Name::FatigueUtilization, criterion).filter(|row| !row.detail);
        used.and_then(|row| Some((row.value?, row.place?.depth))).map_or_else(
            || " – |".to_owned(),
            |(value, z)| format!(" {:.0} %, {z:.3} |", 100.0 * value),
        )
    };
    CRITERIA.map(cell).concat()
}

/// The first step of a job.
fn step(job: &Value) -> Result<StepReport, Box<dyn std::error::Error>> {
    solve(job)?.steps.into_iter().next().ok_or_else(|| "no step".into())
}

/// The raceway before and after it has run in.
fn raceway(_: &Value) -> Computed {
    let mut job = shipped("ball_runs_in")?;
    job["lower"]["material"]["fatigue"] = json!({"torsion": 480, "bending": 800});
    job["load"]["rolling"]["hardening"] = json!("isotropic");
    let step = step(&job)?;
    let mut table = "| criterion | elastic | run in | depth [mm] | of residual stress | life |\n\
                     |---|--:|--:|--:|--:|--:|\n"
        .to_owned();
    for (criterion, word) in CRITERIA {
        let used = row(&step, Name::FatigueUtilization, criterion).ok_or("no utilization")?;
        let part = row(&step, Name::FatigueOfResidualStress, criterion).and_then(|row| row.value);
        let part = part.map_or_else(|| "–".to_owned(), |part| format!("{:.0} %", 100.0 * part));
        let life = row(&step, Name::RelativeLife, criterion).ok_or("no life")?;
        writeln!(
            table,
            "| {word} | {:.0} % | {:.0} % | {:.3} | {part} | {:.1} to {:.1} |",
            100.0 * used.elastic.ok_or("no Hertz")?,
            100.0 * used.value.ok_or("no value")?,
            used.place.ok_or("no place")?.depth,
            life.at_least.ok_or("no life")?,
            life.at_most.ok_or("no life")?,
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
        let step = step(&job)?;
        let level: &str = step.verdict.level.into();
        writeln!(table, "| {friction} | {} |{}", level.replace('_', " "), cells(&step))?;
    }
    Ok(table)
}

/// A flank with and without the residual stress of its case.
fn flank(_: &Value) -> Computed {
    let mut job = shipped("rolled_hardened_roller")?;
    job["lower"]["material"]["fatigue"] = json!({"from_hardness": true});
    let mut table = "| force [N/mm] | Hertz [MPa] | residual stress | Dang Van, depth [mm] | \
                     Crossland | orthogonal shear |\n\
                     |--:|--:|---|--:|--:|--:|\n"
        .to_owned();
    for force in [270.0, 400.0, 800.0] {
        job["load"]["rolling"]["force"] = json!(force);
        for word in ["of the case", "none"] {
            let mut job = job.clone();
            if word == "none" {
                job["lower"]["material"]["initial_stress"] = Value::Null;
            }
            let step = step(&job)?;
            let hertz = step.elastic(Name::PeakPressure).unwrap_or_default();
            writeln!(table, "| {force} | {hertz:.0} | {word} |{}", cells(&step))?;
        }
    }
    Ok(table)
}
