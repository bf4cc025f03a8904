//! Primal-dual active set: Newton's method on the contact conditions.

use std::collections::HashSet;

use super::bordered::{self, GAP_TOLERANCE};
use super::{
    ActiveSet, ContactError, ContactLoad, ContactProblem, ContactSolution, ContactSolver,
    SimplexSolver, StopHook,
};

/// Steps after which the simplex takes over. Contact problems need one to ten.
const STEP_LIMIT: usize = 60;

/// Guesses the pairs in contact, solves, and corrects the guess until it repeats.
///
/// With A the guess, one step solves the bordered system with `δ_A = 0` and `R = 0` elsewhere and
/// takes
/// ```text
/// A' = { k in A : R_k > 0 }  ∪  { k not in A : δ_k < 0 }
/// ```
/// which is a semismooth Newton step for `min(R, δ) = 0`. `δ_k < 0` is compared with the rounding
/// error of its own terms, so that pairs that just touch stay outside the set and do not
/// alternate. A step costs |A|³/6 + n |A| multiply-adds; from the set of the iteration before it
/// takes one or two steps, without a start five to ten.
///
/// # Termination
/// The method is not proven to end for every positive definite F: it may cycle. [`SimplexSolver`],
/// which cannot cycle, takes over after a repeated set, after an F that fails on an intermediate
/// set, or after 60 steps.
///
/// # Reference
/// M. Hintermüller, K. Ito, K. Kunisch, *The primal-dual active set strategy as a semismooth
/// Newton method*, SIAM J. Optim. 13 (2003) 865-888.
#[derive(Debug, Clone, Copy, Default)]
pub struct ActiveSetSolver;

impl ContactSolver for ActiveSetSolver {
    fn solve(
        &self,
        problem: &ContactProblem<'_>,
        start: Option<&ContactSolution>,
        stop: &mut StopHook<'_>,
    ) -> Result<ContactSolution, ContactError> {
        problem.validate()?;
        if let Some(solution) = problem.without_force() {
            return Ok(solution);
        }
        let mut active = first_set(problem, start);
        let mut seen = HashSet::new();
        let mut steps = 0;
        while steps < STEP_LIMIT && !active.is_empty() && seen.insert(active.clone()) {
            steps += 1;
            let Ok(equilibrium) = bordered::solve_on(problem, &active) else { break };
            let (gap, scale) = bordered::gaps(problem, &active, &equilibrium)?;
            let mut touching = vec![false; problem.n_pairs()];
            for k in active.iter() {
                touching[k] = true;
            }
            let next = ActiveSet::from_fn(problem.n_pairs(), |&k| {
                if touching[k] {
                    equilibrium.force[k] > 0.0
                } else {
                    gap[k] < -GAP_TOLERANCE * scale[k]
                }
            });
            if next == active {
                return Ok(bordered::into_solution(problem, active, equilibrium, gap, steps));
            }
            active = next;
        }
        let mut solution = SimplexSolver.solve(problem, None, stop)?;
        solution.pivots += steps;
        Ok(solution)
    }
}

/// The pairs of another answer if there are any, else the pairs that overlap at the prescribed
/// approach, else those whose gap closes first.
fn first_set(problem: &ContactProblem<'_>, start: Option<&ContactSolution>) -> ActiveSet {
    let n = problem.n_pairs();
    let known = start.into_iter().flat_map(|start| start.active_set.iter()).filter(|&k| k < n);
    let known: ActiveSet = known.collect();
    if !known.is_empty() {
        return known;
    }
    let level = match problem.load {
        ContactLoad::Force(_) => problem.first_touch(),
        ContactLoad::Approach(approach) => approach,
    };
    ActiveSet::from_fn(n, |&k| problem.touch(k) <= level)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::never;
    use dense_cholesky::SymmetricMatrix;

    #[test]
    fn starts_where_the_gap_closes_first_and_ignores_foreign_pairs() {
        let flexibility = SymmetricMatrix::from_fn(3, |i, j| if i == j { 2.0 } else { 1.0 });
        let gaps = [0.5, -0.25, -0.25];
        let problem = |load| ContactProblem {
            flexibility: &flexibility,
            initial_gap: &gaps,
            closing: &[1.0; 3],
            load,
        };
        let known = |pairs: &[usize]| ContactSolution {
            active_set: pairs.iter().copied().collect(),
            ..ContactSolution::default()
        };
        let by_force = problem(ContactLoad::Force(1.0));
        assert_eq!(first_set(&by_force, None).as_slice(), [1, 2]);
        assert_eq!(first_set(&by_force, Some(&known(&[2, 9]))).as_slice(), [2]);
        assert_eq!(first_set(&by_force, Some(&known(&[9]))).as_slice(), [1, 2]);
        assert_eq!(first_set(&problem(ContactLoad::Approach(1.0)), None).len(), 3);
    }

    #[test]
    fn a_singular_intermediate_set_goes_to_the_simplex() {
        let flexibility = SymmetricMatrix::from_fn(2, |_, _| 1.0);
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &[0.0, 0.0],
            closing: &[1.0; 2],
            load: ContactLoad::Force(3.0),
        };
        let solution = ActiveSetSolver.solve(&problem, None, &mut never).unwrap();
        assert_eq!(
            (solution.total_force, solution.approach, solution.active_set.len()),
            (3.0, 3.0, 1)
        );
        assert_eq!(solution.pivots, 3, "one step, then two pivots");
    }
}
