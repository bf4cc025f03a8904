//! McEwen's stresses below a Hertzian line contact.

use super::{HertzLine, Stress};

impl HertzLine {
    /// Stress on the axis of symmetry at `depth [mm]` below the surface, plane strain.
    ///
    /// ```text
    /// σ_x = -(p0/a) [(a² + 2d²)/√(a² + d²) - 2d]      tangential
    /// σ_y = -p0 a/√(a² + d²)                          normal to the contact
    /// σ_z = ν (σ_x + σ_y)                             out of plane
    /// ```
    /// `σ_x` is evaluated as `-p0 a³ / (s (s + d)²)`, `s = √(a² + d²)`, the same without its
    /// cancellation at depth.
    ///
    /// # Reference
    /// K. L. Johnson, *Contact Mechanics* (1985), eqs. 4.46 (there z is the depth).
    pub fn stress_on_axis(&self, depth: f64, poisson_ratio: f64) -> Stress {
        let (a, p0) = (self.half_width(), self.peak_pressure());
        let s = a.hypot(depth);
        let sigma_x = -p0 * (a / s) * (a / (s + depth)).powi(2);
        let sigma_y = -p0 * a / s;
        Stress { sigma_x, sigma_y, sigma_z: poisson_ratio * (sigma_x + sigma_y), tau_xy: 0.0 }
    }

    /// Stress at (x, depth) `[mm]`, plane strain.
    ///
    /// With m and n, of the signs of depth and x, from
    /// ```text
    /// m² - n² = a² - x² + d²      m n = x d
    /// σ_x  = -(p0/a) { m [1 + (d² + n²)/(m² + n²)] - 2d }
    /// σ_y  = -(p0/a)   m [1 - (d² + n²)/(m² + n²)]
    /// σ_z  = ν (σ_x + σ_y)
    /// τ_xy = -(p0/a)   n (m² - d²)/(m² + n²)          y into the body
    /// ```
    /// evaluated without cancellation from `w = m² - d²`, the positive root of `w² + (d² + x² -
    /// a²) w = a² d²`. At the edges of the contact every component falls to zero like a square
    /// root.
    ///
    /// # Reference
    /// E. McEwen, *Stresses in elastic cylinders in contact along a generatrix*, Phil. Mag. 40
    /// (1949) 454-459; K. L. Johnson, *Contact Mechanics* (1985), eqs. 4.49.
    pub fn stress(&self, x: f64, depth: f64, poisson_ratio: f64) -> Stress {
        let (a, d) = (self.half_width(), depth);
        let difference = (a - x) * (a + x) + d * d;
        let sum = difference.hypot(2.0 * x * d);
        let b = d * d - (a - x) * (a + x);
        let w = if b > 0.0 { 2.0 * (a * d).powi(2) / (sum + b) } else { 0.5 * (sum - b) };
        if w <= 0.0 {
            return Stress { sigma_x: 0.0, sigma_y: 0.0, sigma_z: 0.0, tau_xy: 0.0 };
        }
        let (m, n) = if difference >= 0.0 {
            let m = (0.5 * (sum + difference)).sqrt();
            (m, x * d / m)
        } else {
            let n = (0.5 * (sum - difference)).sqrt().copysign(x);
            (x * d / n, n)
        };
        let unit = -self.peak_pressure() / a * w;
        let sigma_x = unit * (m * w / (m + d) + 2.0 * n * n) / ((m + d) * sum);
        let sigma_y = unit * m / sum;
        let tau_xy = unit * n / sum;
        Stress { sigma_x, sigma_y, sigma_z: poisson_ratio * (sigma_x + sigma_y), tau_xy }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// a = 1, p0 = 1.
    fn unit() -> HertzLine {
        HertzLine::from_peak_pressure(1.0, 1.0, 2.0)
    }

    /// Superposed line loads (Flamant): σ = -(2/π) ∫ p (x-s)^i d^j / r⁴ ds.
    fn superposed(x: f64, depth: f64) -> [f64; 3] {
        let n = 4000;
        let mut sums = [0.0; 3];
        for i in 0..n {
            let t = PI * (f64::from(i) + 0.5) / f64::from(n);
            let (s, weight) = (t.cos(), t.sin() * t.sin() * PI / f64::from(n));
            let (u, r2) = (x - s, (x - s).powi(2) + depth * depth);
            let factor = -2.0 / PI * weight * depth / (r2 * r2);
            for (sum, term) in sums.iter_mut().zip([u * u, depth * depth, u * depth]) {
                *sum += factor * term;
            }
        }
        sums
    }

    #[test]
    fn field_is_the_superposition_of_line_loads() {
        assert!((unit().half_width() - 1.0).abs() < 1e-15);
        for x in [-2.5, -1.0, -0.4, 0.0, 0.3, 0.865, 1.0, 1.2, 4.0] {
            for depth in [0.05, 0.5, 0.786, 2.0, 9.0] {
                let stress = unit().stress(x, depth, 0.3);
                let expected = superposed(x, depth);
                for (left, right) in
                    [stress.sigma_x, stress.sigma_y, stress.tau_xy].iter().zip(expected)
                {
                    assert!((left - right).abs() < 1e-7, "({x}, {depth}): {left} {right}");
                }
            }
        }
    }

    #[test]
    fn axis_is_part_of_the_field() {
        for depth in [0.0, 0.1, 0.704, 3.0, 1e4] {
            let (axis, field) =
                (unit().stress_on_axis(depth, 0.3), unit().stress(0.0, depth, 0.3));
            let printed =
                -((1.0 + 2.0 * depth * depth) / (1.0 + depth * depth).sqrt() - 2.0 * depth);
            assert!((axis.sigma_x - printed).abs() < 1e-15 * (1.0 + 8.0 * depth));
            assert!((axis.sigma_x / field.sigma_x - 1.0).abs() < 1e-13);
            assert!((axis.sigma_y / field.sigma_y - 1.0).abs() < 1e-13);
            assert!((axis.sigma_z / field.sigma_z - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn surface_carries_the_pressure_and_nothing_outside() {
        for x in [-0.9, 0.0, 0.5] {
            let stress = unit().stress(x, 0.0, 0.3);
            assert!((stress.sigma_y + unit().pressure(x)).abs() < 1e-14);
            assert!(
                (stress.sigma_x - stress.sigma_y).abs() < 1e-14 && stress.tau_xy.abs() < 1e-14
            );
        }
        for x in [-3.0, -1.0, 1.0, 1.001] {
            let stress = unit().stress(x, 0.0, 0.3);
            assert!(stress.von_mises() < 1e-12, "{x}");
        }
    }

    #[test]
    fn largest_shear_and_orthogonal_shear() {
        let deepest = unit().stress_on_axis(0.786, 0.3);
        assert!((deepest.tau_max() - 0.3003).abs() < 5e-5);
        assert!(deepest.tau_max() > unit().stress_on_axis(0.780, 0.3).tau_max());
        assert!(deepest.tau_max() > unit().stress_on_axis(0.792, 0.3).tau_max());
        for side in [-1.0, 1.0] {
            let orthogonal = unit().stress(side * 0.865, 0.5, 0.3).tau_xy;
            assert!((orthogonal + side * 0.25).abs() < 5e-5, "{orthogonal}");
        }
    }
}
