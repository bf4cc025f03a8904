//! Bounds for line contacts of bodies whose strength varies with the depth.

use super::HertzLine;
use super::yield_onset::maximum;

/// Depth, in half-widths, down to which a bound is sought. Shear falls with the square of the depth there, so that a core
/// below would have to be a thousand times softer.
const DEEPEST: f64 = 20.0;
/// Distance from the middle, in half-widths and beside the depth, within which the orthogonal shear of a depth is largest.
const WIDEST: f64 = 1.5;

/// A peak pressure, and the depth that decides it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepthBound {
    /// Peak pressure \[MPa\].
    pub peak_pressure: f64,
    /// Depth below the surface \[mm\].
    pub depth: f64,
}

impl HertzLine {
    /// The peak pressure up to which a rolling contact of this half-width shakes down, if the yield stress in shear is
    /// `shear_yield(depth) [MPa]`:
    ///
    /// ```text
    /// p0_s = min_z k(z) / max_x |τ_xy(x, z)/p0|
    /// ```
    ///
    /// `4 k` for constant k, at half a half-width. Residual stresses that depend on the depth alone can cancel every
    /// stress but the orthogonal shear τ_xy, so that by Melan's theorem nothing yields in the long run below this
    /// pressure and everything that rolls above it does, pass after pass.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), section 9.2.
    pub fn rolling_shakedown(&self, shear_yield: impl Fn(f64) -> f64) -> DepthBound {
        self.weakest_depth(|depth| self.largest_orthogonal_shear(depth) / shear_yield(depth))
    }

    /// The elastic peak pressure at which a contact of this half-width begins to yield on its axis by von Mises' criterion, if
    /// the yield stress is `yield_stress(depth) [MPa]`: `p0 = min_z σ_y(z) / (q(z)/p0)`, plane strain.
    pub fn graded_yield_onset(&self, poisson_ratio: f64, yield_stress: impl Fn(f64) -> f64) -> DepthBound {
        self.weakest_depth(|depth| {
            self.stress_on_axis(depth, poisson_ratio).von_mises() / yield_stress(depth)
        })
    }

    /// Largest orthogonal shear stress `max_x |τ_xy| [MPa]` at a depth `[mm]`.
    pub fn largest_orthogonal_shear(&self, depth: f64) -> f64 {
        let widest = WIDEST * self.half_width() + depth;
        maximum(|x| self.stress(x, depth, 0.0).tau_xy.abs(), widest).1
    }

    /// Scales the contact so that the largest utilization over the depth is one.
    fn weakest_depth(&self, utilization: impl Fn(f64) -> f64) -> DepthBound {
        let (depth, largest) = maximum(utilization, DEEPEST * self.half_width());
        DepthBound { peak_pressure: self.peak_pressure() / largest, depth }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn contact() -> HertzLine {
        HertzLine::from_peak_pressure(1200.0, 20.0, 115_000.0)
    }

    #[test]
    fn a_homogeneous_body_shakes_down_to_four_times_its_shear_yield_stress() {
        let (contact, k) = (contact(), 300.0);
        let bound = contact.rolling_shakedown(|_| k);
        assert!((bound.peak_pressure / (4.0 * k) - 1.0).abs() < 1e-6, "{}", bound.peak_pressure / k);
        assert!((bound.depth / contact.half_width() - 0.5).abs() < 1e-3);
    }

    #[test]
    fn a_homogeneous_body_begins_to_yield_where_the_ungraded_formula_says() {
        let (contact, yield_stress) = (contact(), 500.0);
        let bound = contact.graded_yield_onset(0.3, |_| yield_stress);
        let onset = crate::analytical::YieldOnset::line_von_mises(0.3);
        assert!((bound.peak_pressure / (onset.pressure_ratio * yield_stress) - 1.0).abs() < 1e-6);
        assert!((bound.depth / contact.half_width() - onset.depth_ratio).abs() < 1e-3);
    }

    /// A soft core below a hard case decides both, from a depth at which the case ends; a case that is deep enough does not let
    /// it.
    #[test]
    fn a_soft_core_decides_under_a_thin_case() {
        let contact = contact();
        let a = contact.half_width();
        let case = |depth: f64| move |z: f64| if z < depth * a { 1.0 } else { 0.4 };
        let thin = contact.graded_yield_onset(0.3, case(1.5));
        assert!((thin.depth / (1.5 * a) - 1.0).abs() < 0.02, "{}", thin.depth / a);
        let deep = contact.graded_yield_onset(0.3, case(6.0));
        assert!((deep.depth / a - 0.704).abs() < 1e-2);
        assert!(thin.peak_pressure < deep.peak_pressure);
        let rolling = contact.rolling_shakedown(case(1.5));
        let shear = contact.largest_orthogonal_shear(1.5 * a) / contact.peak_pressure();
        assert!((rolling.peak_pressure * shear / 0.4 - 1.0).abs() < 0.02);
    }
}
