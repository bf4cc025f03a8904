//! The solves of a search: whole jobs with another number, told as preliminary.

use crate::job::{FieldError, Job, JobError};
use crate::report::{Answer, Report, RunError, StepReport};
use crate::solver::method::observer::Retold;
use crate::solver::{IncrementNumber, IterationRecord, Observer, Options, SolveStatus};

/// Solves a job that asks for no input.
pub type Solve = fn(
    &Job,
    Options<'_>,
    &mut dyn Observer,
    &mut dyn FnMut(usize, StepReport),
) -> Result<Report, RunError>;

/// Solves the jobs of one search.
pub struct Trials<'a> {
    pub solve: Solve,
    pub options: Options<'a>,
    pub observer: &'a mut dyn Observer,
    /// Solves that are expected, and those made.
    pub expected: usize,
    pub made: usize,
}

impl Trials<'_> {
    /// Solves a job without fields, which a search has no use for.
    ///
    /// # Errors
    /// Those of a solve, and an interrupt.
    pub fn solve(&mut self, mut job: Job) -> Result<Report, RunError> {
        job.output.fields = false;
        self.made += 1;
        let (number, count) = (self.made, self.expected.max(self.made));
        // Its number counts among the loads.
        let observer = &mut Retold::preliminary(self.observer, |record| {
            let alone = IncrementNumber { number: 1, count: 1, load: 1, loads: 1 };
            let at = record.increment.unwrap_or(alone);
            let load = (number - 1) * at.loads + at.load;
            let increment = Some(IncrementNumber { load, loads: count * at.loads, ..at });
            IterationRecord { increment, ..record.clone() }
        });
        let mut steps = Vec::new();
        let report = (self.solve)(&job, self.options, observer, &mut |number, step| {
            steps.truncate(number);
            steps.push(step);
        })?;
        match report.status.interrupt() {
            Some(interrupt) => Err(RunError::Interrupted(interrupt)),
            None => Ok(Report { steps, ..report }),
        }
    }
}

/// Returns the rows of a report with its steps.
pub fn rows(report: &Report) -> Vec<Answer> {
    rows_of(report, report.steps.last().map_or(&[], |step| &step.answers))
}

/// Returns the rows of a report: those of several loads, and those of its last step. None of a job
/// that has not converged.
pub fn rows_of(report: &Report, last: &[Answer]) -> Vec<Answer> {
    if report.status != SolveStatus::Converged {
        return Vec::new();
    }
    report.answers.iter().chain(last).cloned().collect()
}

/// Returns the first fault of a job that is none.
pub fn words(fault: &JobError) -> String {
    match fault {
        JobError::Fields(faults) => faults.first().map(ToString::to_string).unwrap_or_default(),
        syntax @ JobError::Syntax { .. } => syntax.to_string(),
    }
}

/// Returns the refusal of a field.
pub fn refused(pointer: &str, detail: String) -> RunError {
    RunError::Input(vec![FieldError::not_solvable(pointer, detail)])
}

/// Returns the relative change of a figure over that of an input, of powers their exponent; `None`
/// where the figure is 0 or changes its sign.
pub fn elasticity(inputs: [f64; 2], figures: [f64; 2]) -> Option<f64> {
    let [of_input, of_figure] = [inputs, figures].map(|[one, other]| (other / one).ln());
    Some(of_figure / of_input).filter(|slope| slope.is_finite())
}
