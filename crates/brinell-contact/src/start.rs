//! The initial guess of the forces, for a solve without an earlier answer.
//!
//! Forces proportional to the depth below a level ℓ, `R_j = P d_j / Σd`, `d = max(ℓ - g, 0)`, lift
//! the cell k that is deepest by `u_k = Σ_j F_kj R_j`. With the pairs in order of their gaps,
//! running sums of `F_kj` and `F_kj g_j` give u_k for every ℓ from one column of F. The level
//! satisfies `g_k + u_k = ℓ`. For a smooth body this contact is slightly too wide, which costs few
//! steps, because pairs leave an active set faster than they enter it.

use super::{ContactLoad, ContactProblem};

/// Fills `force` with a first guess. `column` is work space. Costs one application of F.
pub(crate) fn guess(problem: &ContactProblem<'_>, force: &mut [f64], column: &mut [f64]) {
    let gap = problem.initial_gap;
    let mut order: Vec<usize> = (0..gap.len()).collect();
    order.sort_unstable_by(|&i, &j| gap[i].total_cmp(&gap[j]));
    let deepest = order[0];
    force.fill(0.0);
    force[deepest] = 1.0;
    problem.flexibility.apply(force, column);

    let level = match problem.load {
        ContactLoad::Approach(approach) => approach,
        ContactLoad::Force(total) => {
            let (mut lift, mut lift_gap, mut depth) = (0.0, 0.0, 0.0);
            let mut found = gap[order[gap.len() - 1]];
            // The level rises from gap to gap. Between two of them both sides are fractions of ℓ;
            // the first that carries P ends it.
            for (count, pair) in order.windows(2).enumerate() {
                let (j, level) = (pair[0], gap[pair[1]]);
                lift += column[j];
                lift_gap += column[j] * gap[j];
                depth += gap[j];
                let pairs = (count + 1) as f64;
                let depth_sum = level * pairs - depth;
                if depth_sum > 0.0
                    && total * (level * lift - lift_gap) <= depth_sum * (level - gap[deepest])
                {
                    found = level;
                    break;
                }
            }
            found
        }
    };
    for (r, g) in force.iter_mut().zip(gap) {
        *r = (level - g).max(0.0);
    }
    let (depth, lift): (f64, f64) =
        force.iter().zip(column.iter()).fold((0.0, 0.0), |(d, u), (r, c)| (d + r, u + r * c));
    if depth <= 0.0 {
        // A flat contact: every cell at the lowest gap.
        let flat = gap.iter().filter(|g| **g <= gap[deepest]).count() as f64;
        let each = if let ContactLoad::Force(total) = problem.load { total / flat } else { 1.0 };
        for (r, g) in force.iter_mut().zip(gap) {
            *r = if *g <= gap[deepest] { each } else { 0.0 };
        }
        return;
    }
    let factor = match problem.load {
        ContactLoad::Force(total) => total / depth,
        // g_k + u_k = α.
        ContactLoad::Approach(approach) => (approach - gap[deepest]) / lift,
    };
    for r in force.iter_mut() {
        *r *= factor;
    }
}
