//! Uniaxial hardening laws: stress against plastic strain, one file each.
//!
//! A law does not contain the shear modulus: [`crate::ReturnMapping`] combines curve and
//! elasticity.

mod ludwik;
mod poly_line;
mod ramberg_osgood;
mod straight_line;
mod swift;
mod voce;

use std::any::Any;
use std::fmt::Debug;

pub use ludwik::Ludwik;
pub use poly_line::PolyLine;
pub use ramberg_osgood::RambergOsgood;
pub use straight_line::StraightLine;
pub use swift::Swift;
pub use voce::Voce;

/// A uniaxial curve `q(ε_p)` of stress \[MPa\] against plastic strain, rising and concave.
pub trait HardeningLaw: Any + Debug + Send + Sync {
    /// Returns the elastic limit \[MPa\]; 0 where plastic strain begins at once.
    fn yield_stress(&self) -> f64;

    /// Returns q at a plastic strain `>= 0` \[MPa\].
    fn stress(&self, plastic_strain: f64) -> f64;

    /// Returns `dq/dε_p` \[MPa\]; may be infinite at zero.
    fn slope(&self, plastic_strain: f64) -> f64;

    /// Returns stress and slope, for laws that share work between them.
    fn stress_and_slope(&self, plastic_strain: f64) -> (f64, f64) {
        (self.stress(plastic_strain), self.slope(plastic_strain))
    }

    /// Returns `ε_p(q)` for a law that is defined by this inverse; `None` for all others.
    fn inverse(&self, _stress: f64) -> Option<Inverse> {
        None
    }

    /// Returns the corners `[ε_p, q]` of a piecewise linear law, the first at zero plastic strain;
    /// beyond the last corner the slope there continues. `None` for a curved law.
    fn polyline(&self) -> Option<Vec<[f64; 2]>> {
        None
    }

    /// Returns the yield stress or, for a curve without an elastic limit, a conventional proof
    /// stress \[MPa\].
    fn nominal_yield_stress(&self) -> f64 {
        self.yield_stress()
    }

    /// Returns a stress at which the material flows noticeably \[MPa\], for an estimate of the
    /// contact size before the first solve: that at 0.2 % of plastic strain at least, for a curve
    /// that begins low may rise far.
    fn flow_stress(&self) -> f64 {
        self.stress(0.002).max(1.2 * self.yield_stress())
    }

    /// Returns the stress that the curve approaches or reaches at large plastic strains \[MPa\];
    /// infinite for a curve that rises without bound.
    fn largest_stress(&self) -> f64 {
        f64::INFINITY
    }

    /// Whether another law is the same curve: bodies of such laws share their stiffness. A law
    /// that cannot tell says no.
    fn is_like(&self, _other: &(dyn HardeningLaw + 'static)) -> bool {
        false
    }
}

/// Whether another law is of the same kind with the same constants.
fn is_same<L: HardeningLaw + PartialEq>(law: &L, other: &(dyn HardeningLaw + 'static)) -> bool {
    (other as &dyn Any).downcast_ref() == Some(law)
}

/// Plastic strain at a stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inverse {
    /// ε_p.
    pub plastic_strain: f64,
    /// `dε_p/dq` \[1/MPa\].
    pub slope: f64,
}

#[cfg(test)]
pub(crate) mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::ElasticModuli;

    pub(crate) const YOUNG: f64 = 210_000.0;
    pub(crate) const TRIPLE_SHEAR: f64 = 3.0 * YOUNG / 2.6;
    pub(crate) const STEEL: ElasticModuli =
        ElasticModuli { bulk: 175_000.0, shear: TRIPLE_SHEAR / 3.0 };

    /// Every law, two of one.
    pub(crate) fn laws() -> Vec<Arc<dyn HardeningLaw>> {
        let yield_stress = 500.0;
        let points = vec![[0.0, 400.0], [1e-3, 520.0], [0.01, 600.0], [0.1, 640.0]];
        vec![
            Arc::new(StraightLine::of_tangent(yield_stress, 10_500.0, YOUNG)),
            Arc::new(StraightLine { yield_stress, plastic_modulus: 0.0 }),
            Arc::new(RambergOsgood::of_offset(500.0, 0.3, 5.0, YOUNG)),
            Arc::new(PolyLine { points }),
            Arc::new(Swift { yield_stress, strain_offset: 2e-3, exponent: 0.15 }),
            Arc::new(Ludwik { yield_stress, coefficient: 700.0, exponent: 0.4 }),
            Arc::new(Voce { yield_stress, saturation_stress: 800.0, rate: 30.0 }),
        ]
    }

    /// A curve comes within a thousandth of a finite largest stress and never above it.
    #[test]
    fn largest_stresses_are_bounds_that_are_reached() {
        let bounds: Vec<f64> = laws().iter().map(|law| law.largest_stress()).collect();
        let rising = f64::INFINITY;
        assert_eq!(bounds, [rising, 500.0, rising, 640.0, rising, rising, 800.0]);
        for law in laws() {
            let (bound, far) = (law.largest_stress(), law.stress(2.0));
            assert!(far <= bound, "{law:?}");
            assert!(bound.is_infinite() || far > 0.999 * bound, "{law:?}");
        }
    }

    #[test]
    fn slopes_are_derivatives_and_inverses_are_inverse() {
        for law in laws() {
            for p in [2e-4, 5e-3, 0.05, 2.0] {
                let step = 1e-6 * p;
                let derivative = (law.stress(p + step) - law.stress(p - step)) / (2.0 * step);
                assert!(
                    (law.slope(p) - derivative).abs() < 1e-5 * derivative.max(1.0),
                    "{law:?} at {p}"
                );
                assert_eq!(law.stress_and_slope(p), (law.stress(p), law.slope(p)));
                if let Some(inverse) = law.inverse(law.stress(p)) {
                    assert!((inverse.plastic_strain - p).abs() < 1e-12 * p);
                    assert!((inverse.slope * law.slope(p) - 1.0).abs() < 1e-12);
                }
            }
        }
    }
}
