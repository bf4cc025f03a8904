//! Rigid indenters of simple shapes on an elastic half-space.

use std::f64::consts::PI;

/// An indenter whose surface falls off as `C |x|^n`: a wedge or cone (n = 1), a parabola (n = 2),
/// nearly a flat punch (n large).
///
/// ```text
/// plane          P = n C E* a^n I(n)
/// axisymmetric   P = 2 n C E* a^(n+1) I(n+1),   α = n C a^n I(n-1)
/// I(m) = ∫ sinᵐφ dφ from 0 to π/2
/// ```
/// `P = force [N/mm or N]`, `a = half_width [mm]`, `α = approach [mm]`, `E* = effective_modulus
/// [MPa]`. The approach of a plane contact depends on the size of the body.
///
/// # Reference
/// I. N. Sneddon, *The relation between load and penetration in the axisymmetric Boussinesq
/// problem for a punch of arbitrary profile*, Int. J. Engng Sci. 3 (1965) 47–57; K. L. Johnson,
/// *Contact Mechanics* (1985), sections 5.2 and 5.3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerIndenter {
    exponent: f64,
    coefficient: f64,
    effective_modulus: f64,
}

impl PowerIndenter {
    /// The indenter of height `-C |x|^n`, with `C` in mm^(1-n).
    pub const fn new(exponent: f64, coefficient: f64, effective_modulus: f64) -> Self {
        Self { exponent, coefficient, effective_modulus }
    }

    /// The wedge or cone whose flanks are inclined by `angle` \[rad\] to the surface.
    pub fn wedge(angle: f64, effective_modulus: f64) -> Self {
        Self::new(1.0, angle.tan(), effective_modulus)
    }

    /// Force on unit thickness `P [N/mm]` under which the plane contact has the half-width `a
    /// [mm]`.
    pub fn line_force(&self, half_width: f64) -> f64 {
        let n = self.exponent;
        n * self.coefficient * self.effective_modulus * half_width.powf(n) * sine_integral(n)
    }

    /// Force `P [N]` under which the contact circle has the radius `a [mm]`.
    pub fn force(&self, radius: f64) -> f64 {
        let n = self.exponent;
        2.0 * n
            * self.coefficient
            * self.effective_modulus
            * radius.powf(n + 1.0)
            * sine_integral(n + 1.0)
    }

    /// Approach `α [mm]` at which the contact circle has the radius `a [mm]`.
    pub fn approach(&self, radius: f64) -> f64 {
        let n = self.exponent;
        n * self.coefficient * radius.powf(n) * sine_integral(n - 1.0)
    }
}

/// `∫ sinᵐφ dφ` from 0 to π/2, `m > -1`.
fn sine_integral(power: f64) -> f64 {
    // By parts: I(m) = (m+2)/(m+1) I(m+2), up to a power at which the integrand is smooth enough
    // for even steps, whose error then falls faster than any power of their width.
    let (mut m, mut factor) = (power, 1.0);
    while m < 16.0 {
        factor *= (m + 2.0) / (m + 1.0);
        m += 2.0;
    }
    let steps = 200;
    let step = 0.5 * PI / f64::from(steps);
    let inner: f64 = (1..steps).map(|k| (step * f64::from(k)).sin().powf(m)).sum();
    factor * step * (inner + 0.5)
}

/// Pressure of a rigid flat punch with sharp edges on an elastic half-plane, `p = P/(π √(a² - x²))
/// [MPa]`.
///
/// # Reference
/// M. A. Sadowsky (1928); K. L. Johnson, *Contact Mechanics* (1985), eq. 2.64.
pub fn flat_punch_pressure(force_per_length: f64, half_width: f64, x: f64) -> f64 {
    force_per_length / (PI * (half_width * half_width - x * x).sqrt())
}

/// Pressure of a rigid cylindrical punch with a sharp edge on an elastic half-space, `p = P/(2πa
/// √(a² - r²)) [MPa]`.
///
/// # Reference
/// J. Boussinesq (1885); K. L. Johnson, *Contact Mechanics* (1985), eq. 3.34. Its approach is `α =
/// P/(2 a E*)`.
pub fn circular_punch_pressure(force: f64, radius: f64, r: f64) -> f64 {
    force / (2.0 * PI * radius * (radius * radius - r * r).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytical::{HertzLine, HertzPoint};

    #[test]
    fn sine_integrals() {
        for (m, expected) in
            [(0.0, 0.5 * PI), (1.0, 1.0), (2.0, 0.25 * PI), (3.0, 2.0 / 3.0), (9.0, 128.0 / 315.0)]
        {
            assert!((sine_integral(m) / expected - 1.0).abs() < 1e-13, "{m}");
        }
        // √π/2 Γ(0.6)/Γ(1.1)
        assert!(
            (sine_integral(0.2) - 1.387_250_959_242_028).abs() < 1e-6,
            "{}",
            sine_integral(0.2)
        );
    }

    #[test]
    fn the_second_power_is_hertz() {
        let (radius, modulus, force) = (20.0, 230_000.0, 500.0);
        let indenter = PowerIndenter::new(2.0, 0.5 / radius, modulus);
        let line = HertzLine::new(force, radius, modulus);
        assert!((indenter.line_force(line.half_width()) / force - 1.0).abs() < 1e-12);
        let point = HertzPoint::new(force, radius, modulus);
        assert!((indenter.force(point.contact_radius()) / force - 1.0).abs() < 1e-12);
        assert!(
            (indenter.approach(point.contact_radius()) / point.approach() - 1.0).abs() < 1e-12
        );
    }

    /// Sneddon's cone: `p_m = E* tan β / 2`, `α = π/2 a tan β`. Johnson's wedge: `p_m = E* tan β /
    /// 2`.
    #[test]
    fn the_first_power_is_a_cone_or_a_wedge() {
        let (angle, modulus, a) = (0.1_f64, 230_000.0, 0.7);
        let indenter = PowerIndenter::wedge(angle, modulus);
        let mean = 0.5 * modulus * angle.tan();
        assert!((indenter.force(a) / (PI * a * a) / mean - 1.0).abs() < 1e-12);
        assert!((indenter.line_force(a) / (2.0 * a) / mean - 1.0).abs() < 1e-12);
        assert!((indenter.approach(a) / (0.5 * PI * a * angle.tan()) - 1.0).abs() < 1e-12);
    }
}
