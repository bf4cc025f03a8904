//! The edge of a punch that is rounded with a small radius.

use std::f64::consts::PI;

/// Largest pressure over that where the flat ends, `max ∫ √t / √(t - x) dt` from x to 1.
const PEAK: f64 = 1.200;

/// The end of an elastic contact on the arc of a rounded edge, where that is small beside the radius.
///
/// Around the edge the contact is a sum of flat punches that end beyond one another, each with a pressure `dK/√s` at the distance s
/// from its end, under which the surface beside it falls away by `4 dK √s/E*`. With the slope `x/ρ` of the arc Abel's equation gives
/// ```text
/// dK/dt = E* √t / (π ρ),   K = 2 E* d^(3/2) / (3 π ρ),   p(x) = E*/(π ρ) ∫ √t / √(t - x) dt from max(0, x) to d
/// ```
/// `ρ = radius [mm]`, `d = width [mm]` of the contact on the arc, `K = intensity [MPa √mm]` of the sharp punch's pressure.
///
/// # Reference
/// M. Ciavarella, D. A. Hills, G. Monno, *The influence of rounded edges on indentation by a flat punch*, Proc. Instn Mech. Engrs C
/// 212 (1998) 319–328; D. Dini, D. A. Hills, *Bounded asymptotic solutions for incomplete contacts in partial slip*, Int. J. Solids
/// Struct. 41 (2004) 7049–7062.
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
        Self { radius, intensity: force / (2.0 * PI * flat * (2.0 * flat).sqrt()), effective_modulus }
    }

    /// Width of the contact on the arc \[mm\].
    pub fn width(&self) -> f64 {
        (1.5 * PI * self.radius * self.intensity / self.effective_modulus).powf(2.0 / 3.0)
    }

    /// Largest pressure, near the end of the flat \[MPa\].
    pub fn peak_pressure(&self) -> f64 {
        PEAK * self.effective_modulus * self.width() / (PI * self.radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The pressure of the sum of punches is in balance with that of the sharp one far from the edge, and nowhere larger than is said.
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
}
