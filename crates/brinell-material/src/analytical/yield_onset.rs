//! The load at which a contact first yields below the surface.

use super::{HertzEllipse, HertzLine, HertzPoint};

/// Depth, in half-widths, down to which the maximum is sought.
const DEEPEST: f64 = 3.0;

/// Where and at what elastic peak pressure yield begins.
///
/// The equivalent stress on the axis is maximised over the depth by scanning and golden section,
/// to rounding in its value and about 1e-8 in the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldOnset {
    /// `p0 / σ_y`: peak pressure at first yield over the uniaxial yield stress.
    pub pressure_ratio: f64,
    /// `d / a`: its depth over the half-width or contact radius.
    pub depth_ratio: f64,
}

impl YieldOnset {
    /// Line contact in plane strain, von Mises criterion.
    ///
    /// `p0/σ_y` = 1.794 at 0.704 a for ν = 0.3, 1.725 for 0.25, 1.889 for 0.4. Below ν = 0.194
    /// yield begins at the surface, where `q = (1 - 2ν) p0`; the depth is zero then. Plane stress
    /// is the case ν = 0.
    pub fn line_von_mises(poisson_ratio: f64) -> Self {
        let hertz = HertzLine::from_peak_pressure(1.0, 1.0, 2.0);
        Self::of(|depth| hertz.stress_on_axis(depth, poisson_ratio).von_mises())
    }

    /// Point contact. Two of the principal stresses are equal on the axis, so von Mises and Tresca
    /// coincide.
    ///
    /// `p0/σ_y` = 1.613 at 0.481 a for ν = 0.3.
    pub fn point(poisson_ratio: f64) -> Self {
        let (modulus, radius) = (std::f64::consts::FRAC_PI_2, 1.0);
        let hertz = HertzPoint::from_peak_pressure(1.0, radius, modulus);
        Self::of(|depth| hertz.stress_on_axis(depth, poisson_ratio).von_mises())
    }

    /// Elliptic contact, von Mises criterion on the axis; the depth is in shorter semi-axes.
    pub fn ellipse(ellipse: HertzEllipse, poisson_ratio: f64) -> Self {
        Self::of(|depth| ellipse.stress_on_axis(depth, poisson_ratio).von_mises())
    }

    /// Force per length at first yield of a line contact, `P = π R p0² / E* [N/mm]`.
    pub fn line_force(
        &self,
        yield_stress: f64,
        effective_radius: f64,
        effective_modulus: f64,
    ) -> f64 {
        let peak = self.pressure_ratio * yield_stress;
        HertzLine::from_peak_pressure(peak, effective_radius, effective_modulus).force()
    }

    /// Force at first yield of a point contact, `F = π³ R² p0³ / (6 E*²) [N]`.
    pub fn point_force(
        &self,
        yield_stress: f64,
        effective_radius: f64,
        effective_modulus: f64,
    ) -> f64 {
        let peak = self.pressure_ratio * yield_stress;
        HertzPoint::from_peak_pressure(peak, effective_radius, effective_modulus).force()
    }

    /// Force at first yield of a sphere by the fitted formula of Jackson and Green `[N]`.
    ///
    /// `F_c = (4/3) (R/E*)² (π C σ_y / 2)³`, `C = 1.295 exp(0.736 ν)`: C fits `p0/σ_y`.
    ///
    /// # Reference
    /// R. L. Jackson, I. Green, *A finite element study of elasto-plastic hemispherical contact
    /// against a rigid flat*, J. Tribol. 127 (2005) 343-354.
    pub fn jackson_green_force(
        poisson_ratio: f64,
        yield_stress: f64,
        effective_radius: f64,
        effective_modulus: f64,
    ) -> f64 {
        let c = 1.295 * (0.736 * poisson_ratio).exp();
        let stress = std::f64::consts::FRAC_PI_2 * c * yield_stress;
        4.0 / 3.0 * (effective_radius / effective_modulus).powi(2) * stress.powi(3)
    }

    /// From the equivalent stress over depth at unit peak pressure and unit half-width.
    fn of(equivalent: impl Fn(f64) -> f64) -> Self {
        let (depth, stress) = maximum(equivalent, DEEPEST);
        Self { pressure_ratio: 1.0 / stress, depth_ratio: depth }
    }
}

/// The largest value of f in `0..=end` and where it is: a scan finds the hump, golden section its
/// top.
pub(super) fn maximum(f: impl Fn(f64) -> f64, end: f64) -> (f64, f64) {
    const SAMPLES: u32 = 300;
    let step = end / f64::from(SAMPLES);
    let at_surface = (0.0, f(0.0));
    let better = |best: (f64, f64), next: (f64, f64)| if next.1 > best.1 { next } else { best };
    let mut best =
        (1..=SAMPLES).map(|i| f64::from(i) * step).map(|x| (x, f(x))).fold(at_surface, better);
    let section = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = ((best.0 - step).max(0.0), best.0 + step);
    for _ in 0..80 {
        let (left, right) = (high - section * (high - low), low + section * (high - low));
        let found = [left, right].map(|x| (x, f(x)));
        if found[0].1 < found[1].1 {
            low = left;
        } else {
            high = right;
        }
        // Beside a jump the last interval need not have the largest value.
        best = found.into_iter().fold(best, better);
    }
    best
}

/// Returns the factor on a yield stress that makes `force` the force of first yield, and the depth
/// of first yield with this factor. `onset` returns both forces and depths for a factor.
pub fn factor_of_onset(onset: impl Fn(f64) -> (f64, f64), force: f64) -> (f64, f64) {
    let mut factor = 1.0;
    let mut found = onset(factor);
    // The force of first yield grows with the square to the cube of a uniform yield stress.
    for _ in 0..60 {
        let off = force / found.0;
        if (off - 1.0).abs() < 1e-9 || !off.is_finite() {
            break;
        }
        factor *= off.powf(0.4);
        found = onset(factor);
    }
    (factor, found.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_contact_von_mises() {
        for (nu, ratio) in [(0.3, 1.794), (0.25, 1.725), (0.4, 1.889)] {
            let onset = YieldOnset::line_von_mises(nu);
            assert!((onset.pressure_ratio - ratio).abs() < 5e-4, "ν = {nu}: {onset:?}");
        }
        assert!((YieldOnset::line_von_mises(0.3).depth_ratio - 0.704).abs() < 5e-4);
    }

    /// Two steel cylinders, R 10 mm, `σ_y = 350 MPa`.
    #[test]
    fn force_at_first_yield() {
        let (radius, modulus) = (5.0, 210_000.0 / 1.82);
        let onset = YieldOnset::line_von_mises(0.3);
        let force = onset.line_force(350.0, radius, modulus);
        let half_width = HertzLine::new(force, radius, modulus).half_width();
        assert!((force - 53.65).abs() < 0.005, "{force}");
        assert!((half_width - 0.05441).abs() < 5e-6, "{half_width}");
        assert!((onset.depth_ratio * half_width - 0.0383).abs() < 5e-5);
    }

    #[test]
    fn no_point_beside_the_axis_yields_earlier() {
        let hertz = HertzLine::from_peak_pressure(1.0, 1.0, 2.0);
        for nu in [0.0, 0.1, 0.2, 0.3, 0.4, 0.49] {
            let highest = 1.0 / YieldOnset::line_von_mises(nu).pressure_ratio;
            for x in 0..60 {
                for depth in 0..60 {
                    let stress = hertz.stress(0.025 * f64::from(x), 0.025 * f64::from(depth), nu);
                    assert!(stress.von_mises() <= highest + 1e-12, "ν = {nu}: ({x}, {depth})");
                }
            }
        }
    }

    #[test]
    fn small_poisson_ratios_yield_nearer_to_the_surface() {
        let onset = YieldOnset::line_von_mises(0.1);
        assert!(onset.depth_ratio <= 0.0 && (onset.pressure_ratio - 1.25).abs() < 1e-12);
        assert!(YieldOnset::line_von_mises(0.193).depth_ratio <= 0.0);
        assert!(YieldOnset::line_von_mises(0.195).depth_ratio > 0.57);
    }

    #[test]
    fn sphere() {
        let onset = YieldOnset::point(0.3);
        assert!((onset.pressure_ratio - 1.613).abs() < 5e-4, "{onset:?}");
        assert!((onset.depth_ratio - 0.481).abs() < 5e-4);
        let exact = onset.point_force(350.0, 5.0, 115_000.0);
        let fitted = YieldOnset::jackson_green_force(0.3, 350.0, 5.0, 115_000.0);
        assert!((fitted / exact - 1.0).abs() < 5e-3, "{fitted} {exact}");
    }
}
