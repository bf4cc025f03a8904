//! What surrounds the solver that applies the flexibility: normals inclined to the approach,
//! the initial guess, and the final check.
//!
//! With `R' = e R`, `u' = u / e`, `g' = g / e` and `δ' = δ / e` the conditions are those of
//! normals along the approach. The check applies to the original problem.

use super::kkt::{self, ContactScales, KktReport};
use super::{
    ActiveSet, ContactError, ContactProblem, ContactSolution, ContactStatus, Flexibility, start,
};

/// Solves by a method for normals along the approach. It takes a problem with `e = 1`, forces to
/// start from and the largest violation of a condition that is left.
///
/// # Errors
/// Those of the method, and data that are no contact problem.
pub(crate) fn solve(
    problem: &ContactProblem<'_>,
    known: Option<&ContactSolution>,
    tolerance: f64,
    method: impl FnOnce(
        &ContactProblem<'_>,
        ContactSolution,
        f64,
    ) -> Result<ContactSolution, ContactError>,
) -> Result<ContactSolution, ContactError> {
    problem.validate()?;
    if let Some(solution) = problem.without_force() {
        return Ok(solution);
    }
    let steepest = problem.closing.iter().copied().fold(1.0, f64::min);
    if steepest >= 1.0 {
        return method(problem, begin(problem, known), tolerance);
    }
    let flexibility = AlongApproach { problem };
    let gap: Vec<f64> = (0..problem.n_pairs()).map(|k| problem.touch(k)).collect();
    let ones = vec![1.0; gap.len()];
    let along = ContactProblem {
        flexibility: &flexibility,
        initial_gap: &gap,
        closing: &ones,
        load: problem.load,
    };
    let known =
        known.filter(|known| known.force.len() == gap.len()).map(|known| ContactSolution {
            force: known.force.iter().zip(problem.closing).map(|(r, e)| r * e).collect(),
            ..ContactSolution::default()
        });
    // No violation grows by more than 1 / e on the way back.
    let mut solution = method(&along, begin(&along, known.as_ref()), steepest * tolerance)?;
    for (force, closing) in solution.force.iter_mut().zip(problem.closing) {
        *force /= closing;
    }
    let (approach, status) = (solution.approach, solution.status);
    let report = finish(problem, &mut solution, approach);
    if status == ContactStatus::Converged && !report.passes(tolerance) {
        solution.status = ContactStatus::IterationLimit;
    }
    Ok(solution)
}

/// The forces of an earlier answer if there are any, else a guess.
fn begin(problem: &ContactProblem<'_>, known: Option<&ContactSolution>) -> ContactSolution {
    let mut solution = ContactSolution::default();
    match known.filter(|known| known.force.len() == problem.n_pairs()) {
        Some(known) if known.force.iter().any(|r| *r > 0.0) => {
            solution.force.clone_from(&known.force);
        }
        _ => {
            let mut column = vec![0.0; problem.n_pairs()];
            solution.force.clone_from(&column);
            start::guess(problem, &mut solution.force, &mut column);
            solution.applications = 1;
        }
    }
    solution
}

/// Completes an answer by its forces and approach, and judges it.
pub(crate) fn finish(
    problem: &ContactProblem<'_>,
    solution: &mut ContactSolution,
    approach: f64,
) -> KktReport {
    let mut displacement = vec![0.0; problem.n_pairs()];
    problem.flexibility.apply(&solution.force, &mut displacement);
    solution.applications += 1;
    let report =
        kkt::judge(problem, &solution.force, &displacement, approach, ContactScales::default());
    for (k, u) in displacement.iter_mut().enumerate() {
        *u += problem.gap_at(k, approach);
    }
    solution.gap = displacement;
    solution.approach = approach;
    solution.total_force = problem.total(&solution.force);
    solution.active_set = ActiveSet::from_fn(problem.n_pairs(), |&k| solution.force[k] > 0.0);
    report
}

/// The flexibility along the approach, `u'` of `R'`.
struct AlongApproach<'a> {
    problem: &'a ContactProblem<'a>,
}

impl AlongApproach<'_> {
    fn scaled(&self, values: &[f64], by: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        values.iter().zip(self.problem.closing).map(|(value, e)| by(*value, *e)).collect()
    }
}

impl Flexibility for AlongApproach<'_> {
    fn len(&self) -> usize {
        self.problem.n_pairs()
    }

    fn apply(&self, force: &[f64], displacement: &mut [f64]) {
        self.problem.flexibility.apply(&self.scaled(force, |r, e| r / e), displacement);
        displacement.iter_mut().zip(self.problem.closing).for_each(|(u, e)| *u /= e);
    }

    fn precondition(&self, displacement: &[f64], force: &mut [f64]) {
        self.problem.flexibility.precondition(&self.scaled(displacement, |u, e| u * e), force);
        force.iter_mut().zip(self.problem.closing).for_each(|(r, e)| *r *= e);
    }
}
