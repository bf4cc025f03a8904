//! Contact pressure next to the axis of a body of revolution.
//!
//! The innermost nodes of an axisymmetric mesh stand for very small areas, and a 4-node element
//! whose side is the axis represents them poorly: their pressures are low by about 1.2, 0.4 and
//! 0.2 %, whatever the element size. Pressure is smooth and even in the radius there, so that `p =
//! c_0 + c_2 r² + c_4 r⁴`, fitted to the nodes around, says what it is.

use nalgebra::{Matrix3, Vector3};

/// Innermost nodes whose pressures are replaced.
const REPLACED: usize = 3;
/// Nodes that the polynomial is fitted to, counted from the axis.
const FITTED: std::ops::Range<usize> = REPLACED..11;
/// Loaded nodes without a gap that are needed for it: the fit must stay away from the edge of the
/// contact.
const NEEDED: usize = 16;

/// Replaces the pressures at the innermost nodes, in order of the radius and evenly spaced, if the
/// contact is wide enough.
pub(crate) fn recover(pressures: &mut [f64]) {
    if pressures.len() < NEEDED || pressures[..NEEDED].iter().any(|p| *p <= 0.0) {
        return;
    }
    // Squared radius in units of the outermost fitted node, to keep the normal equations tame.
    let square = |k: usize| (k as f64 / FITTED.end as f64).powi(2);
    let basis = |k: usize| Vector3::new(1.0, square(k), square(k).powi(2));
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for k in FITTED {
        normal += basis(k) * basis(k).transpose();
        right += basis(k) * pressures[k];
    }
    let Some(factor) = normal.cholesky() else { return };
    let coefficients = factor.solve(&right);
    for (k, pressure) in pressures.iter_mut().enumerate().take(REPLACED) {
        *pressure = basis(k).dot(&coefficients);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smooth_pressure_is_continued_to_the_axis() {
        let hertz = |k: u32| (1.0 - (f64::from(k) / 20.0).powi(2)).max(0.0).sqrt();
        let mut pressures: Vec<f64> = (0..30).map(hertz).collect();
        pressures[0] *= 0.988;
        pressures[1] *= 0.996;
        recover(&mut pressures);
        for k in 0..3 {
            assert!((pressures[k as usize] - hertz(k)).abs() < 3e-4);
        }
    }

    #[test]
    fn a_narrow_or_annular_contact_is_left_alone() {
        let narrow: Vec<f64> =
            (0..30).map(|k| if k < 10 { 1.0 + f64::from(k) } else { 0.0 }).collect();
        let mut pressures = narrow.clone();
        recover(&mut pressures);
        assert_eq!(pressures, narrow);
    }
}
