//! Jobs that ask for an input (`find`) or have tolerances: several solves, one answer.

mod document;
mod found;
mod search;
#[cfg(test)]
mod tests;
mod tolerances;
mod trials;

use super::{JobEstimate, Report, RunError, StepReport};
use crate::job::{FieldError, Job};
use crate::solver::{Observer, Options};
pub use document::{FoundReport, Looks, TolerancesReport};
pub use trials::Solve;
use trials::{Trials, rows_of};

/// Solves that a search is expected to take: both ends, three or four secants, and a neighbour of
/// the value found.
const SEARCH_SOLVES: usize = 7;

/// Returns whether a job needs more than one solve.
pub fn is_asked(job: &Job) -> bool {
    job.find.is_some() || !job.tolerances.is_empty()
}

/// Returns how many solves are expected.
fn solves(job: &Job) -> usize {
    let search = if job.find.is_some() { SEARCH_SOLVES } else { 1 };
    search + 2 * job.tolerances.len()
}

/// Estimates the cost of a job by that of its most expensive solve.
///
/// # Errors
/// The fields of the job, or the end of the search, that describe a contact outside the theory.
pub fn estimate(
    job: &Job,
    of: fn(&Job) -> Result<JobEstimate, Vec<FieldError>>,
) -> Result<JobEstimate, Vec<FieldError>> {
    let mut whole = of(job)?;
    let ends = job.find.iter().flat_map(|find| find.between.map(|end| (find, end)));
    for (k, (find, end)) in ends.enumerate() {
        let Ok(varied) = job.varied(&find.vary, end) else { continue };
        let one = of(&varied).map_err(|faults| {
            let fault = |fault: FieldError| FieldError {
                detail: format!("with {end}, {fault}"),
                pointer: format!("/find/between/{k}"),
                ..fault
            };
            faults.into_iter().map(fault).collect::<Vec<_>>()
        })?;
        whole = JobEstimate {
            equations: whole.equations.max(one.equations),
            bytes: whole.bytes.max(one.bytes),
            result_bytes: whole.result_bytes.max(one.result_bytes),
        };
    }
    // The steps of the nearest look are kept.
    let bytes = whole.bytes + whole.result_bytes;
    Ok(JobEstimate { bytes, ..whole })
}

/// Finds the input that a job asks for, solves the job with it, passes its steps on and tells what
/// its tolerances do. `solve` solves a job that asks for neither.
///
/// # Errors
/// [`RunError::Input`] where no input is found, and those of a solve.
pub fn run_each(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
    solve: Solve,
) -> Result<Report, RunError> {
    let mut trials = Trials { solve, options, observer, expected: solves(job), made: 0 };
    let sought = job.find.as_ref().map(|find| found::seek(job, find, &mut trials)).transpose()?;
    let (plain, kept, found) = match sought {
        Some(sought) => (sought.job, sought.report, Some((sought.answers, sought.found))),
        None => (Job { find: None, tolerances: Vec::new(), ..job.clone() }, None, None),
    };
    let mut last = Vec::new();
    let mut pass_on = |number, step: StepReport| {
        last.clone_from(&step.answers);
        on_step(number, step);
    };
    let mut report = if let Some(mut kept) = kept.filter(|_| !job.output.fields) {
        kept.steps.drain(..).enumerate().for_each(|(number, step)| pass_on(number, step));
        kept
    } else {
        solve(&plain, options, trials.observer, &mut pass_on)?
    };
    let of_job = rows_of(&report, &last);
    if !job.tolerances.is_empty() && !of_job.is_empty() {
        let told = tolerances::tolerances(&plain, &job.tolerances, &of_job, &mut trials)?;
        report.tolerances = Some(told);
    }
    if let Some((answers, found)) = found {
        report.answers.splice(0..0, answers);
        report.found = Some(found);
    }
    Ok(report)
}
