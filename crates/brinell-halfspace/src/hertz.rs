//! The elastic contact of two smooth bodies, Hertz's ellipse.
//!
//! With the curvatures `1/Rx >= 1/Ry` of the gap along the short and the long semi-axis b and a,
//! `k = b/a` solves
//! ```text
//! Ry/Rx = R_D(0, 1, k²) / R_D(0, k², 1)
//! a³ = P Ry R_D(0, k², 1) / (π E*),   p0 = 3P/(2π a b),   α = (p0 b/E*) K(1 - k²)
//! ```
//! with Carlson's R_D. They are the usual complete integrals, `K - E = m/3 R_D(0, k², 1)` and
//! `E/k² - K = m/3 R_D(0, 1, k²)` with `m = 1 - k²`, without the differences that cancel in a
//! circle.
//!
//! # Reference
//! K. L. Johnson, *Contact Mechanics* (1985), section 4.2; B. C. Carlson, *Numerical computation
//! of real or complex elliptic integrals*, Numer. Algorithms 10 (1995) 13–26.

use std::f64::consts::PI;

/// An elliptic contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipticContact {
    /// Largest pressure p0 \[MPa\].
    pub peak_pressure: f64,
    /// Semi-axis along x \[mm\].
    pub semi_axis_x: f64,
    /// Semi-axis along y \[mm\].
    pub semi_axis_y: f64,
    /// Approach α \[mm\].
    pub approach: f64,
}

impl EllipticContact {
    /// The contact under `force` \[N\] of a gap `x²/(2 Rx) + y²/(2 Ry)` with radii in mm and E* in
    /// MPa, all positive.
    pub fn new(radius_x: f64, radius_y: f64, effective_modulus: f64, force: f64) -> Self {
        let (small, large) = (radius_x.min(radius_y), radius_x.max(radius_y));
        let ratio_of = |k: f64| carlson_rd(1.0, k * k) / carlson_rd(k * k, 1.0);
        // k lies between the ratio of the radii and 1; the right-hand side falls with k.
        let (mut low, mut high) = (small / large, 1.0_f64);
        for _ in 0..200 {
            let middle = (low * high).sqrt();
            if middle <= low || middle >= high {
                break;
            }
            if ratio_of(middle) > large / small { low = middle } else { high = middle }
        }
        let k = high;
        let long = (force * large * carlson_rd(k * k, 1.0) / (PI * effective_modulus)).cbrt();
        let short = k * long;
        let peak_pressure = 1.5 * force / (PI * long * short);
        let approach = peak_pressure * short / effective_modulus * complete_first_kind(k);
        let (semi_axis_x, semi_axis_y) =
            if radius_x <= radius_y { (short, long) } else { (long, short) };
        Self { peak_pressure, semi_axis_x, semi_axis_y, approach }
    }
}

/// Duplications after which nothing changes any more: each takes away three quarters of the
/// differences.
const DUPLICATIONS: u32 = 40;

/// `K(1 - k²)` by the arithmetic-geometric mean of 1 and k.
fn complete_first_kind(k: f64) -> f64 {
    let (mut a, mut g) = (1.0_f64, k);
    for _ in 0..DUPLICATIONS {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    PI / (a + g)
}

/// `R_D(0, y, z)` by duplication.
fn carlson_rd(y: f64, z: f64) -> f64 {
    let (mut x, mut y, mut z) = (0.0_f64, y, z);
    let (mut sum, mut factor) = (0.0, 1.0);
    for _ in 0..DUPLICATIONS {
        let lambda = (x * y).sqrt() + (x * z).sqrt() + (y * z).sqrt();
        sum += factor / (z.sqrt() * (z + lambda));
        factor *= 0.25;
        (x, y, z) = (0.25 * (x + lambda), 0.25 * (y + lambda), 0.25 * (z + lambda));
    }
    3.0 * sum + factor / (z * z.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_the_contact_of_spheres() {
        let (radius, modulus, force) = (10.0, 230_000.0, 80.0);
        let contact = EllipticContact::new(radius, radius, modulus, force);
        let a = (0.75 * force * radius / modulus).cbrt();
        assert!((contact.semi_axis_x / a - 1.0).abs() < 1e-13);
        assert!((contact.semi_axis_y / a - 1.0).abs() < 1e-13);
        assert!((contact.approach / (a * a / radius) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn an_ellipse_has_the_figures_of_the_tables() {
        // Ry/Rx = 5 has b/a = 2.89, 20 has 6.93.
        for (ratio, axes) in [(5.0, 2.89), (20.0, 6.93)] {
            let contact = EllipticContact::new(10.0, 10.0 * ratio, 210_000.0 / 0.91, 100.0);
            assert!((contact.semi_axis_y / contact.semi_axis_x - axes).abs() < 0.01);
            let turned = EllipticContact::new(10.0 * ratio, 10.0, 210_000.0 / 0.91, 100.0);
            assert_eq!(turned.semi_axis_x.to_bits(), contact.semi_axis_y.to_bits());
        }
        let contact = EllipticContact::new(10.0, 50.0, 210_000.0 / 0.91, 317.1424);
        assert!((contact.semi_axis_x - 0.161_853).abs() < 1e-6);
        assert!((contact.semi_axis_y - 0.467_784).abs() < 1e-6);
        assert!((contact.approach - 3.4980e-3).abs() < 1e-7);
        assert!((contact.peak_pressure - 2000.0).abs() < 1e-3);
    }
}
