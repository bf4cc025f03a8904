//! Hertz's elastic contact of spheres.

use std::f64::consts::PI;

use super::Stress;

/// Point contact of two elastic spheres (or sphere and plane).
///
/// ```text
/// a³ = 3 F R / (4 E*)     p0 = 3 F / (2 π a²)     α = a²/R     p(r) = p0 √(1 - r²/a²),  r <= a
/// ```
/// `F = force [N]`, `R = effective_radius [mm]`, `E* = effective_modulus [MPa]`, `a =
/// contact_radius [mm]`, `p0 = peak_pressure [MPa]`, `α = approach [mm]` of points far from the
/// contact. Valid for `a << R`.
///
/// # Reference
/// H. Hertz (1882); K. L. Johnson, *Contact Mechanics* (1985), eqs. 4.22 - 4.24.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzPoint {
    force: f64,
    contact_radius: f64,
    peak_pressure: f64,
    approach: f64,
}

impl HertzPoint {
    /// The contact under the force `F`, with effective radius `R` and effective modulus `E*`.
    pub fn new(force: f64, effective_radius: f64, effective_modulus: f64) -> Self {
        let contact_radius = (0.75 * force * effective_radius / effective_modulus).cbrt();
        Self {
            force,
            contact_radius,
            peak_pressure: 2.0 * effective_modulus * contact_radius / (PI * effective_radius),
            approach: contact_radius * contact_radius / effective_radius,
        }
    }

    /// The contact whose peak pressure is `p0`: `F = π³ R² p0³ / (6 E*²)`.
    pub fn from_peak_pressure(
        peak_pressure: f64,
        effective_radius: f64,
        effective_modulus: f64,
    ) -> Self {
        let ratio = effective_radius / effective_modulus;
        Self::new(
            (PI * peak_pressure).powi(3) * ratio * ratio / 6.0,
            effective_radius,
            effective_modulus,
        )
    }

    /// Force `F [N]`.
    pub const fn force(&self) -> f64 {
        self.force
    }

    /// Contact radius `a [mm]`.
    pub const fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Peak pressure `p0 [MPa]`.
    pub const fn peak_pressure(&self) -> f64 {
        self.peak_pressure
    }

    /// Mean pressure `F / (π a²) = 2 p0 / 3 [MPa]`.
    pub const fn mean_pressure(&self) -> f64 {
        2.0 / 3.0 * self.peak_pressure
    }

    /// Approach `α [mm]` of distant points of the two bodies.
    pub const fn approach(&self) -> f64 {
        self.approach
    }

    /// Pressure `p [MPa]` at the distance `r [mm]` from the middle; zero outside the contact.
    pub fn pressure(&self, r: f64) -> f64 {
        let s = r / self.contact_radius;
        if s.abs() < 1.0 { self.peak_pressure * ((1.0 - s) * (1.0 + s)).sqrt() } else { 0.0 }
    }

    /// Stress on the axis at `depth [mm]`; radial and hoop stress are equal there.
    ///
    /// ```text
    /// σ_r = σ_θ = -p0 { (1 + ν) [1 - (d/a) atan(a/d)] - ½ / (1 + d²/a²) }
    /// σ_y = -p0 / (1 + d²/a²)
    /// ```
    /// `σ_x` and `σ_z` of the result are the radial and the hoop stress.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), eqs. 3.45.
    pub fn stress_on_axis(&self, depth: f64, poisson_ratio: f64) -> Stress {
        let d = depth / self.contact_radius;
        let decay = 1.0 / (1.0 + d * d);
        let radial = -self.peak_pressure
            * ((1.0 + poisson_ratio) * (1.0 - d * 1.0_f64.atan2(d)) - 0.5 * decay);
        Stress {
            sigma_x: radial,
            sigma_y: -self.peak_pressure * decay,
            sigma_z: radial,
            tau_xy: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_pressure_and_approach_fit_together() {
        let hertz = HertzPoint::new(1000.0, 10.0, 115_384.6);
        let a = hertz.contact_radius();
        assert!((a.powi(3) - 3.0 * 1000.0 * 10.0 / (4.0 * 115_384.6)).abs() < 1e-15);
        assert!((hertz.peak_pressure() - 3.0 * 1000.0 / (2.0 * PI * a * a)).abs() < 1e-9);
        assert!((hertz.mean_pressure() * PI * a * a - 1000.0).abs() < 1e-9);
        assert!((hertz.approach() - a * a / 10.0).abs() < 1e-16);
        let back = HertzPoint::from_peak_pressure(hertz.peak_pressure(), 10.0, 115_384.6);
        assert!((back.force() - 1000.0).abs() < 1e-9);
        assert!((hertz.pressure(0.6 * a) - 0.8 * hertz.peak_pressure()).abs() < 1e-9);
        assert!(hertz.pressure(1.1 * a) <= 0.0);
    }

    #[test]
    fn stress_at_the_surface_and_far_below() {
        let hertz = HertzPoint::from_peak_pressure(1.0, 1.0, 1.0);
        let top = hertz.stress_on_axis(0.0, 0.3);
        assert!((top.sigma_y + 1.0).abs() < 1e-14 && (top.sigma_x + 0.8).abs() < 1e-14);
        // Boussinesq's point force: σ_y = -3F / (2π d²).
        let depth = 300.0 * hertz.contact_radius();
        let below = hertz.stress_on_axis(depth, 0.3);
        assert!(
            (below.sigma_y * 2.0 * PI * depth * depth / (3.0 * hertz.force()) + 1.0).abs() < 1e-4
        );
    }
}
