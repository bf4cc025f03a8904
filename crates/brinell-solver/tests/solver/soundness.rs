//! `converged` is never said of a wrong contact set, whatever the contact method believes.

use brinell_solver::contact::{
    ActiveSet, ActiveSetSolver, ContactError, ContactLoad, ContactProblem, ContactSolution,
    ContactSolver, StopHook,
};
use brinell_solver::solver::{Options, SolveStatus};
use serde_json::json;

use crate::problems::{FORCE_3, paper, solve_with, two_cylinders};

/// Hands on the right answer to a contact that has been tampered with.
struct Tampered<F: Fn(&mut ContactSolution)>(F);

impl<F: Fn(&mut ContactSolution)> ContactSolver for Tampered<F> {
    fn solve(
        &self,
        problem: &ContactProblem<'_>,
        start: Option<&ContactSolution>,
        stop: &mut StopHook<'_>,
    ) -> Result<ContactSolution, ContactError> {
        let mut solution = ActiveSetSolver.solve(problem, start, stop)?;
        (self.0)(&mut solution);
        Ok(solution)
    }
}

/// Gives the load to the pairs of the first half-width only: a set that is too narrow, with forces
/// that balance.
struct TooNarrow;

impl ContactSolver for TooNarrow {
    fn solve(
        &self,
        problem: &ContactProblem<'_>,
        start: Option<&ContactSolution>,
        stop: &mut StopHook<'_>,
    ) -> Result<ContactSolution, ContactError> {
        let ContactLoad::Force(total) = problem.load else {
            return ActiveSetSolver.solve(problem, start, stop);
        };
        let mut solution = ActiveSetSolver.solve(problem, start, stop)?;
        let kept = solution.active_set.len() / 2;
        for force in &mut solution.force[kept..] {
            *force = 0.0;
        }
        let scale = total / solution.force.iter().sum::<f64>();
        for force in &mut solution.force {
            *force *= scale;
        }
        solution.active_set = ActiveSet::from_fn(solution.force.len(), |k| *k < kept);
        Ok(solution)
    }
}

fn status_with(contact: &dyn ContactSolver, elastic: bool) -> (SolveStatus, bool) {
    let job = if elastic {
        two_cylinders("clamped", json!(null), FORCE_3)
    } else {
        let mut job = paper(FORCE_3, "accelerated");
        job["solver"]["max_iterations"] = json!(60);
        job
    };
    let options = Options { contact_solver: Some(contact), ..Options::default() };
    let step = &solve_with(&job, options).steps[0];
    (step.status, step.checks.contact.is_sound())
}

#[test]
fn the_untampered_contact_converges() {
    let honest = Tampered(|_| ());
    assert_eq!(status_with(&honest, true), (SolveStatus::Converged, true));
    assert_eq!(status_with(&honest, false), (SolveStatus::Converged, true));
}

#[test]
fn wrong_contact_sets_are_found_out() {
    let tension = Tampered(|solution| {
        let last = solution.force.len() - 1;
        solution.force[last] -= 1.0;
        solution.force[0] += 1.0;
    });
    let penetration = Tampered(|solution| solution.approach *= 1.001);
    let lost_force = Tampered(|solution| solution.force[3] *= 0.99);
    let shifted = Tampered(|solution| solution.force.rotate_right(1));
    for elastic in [true, false] {
        for contact in
            [&TooNarrow as &dyn ContactSolver, &tension, &penetration, &lost_force, &shifted]
        {
            assert_eq!(status_with(contact, elastic), (SolveStatus::NotConverged, false));
        }
    }
}

#[test]
fn a_solver_that_returns_nan_does_not_converge() {
    let poisoned = Tampered(|solution| solution.force[2] = f64::NAN);
    assert_eq!(status_with(&poisoned, true).0, SolveStatus::NotConverged);
}

#[test]
fn too_few_iterations_are_not_convergence() {
    let mut job = paper(FORCE_3, "strong");
    job["solver"]["max_iterations"] = json!(5);
    let solution = solve_with(&job, Options::default());
    assert_eq!(solution.steps[0].status, SolveStatus::NotConverged);
    assert_eq!(solution.steps[0].history.len(), 5);
    assert!(
        solution.steps[0].checks.contact.is_sound(),
        "the contact of an unfinished state is still exact"
    );
}
