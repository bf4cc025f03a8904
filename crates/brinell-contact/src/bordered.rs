//! The linear system that remains once the pairs in contact are known.
//!
//! On the active set A, δ vanishes, and continuity and equilibrium become
//! ```text
//! | F_AA  -e | | R_A |   | -g_A |        R_A = α y - w,   F_AA y = e,   F_AA w = g_A
//! |  eᵀ    0 | |  α  | = |   P  |        α = (P + eᵀw) / eᵀy
//! ```
//! with α known instead where the approach is prescribed. g is counted from what it is when the
//! first pair of A touches, so that an offset of the approach costs no digits.

use super::{
    ActiveSet, ContactError, ContactLoad, ContactProblem, ContactSolution, ContactStatus,
};
use dense_cholesky::DenseCholesky;

/// Penetration, relative to the terms whose sum the gap is, that is put down to rounding.
pub(super) const GAP_TOLERANCE: f64 = 1e-13;

/// Forces of all pairs and approach, when exactly the pairs of `active` touch.
pub(super) struct Equilibrium {
    pub force: Vec<f64>,
    pub approach: f64,
}

/// Solves the bordered system on `active`; |A|³/6 multiply-adds.
pub(super) fn solve_on(
    problem: &ContactProblem,
    active: &ActiveSet,
) -> Result<Equilibrium, ContactError> {
    let pairs = active.as_slice();
    let datum = pairs.iter().map(|&k| problem.touch(k)).fold(f64::INFINITY, f64::min);
    let factor = DenseCholesky::factor(problem.entries()?.principal_block(pairs))
        .map_err(|error| ContactError::NotPositiveDefinite { pair: pairs[error.index] })?;
    let mut per_approach: Vec<f64> = pairs.iter().map(|&k| problem.closing[k]).collect();
    factor.solve_in_place(&mut per_approach);
    let mut from_gap: Vec<f64> = pairs.iter().map(|&k| problem.gap_at(k, datum)).collect();
    factor.solve_in_place(&mut from_gap);

    let (beyond_datum, approach) = match problem.load {
        ContactLoad::Force(total) => {
            let total_of = |values: &[f64]| -> f64 {
                pairs.iter().zip(values).map(|(&k, value)| problem.closing[k] * value).sum()
            };
            let beyond = (total + total_of(&from_gap)) / total_of(&per_approach);
            (beyond, beyond + datum)
        }
        ContactLoad::Approach(approach) => (approach - datum, approach),
    };
    let mut force = vec![0.0; problem.n_pairs()];
    for ((&k, y), w) in pairs.iter().zip(&per_approach).zip(&from_gap) {
        force[k] = beyond_datum * y - w;
    }
    Ok(Equilibrium {
        force,
        approach: if pairs.is_empty() { prescribed(problem) } else { approach },
    })
}

/// `δ = g + F R - α e`, and beside each entry the sum of its terms' magnitudes, the measure of its
/// rounding.
pub(super) fn gaps(
    problem: &ContactProblem,
    active: &ActiveSet,
    equilibrium: &Equilibrium,
) -> Result<(Vec<f64>, Vec<f64>), ContactError> {
    let entries = problem.entries()?;
    let approach = equilibrium.approach;
    let mut gap: Vec<f64> = (0..problem.n_pairs()).map(|k| problem.gap_at(k, approach)).collect();
    let mut scale: Vec<f64> =
        problem.initial_gap.iter().map(|g| g.abs() + approach.abs()).collect();
    for j in active.iter() {
        let force = equilibrium.force[j];
        for ((gap, scale), entry) in gap.iter_mut().zip(&mut scale).zip(entries.row(j)) {
            let displacement = entry * force;
            *gap += displacement;
            *scale += displacement.abs();
        }
    }
    Ok((gap, scale))
}

/// Puts an equilibrium into the form of an answer: gaps are zero in contact, and rounding below
/// zero is cut.
pub(super) fn into_solution(
    problem: &ContactProblem,
    active_set: ActiveSet,
    equilibrium: Equilibrium,
    mut gap: Vec<f64>,
    pivots: usize,
) -> ContactSolution {
    for value in &mut gap {
        *value = value.max(0.0);
    }
    for k in active_set.iter() {
        gap[k] = 0.0;
    }
    let Equilibrium { force, approach } = equilibrium;
    let (total_force, status) = (problem.total(&force), ContactStatus::Converged);
    ContactSolution {
        force,
        gap,
        approach,
        total_force,
        active_set,
        status,
        pivots,
        ..ContactSolution::default()
    }
}

/// The approach that holds when nothing touches.
fn prescribed(problem: &ContactProblem) -> f64 {
    match problem.load {
        ContactLoad::Approach(approach) => approach,
        ContactLoad::Force(_) => problem.first_touch(),
    }
}
