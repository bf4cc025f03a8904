//! The same uniaxial curve by kinematic hardening.
//!
//! A tensile test does not tell isotropic from kinematic hardening: both give its curve, and differ
//! once the load turns round. A backstress of terms `C, γ` has the curve
//! ```text
//! q(ε_p) = σ_y + Σ C_i (1 - exp(-γ_i ε_p))/γ_i        C_i ε_p for γ_i = 0
//! ```
//! Here the moduli `C_i >= 0` are those of the least squares of a curve, with fixed rates. A straight
//! line is one term without recovery, exactly.
//!
//! # Reference
//! J. L. Chaboche, *A review of some plasticity and viscoplasticity constitutive theories*, Int. J.
//! Plasticity 24 (2008), section 2.

use std::sync::Arc;

use crate::hardening::StraightLine;
use crate::{BackstressTerm, HardeningLaw, Solid};

/// Rates of the terms: four decades of plastic strain, and none.
const RATES: [f64; TERMS] = [0.0, 20.0, 200.0, 2000.0];
const TERMS: usize = 4;
/// Plastic strains over which the curve is fitted, evenly in their logarithm: those of a load that
/// rolls, up to what small strains are meant for.
const STRAINS: [f64; 2] = [1e-5, 0.1];
const POINTS: u32 = 81;
/// Rise of a curve over its yield stress below which it does not harden.
const FLAT: f64 = 1e-9;

impl Solid {
    /// Returns the material with the same uniaxial curve and yield point, hardening kinematically
    /// alone; `None` if it has a backstress, does not harden, or has no yield point.
    ///
    /// The strength over depth scales the yield point, and not the hardening.
    #[must_use]
    pub fn hardening_kinematically(&self) -> Option<Self> {
        let (law, yield_stress) = (self.hardening_law()?, self.yield_stress()?);
        let hardens = law.stress(STRAINS[1]) > (1.0 + FLAT) * yield_stress;
        if !self.backstress().is_empty() || !hardens {
            return None;
        }
        let flat = StraightLine { yield_stress, plastic_modulus: 0.0 };
        let terms = terms_of(&**law, yield_stress);
        Some(self.clone().with_hardening(Arc::new(flat)).with_backstress(terms))
    }
}

/// Returns the terms whose curve is nearest to that of a law.
fn terms_of(law: &dyn HardeningLaw, yield_stress: f64) -> Vec<BackstressTerm> {
    let ratio = STRAINS[1] / STRAINS[0];
    let strains =
        (0..POINTS).map(|i| STRAINS[0] * ratio.powf(f64::from(i) / f64::from(POINTS - 1)));
    // Normal equations, in C times the strain or 1/γ that makes it a stress.
    let mut matrix = [[0.0; TERMS]; TERMS];
    let mut right = [0.0; TERMS];
    for strain in strains {
        let values = RATES.map(|rate| basis(rate, strain));
        let rise = law.stress(strain) - yield_stress;
        for (i, value) in values.iter().enumerate() {
            right[i] += value * rise;
            for (j, other) in values.iter().enumerate() {
                matrix[i][j] += value * other;
            }
        }
    }
    // Of all sets of terms the one that fits best without a negative modulus.
    let fits = (1..1_usize << TERMS).filter_map(|set| {
        let found = solve(&matrix, &right, set)?;
        let gain: f64 = found.iter().zip(&right).map(|(c, b)| c * b).sum();
        found.iter().all(|c| *c >= 0.0).then_some((found, gain))
    });
    let best = fits.max_by(|a, b| a.1.total_cmp(&b.1));
    let scaled = best.map_or([0.0; TERMS], |(found, _)| found);
    let terms = RATES
        .iter()
        .zip(scaled)
        .map(|(rate, scaled)| BackstressTerm { modulus: scaled * scale(*rate), rate: *rate });
    terms.filter(|term| term.modulus > 0.0).collect()
}

/// `γ`, or one over the largest strain without recovery.
fn scale(rate: f64) -> f64 {
    if rate > 0.0 { rate } else { STRAINS[1].recip() }
}

/// The curve of a term whose modulus is [`scale`].
fn basis(rate: f64, strain: f64) -> f64 {
    if rate > 0.0 { -(-rate * strain).exp_m1() } else { strain * scale(rate) }
}

/// Solves the equations of a set of unknowns, the bits of `set`; the others are 0.
fn solve(
    matrix: &[[f64; TERMS]; TERMS],
    right: &[f64; TERMS],
    set: usize,
) -> Option<[f64; TERMS]> {
    let (mut a, mut b) = (*matrix, *right);
    let is_in = |i: usize| set >> i & 1 == 1;
    for i in (0..TERMS).filter(|i| !is_in(*i)) {
        (a[i], b[i]) = ([0.0; TERMS], 0.0);
        for row in &mut a {
            row[i] = 0.0;
        }
        a[i][i] = 1.0;
    }
    // The matrix is positive definite: no pivots.
    for i in 0..TERMS {
        let pivot = Some(a[i][i]).filter(|pivot| *pivot > 0.0)?;
        for j in i + 1..TERMS {
            let (factor, above) = (a[j][i] / pivot, a[i]);
            for (value, above) in a[j].iter_mut().zip(above) {
                *value -= factor * above;
            }
            b[j] -= factor * b[i];
        }
    }
    for i in (0..TERMS).rev() {
        let known: f64 = (i + 1..TERMS).map(|k| a[i][k] * b[k]).sum();
        b[i] = (b[i] - known) / a[i][i];
    }
    b.iter().all(|value| value.is_finite()).then_some(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hardening::tests::{YOUNG, laws};

    fn solid(law: Arc<dyn HardeningLaw>) -> Solid {
        let elastic =
            crate::analytical::ElasticConstants { young_modulus: YOUNG, poisson_ratio: 0.3 };
        Solid::new(elastic).with_hardening(law)
    }

    fn curve(terms: &[BackstressTerm], strain: f64) -> f64 {
        let of =
            |term: &BackstressTerm| term.modulus / scale(term.rate) * basis(term.rate, strain);
        terms.iter().map(of).sum()
    }

    #[test]
    fn a_straight_line_is_one_term() {
        let law = StraightLine { yield_stress: 500.0, plastic_modulus: 11_053.0 };
        let kinematic = solid(Arc::new(law)).hardening_kinematically().unwrap();
        let [term] = kinematic.backstress() else { panic!("{kinematic:?}") };
        assert!(term.rate == 0.0 && (term.modulus / 11_053.0 - 1.0).abs() < 1e-9, "{term:?}");
        assert!((kinematic.hardening_law().unwrap().largest_stress() - 500.0).abs() < 1e-9);
    }

    /// Curves with a yield point are met within 3 % of their stress.
    #[test]
    fn curves_keep_their_uniaxial_stress() {
        let mut fitted = 0;
        for law in laws() {
            let Some(kinematic) = solid(Arc::clone(&law)).hardening_kinematically() else {
                continue;
            };
            fitted += 1;
            for strain in [1e-4, 5e-4, 2e-3, 0.01, 0.03, 0.1] {
                let q = law.yield_stress() + curve(kinematic.backstress(), strain);
                let wanted = law.stress(strain);
                assert!((q / wanted - 1.0).abs() < 0.03, "{law:?} {strain}: {q} {wanted}");
            }
            assert!(kinematic.hardening_kinematically().is_none());
        }
        assert!(fitted >= 4, "{fitted}");
    }
}
