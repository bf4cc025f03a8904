//! How far an elastic contact of rough surfaces reaches: half-spaces instead of bodies, pairs as close as the elements of the
//! mesh. A trace touches beyond where its mean surface would.

use std::f64::consts::PI;

use crate::contact::{ActiveSetSolver, ContactLoad, ContactProblem, ContactSolver};
use crate::fem::element::StressState;
use crate::solver::problem::Problem;
use sparse_cholesky::dense::SymmetricMatrix;

/// Half-width of what is looked at over the expected one, and how much wider it becomes where that is not enough.
const REACH: f64 = 1.6;
const WIDENING: f64 = 1.5;
/// Pairs at most to each side of the middle.
const MAX_PAIRS: f64 = 450.0;

/// Half-width of the contact of plane half-spaces under a force, on pairs of this spacing around a middle; `None` where that takes too many
/// pairs, or in axisymmetry.
pub(crate) fn half_width(
    problem: &Problem,
    force: f64,
    centre: f64,
    expected: f64,
    spacing: f64,
) -> Option<f64> {
    if problem.stress_state == StressState::Axisymmetric {
        return None;
    }
    let mut reach = REACH * expected;
    loop {
        let to_each_side = (reach / spacing).ceil();
        if to_each_side > MAX_PAIRS {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small and positive")]
        let count = 2 * to_each_side as usize + 1;
        let x = |k: usize| centre + (k as f64 - to_each_side) * spacing;
        let initial_gap: Vec<f64> = (0..count).map(|k| problem.initial_gap(x(k))).collect();
        let flexibility = half_plane(count, problem.effective_modulus());
        let closing = vec![1.0; count];
        let contact = ContactProblem {
            flexibility: &flexibility,
            initial_gap: &initial_gap,
            closing: &closing,
            load: ContactLoad::Force(force),
        };
        let active = ActiveSetSolver.solve(&contact, None).ok()?.active_set;
        let (first, last) = (active.first()?, active.last()?);
        if first > 1 && last + 2 < count {
            return Some(0.5 * (last - first + 1) as f64 * spacing);
        }
        reach *= WIDENING;
    }
}

/// Normal displacements of a half-plane under unit forces, each spread evenly over an element, relative to a point far away:
/// `-2/(π E*) ∫ ln|x - s| ds/h`.
fn half_plane(count: usize, modulus: f64) -> SymmetricMatrix {
    // In elements; beyond all of them, so that every entry is positive.
    let datum = (10.0 * count as f64).ln();
    let integral = |x: f64| if x == 0.0 { 0.0 } else { x * x.abs().ln() - x };
    let by_distance: Vec<f64> = (0..count)
        .map(|k| {
            let distance = k as f64;
            2.0 / (PI * modulus) * (datum - integral(distance + 0.5) + integral(distance - 0.5))
        })
        .collect();
    SymmetricMatrix::from_fn(count, |i, j| by_distance[i.abs_diff(j)])
}
