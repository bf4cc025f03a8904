//! Deformation (total, Hencky) theory of plasticity.
//!
//! Split the strain into its mean and its deviator `e`, with the equivalent strain `ε_q = √(2/3
//! e:e)`. The response to the mean stays elastic. The deviatoric stress is
//!
//! ```text
//! s = 2 G_s e,   G_s = q / (3 ε_q),   ε_q = q / (3G) + ε_p(q)
//! ```
//!
//! with the equivalent (von Mises) stress `q` and the plastic strain `ε_p(q)` of the uniaxial
//! curve. `G_s <= G` is the *secant* shear modulus. The *initial stress* is the excess of the
//! elastic stress, `σ_0 = D_e ε - σ = 2 (G - G_s) e`; it is deviatoric.
//!
//! The theory has no unloading. It is exact where all stress components grow in proportion.
//!
//! # Reference
//! H. Hencky, *Zur Theorie plastischer Deformationen*, ZAMM 4 (1924) 323–334.

use std::sync::Arc;

use super::model::PerPoint;
use super::tangent::reduction;
use super::{
    ConstitutiveModel, ElasticModuli, HardeningLaw, ModuliReduction, OutOfPlane, PointResponse,
    ReferenceModuli, ReturnMapping, deviator, equivalent_strain,
};

/// Stress as a function of strain alone.
#[derive(Debug, Clone)]
pub struct DeformationPlasticity {
    elastic: ElasticModuli,
    mapping: Option<ReturnMapping>,
    /// Yield stress; infinite for a material that cannot yield \[MPa\].
    yield_stress: f64,
    out_of_plane: OutOfPlane,
}

/// Trials of the secant modulus in plane stress: the usual number, after which every second trial
/// bisects the bracket, and the largest.
const USUAL_TRIALS: u32 = 10;
const MOST_TRIALS: u32 = 130;
/// Accuracy of the secant modulus over G at which the trials end.
const SECANT_ACCURACY: f64 = 1e-14;

/// The secant state of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Secant {
    shear: f64,
    plastic_strain: f64,
    yielded: bool,
}

impl DeformationPlasticity {
    /// Makes the law of elastic moduli and a hardening curve; without a curve the material cannot
    /// yield.
    pub fn with_law(
        elastic: ElasticModuli,
        law: Option<Arc<dyn HardeningLaw>>,
        out_of_plane: OutOfPlane,
    ) -> Self {
        let mapping = law.map(|law| ReturnMapping::new(law, elastic.shear));
        Self {
            elastic,
            yield_stress: mapping.as_ref().map_or(f64::INFINITY, ReturnMapping::yield_stress),
            mapping,
            out_of_plane,
        }
    }

    #[inline(always)]
    fn secant(&self, equivalent_strain: f64) -> Secant {
        let triple_shear = 3.0 * self.elastic.shear;
        let elastic = triple_shear * equivalent_strain;
        match &self.mapping {
            Some(mapping) if elastic > self.yield_stress => {
                let q = mapping.stress(equivalent_strain);
                let plastic_strain = (elastic - q) / triple_shear;
                Secant {
                    shear: q / (3.0 * equivalent_strain),
                    plastic_strain,
                    yielded: mapping.has_yielded(q, plastic_strain),
                }
            }
            _ => Secant { shear: self.elastic.shear, plastic_strain: 0.0, yielded: false },
        }
    }

    #[inline(always)]
    fn response(&self, strain: [f64; 4], secant: Secant) -> PointResponse {
        let pressure = self.elastic.bulk * (strain[0] + strain[1] + strain[2]);
        let [x, y, z, g] = deviator(strain).map(|e| 2.0 * secant.shear * e);
        PointResponse {
            stress: [pressure + x, pressure + y, pressure + z, 0.5 * g],
            secant_shear: secant.shear,
            equivalent_plastic_strain: secant.plastic_strain,
            yielded: secant.yielded,
            ..PointResponse::default()
        }
    }

    /// Returns the ε_zz for which σ_zz = 0, and the state there.
    ///
    /// For a secant modulus G_s it is `ε_zz = -(K - ⅔G_s)(ε_xx + ε_yy) / (K + 4/3 G_s)`, and
    /// [`Self::in_plane_parts`] gives the equivalent strain. The secant method between 0 and G
    /// finds the assumed G_s that equals the G_s of this strain.
    #[inline(always)]
    fn in_plane_stress(&self, [x, y, _, shear_angle]: [f64; 4]) -> ([f64; 4], Secant) {
        let ElasticModuli { bulk, shear: whole } = self.elastic;
        let (distortion, dilatation) = self.in_plane_parts(x, y, shear_angle);
        let completed = |shear: f64| {
            let part = dilatation / (bulk + 4.0 / 3.0 * shear);
            (shear, self.secant((distortion + part * part).sqrt()))
        };
        let at = |(shear, secant): (f64, Secant)| {
            let zz = -(bulk - 2.0 / 3.0 * shear) * (x + y) / (bulk + 4.0 / 3.0 * shear);
            ([x, y, zz, shear_angle], secant)
        };
        let mut answer = completed(whole);
        if answer.1.plastic_strain == 0.0 {
            return at(answer);
        }
        // Implied minus assumed modulus: not negative at 0, not positive at G.
        let (mut low, mut high) = (0.0, whole);
        let (mut last, mut last_rest) = (whole, answer.1.shear - whole);
        let mut assumed = answer.1.shear;
        for k in 0..MOST_TRIALS {
            answer = completed(assumed);
            let rest = answer.1.shear - assumed;
            if rest.abs() <= SECANT_ACCURACY * whole {
                break;
            }
            if rest > 0.0 {
                low = assumed;
            } else {
                high = assumed;
            }
            let next = assumed - rest * (assumed - last) / (rest - last_rest);
            (last, last_rest) = (assumed, rest);
            assumed = if low < next && next < high && (k < USUAL_TRIALS || k % 2 == 0) {
                next
            } else {
                0.5 * (low + high)
            };
        }
        at(answer)
    }

    /// `A` and `B` of the equivalent strain in plane stress,
    ///
    /// ```text
    /// ε_q² = A + (B / (K + 4/3 G_s))²,   A = ((ε_xx - ε_yy)² + γ_xy²) / 3,   B = K (ε_xx + ε_yy)
    /// ```
    #[inline(always)]
    fn in_plane_parts(&self, x: f64, y: f64, shear_angle: f64) -> (f64, f64) {
        ((shear_angle * shear_angle + (x - y) * (x - y)) / 3.0, self.elastic.bulk * (x + y))
    }
}

impl ConstitutiveModel for DeformationPlasticity {
    type State = ();

    fn elastic(&self) -> ElasticModuli {
        self.elastic
    }

    #[inline(always)]
    fn out_of_plane(&self) -> OutOfPlane {
        self.out_of_plane
    }

    fn hardening(&self) -> Option<&dyn HardeningLaw> {
        self.mapping.as_ref().map(ReturnMapping::law)
    }

    #[inline]
    fn update(&self, strain: [f64; 4], (): &()) -> (PointResponse, ()) {
        let response = match self.out_of_plane {
            OutOfPlane::Strained => {
                self.response(strain, self.secant(equivalent_strain(deviator(strain))))
            }
            OutOfPlane::PlaneStress => {
                let (strain, secant) = self.in_plane_stress(strain);
                let mut response = self.response(strain, secant);
                response.stress[2] = 0.0;
                response
            }
        };
        (response, ())
    }

    fn tangent(
        &self,
        strain: [f64; 4],
        (): &(),
        reference: ReferenceModuli,
    ) -> Option<ModuliReduction> {
        let mapping = self.mapping.as_ref()?;
        let strain = match self.out_of_plane {
            OutOfPlane::Strained => strain,
            OutOfPlane::PlaneStress => self.in_plane_stress(strain).0,
        };
        let trial = deviator(strain);
        let equivalent = equivalent_strain(trial);
        let stress = |factor: f64| mapping.stress(factor * equivalent);
        reduction(self.elastic, self.out_of_plane, trial, self.yield_stress, stress, reference)
    }

    #[inline(always)]
    fn initial_stress(&self, strain: &mut [PerPoint; 4], states: &[(); 4]) -> Option<usize> {
        let limit = self.yield_stress / (3.0 * self.elastic.shear);
        if self.out_of_plane == OutOfPlane::PlaneStress {
            let ElasticModuli { bulk, shear } = self.elastic;
            let stiffness = bulk + 4.0 / 3.0 * shear;
            let squares: PerPoint = std::array::from_fn(|g| {
                let (distortion, dilatation) =
                    self.in_plane_parts(strain[0][g], strain[1][g], strain[3][g]);
                distortion + (dilatation / stiffness) * (dilatation / stiffness)
            });
            if squares.iter().all(|&square| square <= limit * limit) {
                return None;
            }
            return self.initial_stress_point_by_point(strain, states);
        }
        let squares = make_deviatoric(strain);
        // Squares are compared: elastic points need no root.
        if squares.iter().all(|&square| square <= limit * limit) {
            return None;
        }
        let mut yielded = 0;
        for (g, &square) in squares.iter().enumerate() {
            let secant = self.secant(square.sqrt());
            let factor = 2.0 * (self.elastic.shear - secant.shear);
            yielded += usize::from(secant.yielded);
            for component in strain.iter_mut() {
                component[g] *= factor;
            }
            strain[3][g] *= 0.5;
        }
        Some(yielded)
    }
}

/// Subtracts the mean from the normal strains and returns `ε_q²` at each point.
#[inline(always)]
pub(super) fn make_deviatoric(strain: &mut [PerPoint; 4]) -> PerPoint {
    let [x, y, z, shear] = strain;
    std::array::from_fn(|g| {
        let mean = (x[g] + y[g] + z[g]) / 3.0;
        x[g] -= mean;
        y[g] -= mean;
        z[g] -= mean;
        2.0 / 3.0 * (x[g] * x[g] + y[g] * y[g] + z[g] * z[g] + 0.5 * shear[g] * shear[g])
    })
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::hardening::StraightLine;
    use crate::hardening::tests::{STEEL, YOUNG, laws};

    /// Steel with a straight hardening curve.
    pub(crate) fn law(out_of_plane: OutOfPlane) -> DeformationPlasticity {
        let curve = StraightLine::of_tangent(500.0, 10_500.0, YOUNG);
        DeformationPlasticity::with_law(STEEL, Some(Arc::new(curve)), out_of_plane)
    }

    #[test]
    fn uniaxial_tension_in_plane_stress_follows_the_uniaxial_curve() {
        let law = law(OutOfPlane::PlaneStress);
        let modulus = 10_500.0 / (1.0 - 0.05);
        for stress in [200.0, 499.0, 510.0, 700.0, 1500.0] {
            let plastic = f64::max(0.0, (stress - 500.0) / modulus);
            let along = stress / 210_000.0 + plastic;
            let across = -0.3 * stress / 210_000.0 - 0.5 * plastic;
            let (response, ()) = law.update([along, across, 0.0, 0.0], &());
            assert!((response.stress[0] - stress).abs() < 1e-8 * stress, "{stress}: {response:?}");
            assert!(response.stress[1].abs() < 1e-8 * stress && response.stress[2] == 0.0);
            assert!((response.equivalent_plastic_strain - plastic).abs() < 1e-12);
        }
    }

    #[test]
    fn no_stress_goes_through_the_thickness_in_plane_stress() {
        let strains = [[4e-3, -1e-3, 0.0, 3e-3], [2e-3, 2e-3, 0.0, 0.0], [-0.3, 0.1, 0.0, 0.2]];
        for curve in laws() {
            let law = DeformationPlasticity::with_law(
                STEEL,
                Some(Arc::clone(&curve)),
                OutOfPlane::PlaneStress,
            );
            for strain in strains {
                let (completed, secant) = law.in_plane_stress(strain);
                let stress = law.response(completed, secant).stress;
                let size = STEEL.bulk * completed.iter().map(|e| e.abs()).sum::<f64>();
                assert!(stress[2].abs() < 1e-11 * size, "{curve:?} {strain:?}: {stress:?}");
                assert!(
                    equivalent_strain(deviator(completed))
                        > curve.yield_stress() / (3.0 * STEEL.shear)
                );
                let mut initial = strain.map(|component| [component; 4]);
                assert_eq!(
                    law.initial_stress(&mut initial, &[(); 4]).is_some(),
                    secant.plastic_strain > 0.0
                );
            }
            let mut initial = [1e-6, 2e-6, 0.0, 1e-6].map(|component| [component; 4]);
            assert_eq!(
                law.initial_stress(&mut initial, &[(); 4]).is_none(),
                curve.yield_stress() > 0.0
            );
        }
    }

    #[test]
    fn initial_stress_is_elastic_less_actual_stress() {
        let strain = [4e-3, -1e-3, 5e-4, 3e-3];
        for out_of_plane in [OutOfPlane::Strained, OutOfPlane::PlaneStress] {
            let law = law(out_of_plane);
            let (response, ()) = law.update(strain, &());
            assert!(response.yielded);
            let mut initial = strain.map(|component| [component; 4]);
            assert_eq!(law.initial_stress(&mut initial, &[(); 4]), Some(4));
            let elastic = law.elastic().stress(strain, out_of_plane);
            for k in 0..4 {
                assert!(
                    (elastic[k] - response.stress[k] - initial[k][2]).abs() < 1e-8,
                    "component {k}"
                );
            }
        }
    }
}
