//! Random searches: a figure is that of a hidden input, which the search has to find.

use brinell_solver::job::Job;
use brinell_solver::report::{self, Answer, ErrorBar, Report, RunError};
use brinell_solver::solver::{SolveStatus, Unobserved};
use serde_json::{Value, json};

/// Inputs that are sought, of those that a job has.
const INPUTS: [&str; 9] = [
    "/upper/shape/radius",
    "/lower/shape/radius",
    "/upper/shape/radius_x",
    "/upper/material/young_modulus",
    "/lower/material/young_modulus",
    "/upper/material/plasticity/yield_stress",
    "/lower/material/plasticity/yield_stress",
    "/load/force",
    "/load/approach",
];
/// Figures that are wanted.
const FIGURES: [&str; 8] = [
    "peak_pressure",
    "half_width",
    "semi_axis_a",
    "approach",
    "force",
    "mean_pressure",
    "max_plastic_strain",
    "utilization",
];
/// Ends of the search over the input of the job; the hidden input lies between.
const ENDS: [f64; 2] = [0.5, 2.0];
const HIDDEN: [f64; 2] = [0.6, 1.7];
/// Part of the wanted value that a figure without a bar may miss it by.
const NEAR: f64 = 1e-2;

/// Solves searches from one seed on until so many have a figure to look for; prints a line of JSON
/// for each and a summary. `draw` draws a job, what chooses its input and figure, and the hidden
/// input over that of the job, by a number between 0 and 1.
pub fn searches(count: u64, draw: impl Fn(u64) -> (Value, [u64; 2], f64)) {
    let (mut solves, mut found, mut ended) = (Vec::new(), 0, 0);
    for (seed, job, hidden) in
        (0..).filter_map(|seed| search(seed, draw(seed))).take(usize::try_from(count).unwrap_or(0))
    {
        let (told, looks) = outcome(&job, hidden);
        solves.extend(looks);
        found += usize::from(told["is_found"] == true);
        ended += usize::from(told.get("reason").is_some());
        println!("{}", json!({"seed": seed, "find": job["find"], "hidden": hidden, "told": told}));
    }
    solves.sort_unstable();
    let median = solves.get(solves.len() / 2);
    eprintln!(
        "{count} searches: {found} found, {ended} ended by a reason, median solves {median:?}"
    );
}

/// Returns a job that asks for an input and the hidden one; none of a seed whose job has no figure.
fn search(
    seed: u64,
    (mut job, [input, figure], part): (Value, [u64; 2], f64),
) -> Option<(u64, Value, f64)> {
    let inputs: Vec<_> = INPUTS.iter().filter(|input| job.pointer(input).is_some()).collect();
    let vary = **chosen(&inputs, input)?;
    let given = job.pointer(vary)?.as_f64()?;
    let hidden = given * (HIDDEN[0] + part * (HIDDEN[1] - HIDDEN[0]));
    let mut known = job.clone();
    *known.pointer_mut(vary)? = json!(hidden);
    let report = solved(&known).ok().filter(|report| report.status == SolveStatus::Converged)?;
    let rows = &report.steps.last()?.answers;
    let free = |row: &&Answer| {
        FIGURES.contains(&row.name.as_str())
            && row.body.is_none()
            && row.value.is_some_and(|value| value != 0.0)
            && row.error.bound().is_some_and(|bound| bound > 0.0)
    };
    let rows: Vec<_> = rows.iter().filter(free).collect();
    let row = *chosen(&rows, figure)?;
    let between = ENDS.map(|part| part * given);
    job["find"] = json!({"vary": vary, "between": between, "until": {&row.name: row.value}});
    Some((seed, job, hidden))
}

fn chosen<T>(list: &[T], by: u64) -> Option<&T> {
    let place = by.checked_rem(list.len() as u64)?;
    list.get(usize::try_from(place).ok()?)
}

fn solved(job: &Value) -> Result<Report, RunError> {
    let job = Job::from_value(job).map_err(|error| RunError::Failed(format!("{error:?}")))?;
    report::run(&job, &mut Unobserved)
}

/// Returns what a search has come to, and its solves.
fn outcome(job: &Value, hidden: f64) -> (Value, Option<usize>) {
    let report = match solved(job) {
        Ok(report) => report,
        Err(error) => return (json!({"reason": error.to_string()}), None),
    };
    let Some(found) = &report.found else { return (json!({"reason": "no answer"}), None) };
    let until = job["find"]["until"].as_object().and_then(|until| until.values().next());
    let wanted = until.and_then(Value::as_f64).unwrap_or_default();
    let row = report
        .steps
        .last()
        .and_then(|step| step.answers.iter().find(|row| row.name == found.figure));
    let value = row.and_then(|row| row.value).unwrap_or_default();
    let missed = (value / wanted - 1.0).abs();
    let bar = row.and_then(|row| row.error.bound()).unwrap_or(NEAR);
    let error = report.answers.first().map(|row| row.error);
    let off = found.values.iter().map(|value| (value / hidden - 1.0).abs());
    let told = json!({
        "is_found": missed <= bar,
        "values": found.values,
        "missed": missed,
        "bar": bar,
        "error": error.and_then(ErrorBar::bound),
        "off_hidden": off.fold(f64::INFINITY, f64::min),
        "solves": found.looks.value.len(),
    });
    (told, Some(found.looks.value.len()))
}
