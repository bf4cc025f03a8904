//! What tolerances of inputs do to every figure: by central differences, two solves an input.

use super::document::TolerancesReport;
use super::trials::{Trials, elasticity, refused, rows, words};
use crate::job::{Job, Named as _, Side, Tolerance};
use crate::report::{Answer, AnswerBody, RunError};
use crate::units::percent;

/// Solves a job beside itself and returns what its tolerances do to its rows.
///
/// # Errors
/// Those of a solve.
pub fn tolerances(
    job: &Job,
    tolerances: &[Tolerance],
    of_job: &[Answer],
    trials: &mut Trials<'_>,
) -> Result<TolerancesReport, RunError> {
    let beside: Vec<[Vec<Answer>; 2]> = tolerances
        .iter()
        .map(|one| {
            let number = job.number_at(&one.pointer).unwrap_or_default();
            let mut at = |part: f64| {
                let pointers = [one.pointer.clone()];
                let varied = job.varied(&pointers, part * number);
                let varied = varied.map_err(|fault| refused("/tolerances", words(&fault)))?;
                trials.solve(varied).map(|report| rows(&report))
            };
            Ok([at(1.0 - one.change())?, at(1.0 + one.change())?])
        })
        .collect::<Result<_, RunError>>()?;
    let mut told = TolerancesReport {
        inputs: tolerances.iter().map(|one| one.pointer.clone()).collect(),
        relative: tolerances.iter().map(|one| one.relative).collect(),
        ..TolerancesReport::default()
    };
    let of_bodies: Vec<Answer> = of_job.iter().flat_map(|row| of_bodies(row, &beside)).collect();
    for effect in of_bodies.iter().filter_map(|row| effect(row, tolerances, &beside)) {
        if told.text.is_empty() && effect.at_worst > Some(0.0) {
            told.text = most(tolerances, &effect);
        }
        told.name.push(effect.row.name.clone());
        told.label.push(effect.row.label.clone());
        told.body.push(effect.row.body);
        told.error.push(effect.row.error.bound());
        told.elasticities.push(effect.elasticities);
        told.at_worst.push(effect.at_worst);
        told.root_of_squares.push(effect.root_of_squares);
    }
    Ok(told)
}

/// Returns a row of both bodies as one of each, where another number makes them differ.
fn of_bodies(row: &Answer, beside: &[[Vec<Answer>; 2]]) -> Vec<Answer> {
    let is_whole = |rows: &Vec<Answer>| rows.iter().any(|other| other.is_alike(row));
    if row.body != Some(AnswerBody::Both) || beside.iter().flatten().all(is_whole) {
        return vec![row.clone()];
    }
    let of = |side: Side| Answer {
        body: Some(AnswerBody::from(side)),
        label: format!("{}, {}", row.label, side.name()),
        ..row.clone()
    };
    Side::BOTH.map(of).into()
}

/// What tolerances do to one row.
struct Effect<'a> {
    row: &'a Answer,
    elasticities: Vec<Option<f64>>,
    /// The change by the tolerance of each input, the larger one of both senses.
    changes: Vec<Option<f64>>,
    at_worst: Option<f64>,
    root_of_squares: Option<f64>,
}

fn effect<'a>(
    row: &'a Answer,
    tolerances: &[Tolerance],
    beside: &[[Vec<Answer>; 2]],
) -> Option<Effect<'a>> {
    let value = row.value.filter(|value| *value != 0.0)?;
    let is_row = |other: &&Answer| {
        let is_body = other.body == row.body || other.body == Some(AnswerBody::Both);
        (&other.name, other.at) == (&row.name, row.at) && is_body
    };
    let at = |rows: &[Answer]| rows.iter().find(is_row)?.value;
    let pairs = tolerances.iter().zip(beside);
    let elasticities: Vec<_> = pairs
        .map(|(one, [less, more])| {
            elasticity([1.0 - one.change(), 1.0 + one.change()], [at(less)?, at(more)?])
        })
        .collect();
    // Beside a kink, as where two bodies yield at once, one sense changes a figure more.
    let change = |(one, [less, more]): (&Tolerance, &[Vec<Answer>; 2])| {
        let of = |rows: &[Answer]| Some((at(rows)? / value - 1.0).abs());
        Some(of(less)?.max(of(more)?) * one.relative / one.change())
    };
    let each: Vec<Option<f64>> = tolerances.iter().zip(beside).map(change).collect();
    let changes: Option<Vec<f64>> = each.iter().copied().collect();
    let squares = |changes: &Vec<f64>| changes.iter().map(|one| one * one).sum::<f64>().sqrt();
    Some(Effect {
        row,
        at_worst: changes.as_ref().map(|changes| changes.iter().sum()),
        root_of_squares: changes.as_ref().map(squares),
        elasticities,
        changes: each,
    })
}

/// Returns which input matters most to a row.
fn most(tolerances: &[Tolerance], effect: &Effect<'_>) -> String {
    let changes = tolerances.iter().zip(&effect.changes);
    let changes = changes.map(|(one, of)| (one, of.unwrap_or_default()));
    let Some((one, change)) = changes.max_by(|one, other| one.1.total_cmp(&other.1)) else {
        return String::new();
    };
    let part = |of: Option<f64>| percent(of.unwrap_or_default());
    format!(
        "{}: {} matters most, whose {} are {}; all together {} as root of squares, {} at worst.",
        effect.row.label,
        one.pointer,
        percent(one.relative),
        percent(change),
        part(effect.root_of_squares),
        part(effect.at_worst)
    )
}
