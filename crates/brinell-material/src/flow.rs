//! Flow (incremental, Prandtl–Reuss) theory of plasticity, with isotropic and kinematic hardening.
//!
//! ```text
//! f = |s - Σ X_i|_eq - q(p) <= 0          yield condition, |a|_eq = √(3/2 a:a)
//! dε_p = dp n,  n = 3/2 (s - ΣX)/|s - ΣX|_eq
//! dX_i = 2/3 C_i dε_p - γ_i X_i dp         Armstrong and Frederick; Prager's law where γ_i = 0
//! ```
//!
//! The strain path of an increment is straight. The part of the path outside the elastic domain is
//! divided into equal parts. In each part the stress returns along the mean of the normals at its
//! two ends (Rice and Tracey), with an error of second order. A path of one part uses backward
//! Euler:
//!
//! ```text
//! n = 3/2 m/|m|_eq,   m = s + s_tr - 2 ΣX_i     backward Euler: m = s_tr - ΣX_i e_i
//! e_i = exp(-γ_i Δp)
//! X_i' = X_i e_i + 2/3 C_i/γ_i (1 - e_i) n,   s' = s_tr - 2G Δp n,   |s' - ΣX_i'|_eq = q(p+Δp)
//! ```
//!
//! For n constant over a part this integrates the backstress exactly, so that a uniaxial loop has
//! no error. From rest a straight path keeps its direction: the first increment is deformation
//! theory for any number of parts.
//!
//! # Reference
//! J. C. Simo, T. J. R. Hughes, *Computational Inelasticity* (1998), chapter 3; J. R. Rice, D. M.
//! Tracey, *Computational fracture mechanics*, in Numerical and Computer Methods in Structural
//! Mechanics (1973), 585–623; C. O. Frederick, P. J. Armstrong, *A mathematical representation of
//! the multiaxial Bauschinger effect*, CEGB report RD/B/N731 (1966), reprinted in Mater. High
//! Temp. 24 (2007) 1–26; J. L. Chaboche, *Constitutive equations for cyclic plasticity and cyclic
//! viscoplasticity*, Int. J. Plasticity 5 (1989) 247–302.

use super::tangent::reduction;
use super::{
    ConstitutiveModel, ElasticModuli, HardeningLaw, ModuliReduction, OutOfPlane, PointResponse,
    ReferenceModuli, ReturnMapping, deviator, equivalent_strain,
};

/// Parts into which the plastic part of a strain path is divided.
const SUBSTEPS: u32 = 6;

/// On curves without an elastic domain: plastic over elastic strain below which a path has one
/// part, and below which it is elastic.
const SMALL_FLOW: f64 = 1e-4;
const NO_FLOW: f64 = 1e-10;

/// γ Δp below which six terms of the exponential series are exact.
const SMALL_RECOVERY: f64 = 1.0 / 128.0;
/// Newton step over Δp below which only rounding is left.
const LAST_STEP: f64 = 1e-7;

/// Accuracies of ε_zz in plane stress over the strains: for the path in one part and for the
/// divided path.
const ROUGH: f64 = 1e-6;
const FINE: f64 = 1e-14;
/// Least slope by which σ_zz is extrapolated over ε_zz, over the bulk modulus.
const LEAST_SLOPE: f64 = 0.25;

/// One term of the backstress.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BackstressTerm {
    /// C \[MPa\].
    pub modulus: f64,
    /// γ.
    pub rate: f64,
}

impl BackstressTerm {
    /// `C/γ`, the equivalent stress that the term approaches \[MPa\]; infinite without recovery.
    pub fn largest(&self) -> f64 {
        if self.modulus > 0.0 { self.modulus / self.rate } else { 0.0 }
    }

    /// `exp(-γ Δp) - 1`.
    #[inline(always)]
    fn recovery(&self, dp: f64) -> f64 {
        let x = -self.rate * dp;
        if x > -SMALL_RECOVERY {
            // Taylor's series to rounding: the library call would take most of the time of a
            // point.
            x * (1.0
                + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0)))))
        } else {
            x.exp_m1()
        }
    }

    /// `C/γ (1 - exp(-γ Δp))`, C Δp where γ is zero \[MPa\].
    #[inline(always)]
    fn growth(&self, dp: f64, recovery: f64) -> f64 {
        if self.rate == 0.0 { self.modulus * dp } else { -self.modulus / self.rate * recovery }
    }
}

/// Flow theory with N terms of backstress.
#[derive(Debug, Clone)]
pub struct FlowPlasticity<const N: usize> {
    elastic: ElasticModuli,
    mapping: ReturnMapping,
    backstress: [BackstressTerm; N],
    out_of_plane: OutOfPlane,
    substeps: u32,
}

/// The memory of a point of flow theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowState<const N: usize> {
    /// `[ε_xx, ε_yy, ε_zz, γ_xy]`.
    pub strain: [f64; 4],
    /// Plastic part of the strain.
    pub plastic_strain: [f64; 4],
    /// Accumulated equivalent plastic strain p.
    pub accumulated: f64,
    /// `X_i` `[xx, yy, zz, xy]` \[MPa\].
    pub backstress: [[f64; 4]; N],
    /// `∫σ:dε_p` \[MPa\].
    pub plastic_work: f64,
}

impl<const N: usize> Default for FlowState<N> {
    fn default() -> Self {
        Self {
            strain: [0.0; 4],
            plastic_strain: [0.0; 4],
            accumulated: 0.0,
            backstress: [[0.0; 4]; N],
            plastic_work: 0.0,
        }
    }
}

/// The part of a state that changes during plastic flow. Tensors have D components, the three
/// normal ones first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flowing<const N: usize, const D: usize> {
    /// Stress deviator s \[MPa\].
    pub stress: [f64; D],
    /// Accumulated equivalent plastic strain p.
    pub accumulated: f64,
    /// `X_i` \[MPa\].
    pub backstress: [[f64; D]; N],
    /// `∫σ:dε_p` \[MPa\].
    pub plastic_work: f64,
}

impl<const N: usize> FlowPlasticity<N> {
    /// Makes the law of elastic moduli, a hardening curve and backstress.
    pub fn new(
        elastic: ElasticModuli,
        mapping: ReturnMapping,
        backstress: [BackstressTerm; N],
        out_of_plane: OutOfPlane,
    ) -> Self {
        Self { elastic, mapping, backstress, out_of_plane, substeps: SUBSTEPS }
    }

    /// Returns the same law with another number of parts of a strain path.
    #[must_use]
    pub fn with_substeps(self, substeps: u32) -> Self {
        Self { substeps: substeps.max(1), ..self }
    }

    /// Returns the hardening curve, prepared for the elastic shear modulus.
    pub fn mapping(&self) -> &ReturnMapping {
        &self.mapping
    }

    /// Returns the energy that backstress stores, `C/3 α:α` with `X = 2/3 C α` \[MPa\].
    pub fn backstress_energy<const D: usize>(&self, backstress: &[[f64; D]; N]) -> f64 {
        let terms = backstress.iter().zip(&self.backstress).filter(|(_, term)| term.modulus > 0.0);
        terms.map(|(x, term)| 0.75 * product(*x, *x) / term.modulus).sum()
    }

    /// Terms of the backstress.
    pub fn backstress_terms(&self) -> &[BackstressTerm] {
        &self.backstress
    }

    /// Parts of a strain path.
    pub fn substeps(&self) -> u32 {
        self.substeps
    }

    /// Returns the state at the end of a straight path, all components of which are given.
    #[inline]
    fn along(&self, strain: [f64; 4], state: &FlowState<N>, parts: u32) -> FlowState<N> {
        let double_shear = 2.0 * self.elastic.shear;
        let elastic_strain: [f64; 4] =
            std::array::from_fn(|k| state.strain[k] - state.plastic_strain[k]);
        let now = Flowing {
            stress: stress_of(deviator(elastic_strain), double_shear),
            accumulated: state.accumulated,
            backstress: state.backstress,
            plastic_work: state.plastic_work,
        };
        let change = deviator(std::array::from_fn(|k| strain[k] - state.strain[k]));
        let Some(now) = self.flow_along(now, stress_of(change, double_shear), parts) else {
            return FlowState { strain, ..*state };
        };
        let end = deviator(strain);
        let [x, y, z, t] = now.stress.map(|s| s / double_shear);
        FlowState {
            strain,
            plastic_strain: [end[0] - x, end[1] - y, end[2] - z, end[3] - 2.0 * t],
            accumulated: now.accumulated,
            backstress: now.backstress,
            plastic_work: now.plastic_work,
        }
    }

    /// Returns the state at the end of a straight trial path of the stress deviator, divided into
    /// `parts`; `None` where no plastic flow occurs.
    #[inline]
    pub fn flow_along<const D: usize>(
        &self,
        mut now: Flowing<N, D>,
        step: [f64; D],
        mut parts: u32,
    ) -> Option<Flowing<N, D>> {
        let shift = sum(&now.backstress);
        let from: [f64; D] = std::array::from_fn(|k| now.stress[k] - shift[k]);
        let radius = if now.accumulated > 0.0 {
            self.mapping.law().stress(now.accumulated)
        } else {
            self.mapping.yield_stress()
        };
        let elastic_part = elastic_part(from, step, radius)?;
        for (s, d) in now.stress.iter_mut().zip(step) {
            *s += elastic_part * d;
        }
        let (mut flow, mut yield_stress) = (0.0, radius);
        let flows_everywhere = self.mapping.yield_stress() == 0.0;
        if N > 0 || flows_everywhere {
            let size = equivalent_stress::<D>(std::array::from_fn(|k| from[k] + step[k]));
            let elastic = size / (3.0 * self.elastic.shear);
            let most = self.isotropic_flow(size, now.accumulated);
            if flows_everywhere && most <= NO_FLOW * elastic {
                return None;
            }
            // What flows on such a curve is mostly so little that it does not turn the stress.
            if flows_everywhere && most <= SMALL_FLOW * elastic {
                parts = 1;
            }
            flow = most / f64::from(parts);
        }
        let part = (1.0 - elastic_part) / f64::from(parts);
        let step = step.map(|d| part * d);
        // A part much larger than the yield surface ends in the direction of the path, whatever
        // its start.
        let weight = 1.0 / (1.0 + 1.5 * product(step, step) / (radius * radius));
        // A curve without an elastic domain has no normal at the start.
        let weight = if parts > 1 { weight } else { 0.0 };
        for k in 1..=parts {
            if N == 0 && weight > 0.0 {
                self.flow_along_mean_normal(step, &mut now, &mut yield_stress, weight, k == parts);
            } else {
                let before = now.accumulated;
                self.flow(step, &mut now, &mut yield_stress, flow, weight);
                flow = now.accumulated - before;
            }
        }
        Some(now)
    }

    /// Takes one step along the weighted mean of the normals before and after it; `weight` belongs
    /// to the normal before. `change` is the elastic change of the stress deviator. Updates the
    /// yield stress.
    ///
    /// With `c` and `d` the parts of the trial stress along the normal and across it, `(c - 3G
    /// Δp)² + d² = q²`. The root `c - 3G Δp = √(q² - d²)` is expanded to two terms in d/q, with q
    /// before the step. The remainder is below the error of the step, and the next step starts
    /// from it.
    #[inline]
    fn flow_along_mean_normal<const D: usize>(
        &self,
        change: [f64; D],
        now: &mut Flowing<N, D>,
        yield_stress: &mut f64,
        weight: f64,
        is_last: bool,
    ) {
        let triple_shear = 3.0 * self.elastic.shear;
        let trial: [f64; D] = std::array::from_fn(|k| now.stress[k] + change[k]);
        let mean: [f64; D] = std::array::from_fn(|k| trial[k] + weight * now.stress[k]);
        let size = equivalent_stress(mean);
        let along = equivalent_along(trial, mean, size);
        let across =
            (1.5 * product(trial, trial) - along * along).max(0.0) / (2.0 * *yield_stress);
        let radial = along + across * (1.0 + across / (2.0 * *yield_stress));
        let strain = radial / triple_shear + now.accumulated;
        let q = self.mapping.stress(strain);
        let excess = radial - q;
        if excess <= 0.0 {
            // Along the surface, which is crossed, if at all, by what was left of the step before.
            return self.flow(change, now, yield_stress, 0.0, 0.0);
        }
        let dp = excess / triple_shear;
        now.plastic_work += 0.5 * (equivalent_along(now.stress, mean, size) + along - excess) * dp;
        now.accumulated += dp;
        now.stress = std::array::from_fn(|k| trial[k] - excess / size * mean[k]);
        *yield_stress = q;
        if is_last {
            let ratio = q / equivalent_stress(now.stress);
            now.stress = now.stress.map(|s| ratio * s);
        }
    }

    /// Takes one step for an elastic `change` of the stress deviator and updates the yield stress.
    /// Without backstress the step is backward Euler; with backstress it follows the weighted mean
    /// of the normals before and after it, and `weight` belongs to the normal before. `expected`
    /// is an estimate of Δp.
    #[inline]
    fn flow<const D: usize>(
        &self,
        change: [f64; D],
        now: &mut Flowing<N, D>,
        yield_stress: &mut f64,
        expected: f64,
        weight: f64,
    ) {
        let triple_shear = 3.0 * self.elastic.shear;
        let trial: [f64; D] = std::array::from_fn(|k| now.stress[k] + change[k]);
        if N == 0 {
            let q_trial = equivalent_stress(trial);
            let strain = q_trial / triple_shear + now.accumulated;
            let q = self.mapping.stress(strain);
            let dp = (q_trial - q) / triple_shear;
            if dp <= 0.0 {
                now.stress = trial;
                return;
            }
            let ratio = q / q_trial;
            // dε_p = (s_tr - s)/2G lies along s_tr, as s does.
            now.plastic_work += 0.5 * (q + equivalent_along(now.stress, trial, q_trial)) * dp;
            now.accumulated += dp;
            now.stress = trial.map(|s| ratio * s);
            return;
        }
        let mut expected = expected;
        let direction = (weight > 0.0).then(|| {
            let shift = sum(&now.backstress);
            if expected <= 0.0 {
                let size = equivalent_stress::<D>(std::array::from_fn(|k| trial[k] - shift[k]));
                expected =
                    (size - *yield_stress).max(0.0) / (triple_shear + self.kinematic_modulus());
            }
            let recovery = self.backstress.map(|term| term.recovery(expected));
            let after = after_recovery(trial, &now.backstress, recovery);
            std::array::from_fn(|k| after[k] + weight * (now.stress[k] - shift[k]))
        });
        let dp = self.multiplier(trial, now, yield_stress, expected, direction);
        if dp <= 0.0 && weight > 0.0 {
            // Along the surface.
            return self.flow(change, now, yield_stress, expected, 0.0);
        }
        if dp <= 0.0 {
            now.stress = trial;
            return;
        }
        let recovery = self.backstress.map(|term| term.recovery(dp));
        let relative =
            direction.unwrap_or_else(|| after_recovery(trial, &now.backstress, recovery));
        let size = equivalent_stress(relative);
        let n = relative.map(|r| 1.5 * r / size);
        let before = now.stress;
        for k in 0..D {
            now.stress[k] = trial[k] - 2.0 / 3.0 * triple_shear * dp * n[k];
        }
        for ((x, term), recovery) in now.backstress.iter_mut().zip(&self.backstress).zip(recovery)
        {
            let (decay, growth) = (1.0 + recovery, 2.0 / 3.0 * term.growth(dp, recovery));
            for (x, n) in x.iter_mut().zip(n) {
                *x = *x * decay + growth * n;
            }
        }
        let mean: [f64; D] = std::array::from_fn(|k| 0.5 * (before[k] + now.stress[k]));
        now.plastic_work += product(mean, n) * dp;
        now.accumulated += dp;
    }

    /// Returns Δp, zero if the trial lies within the given yield stress, and the yield stress
    /// after it. The return is along a direction or, without one, by backward Euler.
    ///
    /// Newton's method starts from the expected Δp in the bracket `[0, ∞)`. With `ξ = s_tr - ΣX_i
    /// e_i`, whose `|ξ|_eq²` is a quadratic form of the `e_i` with coefficients that are known
    /// beforehand, and with `c` its part along the direction,
    ///
    /// ```text
    /// backward Euler   |ξ|_eq = 3G Δp + Σ C_i/γ_i (1 - e_i) + q
    /// along n          c = 3G Δp + Σ C_i/γ_i (1 - e_i) + √(q² - |ξ|_eq² + c²)
    /// ```
    fn multiplier<const D: usize>(
        &self,
        trial: [f64; D],
        now: &Flowing<N, D>,
        yield_stress: &mut f64,
        expected: f64,
        direction: Option<[f64; D]>,
    ) -> f64 {
        let triple_shear = 3.0 * self.elastic.shear;
        let square = 1.5 * product(trial, trial);
        let along: [f64; N] = std::array::from_fn(|i| 1.5 * product(trial, now.backstress[i]));
        let gram: [[f64; N]; N] = std::array::from_fn(|i| {
            std::array::from_fn(|j| 1.5 * product(now.backstress[i], now.backstress[j]))
        });
        let first: f64 =
            gram.iter().flatten().sum::<f64>() - 2.0 * along.iter().sum::<f64>() + square;
        let onto = direction.map(|direction| {
            let size = equivalent_stress(direction);
            let backstress = now.backstress.map(|x| equivalent_along(x, direction, size));
            (equivalent_along(trial, direction, size), backstress)
        });
        let excess = match onto {
            None => first.max(0.0).sqrt() - *yield_stress,
            Some((part, backstress)) => {
                let part = part - backstress.iter().sum::<f64>();
                part - (*yield_stress * *yield_stress - first + part * part).max(0.0).sqrt()
            }
        };
        if excess <= 0.0 {
            return 0.0;
        }
        let law = self.mapping.law();
        let (mut low, mut high) = (0.0, f64::INFINITY);
        // This estimate is too large with backstress that does not recover, and with perfect
        // plasticity.
        let mut dp = if expected > 0.0 {
            expected
        } else {
            excess / (triple_shear + self.kinematic_modulus())
        };
        for _ in 0..100 {
            let recovery = self.backstress.map(|term| term.recovery(dp));
            let (mut size, mut change) = (square, 0.0);
            for i in 0..N {
                let decay = 1.0 + recovery[i];
                // X_i · ξ.
                let part =
                    along[i] - (0..N).map(|j| gram[i][j] * (1.0 + recovery[j])).sum::<f64>();
                size -= decay * (along[i] + part);
                change += self.backstress[i].rate * decay * part;
            }
            let (q, slope) = law.stress_and_slope(now.accumulated + dp);
            *yield_stress = q;
            let (mut rest, mut rate) = (-triple_shear * dp, -triple_shear);
            match onto {
                None => {
                    let size = size.max(0.0).sqrt();
                    rest += size - q;
                    rate -= slope - if size > 0.0 { change / size } else { 0.0 };
                }
                Some((mut part, backstress)) => {
                    for ((x, term), recovery) in
                        backstress.iter().zip(&self.backstress).zip(recovery)
                    {
                        part -= x * (1.0 + recovery);
                        rate += term.rate * x * (1.0 + recovery);
                    }
                    let along = (q * q - size + part * part).max(0.0).sqrt();
                    rest += part - along;
                    rate -= slope * (q / along.max(0.5 * q));
                }
            }
            for (term, recovery) in self.backstress.iter().zip(recovery) {
                rest -= term.growth(dp, recovery);
                rate -= term.modulus * (1.0 + recovery);
            }
            let step = -rest / rate;
            if step.abs() <= LAST_STEP * dp {
                dp += step;
                *yield_stress += slope * step;
                break;
            }
            if rest > 0.0 {
                low = dp;
            } else {
                high = dp;
            }
            if high.is_finite() && high - low <= 1e-15 * high {
                break;
            }
            dp = if dp + step > low && dp + step < high {
                dp + step
            } else if high.is_finite() {
                0.5 * (low + high)
            } else {
                2.0 * dp
            };
        }
        dp
    }

    /// dX/dp of backstress that has not recovered \[MPa\].
    fn kinematic_modulus(&self) -> f64 {
        self.backstress.iter().map(|term| term.modulus).sum()
    }

    /// Returns Δp of a trial of this size along the relative stress for constant backstress, an
    /// upper bound with backstress.
    fn isotropic_flow(&self, size: f64, accumulated: f64) -> f64 {
        let triple_shear = 3.0 * self.elastic.shear;
        let strain = size / triple_shear + accumulated;
        (strain - self.mapping.stress(strain) / triple_shear - accumulated).max(0.0)
    }

    /// Δp of a trial in the direction of the relative stress, for the tangent.
    fn radial_multiplier(&self, size: f64, accumulated: f64) -> f64 {
        let triple_shear = 3.0 * self.elastic.shear;
        let mut dp = 0.0;
        for _ in 0..30 {
            let q = self
                .mapping
                .stress((size - triple_shear * dp).max(0.0) / triple_shear + accumulated + dp);
            let kinematic: f64 =
                self.backstress.iter().map(|term| term.growth(dp, term.recovery(dp))).sum();
            let step = (size - triple_shear * dp - kinematic - q)
                / (triple_shear + self.kinematic_modulus());
            dp = (dp + step).max(0.0);
            if step.abs() <= 1e-6 * dp {
                break;
            }
        }
        dp
    }

    /// Returns the state at the end of a straight path; in plane stress the state with the ε_zz
    /// for which `σ_zz = 0`.
    fn state_after(&self, strain: [f64; 4], state: &FlowState<N>) -> FlowState<N> {
        match self.out_of_plane {
            OutOfPlane::Strained => self.along(strain, state, self.substeps),
            OutOfPlane::PlaneStress => self.in_plane_stress(strain, state),
        }
    }

    /// Returns the state with σ_zz = 0. A path in one part gives a good estimate of ε_zz at a
    /// small part of the cost of the divided path.
    fn in_plane_stress(&self, strain: [f64; 4], state: &FlowState<N>) -> FlowState<N> {
        let lame = self.elastic.lame();
        let change = strain[0] - state.strain[0] + strain[1] - state.strain[1];
        let elastic = state.strain[2] - lame / (lame + 2.0 * self.elastic.shear) * change;
        let stiffest = self.elastic.bulk + 4.0 / 3.0 * self.elastic.shear;
        let mut start = (elastic, stiffest);
        let size = strain[0].abs() + strain[1].abs() + elastic.abs() + strain[3].abs();
        if self.substeps > 1 {
            let (end, slope) =
                self.without_thickness_stress(strain, state, start, 1, ROUGH * size);
            if end.accumulated.to_bits() == state.accumulated.to_bits() {
                // An elastic path has no parts.
                return end;
            }
            start = (end.strain[2], slope);
        }
        self.without_thickness_stress(strain, state, start, self.substeps, FINE * size).0
    }

    /// The zero of σ_zz over ε_zz by the secant of the last two points, from a strain and a slope,
    /// within the accuracy of ε_zz, in a bracket of the signs seen so far. Returns the last slope,
    /// too.
    ///
    /// σ_zz rises by `K + 4/3 G` at most and by backward Euler by K at least; along the mean
    /// normal it may rise less for a while. There is a zero in any case: far away `K tr ε`
    /// outweighs the deviator, which the yield stress bounds.
    fn without_thickness_stress(
        &self,
        strain: [f64; 4],
        state: &FlowState<N>,
        (start, mut slope): (f64, f64),
        parts: u32,
        accuracy: f64,
    ) -> (FlowState<N>, f64) {
        let ElasticModuli { bulk, shear } = self.elastic;
        let stiffest = bulk + 4.0 / 3.0 * shear;
        let at = |zz: f64| {
            let end = self.along([strain[0], strain[1], zz, strain[3]], state, parts);
            let stress = self.stress(&end)[2];
            (zz, stress, end)
        };
        let mut now = at(start);
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for _ in 0..60 {
            let (zz, stress, _) = now;
            if stress.abs() <= accuracy * stiffest {
                break;
            }
            if stress > 0.0 {
                high = zz;
            } else {
                low = zz;
            }
            // The point moves towards the other sign, until the bracket has two ends.
            let secant = zz - stress / slope;
            let next = if secant > low && secant < high { secant } else { 0.5 * (low + high) };
            if !next.is_finite() || next.to_bits() == zz.to_bits() {
                // The step is lost in rounding.
                break;
            }
            now = at(next);
            slope = ((now.1 - stress) / (now.0 - zz)).clamp(LEAST_SLOPE * bulk, stiffest);
        }
        (now.2, slope)
    }

    fn stress(&self, state: &FlowState<N>) -> [f64; 4] {
        let elastic: [f64; 4] = std::array::from_fn(|k| state.strain[k] - state.plastic_strain[k]);
        self.elastic.stress(elastic, OutOfPlane::Strained)
    }
}

impl<const N: usize> ConstitutiveModel for FlowPlasticity<N> {
    type State = FlowState<N>;

    fn elastic(&self) -> ElasticModuli {
        self.elastic
    }

    #[inline(always)]
    fn out_of_plane(&self) -> OutOfPlane {
        self.out_of_plane
    }

    fn hardening(&self) -> Option<&dyn HardeningLaw> {
        Some(self.mapping.law())
    }

    fn has_memory(&self) -> bool {
        true
    }

    fn update(&self, strain: [f64; 4], state: &FlowState<N>) -> (PointResponse, FlowState<N>) {
        let end = self.state_after(strain, state);
        let mut stress = self.stress(&end);
        if self.out_of_plane == OutOfPlane::PlaneStress {
            stress[2] = 0.0;
        }
        let is_plastic = end.accumulated > 0.0;
        let response = PointResponse {
            stress,
            secant_shear: self.elastic.shear,
            equivalent_plastic_strain: end.accumulated,
            yielded: is_plastic
                && self
                    .mapping
                    .has_yielded(self.mapping.law().stress(end.accumulated), end.accumulated),
            plastic_work: end.plastic_work,
            backstress_energy: self.backstress_energy(&end.backstress),
        };
        (response, end)
    }

    fn tangent(
        &self,
        strain: [f64; 4],
        state: &FlowState<N>,
        reference: ReferenceModuli,
    ) -> Option<ModuliReduction> {
        let end = match self.out_of_plane {
            OutOfPlane::Strained => strain,
            OutOfPlane::PlaneStress => self.in_plane_stress(strain, state).strain,
        };
        let elastic: [f64; 4] = std::array::from_fn(|k| end[k] - state.plastic_strain[k]);
        let shift = sum(&state.backstress).map(|x| x / (2.0 * self.elastic.shear));
        let [x, y, z, g] = deviator(elastic);
        let trial = [x - shift[0], y - shift[1], z - shift[2], g - 2.0 * shift[3]];
        let size = equivalent_strain(trial);
        let triple_shear = 3.0 * self.elastic.shear;
        let stress = |factor: f64| {
            if N == 0 {
                self.mapping.stress(factor * size + state.accumulated)
            } else {
                let trial = factor * triple_shear * size;
                trial - triple_shear * self.radial_multiplier(trial, state.accumulated)
            }
        };
        let radius = self.mapping.law().stress(state.accumulated);
        reduction(self.elastic, self.out_of_plane, trial, radius, stress, reference)
    }
}

/// `[2G e_xx, 2G e_yy, 2G e_zz, G γ_xy]`.
#[inline(always)]
fn stress_of(strain_deviator: [f64; 4], double_shear: f64) -> [f64; 4] {
    let [x, y, z, g] = strain_deviator.map(|e| double_shear * e);
    [x, y, z, 0.5 * g]
}

/// `a:b` of two stresses.
#[inline(always)]
fn product<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    let normal = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    (3..D).fold(normal, |sum, k| sum + 2.0 * a[k] * b[k])
}

/// `√(3/2 s:s)` of a deviator.
#[inline(always)]
fn equivalent_stress<const D: usize>(deviator: [f64; D]) -> f64 {
    (1.5 * product(deviator, deviator)).sqrt()
}

/// Returns the component of a stress deviator along another one, as an equivalent stress.
#[inline(always)]
fn equivalent_along<const D: usize>(stress: [f64; D], direction: [f64; D], size: f64) -> f64 {
    1.5 * product(stress, direction) / size
}

fn sum<const N: usize, const D: usize>(terms: &[[f64; D]; N]) -> [f64; D] {
    let mut total = [0.0; D];
    for term in terms {
        for (total, x) in total.iter_mut().zip(term) {
            *total += x;
        }
    }
    total
}

/// Returns the part of a step that stays in the sphere `|a|_eq <= radius`, from a point in or on
/// it; `None` if the whole step stays in it.
#[inline(always)]
fn elastic_part<const D: usize>(from: [f64; D], step: [f64; D], radius: f64) -> Option<f64> {
    let a = 1.5 * product(step, step);
    let b = 1.5 * product(from, step);
    let c = 1.5 * product(from, from) - radius * radius;
    if a + 2.0 * b + c <= 0.0 {
        return None;
    }
    // From the surface, where rounding decides the sign of c: inward first, or outward at once.
    let inside = c.min(0.0);
    let root = (b * b - a * inside).max(0.0).sqrt();
    let part = if b >= 0.0 { -inside / (b + root).max(f64::MIN_POSITIVE) } else { (root - b) / a };
    Some(part.clamp(0.0, 1.0))
}

/// `s_tr - ΣX_i e_i` by the `e_i - 1` \[MPa\].
#[inline(always)]
fn after_recovery<const N: usize, const D: usize>(
    mut trial: [f64; D],
    backstress: &[[f64; D]; N],
    recovery: [f64; N],
) -> [f64; D] {
    for (x, recovery) in backstress.iter().zip(recovery) {
        for (r, x) in trial.iter_mut().zip(x) {
            *r -= x * (1.0 + recovery);
        }
    }
    trial
}

#[cfg(test)]
mod tests;
