//! Contacts of bodies whose strength varies with depth: the onset of yield, and the limit of
//! rolling.
//!
//! ```text
//! p0 max F(z/a) <= σ_y(z) for every depth z,   a = c p0
//! ```
//!
//! with F the equivalent stress at unit peak pressure. A higher pressure means higher stresses at
//! every depth, so that the largest p0 for which this holds is found by bisection.

use std::sync::LazyLock;

use super::{HertzEllipse, HertzLine, HertzPoint, shear_yield_von_mises};

/// The first depth at which a limit is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthLimit {
    /// Elastic peak pressure \[MPa\].
    pub peak_pressure: f64,
    /// Depth z \[mm\].
    pub depth: f64,
}

/// Deepest depth looked at, in half-widths. Stress has fallen to a fiftieth there, the smallest
/// strength to no less than a hundredth: what is weaker below is found with a depth that is too
/// small.
const DEEPEST: f64 = 100.0;
/// Depths that are looked at, and those between the neighbours of the highest of them.
const SAMPLES: u32 = 600;
const REFINED: u32 = 500;

impl DepthLimit {
    /// Onset of yield of a line contact, von Mises criterion on the axis, for a yield stress over
    /// depth \[MPa\]. `half_width` is that of a unit peak pressure \[mm/MPa\]: `2R/E*`.
    ///
    /// # Reference
    /// Stresses: E. McEwen (1949), as in [`HertzLine::stress_on_axis`].
    pub fn line_onset(
        poisson_ratio: f64,
        half_width: f64,
        yield_stress: impl Fn(f64) -> f64,
    ) -> Self {
        let hertz = HertzLine::from_peak_pressure(1.0, 1.0, 2.0);
        Self::first(half_width, yield_stress, |z| {
            hertz.stress_on_axis(z, poisson_ratio).von_mises()
        })
    }

    /// Onset of yield of a point contact, on the axis or at the surface on the edge of the contact
    /// circle, where the radial tension `(1 - 2ν) p0/3` and as much hoop pressure have the von
    /// Mises stress `(1 - 2ν) p0/√3`; `half_width` is the contact radius of a unit peak pressure
    /// \[mm/MPa\]: `πR/2E*`.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), eq. 3.49.
    pub fn point_onset(
        poisson_ratio: f64,
        half_width: f64,
        yield_stress: impl Fn(f64) -> f64,
    ) -> Self {
        let hertz = HertzPoint::from_peak_pressure(1.0, 1.0, std::f64::consts::FRAC_PI_2);
        let edge = (1.0 - 2.0 * poisson_ratio) / 3f64.sqrt();
        Self::first(half_width, yield_stress, |z| {
            let on_axis = hertz.stress_on_axis(z, poisson_ratio).von_mises();
            if z == 0.0 { on_axis.max(edge) } else { on_axis }
        })
    }

    /// Onset of yield on the axis of an elliptic contact; `half_width` is the shorter semi-axis of
    /// a unit peak pressure \[mm/MPa\].
    ///
    /// # Reference
    /// Stresses: H. R. Thomas, V. A. Hoersch (1930), as in [`HertzEllipse::stress_on_axis`].
    pub fn ellipse_onset(
        ellipse: HertzEllipse,
        poisson_ratio: f64,
        half_width: f64,
        yield_stress: impl Fn(f64) -> f64,
    ) -> Self {
        Self::first(half_width, yield_stress, |z| {
            ellipse.stress_on_axis(z, poisson_ratio).von_mises()
        })
    }

    /// Elastic shakedown limit of a line contact that rolls freely, for a yield stress over depth
    /// \[MPa\].
    ///
    /// ```text
    /// p0 max_x |τ_xy(x, z)|/p0 <= k(z),   k = σ_y/√3        4.000 k where k is constant
    /// ```
    ///
    /// Residual stresses that rolling leaves depend on depth alone, so that by equilibrium they
    /// are σ_x and σ_z only: they can take away all of the deviator but the orthogonal shear
    /// stress (Melan). Above this limit the material at that depth yields in every passage. Below
    /// it, it shakes down where the strength is constant and ν is above 0.067: the stress at the
    /// surface goes from 0 to `(1 - 2ν) p0` and back, which may be no more than `2 σ_y`. Where the
    /// strength is not constant, this is an upper bound.
    ///
    /// # Reference
    /// K. L. Johnson, *A shakedown limit in rolling contact*, Proc. 4th U.S. National Congress of
    /// Applied Mechanics, ASME (1962) 971–975; K. L. Johnson, *Contact Mechanics* (1985), section
    /// 9.2.
    pub fn rolling(half_width: f64, yield_stress: impl Fn(f64) -> f64) -> Self {
        /// Friction is a table of its own; free rolling is asked for by every job.
        static FREE: LazyLock<ShearOverDepth> = LazyLock::new(|| ShearOverDepth::new(0.0));
        Self::first(half_width, |z| shear_yield_von_mises(yield_stress(z)), |depth| FREE.at(depth))
    }

    /// Elastic shakedown limit of a line contact that rolls and slides, `q = μ p` over the whole
    /// contact, for a perfectly plastic material with a yield stress over depth \[MPa\].
    ///
    /// ```text
    /// p0 max_x |τ_xy + μ σ_x|/p0 <= k(z)      at z = 0:  |μ| p0 <= k(0)
    /// ```
    ///
    /// τ_xy and σ_x are those of the pressure alone: a traction of the same shape makes the shear
    /// stress that the pressure makes as σ_x. The limit holds for both signs of the friction. A
    /// residual stress that depends on depth alone does not enter, and so neither does an initial
    /// one. The depth is zero where the surface decides, for uniform k from μ = 0.367 on.
    ///
    /// Costs some milliseconds.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), sections 7.1 and 9.2.
    pub fn sliding(friction: f64, half_width: f64, yield_stress: impl Fn(f64) -> f64) -> Self {
        let shear = ShearOverDepth::new(friction);
        let strength = |depth: f64| shear_yield_von_mises(yield_stress(depth));
        Self::first(half_width, strength, |depth| shear.at(depth))
    }

    /// [`Self::sliding`] for several frictions, from the least on.
    pub fn over_friction(
        half_width: f64,
        yield_stress: impl Fn(f64) -> f64,
    ) -> impl Iterator<Item = (f64, Self)> {
        /// A fifth of a per mille is lost between so few depths.
        static TABLES: LazyLock<Vec<ShearOverDepth>> =
            LazyLock::new(|| FRICTIONS.map(|[mu, ..]| ShearOverDepth::with(mu, 300)).into());
        FRICTIONS.iter().zip(&*TABLES).map(move |([friction, ..], shear)| {
            let strength = |depth: f64| shear_yield_von_mises(yield_stress(depth));
            (*friction, Self::first(half_width, strength, |depth| shear.at(depth)))
        })
    }

    /// [`Self::over_friction`] of a yield stress that is the same everywhere, which scales.
    pub fn uniform_over_friction(
        half_width: f64,
        yield_stress: f64,
    ) -> impl Iterator<Item = (f64, Self)> {
        let strength = shear_yield_von_mises(yield_stress);
        FRICTIONS.iter().map(move |[friction, over_strength, depth]| {
            let peak_pressure = over_strength * strength;
            (*friction, Self { peak_pressure, depth: depth * half_width * peak_pressure })
        })
    }

    /// [`Self::rolling`] of a yield stress that is the same everywhere: the orthogonal shear
    /// stress is `p0/4` at the depth `a/2`.
    pub fn uniform_rolling(half_width: f64, yield_stress: f64) -> Self {
        let peak_pressure = 4.0 * shear_yield_von_mises(yield_stress);
        Self { peak_pressure, depth: 0.5 * half_width * peak_pressure }
    }

    /// Upper bound of the elastic shakedown limit of an elliptic contact that rolls freely along
    /// its shorter semi-axis; `half_width` is that semi-axis at a unit peak pressure \[mm/MPa\].
    ///
    /// ```text
    /// p0 max_x |τ_xz(x, 0, z)|/p0 <= k(z)     constant k: 4.000 k of a line, 4.675 k of a circle
    /// ```
    ///
    /// A place below the track has this shear stress in one direction and then in the other, with
    /// the same other stresses. No residual stress, which stays, makes that smaller: above the
    /// bound it yields in every passage. The limit itself is 4.0 k of a line and 4.7 k of a
    /// circle.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), section 9.2; A. R. S. Ponter, A. D. Hearle, K.
    /// L. Johnson, *Application of the kinematical shakedown theorem to rolling and sliding point
    /// contacts*, J. Mech. Phys. Solids 33 (1985) 339–362.
    pub fn ellipse_rolling(
        ellipse: HertzEllipse,
        half_width: f64,
        yield_stress: impl Fn(f64) -> f64,
    ) -> Self {
        let strength = |depth: f64| shear_yield_von_mises(yield_stress(depth));
        Self::first(half_width, strength, |depth| ellipse.orthogonal_shear(depth))
    }

    /// [`Self::ellipse_rolling`] of a yield stress that is the same everywhere.
    pub fn uniform_ellipse_rolling(
        ellipse: HertzEllipse,
        half_width: f64,
        yield_stress: f64,
    ) -> Self {
        let (shear, depth) = ellipse.largest_orthogonal_shear();
        let peak_pressure = shear_yield_von_mises(yield_stress) / shear;
        Self { peak_pressure, depth: depth * half_width * peak_pressure }
    }

    fn first(half_width: f64, strength: impl Fn(f64) -> f64, stress: impl Fn(f64) -> f64) -> Self {
        // Stress over strength at the depth where that is largest.
        let highest = |pressure: f64| {
            let ratio =
                |depth: f64| pressure * stress(depth) / strength(depth * half_width * pressure);
            let at = |k: u32| DEEPEST * (f64::from(k) / f64::from(SAMPLES)).powi(3);
            let ratios: Vec<f64> = (0..=SAMPLES).map(|k| ratio(at(k))).collect();
            let best = (0..=SAMPLES)
                .max_by(|a, b| ratios[*a as usize].total_cmp(&ratios[*b as usize]))
                .unwrap_or(0);
            let (low, high) = (at(best.saturating_sub(1)), at((best + 1).min(SAMPLES)));
            let between = |k: u32| low + (high - low) * f64::from(k) / f64::from(REFINED);
            let refined = (0..=REFINED).map(between).map(|depth| (ratio(depth), depth));
            refined.fold((ratios[best as usize], at(best)), |a, b| if b.0 > a.0 { b } else { a })
        };
        let (mut low, mut high) = (0.0, strength(0.0).max(f64::MIN_POSITIVE));
        while highest(high).0 < 1.0 {
            low = high;
            high *= 2.0;
        }
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if highest(middle).0 < 1.0 { low = middle } else { high = middle }
        }
        let depth = highest(high).1 * half_width * high;
        Self { peak_pressure: high, depth }
    }
}

/// `max_x |τ_xy + μ σ_x|/p0` of a line contact over depth in half-widths, with equal steps of
/// `ln(1 + depth)`.
struct ShearOverDepth(Vec<f64>);

/// Frictions with the limit over k and its depth over the half-width, by [`DepthLimit::sliding`] of
/// a strength that is the same everywhere.
const FRICTIONS: [[f64; 3]; 10] = [
    [0.0, 4.0, 0.5],
    [0.05, 3.7718, 0.4747],
    [0.1, 3.5642, 0.4522],
    [0.15, 3.3750, 0.4327],
    [0.2, 3.2024, 0.4136],
    [0.25, 3.0444, 0.4],
    [0.3, 2.8996, 0.384],
    [0.35, 2.7665, 0.3708],
    [0.4, 2.5, 0.0],
    [0.5, 2.0, 0.0],
];

impl ShearOverDepth {
    fn new(friction: f64) -> Self {
        Self::with(friction, TABLE_STEPS)
    }

    fn with(friction: f64, steps: u32) -> Self {
        let depth = |k: u32| (LOG_OF_DEEPEST * f64::from(k) / f64::from(steps)).exp_m1();
        Self((0..=steps).map(|k| largest(depth(k), friction)).collect())
    }

    fn at(&self, depth: f64) -> f64 {
        let steps = self.0.len() - 1;
        let place = depth.ln_1p() / LOG_OF_DEEPEST * steps as f64;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "no more than the steps of the table"
        )]
        let before = (place as usize).min(steps - 1);
        let (a, b) = (self.0[before], self.0[before + 1]);
        a + (place - before as f64) * (b - a)
    }
}

const TABLE_STEPS: u32 = 2400;
/// `ln(101)`, so that the deepest depth is the last of the table.
const LOG_OF_DEEPEST: f64 = 4.615_120_516_841_26;

/// The largest shear stress at a depth: a scan finds the hump, golden section its top.
fn largest(depth: f64, friction: f64) -> f64 {
    let hertz = HertzLine::from_peak_pressure(1.0, 1.0, 2.0);
    let shear = |x: f64| {
        let stress = hertz.stress(x, depth, 0.0);
        (stress.tau_xy + friction * stress.sigma_x).abs()
    };
    // Near the surface it is next to the edge of the contact or in the middle, far below it under
    // 30° to the axis, on the side where both parts have one sign.
    let step = (1.0 + depth) / 40.0;
    let best = (-60..=60i32)
        .map(|k| step * f64::from(k))
        .fold(0.0, |a, x| if shear(x) > shear(a) { x } else { a });
    let section = 0.5 * (5f64.sqrt() - 1.0);
    let (mut low, mut high) = (best - step, best + step);
    for _ in 0..40 {
        let (left, right) = (high - section * (high - low), low + section * (high - low));
        if shear(left) < shear(right) { low = left } else { high = right }
    }
    shear(0.5 * (low + high)).max(shear(best))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytical::YieldOnset;

    /// The rows of a uniform strength, and a coarser table of shear stresses.
    #[test]
    fn limits_over_friction_are_those_of_each_friction() {
        let all = DepthLimit::over_friction(1e-3, |_| 500.0);
        for ((friction, limit), (_, uniform)) in
            all.zip(DepthLimit::uniform_over_friction(1e-3, 500.0))
        {
            let one = DepthLimit::sliding(friction, 1e-3, |_| 500.0);
            for of in [limit, uniform] {
                assert!((of.peak_pressure / one.peak_pressure - 1.0).abs() < 2e-4, "{friction}");
                // The maximum over depth is flat.
                assert!((of.depth - one.depth).abs() < 0.03, "{friction} {of:?} {one:?}");
            }
        }
    }

    #[test]
    fn without_a_gradient_onset_is_the_closed_form() {
        for nu in [0.1, 0.25, 0.3, 0.45] {
            let line = DepthLimit::line_onset(nu, 1e-3, |_| 500.0);
            let expected = YieldOnset::line_von_mises(nu);
            assert!(
                (line.peak_pressure / (500.0 * expected.pressure_ratio) - 1.0).abs() < 1e-5,
                "{nu}"
            );
            assert!((line.depth - expected.depth_ratio * 1e-3 * line.peak_pressure).abs() < 2e-3);
            let point = DepthLimit::point_onset(nu, 1e-3, |_| 500.0);
            let expected = YieldOnset::point(nu);
            assert!(
                (point.peak_pressure / (500.0 * expected.pressure_ratio) - 1.0).abs() < 1e-5,
                "{nu}"
            );
        }
    }

    /// p0 = min σ_y(z)/F(z/a): with the a of the answer, no depth is closer to yield.
    #[test]
    fn with_a_gradient_the_weakest_depth_is_found() {
        let strength =
            |z: f64| if z < 0.8 { 900.0 } else { 900.0 - 600.0 * ((z - 0.8) / 0.1).min(1.0) };
        let limit = DepthLimit::line_onset(0.3, 5e-4, strength);
        let a = 5e-4 * limit.peak_pressure;
        let hertz = HertzLine::from_peak_pressure(1.0, 1.0, 2.0);
        let pressure = |z: f64| strength(z) / hertz.stress_on_axis(z / a, 0.3).von_mises();
        let least =
            (0..40_000u32).map(|k| pressure(1e-4 * f64::from(k))).fold(f64::INFINITY, f64::min);
        assert!((limit.peak_pressure / least - 1.0).abs() < 1e-4, "{limit:?} {least}");
        assert!((limit.depth - 0.9).abs() < 5e-3 && limit.depth > 0.8 * a, "{limit:?}");
        // Far below the contact as well.
        let core = DepthLimit::line_onset(0.3, 1e-4, |z| if z < 1.0 { 3000.0 } else { 100.0 });
        assert!((core.depth - 1.0).abs() < 0.02, "{core:?}");
    }

    /// 4.68 k of a circle, as Johnson has it; a strong case over a shallow part of it adds
    /// nothing.
    #[test]
    fn rolling_ellipses_shake_down_up_to_more_than_a_line() {
        let k = 300.0;
        let strength = 3f64.sqrt() * k;
        for (axis_ratio, expected, tolerance) in [(1.0, 4.68, 2e-3), (1e-4, 4.0, 1e-3)] {
            let ellipse = HertzEllipse { axis_ratio };
            let limit = DepthLimit::uniform_ellipse_rolling(ellipse, 1e-4, strength);
            assert!((limit.peak_pressure / (expected * k) - 1.0).abs() < tolerance, "{limit:?}");
            let same = DepthLimit::ellipse_rolling(ellipse, 1e-4, |_| strength);
            assert!(
                (same.peak_pressure / limit.peak_pressure - 1.0).abs() < 1e-6,
                "{same:?} {limit:?}"
            );
            assert!((same.depth / limit.depth - 1.0).abs() < 5e-3, "{same:?} {limit:?}");
            let cased = |depth: f64| strength * if depth < 0.5 * limit.depth { 2.0 } else { 1.0 };
            let cased = DepthLimit::ellipse_rolling(ellipse, 1e-4, cased);
            assert!((cased.peak_pressure / limit.peak_pressure - 1.0).abs() < 1e-6, "{cased:?}");
        }
    }

    /// Orthogonal shear p0/4 at half a half-width.
    #[test]
    fn rolling_shakes_down_up_to_four_k() {
        let k = 300.0;
        let limit = DepthLimit::rolling(1e-3, |_| k * 3f64.sqrt());
        assert!((limit.peak_pressure / k - 4.0).abs() < 1e-4, "{}", limit.peak_pressure / k);
        assert!((limit.depth / (1e-3 * limit.peak_pressure) - 0.5).abs() < 0.01, "{limit:?}");
        let uniform = DepthLimit::uniform_rolling(1e-3, k * 3f64.sqrt());
        assert!(
            (limit.peak_pressure / uniform.peak_pressure - 1.0).abs() < 2e-5,
            "{limit:?} {uniform:?}"
        );
        // A case that ends at the depth of the largest shear stress is worth nothing; a deep one
        // is worth all.
        let case = |depth: f64| move |z: f64| 3f64.sqrt() * if z < depth { 2.0 * k } else { k };
        let thin = DepthLimit::rolling(1e-3, case(0.3)).peak_pressure;
        let deep = DepthLimit::rolling(1e-3, case(60.0)).peak_pressure;
        assert!(
            (thin / (4.0 * k) - 1.0).abs() < 1e-4 && (deep / (8.0 * k) - 1.0).abs() < 1e-4,
            "{thin} {deep}"
        );
    }

    /// The limits of perfect plasticity over friction, as the formula gives them on a fine grid of
    /// points.
    #[test]
    fn friction_lowers_the_limit_of_a_sliding_line() {
        let (k, half_width) = (300.0, 1e-3);
        let limit = |friction: f64| DepthLimit::sliding(friction, half_width, |_| k * 3f64.sqrt());
        let expected = [
            (0.0, 4.0000),
            (0.05, 3.7719),
            (0.1, 3.5642),
            (0.15, 3.3750),
            (0.2, 3.2024),
            (0.25, 3.0444),
            (0.3, 2.8996),
            (0.35, 2.7665),
            (0.367, 2.7237),
            (0.4, 2.5),
            (0.5, 2.0),
        ];
        for (friction, ratio) in expected {
            let found = limit(friction);
            assert!(
                (found.peak_pressure / (k * ratio) - 1.0).abs() < 1e-4,
                "{friction}: {found:?}"
            );
            let driven = limit(-friction).peak_pressure;
            assert!((driven / found.peak_pressure - 1.0).abs() < 1e-12, "{friction}");
            let depth = found.depth / (half_width * found.peak_pressure);
            assert_eq!(depth < 1e-3, friction > 0.367, "{friction}: {depth}");
        }
    }

    /// A hard case lifts the limit of the surface and leaves that of the core; a soft skin lowers
    /// the limit of the surface alone.
    #[test]
    fn strength_over_depth_acts_where_friction_does() {
        let (k, half_width) = (300.0, 1e-3);
        let limit = |friction: f64, skin: f64, core: f64| {
            let strength = |z: f64| 3f64.sqrt() * k * if z < 0.02 { skin } else { core };
            DepthLimit::sliding(friction, half_width, strength)
        };
        let soft = limit(0.3, 0.5, 1.0);
        assert!((soft.peak_pressure / (k * 0.5 / 0.3) - 1.0).abs() < 1e-3, "{soft:?}");
        assert!(soft.depth < 0.02, "{soft:?}");
        let hard = limit(0.5, 2.0, 1.0);
        assert!(hard.peak_pressure > 2.1 * k && hard.depth > 0.0199, "{hard:?}");
    }
}
