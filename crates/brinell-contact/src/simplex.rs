//! The simplex method with restricted basis entry.

use super::bordered;
use super::tableau::{Tableau, Variable};
use super::{
    ActiveSet, ContactError, ContactLoad, ContactProblem, ContactSolution, ContactSolver, StopHook,
};

/// Penetration, relative to its own terms, above which the recomputed answer is refused.
const ACCEPTABLE_VIOLATION: f64 = 1e-9;

/// Contact as a linear programme whose complementary variables may not share a basis.
///
/// The tableau holds the n continuity rows and the load row
/// ```text
/// -F R + α e + δ = g            start basis { δ_1, …, δ_n, z }
///         eᵀR     + z = P       minimise z
/// ```
/// A variable may enter only if its complement (`R_k` and `δ_k`) is out of the basis or leaves in
/// the same pivot. That leaves no choice: α enters first, the pair with the smallest gap closes,
/// and from then on the complement of what has just left enters, until z leaves. If no pair opens
/// again, `n_active` pairs take `n_active + 1` pivots.
///
/// **Negative gaps.** Right-hand sides must be >= 0, so all gaps are counted from what they are
/// when the first pair touches; that approach is added back to α.
///
/// **Prescribed approach.** The load row becomes `α + z = α_given`. Eliminating α by it shows
/// Lemke's method for the linear complementarity problem `δ = (g - α_given e) + F R` with covering
/// vector e and artificial variable z: the path through the bases is that of the force problem,
/// and only ends elsewhere.
///
/// **Degeneracy.** Ties of the ratio test are broken lexicographically, so no basis returns; z is
/// preferred where it ties. α never leaves: along the path it only grows, for F positive definite.
///
/// **Polish.** The path decides *which* pairs touch. Forces and approach are then computed afresh
/// on that set by Cholesky, which removes the rounding gathered over the pivots; a pair whose
/// force comes out as zero or negative there was tied, and is left out.
///
/// O(n²) a pivot. `start` is not used: the path has one beginning.
///
/// # Reference
/// T. F. Conry, A. Seireg, *A mathematical programming method for design of elastic bodies in
/// contact*, J. Appl. Mech. 38 (1971) 387-392. C. E. Lemke, *Bimatrix equilibrium points and
/// mathematical programming*, Manag. Sci. 11 (1965) 681-689.
#[derive(Debug, Clone, Copy, Default)]
pub struct SimplexSolver;

impl ContactSolver for SimplexSolver {
    fn solve(
        &self,
        problem: &ContactProblem<'_>,
        _: Option<&ContactSolution>,
        _: &mut StopHook<'_>,
    ) -> Result<ContactSolution, ContactError> {
        problem.validate()?;
        if let Some(solution) = problem.without_force() {
            return Ok(solution);
        }
        polish(problem, &follow_path(problem)?)
    }
}

/// Pivots until z leaves, and reads the answer from the last tableau.
///
/// The tableau works in the units of the problem: force in P, length in P times the largest
/// flexibility (or in the prescribed approach), so that its tolerances mean the same for every
/// problem.
fn follow_path(problem: &ContactProblem) -> Result<ContactSolution, ContactError> {
    let n = problem.n_pairs();
    let datum = problem.first_touch();
    let entries = problem.entries()?;
    let largest = (0..n).map(|k| entries.at(k, k)).fold(0.0, f64::max);
    if largest <= 0.0 {
        return Err(ContactError::NotPositiveDefinite { pair: 0 });
    }
    let (force_unit, length_unit) = match problem.load {
        ContactLoad::Force(total) => (total, total * largest),
        ContactLoad::Approach(approach) => ((approach - datum) / largest, approach - datum),
    };
    let mut tableau = Tableau::new(
        n,
        |i, j| entries.at(i, j) / largest,
        |k| problem.gap_at(k, datum) / length_unit,
        |k| problem.closing[k],
        matches!(problem.load, ContactLoad::Force(_)),
    );
    let limit = 50 * (n + 2);
    let mut pivots = 0;
    let mut entering = Variable::Approach;
    loop {
        let column = tableau.column_of(entering);
        let row = tableau.leaving_row(column).ok_or(ContactError::Ray { pivots })?;
        let leaving = tableau.pivot(row, column);
        pivots += 1;
        entering = match leaving {
            Variable::Gap(k) => Variable::Force(k),
            Variable::Force(k) => Variable::Gap(k),
            Variable::Approach | Variable::Artificial => break,
        };
        if pivots == limit {
            return Err(ContactError::PivotLimit { limit });
        }
    }
    let mut end = ContactSolution {
        force: vec![0.0; n],
        gap: vec![0.0; n],
        approach: datum,
        pivots,
        ..ContactSolution::default()
    };
    let mut active = Vec::new();
    for (variable, value) in tableau.basic_values() {
        match variable {
            Variable::Force(k) => {
                end.force[k] = value * force_unit;
                active.push(k);
            }
            Variable::Gap(k) => end.gap[k] = value * length_unit,
            Variable::Approach => end.approach += value * length_unit,
            Variable::Artificial => {}
        }
    }
    end.total_force = problem.total(&end.force);
    end.active_set = active.into_iter().collect();
    Ok(end)
}

/// Recomputes forces, approach and gaps on the pairs the path ended with.
fn polish(
    problem: &ContactProblem,
    end: &ContactSolution,
) -> Result<ContactSolution, ContactError> {
    let mut active = end.active_set.clone();
    loop {
        let equilibrium = bordered::solve_on(problem, &active)?;
        let carrying: ActiveSet = active.iter().filter(|&k| equilibrium.force[k] > 0.0).collect();
        if carrying != active {
            active = carrying;
            continue;
        }
        let (gap, scale) = bordered::gaps(problem, &active, &equilibrium)?;
        let violation = gap
            .iter()
            .zip(&scale)
            .enumerate()
            .filter(|(k, _)| !active.contains(*k))
            .map(|(_, (gap, scale))| -gap / scale)
            .fold(0.0, f64::max);
        if violation > ACCEPTABLE_VIOLATION {
            return Err(ContactError::IllConditioned { violation });
        }
        return Ok(bordered::into_solution(problem, active, equilibrium, gap, end.pivots));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{kkt, never};
    use dense_cholesky::SymmetricMatrix;

    /// Smooth, poorly conditioned, like the flexibility of a fine mesh.
    fn smooth(n: usize, ridge: f64) -> SymmetricMatrix {
        SymmetricMatrix::from_fn(n, |i, j| {
            let distance = (i as f64 - j as f64) / n as f64;
            (-8.0 * distance * distance).exp() + if i == j { ridge } else { 0.0 }
        })
    }

    fn parabola(n: usize) -> Vec<f64> {
        (0..n).map(|k| (k as f64 / n as f64 - 0.41).powi(2)).collect()
    }

    #[test]
    fn the_last_tableau_itself_is_accurate() {
        for (n, ridge, agreement) in
            [(10, 1e-2, 1e-12), (60, 1e-2, 1e-11), (60, 1e-6, 1e-8), (150, 1e-4, 1e-8)]
        {
            let flexibility = smooth(n, ridge);
            let initial_gap = parabola(n);
            for load in [ContactLoad::Force(0.5), ContactLoad::Approach(0.1)] {
                let problem = ContactProblem {
                    flexibility: &flexibility,
                    initial_gap: &initial_gap,
                    closing: &vec![1.0; n],
                    load,
                };
                let raw = follow_path(&problem).unwrap();
                let polished = polish(&problem, &raw).unwrap();
                assert_eq!(raw.active_set, polished.active_set);
                assert!(kkt::check(&problem, &raw.force, raw.approach).passes(agreement));
                let scale = polished.force.iter().copied().fold(0.0, f64::max);
                for (left, right) in raw.force.iter().zip(&polished.force) {
                    assert!(
                        (left - right).abs() < agreement * scale,
                        "n {n}, ridge {ridge}: {left} {right}"
                    );
                }
                for (left, right) in raw.gap.iter().zip(&polished.gap) {
                    assert!((left - right).abs() < agreement * polished.approach);
                }
                assert!((raw.approach - polished.approach).abs() < agreement * polished.approach);
            }
        }
    }

    #[test]
    fn ends_on_a_ray_where_the_flexibility_is_indefinite() {
        let flexibility = SymmetricMatrix::from_fn(2, |i, j| if i == j { 1.0 } else { -2.0 });
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &[0.0, 0.0],
            closing: &[1.0; 2],
            load: ContactLoad::Approach(1.0),
        };
        assert_eq!(
            SimplexSolver.solve(&problem, None, &mut never),
            Err(ContactError::Ray { pivots: 2 })
        );
        let rigid = SymmetricMatrix::zeros(2);
        let problem = ContactProblem { flexibility: &rigid, ..problem };
        assert_eq!(
            SimplexSolver.solve(&problem, None, &mut never),
            Err(ContactError::NotPositiveDefinite { pair: 0 })
        );
    }

    #[test]
    fn pairs_given_twice_share_one_force() {
        let base = smooth(12, 1e-2);
        let flexibility = SymmetricMatrix::from_fn(24, |i, j| base[(i / 2, j / 2)]);
        let gaps = parabola(12);
        let initial_gap: Vec<f64> = (0..24).map(|k| gaps[k / 2]).collect();
        let problem = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &initial_gap,
            closing: &[1.0; 24],
            load: ContactLoad::Force(0.5),
        };
        let solution = SimplexSolver.solve(&problem, None, &mut never).unwrap();
        assert!(kkt::check(&problem, &solution.force, solution.approach).passes(1e-12));
        assert!(solution.active_set.iter().all(|k| !solution.active_set.contains(k ^ 1)));
    }
}
