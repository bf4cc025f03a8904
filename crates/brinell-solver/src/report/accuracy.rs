//! Meshes that are refined until the figures that answer a job have the error it asks for.

use super::answers::{Answer, ErrorBar};
use super::find::Solve;
use super::findings::{Finding, Missed};
use super::{JobEstimate, Report, RunError, StepReport, validity};
use crate::job::{Analysis, FieldError, Job, MeshSettings};
use crate::solver::{Observer, Options, SolveStatus};
use crate::units::UnitConverter;

/// Largest number of elements over the number that the job gives.
const MOST: u32 = 4;

/// Returns the job on a mesh of so many elements.
fn on(job: &Job, elements: u32) -> Job {
    Job { mesh: job.mesh.with_elements(elements), ..job.clone() }
}

fn most_elements(job: &Job) -> u32 {
    let most = match job.analysis {
        Analysis::ThreeDimensional => MeshSettings::MAX_CELLS_PER_SEMI_AXIS,
        _ => MeshSettings::MAX_ELEMENTS_PER_HALF_WIDTH,
    };
    most.min(MOST * job.mesh.elements_per_half_width)
}

/// Estimates the cost of a job: with an accuracy that of its finest mesh.
///
/// # Errors
/// Those of the estimate of one mesh.
pub(super) fn estimate(
    job: &Job,
    of: fn(&Job) -> Result<JobEstimate, Vec<FieldError>>,
) -> Result<JobEstimate, Vec<FieldError>> {
    match job.mesh.accuracy {
        Some(_) => of(&on(job, most_elements(job))),
        None => of(job),
    }
}

/// Solves a job, on finer and finer meshes where it asks for an accuracy. Steps of a finer mesh
/// replace those before. A finer mesh without an answer, or a job that is stopped, leaves the last one.
///
/// # Errors
/// Those of the first mesh.
pub(super) fn solve(
    job: &Job,
    options: Options<'_>,
    observer: &mut dyn Observer,
    on_step: &mut dyn FnMut(usize, StepReport),
    solve: Solve,
) -> Result<Report, RunError> {
    let Some(asked) = job.mesh.accuracy else { return solve(job, options, observer, on_step) };
    let (mut elements, most) = (job.mesh.elements_per_half_width, most_elements(job));
    let (mut kept, mut steps) = solve_on(job, elements, options, observer, solve)?;
    let missed = loop {
        let figure = worst(&kept, &steps);
        let is_met = figure.as_ref().is_some_and(|(_, error)| *error <= asked.get());
        if is_met || kept.status != SolveStatus::Converged {
            break None;
        }
        let missed = |why: Missed| Some(Finding::AccuracyMissed { figure, why });
        if elements >= most {
            break missed(Missed::Elements(most));
        }
        let finer = most.min(elements + elements.div_ceil(2));
        match solve_on(job, finer, options, observer, solve) {
            Ok((report, finer_steps)) if report.status == SolveStatus::Converged => {
                (kept, steps, elements) = (report, finer_steps, finer);
            }
            Ok((report, _)) if report.status.is_stopped() => break missed(Missed::Stopped(finer)),
            Err(RunError::Interrupted(_)) => break missed(Missed::Stopped(finer)),
            _ => break missed(Missed::NoAnswer(finer)),
        }
    };
    let write = UnitConverter::new(job.units, job.analysis);
    kept.validity.extend(validity::remarks(missed.as_slice(), write));
    steps.into_iter().enumerate().for_each(|(number, step)| on_step(number, step));
    Ok(kept)
}

/// Solves a job on a mesh and collects its steps.
fn solve_on(
    job: &Job,
    elements: u32,
    options: Options<'_>,
    observer: &mut dyn Observer,
    solve: Solve,
) -> Result<(Report, Vec<StepReport>), RunError> {
    let mut steps = Vec::new();
    let report = solve(&on(job, elements), options, observer, &mut |number, step| {
        steps.truncate(number);
        steps.push(step);
    })?;
    Ok((report, steps))
}

/// Returns label and error of the figure with the largest one, of those that answer the job; `None`
/// where none has a bound, as on a mesh that is too coarse.
fn worst(report: &Report, steps: &[StepReport]) -> Option<(String, f64)> {
    let of_steps = steps.iter().flat_map(|step| &step.answers);
    let rows = report.answers.iter().chain(of_steps);
    let bound = |row: &Answer| match row.error {
        ErrorBar::Relative(error) if !row.detail => Some((row.label.clone(), error)),
        _ => None,
    };
    rows.filter_map(bound).max_by(|a, b| a.1.total_cmp(&b.1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::run;
    use crate::solver::Unobserved;

    fn cylinders(accuracy: f64) -> Report {
        let mut job: serde_json::Value =
            serde_json::from_slice(include_bytes!("../../../../api/examples/two_cylinders.json"))
                .unwrap();
        for side in ["upper", "lower"] {
            job[side]["material"].as_object_mut().unwrap().remove("plasticity");
        }
        job["mesh"] = serde_json::json!({"elements_per_half_width": 8, "accuracy": accuracy});
        run(&Job::from_value(&job).unwrap(), &mut Unobserved).unwrap()
    }

    #[test]
    fn a_mesh_is_refined_until_the_figures_are_met() {
        let report = cylinders(0.006);
        let (label, error) = worst(&report, &report.steps).unwrap();
        assert!(error <= 0.006 && report.validity.is_empty(), "{label} {error}");
        let coarse = cylinders(0.2);
        assert!(coarse.mesh.nodes < report.mesh.nodes);
    }

    #[test]
    fn what_is_not_met_is_named() {
        let report = cylinders(0.001);
        let (label, _) = worst(&report, &report.steps).unwrap();
        let note = &report.validity[0];
        assert_eq!(note.code, "accuracy_missed");
        assert!(
            note.message.contains(&label.to_lowercase()) && note.message.contains("32"),
            "{note:?}"
        );
    }
}
