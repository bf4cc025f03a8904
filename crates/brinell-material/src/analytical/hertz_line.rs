//! Hertz's elastic contact of cylinders with parallel axes.

use std::f64::consts::PI;

/// Line contact of two elastic cylinders (or cylinder and block, or cylinder and groove).
///
/// ```text
/// a = √(4 P R / (π E*))      p0 = 2 P / (π a)      p(x) = p0 √(1 - x²/a²),  |x| <= a
/// ```
/// `P = force [N/mm]`, `R = effective_radius [mm]`, `E* = effective_modulus [MPa]`, `a =
/// half_width [mm]`, `p0 = peak_pressure [MPa]`. Valid for `a << R`.
///
/// # Reference
/// H. Hertz (1882); K. L. Johnson, *Contact Mechanics* (1985), eqs. 4.43 - 4.45.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzLine {
    force: f64,
    half_width: f64,
    peak_pressure: f64,
}

impl HertzLine {
    /// The contact under the force per length `P`, with effective radius `R` and effective modulus
    /// `E*`.
    pub fn new(force_per_length: f64, effective_radius: f64, effective_modulus: f64) -> Self {
        let half_width =
            (4.0 * force_per_length * effective_radius / (PI * effective_modulus)).sqrt();
        // Not 2P/(πa), which is 0/0 for P = 0.
        let peak_pressure =
            (force_per_length * effective_modulus / (PI * effective_radius)).sqrt();
        Self { force: force_per_length, half_width, peak_pressure }
    }

    /// The contact whose peak pressure is `p0`: `P = π R p0² / E*`.
    pub fn from_peak_pressure(
        peak_pressure: f64,
        effective_radius: f64,
        effective_modulus: f64,
    ) -> Self {
        let force = PI * effective_radius * peak_pressure * peak_pressure / effective_modulus;
        Self::new(force, effective_radius, effective_modulus)
    }

    /// Force per length `P [N/mm]`.
    pub const fn force(&self) -> f64 {
        self.force
    }

    /// Half the contact width `a [mm]`.
    pub const fn half_width(&self) -> f64 {
        self.half_width
    }

    /// Peak pressure `p0 [MPa]`.
    pub const fn peak_pressure(&self) -> f64 {
        self.peak_pressure
    }

    /// Mean pressure `P / 2a = π p0 / 4 [MPa]`.
    pub const fn mean_pressure(&self) -> f64 {
        0.25 * PI * self.peak_pressure
    }

    /// Pressure `p [MPa]` at the distance `x [mm]` from the middle; zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        let s = x / self.half_width;
        if s.abs() < 1.0 { self.peak_pressure * ((1.0 - s) * (1.0 + s)).sqrt() } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytical::{ElasticConstants, effective_modulus, effective_radius};

    /// NAFEMS benchmark: steel cylinder, R 50 mm, on an aluminium block.
    #[test]
    fn cylinder_on_block() {
        let modulus = effective_modulus([
            Some(ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 }),
            Some(ElasticConstants { young_modulus: 70_000.0, poisson_ratio: 0.3 }),
        ]);
        let hertz = HertzLine::new(35_000.0, effective_radius([1.0 / 50.0, 0.0]), modulus);
        assert!((hertz.half_width() - 6.2146).abs() < 5e-5);
        assert!((hertz.peak_pressure() - 3585.4).abs() < 0.05);
        assert!(
            (hertz.peak_pressure() * PI * hertz.half_width() / 2.0 / 35_000.0 - 1.0).abs() < 1e-14
        );
    }

    /// The paper's cylinders: P = 612.6106 N/mm is the load whose elastic peak is `3 σ_y`.
    #[test]
    fn peak_pressure_and_force_are_inverse() {
        let hertz = HertzLine::from_peak_pressure(1500.0, 10.0, 210_000.0 / 1.82);
        assert!((hertz.force() - 612.6106).abs() < 5e-5);
        assert!((hertz.peak_pressure() - 1500.0).abs() < 1e-10);
    }

    #[test]
    fn pressure_carries_the_force() {
        let hertz = HertzLine::new(100.0, 10.0, 115_000.0);
        let (a, n) = (hertz.half_width(), 4000);
        let sum: f64 = (0..n)
            .map(|i| PI * (f64::from(i) + 0.5) / f64::from(n))
            .map(|t| hertz.pressure(a * t.cos()) * a * t.sin() * PI / f64::from(n))
            .sum();
        assert!((sum / 100.0 - 1.0).abs() < 1e-6);
        assert!((hertz.mean_pressure() * 2.0 * a / 100.0 - 1.0).abs() < 1e-14);
        assert!(hertz.pressure(1.01 * a) <= 0.0 && hertz.pressure(-a) <= 0.0);
        assert!(HertzLine::new(0.0, 10.0, 115_000.0).peak_pressure() <= 0.0);
    }
}
