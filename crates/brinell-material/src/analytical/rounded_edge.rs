//! The edge of a punch that is rounded with a small radius.

use std::f64::consts::PI;

use nalgebra::Complex;

use super::stress::von_mises;

/// Largest pressure over that where the flat ends, `max ∫ √t / √(t - x) dt` from x to 1.
const PEAK: f64 = 1.200;

/// The end of an elastic contact on the arc of a rounded edge, where that is small beside the
/// radius.
///
/// Around the edge the contact is a sum of flat punches that end beyond one another, each with a
/// pressure `dK/√s` at the distance s from its end, under which the surface beside it falls away
/// by `4 dK √s/E*`. With the slope `x/ρ` of the arc Abel's equation gives
/// ```text
/// dK/dt = E* √t / (π ρ),   K = 2 E* d^(3/2) / (3 π ρ)
/// p(x) = E*/(π ρ) ∫ √t / √(t - x) dt from max(0, x) to d
/// ```
/// `ρ = radius [mm]`, `d = width [mm]` of the contact on the arc, `K = intensity [MPa √mm]` of the
/// sharp punch's pressure.
///
/// # Reference
/// M. Ciavarella, D. A. Hills, G. Monno, *The influence of rounded edges on indentation by a flat
/// punch*, Proc. Instn Mech. Engrs C 212 (1998) 319–328; D. Dini, D. A. Hills, *Bounded asymptotic
/// solutions for incomplete contacts in partial slip*, Int. J. Solids Struct. 41 (2004) 7049–7062.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundedEdge {
    radius: f64,
    intensity: f64,
    effective_modulus: f64,
}

impl RoundedEdge {
    /// The edge of a plane punch with a flat of this half-width \[mm\] under a force \[N/mm\].
    pub fn plane(radius: f64, flat: f64, force: f64, effective_modulus: f64) -> Self {
        Self { radius, intensity: force / (PI * (2.0 * flat).sqrt()), effective_modulus }
    }

    /// The edge of a circular punch with a flat of this radius \[mm\] under a force \[N\].
    pub fn circular(radius: f64, flat: f64, force: f64, effective_modulus: f64) -> Self {
        Self {
            radius,
            intensity: force / (2.0 * PI * flat * (2.0 * flat).sqrt()),
            effective_modulus,
        }
    }

    /// Width of the contact on the arc \[mm\].
    pub fn width(&self) -> f64 {
        (1.5 * PI * self.radius * self.intensity / self.effective_modulus).powf(2.0 / 3.0)
    }

    /// Largest pressure, near the end of the flat \[MPa\].
    pub fn peak_pressure(&self) -> f64 {
        PEAK * self.effective_modulus * self.width() / (PI * self.radius)
    }

    /// Largest von Mises stress below the edge, over the largest pressure, and its place `[x,
    /// depth]` in widths from the end of the flat; `out_of_plane` is `σ_z / (σ_x + σ_y)`,
    /// Poisson's ratio in plane strain and 0 in plane stress.
    pub fn von_mises_over_peak(out_of_plane: f64) -> (f64, [f64; 2]) {
        let part = f64::from(PLACES).recip();
        let place = |i: u32, j: u32| [f64::from(i) * part - 1.0, (f64::from(j) + 1e-6) * part];
        let places = (0..WIDE * PLACES).flat_map(|i| (0..PLACES).map(move |j| place(i, j)));
        let stresses =
            places.map(|place| (von_mises(stress_of_widths(place, out_of_plane)) / PEAK, place));
        stresses.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default()
    }
}

/// Places over the width and the depth of the contact on the arc at which stress is looked at, and
/// its widths along the surface.
const PLACES: u32 = 40;
const WIDE: u32 = 2;

/// Stress `[σ_x, σ_y, σ_z, τ_xy]` at a place `[x, y]` in widths d from the end of the flat, y into
/// the body, over `E* d/(π ρ)`.
///
/// Each flat punch that ends at t has the potential `Z = -dK/√(t - w)` of `w = x + i y`, with
/// `σ_x = Re Z - y Im Z'`, `σ_y = Re Z + y Im Z'`, `τ_xy = -y Re Z'`. Their sum is `-(s + w l)`
/// with `s = √(1 - w)` and `l = ln((1 + s)/√-w)`.
///
/// # Reference
/// H. M. Westergaard, *Bearing pressures and cracks*, J. Appl. Mech. 6 (1939) A49–A53.
fn stress_of_widths([x, y]: [f64; 2], out_of_plane: f64) -> [f64; 4] {
    let w = Complex::new(x, y);
    let s = (Complex::new(1.0, 0.0) - w).sqrt();
    let l = (s + 1.0).ln() - (-w).ln() * 0.5;
    let (potential, slope) = (-(s + w * l), s.inv() - l);
    let (along, normal) = (potential.re - y * slope.im, potential.re + y * slope.im);
    [along, normal, out_of_plane * (along + normal), -y * slope.re]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pressure of the sum of punches is in balance with that of the sharp one far from the
    /// edge, and nowhere larger than is said.
    #[test]
    fn the_pressure_is_that_of_a_sharp_edge_far_from_it() {
        let edge = RoundedEdge::plane(0.03, 0.97, 2000.0, 230_769.0);
        let d = edge.width();
        // By t = max(0, x) + s², which takes the root out of the integrand.
        let pressure = |x: f64| {
            let from = x.max(0.0);
            let (steps, end) = (20_000, (d - from).sqrt());
            let step = end / f64::from(steps);
            let part = |k: u32| {
                let s = step * (f64::from(k) + 0.5);
                let t = from + s * s;
                2.0 * s * step * (t / (t - x)).sqrt()
            };
            edge.effective_modulus / (PI * edge.radius) * (0..steps).map(part).sum::<f64>()
        };
        let far = 1000.0 * d;
        assert!((pressure(-far) * far.sqrt() / edge.intensity - 1.0).abs() < 1e-3);
        let largest = (0..100).map(|k| pressure(0.01 * f64::from(k) * d)).fold(0.0, f64::max);
        assert!((largest / edge.peak_pressure() - 1.0).abs() < 1e-3, "{largest}");
    }

    /// Where the surface yields first it is under `-p` in both directions of the section.
    #[test]
    fn stress_below_the_edge() {
        for (out_of_plane, exact) in [(0.0, 1.0), (0.1, 0.8)] {
            assert!((RoundedEdge::von_mises_over_peak(out_of_plane).0 - exact).abs() < 2e-3);
        }
        // Without shear at the surface, and none of the normal stress beyond the contact.
        let at_surface = |x: f64| stress_of_widths([x, 1e-9], 0.3);
        assert!(at_surface(0.5)[3].abs() < 1e-6 && at_surface(1.5)[1].abs() < 1e-6);
    }

    /// A rigid punch, 4 mm wide, on steel that yields at 500 MPa: P_Y of the exact pressure with
    /// Flamant's stresses.
    #[test]
    fn yield_of_a_block_begins_at_the_edge() {
        for (radius, exact) in [(0.02, 50.4), (0.1, 110.3), (0.4, 202.5), (1.0, 253.7)] {
            let edge = RoundedEdge::plane(radius, 2.0 - radius, exact, 210_000.0 / 0.91);
            let utilization =
                edge.peak_pressure() * RoundedEdge::von_mises_over_peak(0.3).0 / 500.0;
            assert!((utilization.powf(1.5) - 1.0).abs() < 0.015, "{radius}: {utilization}");
        }
    }
}
