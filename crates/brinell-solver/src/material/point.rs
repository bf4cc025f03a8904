//! The response of one material point.

use super::{HardeningLaw, UniaxialCurve, equivalent_strain};
use crate::job::Deformable;

/// What is known of the out-of-plane direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutOfPlane {
    /// The strain ε_zz is given (zero in plane strain, hoop strain in axisymmetry).
    Strained,
    /// The stress σ_zz is zero and the strain follows (plane stress).
    Free,
}

/// Stress as a function of strain by deformation theory.
#[derive(Debug, Clone, PartialEq)]
pub struct PointLaw {
    bulk_modulus: f64,
    shear_modulus: f64,
    curve: Option<UniaxialCurve>,
    /// Infinite without a curve \[MPa\].
    yield_stress: f64,
    out_of_plane: OutOfPlane,
}

/// State of one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointState {
    /// `[σ_xx, σ_yy, σ_zz, τ_xy]` \[MPa\], tensile positive.
    pub stress: [f64; 4],
    /// Secant shear modulus G_s \[MPa\].
    pub secant_shear: f64,
    /// Equivalent plastic strain.
    pub equivalent_plastic_strain: f64,
    /// Whether the point counts as yielded.
    pub yielded: bool,
}

/// How far from elastic a point is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Secant {
    shear: f64,
    plastic_strain: f64,
    yielded: bool,
}

impl PointLaw {
    /// The law of a material.
    pub fn new(material: &Deformable, out_of_plane: OutOfPlane) -> Self {
        let curve = UniaxialCurve::of(material);
        Self {
            bulk_modulus: material.elastic().bulk_modulus(),
            shear_modulus: material.elastic().shear_modulus(),
            yield_stress: curve.as_ref().map_or(f64::INFINITY, HardeningLaw::yield_stress),
            curve,
            out_of_plane,
        }
    }

    /// What is known of the out-of-plane direction.
    pub fn out_of_plane(&self) -> OutOfPlane {
        self.out_of_plane
    }

    pub(super) fn curve(&self) -> Option<&UniaxialCurve> {
        self.curve.as_ref()
    }

    pub(super) fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    pub(super) fn bulk_modulus(&self) -> f64 {
        self.bulk_modulus
    }

    /// Whether plastic strain is possible at all.
    pub fn can_yield(&self) -> bool {
        self.curve.is_some()
    }

    /// Equivalent strain up to which a point with known ε_zz is elastic; infinite without a hardening curve.
    pub fn elastic_limit(&self) -> f64 {
        self.yield_stress / (3.0 * self.shear_modulus)
    }

    /// State at a strain `[ε_xx, ε_yy, ε_zz, γ_xy]`. The dilatation is given apart, because B-bar elements take
    /// it from the whole element; with a free thickness both it and ε_zz are found here instead.
    #[inline]
    pub fn respond(&self, strain: [f64; 4], dilatation: f64) -> PointState {
        match self.out_of_plane {
            OutOfPlane::Strained => {
                let deviator = deviator(strain);
                self.state(deviator, dilatation, self.secant(equivalent_strain(deviator)))
            }
            OutOfPlane::Free => {
                let (strain, secant) = self.with_free_thickness(strain);
                let state = self.state(deviator(strain), strain[0] + strain[1] + strain[2], secant);
                let [x, y, _, t] = state.stress;
                PointState { stress: [x, y, 0.0, t], ..state }
            }
        }
    }

    /// Initial stress `D_e ε - σ` \[MPa\] at a strain, and whether the point has yielded.
    pub fn initial_stress(&self, strain: [f64; 4]) -> ([f64; 4], bool) {
        match self.out_of_plane {
            OutOfPlane::Strained => {
                let deviator = deviator(strain);
                let (factor, yielded) = self.initial_stress_factor(equivalent_strain(deviator));
                let [x, y, z, g] = deviator.map(|e| factor * e);
                ([x, y, z, 0.5 * g], yielded)
            }
            OutOfPlane::Free => {
                let state = self.respond(strain, 0.0);
                if state.equivalent_plastic_strain == 0.0 {
                    return ([0.0; 4], false);
                }
                let [x, y, _, g] = strain;
                let lame = self.bulk_modulus - 2.0 / 3.0 * self.shear_modulus;
                let plane = 2.0 * self.shear_modulus * lame / (lame + 2.0 * self.shear_modulus);
                let normal = |e: f64| 2.0 * self.shear_modulus * e + plane * (x + y);
                let [sx, sy, _, t] = state.stress;
                ([normal(x) - sx, normal(y) - sy, 0.0, self.shear_modulus * g - t], state.yielded)
            }
        }
    }

    /// `2 (G - G_s)` \[MPa\] at an equivalent strain, and whether the point has yielded.
    #[inline]
    pub fn initial_stress_factor(&self, equivalent_strain: f64) -> (f64, bool) {
        let secant = self.secant(equivalent_strain);
        (2.0 * (self.shear_modulus - secant.shear), secant.yielded)
    }

    #[inline(always)]
    fn secant(&self, equivalent_strain: f64) -> Secant {
        let elastic = 3.0 * self.shear_modulus * equivalent_strain;
        match &self.curve {
            Some(curve) if elastic > self.yield_stress => {
                let q = curve.equivalent_stress(equivalent_strain);
                let plastic_strain = (elastic - q) / (3.0 * self.shear_modulus);
                Secant {
                    shear: q / (3.0 * equivalent_strain),
                    plastic_strain,
                    yielded: curve.has_yielded(q, plastic_strain),
                }
            }
            _ => Secant { shear: self.shear_modulus, plastic_strain: 0.0, yielded: false },
        }
    }

    #[inline(always)]
    fn state(&self, deviator: [f64; 4], dilatation: f64, secant: Secant) -> PointState {
        let pressure = self.bulk_modulus * dilatation;
        let [x, y, z, g] = deviator.map(|e| 2.0 * secant.shear * e);
        PointState {
            stress: [pressure + x, pressure + y, pressure + z, 0.5 * g],
            secant_shear: secant.shear,
            equivalent_plastic_strain: secant.plastic_strain,
            yielded: secant.yielded,
        }
    }

    /// The ε_zz that leaves σ_zz = 0, and the state with it.
    ///
    /// For a secant modulus G_s it is `ε_zz = -(K - ⅔G_s)(ε_xx + ε_yy) / (K + 4/3 G_s)`; the G_s that this strain
    /// implies falls short of or exceeds the assumed one, and the two are made equal by the false-position method
    /// of Illinois between 0 and G.
    pub(super) fn with_free_thickness(&self, strain: [f64; 4]) -> ([f64; 4], Secant) {
        let in_plane = strain[0] + strain[1];
        let completed = |shear: f64| {
            let zz =
                -(self.bulk_modulus - 2.0 / 3.0 * shear) * in_plane / (self.bulk_modulus + 4.0 / 3.0 * shear);
            let full = [strain[0], strain[1], zz, strain[3]];
            (full, self.secant(equivalent_strain(deviator(full))))
        };
        let mut answer = completed(self.shear_modulus);
        if answer.1.plastic_strain == 0.0 {
            return answer;
        }
        // Implied minus assumed modulus: not negative at 0, not positive at G.
        let (mut low, mut high) = (0.0, self.shear_modulus);
        let mut at_low = completed(low).1.shear;
        let mut at_high = answer.1.shear - high;
        let mut last_side = 0;
        for _ in 0..60 {
            let middle = (low * at_high - high * at_low) / (at_high - at_low);
            answer = completed(middle);
            let rest = answer.1.shear - middle;
            if rest.abs() <= 1e-14 * self.shear_modulus {
                break;
            }
            if rest > 0.0 {
                (low, at_low) = (middle, rest);
                at_high *= if last_side == 1 { 0.5 } else { 1.0 };
                last_side = 1;
            } else {
                (high, at_high) = (middle, rest);
                at_low *= if last_side == -1 { 0.5 } else { 1.0 };
                last_side = -1;
            }
        }
        answer
    }
}

#[inline(always)]
pub(super) fn deviator(strain: [f64; 4]) -> [f64; 4] {
    let [x, y, z, g] = strain;
    let mean = (x + y + z) / 3.0;
    [x - mean, y - mean, z - mean, g]
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::job::{Elastic, Hardening, NonNegativeF64, PoissonRatio, PositiveF64};

    /// Steel with a straight hardening curve.
    pub(in crate::material) fn law(out_of_plane: OutOfPlane) -> PointLaw {
        let positive = |value| PositiveF64::new(value).unwrap();
        let elastic =
            Elastic { young_modulus: positive(210_000.0), poisson_ratio: PoissonRatio::new(0.3).unwrap() };
        let hardening = Hardening::Bilinear {
            yield_stress: positive(500.0),
            tangent_modulus: NonNegativeF64::new(10_500.0).unwrap(),
        };
        PointLaw::new(&Deformable::new(elastic, Some(hardening)).unwrap(), out_of_plane)
    }

    #[test]
    fn uniaxial_tension_of_a_free_sheet_follows_the_uniaxial_curve() {
        let law = law(OutOfPlane::Free);
        let modulus = 10_500.0 / (1.0 - 0.05);
        for stress in [200.0, 499.0, 510.0, 700.0, 1500.0] {
            let plastic = f64::max(0.0, (stress - 500.0) / modulus);
            let along = stress / 210_000.0 + plastic;
            let across = -0.3 * stress / 210_000.0 - 0.5 * plastic;
            let state = law.respond([along, across, 0.0, 0.0], 0.0);
            assert!((state.stress[0] - stress).abs() < 1e-8 * stress, "{stress}: {state:?}");
            assert!(state.stress[1].abs() < 1e-8 * stress && state.stress[2] == 0.0);
            assert!((state.equivalent_plastic_strain - plastic).abs() < 1e-12);
        }
    }

    #[test]
    fn initial_stress_is_elastic_less_actual_stress() {
        let (bulk, shear) = (175_000.0, 210_000.0 / 2.6);
        let strain = [4e-3, -1e-3, 5e-4, 3e-3];
        let law = law(OutOfPlane::Strained);
        let dilatation = 3.5e-3;
        let state = law.respond(strain, dilatation);
        assert!(state.yielded);
        let (initial, _) = law.initial_stress(strain);
        for k in 0..4 {
            let elastic = if k == 3 {
                shear * strain[3]
            } else {
                bulk * dilatation + 2.0 * shear * (strain[k] - dilatation / 3.0)
            };
            assert!((elastic - state.stress[k] - initial[k]).abs() < 1e-8, "component {k}");
        }
    }
}
