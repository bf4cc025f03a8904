//! Stresses below Hertz's elliptic contact: below its middle, and the orthogonal shear stress.
//!
//! ```text
//! T = √((b² + z²)/(a² + z²)),   ζ = z/a,   cot φ = ζ,   e² = 1 - b²/a²,   b <= a
//! σ_a/p0 = 2b/(e² a) (-(1 - T)/2 + ζ (F - E) + ν (1 - a² T/b² + ζ (a² E/b² - F)))
//! σ_b/p0 = 2b/(e² a) (1/2 + 1/2T - a² T/b² + ζ (a² E/b² - F) + ν (T - 1 + ζ (F - E)))
//! σ_n/p0 = -b/(e² a) (1 - T²)/T
//! ```
//!
//! with the incomplete elliptic integrals F(φ, e) and E(φ, e).
//!
//! # Reference
//! H. R. Thomas, V. A. Hoersch, *Stresses due to the pressure of one elastic solid upon another*,
//! Univ. Illinois Eng. Exp. Station Bull. 212 (1930); K. L. Johnson, *Contact Mechanics* (1985),
//! section 4.2; B. C. Carlson, *Numerical computation of real or complex elliptic integrals*,
//! Numer. Algorithms 10 (1995) 13–26.

use super::{HertzPoint, Stress};

/// Ratio of the axes from which on the contact is a circle: `1/e²` costs digits there.
const CIRCLE: f64 = 0.9999;

/// An elliptic contact whose shorter semi-axis and peak pressure are 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzEllipse {
    /// Shorter semi-axis over the longer one, above 0 and at most 1.
    pub axis_ratio: f64,
}

impl HertzEllipse {
    /// Stress below the middle: `x` along the shorter semi-axis, `y` normal to the surface, `z`
    /// along the longer one.
    pub fn stress_on_axis(self, depth: f64, poisson_ratio: f64) -> Stress {
        if self.axis_ratio >= CIRCLE {
            let circle = HertzPoint::from_peak_pressure(1.0, 1.0, std::f64::consts::FRAC_PI_2);
            return circle.stress_on_axis(depth, poisson_ratio);
        }
        let (long, short) = (self.axis_ratio.recip(), 1.0);
        let squared = long * long;
        let modulus = 1.0 - self.axis_ratio * self.axis_ratio;
        let (first, second) = elliptic_integrals(long.atan2(depth), modulus);
        let ratio = ((short + depth * depth) / (squared + depth * depth)).sqrt();
        let zeta = depth / long;
        let along = zeta * (first - second);
        let across = zeta * (squared * second - first);
        let scale = 2.0 / (modulus * long);
        Stress {
            sigma_x: scale
                * (0.5 + 0.5 / ratio - squared * ratio
                    + across
                    + poisson_ratio * (ratio - 1.0 + along)),
            sigma_y: -0.5 * scale * (1.0 - ratio * ratio) / ratio,
            sigma_z: scale
                * (0.5 * (ratio - 1.0) + along + poisson_ratio * (1.0 - squared * ratio + across)),
            tau_xy: 0.0,
        }
    }

    /// `max_x |τ_xz|` at a depth, in the plane of the shorter semi-axis and the normal: the
    /// orthogonal shear stress of a contact that rolls along its shorter semi-axis.
    ///
    /// ```text
    /// V = (π a b p0/2) ∫_λ^∞ (1 - x²/(a² + w) - y²/(b² + w) - z²/w) dw/Δ
    /// Δ² = (a² + w)(b² + w) w,   τ_xz = -(z/2π) V_xz
    /// a = 1, y = 0, u = z²/λ:
    /// |τ_xz|/p0 = b z √((1 + λ)(1 - u)) / (Δ(λ) (1 + λ) ((1 - u)/(1 + λ) + u/λ)) z/λ
    /// ```
    ///
    /// V is the potential of the pressure; λ, above 0, is where its integrand is 0. At each depth
    /// u from 0 to 1 is all x.
    pub fn orthogonal_shear(self, depth: f64) -> f64 {
        if depth <= 0.0 {
            return 0.0;
        }
        let squared = self.axis_ratio.powi(-2);
        let shear = |u: f64| {
            let lambda = depth * depth / u;
            let beside = (1.0 - u) / (1.0 + lambda);
            let root = ((1.0 + lambda / squared) * lambda).sqrt();
            u * (1.0 - u).sqrt() / ((1.0 + lambda) * root * (beside + u / lambda))
        };
        let section = 0.5 * (5f64.sqrt() - 1.0);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..25 {
            let (left, right) = (high - section * (high - low), low + section * (high - low));
            if shear(left) < shear(right) { low = left } else { high = right }
        }
        shear(0.5 * (low + high))
    }

    /// The largest orthogonal shear stress of all depths, and its depth.
    ///
    /// ```text
    /// (t² - 1)(2t - 1) = (a/b)²,    τ/p0 = √(2t - 1)/(2t (t + 1)),    z/a = 1/((t + 1) √(2t - 1))
    /// ```
    ///
    /// # Reference
    /// G. Lundberg, A. Palmgren, *Dynamic capacity of rolling bearings*, Acta Polytechnica, Mech.
    /// Eng. Ser. 1 no. 3 (1947).
    pub fn largest_orthogonal_shear(self) -> (f64, f64) {
        let (mut low, mut high) = (1.0, 2.0);
        for _ in 0..60 {
            let t: f64 = 0.5 * (low + high);
            let is_below = (t * t - 1.0) * (2.0 * t - 1.0) < self.axis_ratio.powi(2);
            if is_below { low = t } else { high = t }
        }
        let root = (2.0 * low - 1.0_f64).sqrt();
        (root / (2.0 * low * (low + 1.0)), 1.0 / ((low + 1.0) * root))
    }
}

/// F and E of an angle in the first quadrant, the modulus given by its square.
fn elliptic_integrals(angle: f64, modulus_squared: f64) -> (f64, f64) {
    let (sine, cosine) = angle.sin_cos();
    let (x, y) = (cosine * cosine, 1.0 - modulus_squared * sine * sine);
    let (rf, rd) = carlson(x, y);
    let first = sine * rf;
    (first, first - modulus_squared * sine.powi(3) / 3.0 * rd)
}

/// `R_F(x, y, 1)` and `R_D(x, y, 1)` by duplication.
fn carlson(mut x: f64, mut y: f64) -> (f64, f64) {
    let (mut z, mut sum, mut factor) = (1.0_f64, 0.0, 1.0);
    // Each doubling takes away three quarters of the differences.
    for _ in 0..30 {
        let lambda = (x * y).sqrt() + (x * z).sqrt() + (y * z).sqrt();
        sum += factor / (z.sqrt() * (z + lambda));
        factor *= 0.25;
        (x, y, z) = (0.25 * (x + lambda), 0.25 * (y + lambda), 0.25 * (z + lambda));
    }
    (z.sqrt().recip(), 3.0 * sum + factor / (z * z.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Boussinesq's point loads summed over a quarter of the ellipse.
    fn by_point_loads(short: f64, long: f64, depth: f64, nu: f64) -> [f64; 3] {
        const STEPS: u32 = 300;
        let (mut sums, step) = ([0.0; 3], std::f64::consts::FRAC_PI_2 / f64::from(STEPS));
        for i in 0..STEPS {
            let (radius, pressure) = ((f64::from(i) + 0.5) * step).sin_cos();
            for j in 0..STEPS {
                let (sine, cosine) = ((f64::from(j) + 0.5) * step).sin_cos();
                let (x, y) = (short * radius * cosine, long * radius * sine);
                let weight = 4.0 * short * long * radius * pressure * step * step * pressure;
                let (plane, distance) = (x * x + y * y, (x * x + y * y + depth * depth).sqrt());
                let tangential = |u: f64, v: f64| {
                    let within = (1.0 - depth / distance) * (u * u - v * v) / plane
                        + depth * v * v / distance.powi(3);
                    (1.0 - 2.0 * nu) / plane * within - 3.0 * depth * u * u / distance.powi(5)
                };
                let factor = weight / (2.0 * std::f64::consts::PI);
                sums[0] += factor * tangential(x, y);
                sums[1] -= factor * 3.0 * depth.powi(3) / distance.powi(5);
                sums[2] += factor * tangential(y, x);
            }
        }
        sums
    }

    #[test]
    fn stresses_are_those_of_point_loads() {
        for (ratio, depth) in [(0.35, 0.7), (0.35, 1.5), (0.9, 0.5), (0.99995, 0.6)] {
            let stress = HertzEllipse { axis_ratio: ratio }.stress_on_axis(depth, 0.3);
            let expected = by_point_loads(1.0, ratio.recip(), depth, 0.3);
            for (found, expected) in
                [stress.sigma_x, stress.sigma_y, stress.sigma_z].into_iter().zip(expected)
            {
                assert!((found - expected).abs() < 1e-4, "{ratio} {depth}: {found} {expected}");
            }
        }
    }

    /// A line has p0/4 at a/2, a circle 0.2139 p0 at 0.351 a; between them the potential says so.
    #[test]
    fn orthogonal_shear_is_that_of_lundberg_and_palmgren() {
        for (axis_ratio, expected, at) in [(1e-4, 0.25, 0.5), (1.0, 0.21390, 0.3509)] {
            let (shear, depth) = HertzEllipse { axis_ratio }.largest_orthogonal_shear();
            assert!(
                (shear - expected).abs() < 1e-4 && (depth - at).abs() < 1e-3,
                "{shear} {depth}"
            );
        }
        for axis_ratio in [0.05, 0.2, 0.5, 0.8, 1.0] {
            let ellipse = HertzEllipse { axis_ratio };
            let (shear, depth) = ellipse.largest_orthogonal_shear();
            let [above, found, below] =
                [0.97, 1.0, 1.03].map(|part| ellipse.orthogonal_shear(part * depth));
            assert!((found / shear - 1.0).abs() < 1e-8, "{axis_ratio}: {found} {shear}");
            assert!(above < found && below < found && above.min(below) > 0.998 * found);
        }
    }

    #[test]
    fn a_long_ellipse_is_a_line() {
        let line =
            super::super::HertzLine::from_peak_pressure(1.0, 1.0, 2.0).stress_on_axis(0.7, 0.3);
        let long = HertzEllipse { axis_ratio: 1e-3 }.stress_on_axis(0.7, 0.3);
        assert!((line.von_mises() - long.von_mises()).abs() < 2e-3, "{line:?} {long:?}");
    }
}
