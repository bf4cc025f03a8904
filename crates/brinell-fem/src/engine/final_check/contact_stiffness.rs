//! The slope dP/dα of the load-approach curve of elastic bodies at an answer, be they elastic by
//! nature or because the load falls.
//!
//! ```text
//! dP/dα = eᵀ F⁻¹ e      over the pairs in contact: F their flexibility,
//!                       e their cosines to the approach
//! ```

use crate::engine::ContactPatch;
use crate::engine::body_system::contact_patch::BEFORE_NODE;
use crate::engine::body_system::system::System;
use brinell_method::couplings::iteration::State;
use dense_cholesky::DenseCholesky;

/// dP/dα of a system whose factors are elastic, of both sides of the axis together \[N/mm per mm,
/// or N per mm\]; 0 where nothing touches. A contact that ends somewhere between two nodes has a
/// `patch`; one that is held by an edge has none.
///
/// The stiffness grows in steps as pair after pair comes into contact. Between two steps it is
/// interpolated, by how it would change with one pair more or less.
pub(super) fn elastic_stiffness(
    system: &System,
    state: &State,
    patch: Option<ContactPatch>,
) -> f64 {
    let active: Vec<usize> = state.response.contact.active_set.iter().collect();
    let whole = stiffness(system, &active);
    patch.map_or(whole, |patch| whole + at_the_ends(system, &active, patch, whole))
}

/// Returns the elastic contact stiffness of these pairs.
fn stiffness(system: &System, pairs: &[usize]) -> f64 {
    let Ok(factor) = DenseCholesky::factor(system.flexibility.principal_block(pairs)) else {
        return 0.0;
    };
    let mut tied: Vec<f64> = pairs.iter().map(|&k| system.closing[k]).collect();
    factor.solve_in_place(&mut tied);
    let mut force = vec![0.0; system.initial_gap.len()];
    for (&k, r) in pairs.iter().zip(tied) {
        force[k] = r;
    }
    system.whole_load(&force)
}

/// Part of an element by which active pairs reach beyond the outermost of them: the middle of the
/// ends that they serve.
const OVERHANG: f64 = 0.5 - BEFORE_NODE;

/// Returns the stiffness that the parts of elements between the outermost active pairs and the ends
/// of the contact add.
fn at_the_ends(system: &System, active: &[usize], patch: ContactPatch, whole: f64) -> f64 {
    let (Some(&first), Some(&last)) = (active.first(), active.last()) else { return 0.0 };
    let zone = &system.zone;
    let share = |beyond: f64| (beyond / zone.spacing() - OVERHANG).clamp(-1.0, 1.0);
    let change = |pairs: &[usize], share: f64| share.abs() * (stiffness(system, pairs) - whole);
    let mut sum = 0.0;
    let right = share(patch.right - zone.abscissa(last));
    if right >= 0.0 && last < zone.columns() {
        sum += change(&[active, &[last + 1]].concat(), right);
    } else if right < 0.0 && active.len() > 2 {
        sum += change(&active[..active.len() - 1], right);
    }
    if !zone.is_symmetric() {
        let left = share(zone.abscissa(first) - patch.left);
        if left >= 0.0 && first > 0 {
            sum += change(&[&[first - 1], active].concat(), left);
        } else if left < 0.0 && active.len() > 2 {
            sum += change(&active[1..], left);
        }
    }
    sum
}
