//! The radial return of a trial state to the hardening curve.
//!
//! ```text
//! q + 3G ε_p = 3G ε,   q = q(ε_p)        ε = q_tr / (3G) + ε_p,n
//! ```
//!
//! with the equivalent trial stress `q_tr` and the plastic strain `ε_p,n` before. From rest, ε is
//! the equivalent strain, and the result is deformation theory.
//!
//! Piecewise linear laws have a closed form. Other laws are solved in advance at the nodes of an
//! [`Interpolant`], which is exact to rounding. An evaluation costs one polynomial for any law.

use std::sync::Arc;

use super::HardeningLaw;
use super::interpolant::Interpolant;

/// A hardening law beside an elastic shear modulus, prepared for evaluation.
#[derive(Debug, Clone)]
pub struct ReturnMapping {
    law: Arc<dyn HardeningLaw>,
    triple_shear: f64,
    yield_stress: f64,
    form: Form,
}

#[derive(Debug, Clone)]
enum Form {
    /// One slope `dq/dε` \[MPa\] beyond yield.
    Line(f64),
    /// Corners `[ε, q]`; the last one is the end of hardening.
    Polyline(Vec<[f64; 2]>),
    /// Any other law: q over `ε - σ_y/(3G)`.
    Curve(Interpolant),
}

/// Plastic strain over the elastic one from which on a point of a curve without an elastic limit
/// counts as yielded, and from which on a point that gains it in an increment flows.
const YIELDED: f64 = 1e-2;
/// Part of its plastic region from which on a body flows.
const FLOWING: f64 = 1e-2;
/// Newton step over the unknown below which only rounding is left.
const LAST_STEP: f64 = 1e-9;

/// Returns whether a point flows in an increment in which it gains a plastic strain `gained`: if that
/// is more than a hundredth of its elastic strain. `triple_shear` is 3G \[MPa\].
pub fn flows(gained: f64, stress: f64, triple_shear: f64) -> bool {
    gained > YIELDED * stress / triple_shear
}

/// Returns whether a body flows of which a part `flowing` of its region `plastic` flows, both areas or
/// volumes: single points at the end of a contact leave it elastic.
pub fn body_flows(flowing: f64, plastic: f64) -> bool {
    flowing > FLOWING * plastic
}

/// Returns the stress from which on a point counts as yielded \[MPa\]
/// ([`ReturnMapping::has_yielded`]). `triple_shear` is 3G \[MPa\].
pub fn stress_of_yield(law: &dyn HardeningLaw, triple_shear: f64) -> f64 {
    if law.yield_stress() > 0.0 {
        return law.yield_stress();
    }
    // Bisects the logarithm of the plastic strain.
    let [mut below, mut above] = [f64::MIN_POSITIVE.ln(), 0.0];
    for _ in 0..64 {
        let middle = 0.5 * (below + above);
        let strain: f64 = middle.exp();
        if strain > YIELDED * law.stress(strain) / triple_shear {
            above = middle;
        } else {
            below = middle;
        }
    }
    law.stress(above.exp())
}

impl ReturnMapping {
    /// Prepares a law beside a shear modulus \[MPa\].
    pub fn new(law: Arc<dyn HardeningLaw>, shear_modulus: f64) -> Self {
        let triple_shear = 3.0 * shear_modulus;
        let yield_stress = law.yield_stress();
        let form = match law.polyline() {
            Some(corners) if corners.len() == 1 => {
                let plastic = law.slope(0.0);
                Form::Line(triple_shear * plastic / (triple_shear + plastic))
            }
            Some(corners) => {
                Form::Polyline(corners.iter().map(|[p, q]| [q / triple_shear + p, *q]).collect())
            }
            None => Form::Curve(Interpolant::new()),
        };
        Self { law, triple_shear, yield_stress, form }
    }

    /// The law.
    pub fn law(&self) -> &dyn HardeningLaw {
        &*self.law
    }

    /// Whether a point counts as yielded: if it has plastic strain or, on a curve without an
    /// elastic limit, if that strain is more than a hundredth of the elastic one.
    #[inline]
    pub fn has_yielded(&self, stress: f64, plastic_strain: f64) -> bool {
        let least =
            if self.yield_stress > 0.0 { 0.0 } else { YIELDED * stress / self.triple_shear };
        plastic_strain > least
    }

    /// σ_y \[MPa\].
    pub fn yield_stress(&self) -> f64 {
        self.yield_stress
    }

    /// The stress q \[MPa\] that solves `q/(3G) + ε_p(q) = ε` for `ε >= 0`; never above `3G ε`.
    #[inline]
    pub fn stress(&self, strain: f64) -> f64 {
        let trial = self.triple_shear * strain;
        if trial <= self.yield_stress {
            return trial;
        }
        match &self.form {
            Form::Line(slope) => trial
                .min(self.yield_stress + slope * (strain - self.yield_stress / self.triple_shear)),
            Form::Polyline(corners) => along(corners, strain),
            Form::Curve(curve) => {
                let beyond = strain - self.yield_stress / self.triple_shear;
                curve
                    .at(beyond, || self.solver())
                    .unwrap_or_else(|| self.solve(strain, None))
                    .min(trial)
            }
        }
    }

    /// Newton's method from a stress nearby, if one is known.
    fn solve(&self, strain: f64, near: Option<f64>) -> f64 {
        let trial = self.triple_shear * strain;
        let q = if self.law.inverse(0.0).is_some() {
            self.solve_for_stress(strain, near)
        } else {
            let near = near.map(|q| strain - q / self.triple_shear).filter(|p| *p > 0.0);
            self.solve_for_strain(trial, near)
        };
        q.min(trial)
    }

    /// `f(q) = q/(3G) + ε_p(q) - ε` is convex and rising: started above the root Newton's method
    /// falls to it without overshoot, and its first step from below leads there. Without a start
    /// it is the lower of the elastic and the purely plastic answer; both lie above.
    fn solve_for_stress(&self, strain: f64, near: Option<f64>) -> f64 {
        let excess = |q: f64| {
            let inverse = self.law.inverse(q)?;
            Some((q / self.triple_shear + inverse.plastic_strain - strain, inverse.slope))
        };
        let mut q =
            near.unwrap_or_else(|| self.law.stress(strain).min(self.triple_shear * strain));
        for _ in 0..60 {
            let Some((rest, slope)) = excess(q) else { break };
            let step = rest / (self.triple_shear.recip() + slope);
            q = (q - step).max(0.0);
            if step.abs() <= LAST_STEP * q {
                break;
            }
        }
        q
    }

    /// `f(p) = q(p) + 3G p - 3G ε` is concave and rising. Newton's method in the bracket `[0, (3G
    /// ε - σ_y)/3G]`; a step that leaves it (an infinite slope at zero) is replaced by bisection.
    fn solve_for_strain(&self, trial: f64, near: Option<f64>) -> f64 {
        // On a steep curve the plastic strain is below rounding.
        if self.law.stress(f64::EPSILON * trial / self.triple_shear) >= trial {
            return trial;
        }
        let (mut low, mut high) = (0.0, (trial - self.yield_stress) / self.triple_shear);
        let mut strain: f64 = near.map_or(high, |near| near.min(high));
        let mut stress = trial;
        for _ in 0..100 {
            let (q, slope) = self.law.stress_and_slope(strain);
            let rest = q + self.triple_shear * strain - trial;
            if rest > 0.0 {
                high = strain;
            } else {
                low = strain;
            }
            let step = -rest / (slope + self.triple_shear);
            let newton = strain + step;
            if newton > low && newton < high || rest == 0.0 {
                // The tangent at the last point. `trial - 3G p` would lose digits at large
                // strains.
                stress = q + slope * step;
                strain = newton;
                if step.abs() <= LAST_STEP * strain {
                    break;
                }
            } else if high - low <= 1e-15 * high || step.abs() <= 1e-15 * high {
                stress = q;
                break;
            } else {
                strain = 0.5 * (low + high);
            }
        }
        stress
    }

    /// q over `ε - σ_y/(3G)` for strains one after the other, each of which is a start for the
    /// next.
    fn solver(&self) -> impl FnMut(f64) -> f64 {
        let onset = self.yield_stress / self.triple_shear;
        let mut last: Option<[f64; 3]> = None;
        move |beyond| {
            let near = last.map(|[before, q, slope]| q + slope * (beyond - before));
            let q = self.solve(onset + beyond, near);
            last = Some([beyond, q, self.slope_at(onset + beyond, q)]);
            q
        }
    }

    /// `dq/dε` where q is the answer for ε.
    fn slope_at(&self, strain: f64, stress: f64) -> f64 {
        if let Some(inverse) = self.law.inverse(stress) {
            return (self.triple_shear.recip() + inverse.slope).recip();
        }
        let plastic = self.law.slope((strain - stress / self.triple_shear).max(0.0));
        if plastic.is_finite() {
            self.triple_shear * plastic / (self.triple_shear + plastic)
        } else {
            self.triple_shear
        }
    }
}

/// Interpolates on the segment of a strain, found by bisection; constant beyond the last corner.
fn along(corners: &[[f64; 2]], strain: f64) -> f64 {
    let beyond = corners.partition_point(|corner| corner[0] <= strain);
    let from = beyond.checked_sub(1).map_or([0.0, 0.0], |k| corners[k]);
    match corners.get(beyond) {
        Some(to) => from[1] + (strain - from[0]) * (to[1] - from[1]) / (to[0] - from[0]),
        None => from[1],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hardening::tests::{TRIPLE_SHEAR, YOUNG, laws};
    use crate::hardening::{Ludwik, RambergOsgood};

    fn mapping(law: Arc<dyn HardeningLaw>) -> ReturnMapping {
        ReturnMapping::new(law, TRIPLE_SHEAR / 3.0)
    }

    fn ramberg_osgood(exponent: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(RambergOsgood::of_offset(500.0, 0.3, exponent, YOUNG))
    }

    fn ludwik(exponent: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(Ludwik { yield_stress: 500.0, coefficient: 300.0, exponent })
    }

    #[test]
    fn it_meets_the_uniaxial_curve_of_every_law() {
        for law in laws() {
            let mapping = mapping(Arc::clone(&law));
            for plastic_strain in [1e-14, 1e-9, 1e-6, 3e-5, 1e-3, 5e-3, 0.02, 0.3, 4.0, 90.0] {
                let q = law.stress(plastic_strain);
                let found = mapping.stress(q / TRIPLE_SHEAR + plastic_strain);
                assert!(
                    (found - q).abs() < 2e-12 * q,
                    "{law:?} at {plastic_strain}: {found} instead of {q}"
                );
            }
        }
    }

    /// At any strain, not only where a plastic strain is round.
    #[test]
    fn the_prepared_curve_is_the_solved_one() {
        let sharp = [ramberg_osgood(200.0), ludwik(0.01)];
        for law in laws().into_iter().chain(sharp) {
            let mapping = mapping(Arc::clone(&law));
            for k in 0..4000 {
                let strain = 1e-13 * 1.01f64.powi(k);
                let (q, solved) = (mapping.stress(strain), mapping.solve(strain, None));
                if strain * TRIPLE_SHEAR > mapping.yield_stress() && law.polyline().is_none() {
                    assert!(
                        (q - solved).abs() < 1e-12 * solved,
                        "{law:?} at {strain}: {q} instead of {solved}"
                    );
                }
            }
        }
    }

    #[test]
    fn below_yield_it_is_elastic() {
        for law in laws() {
            let limit = law.yield_stress();
            for q in [0.0, 0.5 * limit, 0.999 * limit] {
                assert!(
                    (mapping(Arc::clone(&law)).stress(q / TRIPLE_SHEAR) - q).abs()
                        <= 1e-12 * limit
                );
            }
        }
    }

    #[test]
    fn stress_never_falls_with_strain_nor_exceeds_the_elastic_one() {
        for law in laws() {
            let mapping = mapping(Arc::clone(&law));
            let mut last = 0.0;
            for k in 0..2000 {
                let strain = 1e-7 * 1.01f64.powi(k);
                let q = mapping.stress(strain);
                assert!(
                    q >= last * (1.0 - 1e-12) && q <= TRIPLE_SHEAR * strain * (1.0 + 1e-12),
                    "{law:?}"
                );
                last = q;
            }
        }
    }

    /// Extreme exponents: nearly linear, nearly perfectly plastic.
    #[test]
    fn sharp_and_flat_power_laws_are_met() {
        for exponent in [1.0, 1.5, 20.0, 200.0] {
            let law = ramberg_osgood(exponent);
            let mapping = mapping(law.clone());
            for q in [1.0, 100.0, 400.0, 499.0, 501.0, 520.0, 900.0_f64] {
                let Some(inverse) = law.inverse(q) else { continue };
                if inverse.plastic_strain < 50.0 {
                    let found = mapping.stress(q / TRIPLE_SHEAR + inverse.plastic_strain);
                    assert!((found - q).abs() < 1e-12 * q, "m {exponent}: {found} instead of {q}");
                }
            }
        }
    }
}
