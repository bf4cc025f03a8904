//! The pin in a hole of nearly its own radius.

use std::f64::consts::PI;

/// Elastic contact of a pin with a hole in an infinite plate of the same material, over a given
/// angle to each side.
///
/// ```text
/// b = tan(ε/2)
/// E₁* ΔR/Q = (2 - ln(1 + b²) - 2b⁴)/(π b² (1 + b²))
/// p R/Q = 2/π √(b² - t²)/(√(1 + b²) (1 + t²))
///         + 1/(2π b² (1 + b²)) ln (√(1 + b²) + √(b² - t²))/(√(1 + b²) - √(b² - t²))
/// ```
/// `ε = half_angle [rad]`, `t = tan(θ/2)`, `Q = force [N/mm]`, `ΔR = clearance [mm]`, the
/// difference of the radii, `p = pressure [MPa]`, `E₁* = E/(1 - ν²)` of one of the two equal
/// bodies in plane strain, E in plane stress. Small ε is Hertz's contact. Without clearance ε is
/// 84.8°, whatever the force.
///
/// # Reference
/// A. Persson, *On the stress distribution of cylindrical elastic bodies in contact*,
/// dissertation, Chalmers, Göteborg (1964); M. Ciavarella, P. Decuzzi, *The state of stress
/// induced by the plane frictionless cylindrical contact. I*, Int. J. Solids Struct. 38 (2001)
/// 4507–4523.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinInHole {
    /// tan(ε/2).
    b: f64,
}

impl PinInHole {
    /// The contact that reaches over `half_angle` \[rad\] to each side.
    pub fn of_half_angle(half_angle: f64) -> Self {
        Self { b: (0.5 * half_angle).tan() }
    }

    /// The contact of a force: `E₁* ΔR/Q` is `clearance_ratio`, above 0.
    pub fn of_clearance_ratio(clearance_ratio: f64) -> Self {
        // Falls from infinity to below zero at 90°.
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            let is_too_narrow = Self { b: middle }.clearance_ratio() > clearance_ratio;
            if is_too_narrow { low = middle } else { high = middle }
        }
        Self { b: 0.5 * (low + high) }
    }

    /// Angle over which the bodies touch to each side ε \[rad\].
    pub fn half_angle(&self) -> f64 {
        2.0 * self.b.atan()
    }

    /// `E₁* ΔR/Q`.
    pub fn clearance_ratio(&self) -> f64 {
        let square = self.b * self.b;
        (2.0 - square.ln_1p() - 2.0 * square * square) / (PI * square * (1.0 + square))
    }

    /// `p R/Q` at an angle from the middle \[rad\]; zero beyond the contact.
    pub fn pressure_ratio(&self, angle: f64) -> f64 {
        let (square, t) = (self.b * self.b, (0.5 * angle).tan());
        let (whole, root) = ((1.0 + square).sqrt(), (square - t * t).max(0.0).sqrt());
        2.0 / PI * root / (whole * (1.0 + t * t))
            + ((whole + root) / (whole - root)).ln() / (2.0 * PI * square * (1.0 + square))
    }

    /// `p0 R/Q`, at the middle.
    pub fn peak_pressure_ratio(&self) -> f64 {
        self.pressure_ratio(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEGREES: [f64; 5] = [5.0, 20.0, 45.0, 60.0, 75.0];

    #[test]
    fn the_table_of_persson() {
        let clearance = [333.005_57, 19.535_25, 2.823_12, 1.067_20, 0.287_08];
        let peak = [7.302_08, 1.852_39, 0.882_11, 0.711_72, 0.628_10];
        for ((degrees, clearance), peak) in DEGREES.into_iter().zip(clearance).zip(peak) {
            let pin = PinInHole::of_half_angle(degrees.to_radians());
            assert!((pin.clearance_ratio() / clearance - 1.0).abs() < 2e-5, "{degrees}");
            assert!((pin.peak_pressure_ratio() / peak - 1.0).abs() < 2e-5, "{degrees}");
            let again = PinInHole::of_clearance_ratio(pin.clearance_ratio());
            assert!((again.half_angle() - degrees.to_radians()).abs() < 1e-12);
        }
    }

    /// What pressure does to the radii is the clearance. A pressure `p_n cos nθ` opens disc and
    /// hole together by `p_n R/E₁* · 4n/(n² - 1)`, a uniform one by `2 p_0 R/E₁*`, one with `n =
    /// 1` moves them as a whole; and what is left, `ΔR (1 - cos θ)`, has the curvature `ΔR`
    /// everywhere: `ΔR E₁*/R = 4 Σ n p_n cos nθ - 4 p_1 cos θ - 2 p_0`.
    #[test]
    fn clearance_follows_from_pressure() {
        for degrees in DEGREES {
            let end = degrees.to_radians();
            let pin = PinInHole::of_half_angle(end);
            let steps = 20_000;
            // At θ = 0 the sum is `-1/π ∫ p'(s) cot(s/2) ds` over one side, with s = ε sin φ.
            let place = |k: f64| end * (0.5 * PI * k / f64::from(steps)).sin();
            let (mut sum, mut whole) = (0.0, 0.0);
            for k in 0..steps {
                let (from, to) = (place(f64::from(k)), place(f64::from(k + 1)));
                let (p, q) = (pin.pressure_ratio(from), pin.pressure_ratio(to));
                sum -= (q - p) / (PI * (0.5 * place(f64::from(k) + 0.5)).tan());
                whole += (p + q) * (to - from);
            }
            // p_1 = Q/(π R), p_0 = ∫ p dθ/2π.
            let ratio = 4.0 * sum - 4.0 / PI - whole / PI;
            assert!((ratio / pin.clearance_ratio() - 1.0).abs() < 1e-4, "{degrees}: {ratio}");
        }
    }

    /// The vertical parts of the pressures add up to the force.
    #[test]
    fn pressure_carries_the_force() {
        for degrees in DEGREES {
            let end = degrees.to_radians();
            let pin = PinInHole::of_half_angle(end);
            // With θ = ε sin φ the integrand is smooth at the ends.
            let steps = 2000;
            let sum: f64 = (0..steps)
                .map(|k| {
                    let phi = 0.5 * PI * (f64::from(k) + 0.5) / f64::from(steps);
                    let angle = end * phi.sin();
                    pin.pressure_ratio(angle) * angle.cos() * end * phi.cos()
                })
                .sum();
            let force = 2.0 * sum * 0.5 * PI / f64::from(steps);
            assert!((force - 1.0).abs() < 1e-5, "{degrees}: {force}");
        }
    }
}
