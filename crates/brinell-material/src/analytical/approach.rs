//! Approach of a line contact, which depends on where it is counted from.

use std::f64::consts::PI;

use super::ElasticConstants;

/// Approach of the centre of a disc to its contact point `[mm]`, plane strain.
///
/// ```text
/// α = P (1 - ν²)/(π E) [2 ln(4R/a) - 1]
/// ```
/// `P = force [N/mm]`, `R = radius [mm]` of the disc itself (not the effective one), `a =
/// half_width [mm]`. The disc is loaded by equal and opposite contacts; `a << R`.
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), eq. 5.57.
pub fn disc_approach(force: f64, elastic: ElasticConstants, radius: f64, half_width: f64) -> f64 {
    unit(force, elastic) * (2.0 * (4.0 * radius / half_width).ln() - 1.0)
}

/// Approach of the base of a layer of depth d to the contact point `[mm]`, plane strain.
///
/// ```text
/// α = P (1 - ν²)/(π E) [2 ln(2d/a) - ν/(1 - ν)]
/// ```
/// `P = force [N/mm]`, `d = depth [mm]`, `a = half_width [mm]`, `a << d`. The stresses are those
/// of a half-plane, so the base's reaction is neglected.
///
/// # Reference
/// K. L. Johnson, *Contact Mechanics* (1985), section 5.6, by integration of the strain on the
/// axis.
pub fn layer_approach(force: f64, elastic: ElasticConstants, depth: f64, half_width: f64) -> f64 {
    let nu = elastic.poisson_ratio;
    unit(force, elastic) * (2.0 * (2.0 * depth / half_width).ln() - nu / (1.0 - nu))
}

/// `P (1 - ν²)/(π E)`
fn unit(force: f64, elastic: ElasticConstants) -> f64 {
    let ElasticConstants { young_modulus, poisson_ratio } = elastic;
    force * (1.0 - poisson_ratio * poisson_ratio) / (PI * young_modulus)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytical::HertzLine;

    const STEEL: ElasticConstants =
        ElasticConstants { young_modulus: 210_000.0, poisson_ratio: 0.3 };

    /// `∫ (1-ν²)/E (σ_y - ν/(1-ν) σ_x)` over depth, with further stresses added to the
    /// half-plane's.
    fn shortening(hertz: &HertzLine, end: f64, further: impl Fn(f64) -> (f64, f64)) -> f64 {
        let n = 20_000;
        // d = a sinh(t) spreads the points evenly over the decades of depth.
        let last = (end / hertz.half_width()).asinh();
        let sum: f64 = (0..n)
            .map(|i| last * (f64::from(i) + 0.5) / f64::from(n))
            .map(|t| {
                let depth = hertz.half_width() * t.sinh();
                let (stress, more) = (hertz.stress_on_axis(depth, 0.3), further(depth));
                let strain = stress.sigma_y + more.1 - 0.3 / 0.7 * (stress.sigma_x + more.0);
                -strain * hertz.half_width() * t.cosh() * last / f64::from(n)
            })
            .sum();
        sum * 0.91 / 210_000.0
    }

    #[test]
    fn layer_is_the_integral_of_the_strain() {
        let hertz = HertzLine::new(100.0, 10.0, 115_384.6);
        let formula =
            layer_approach(100.0, STEEL, 1000.0 * hertz.half_width(), hertz.half_width());
        assert!(
            (formula / shortening(&hertz, 1000.0 * hertz.half_width(), |_| (0.0, 0.0)) - 1.0)
                .abs()
                < 1e-6
        );
    }

    /// On a disc the opposite force adds `-2P/(π(2R - d))`, and a uniform `P/(πR)` frees the rim
    /// of stress.
    #[test]
    fn disc_is_the_integral_of_the_strain() {
        let (force, radius) = (1.0, 20.0);
        let hertz = HertzLine::new(force, 10.0, 115_384.6);
        let rim = force / (PI * radius);
        let integral =
            shortening(&hertz, radius, |d| (rim, rim - 2.0 * force / (PI * (2.0 * radius - d))));
        let formula = disc_approach(force, STEEL, radius, hertz.half_width());
        assert!((formula / integral - 1.0).abs() < 1e-6, "{formula} {integral}");
    }

    /// The paper's cylinders, elastic: α of both discs together.
    #[test]
    fn paper_cylinders() {
        let hertz = HertzLine::from_peak_pressure(1500.0, 10.0, 210_000.0 / 1.82);
        let approach = 2.0 * disc_approach(hertz.force(), STEEL, 20.0, hertz.half_width());
        assert!((approach - 0.017_67).abs() < 5e-6, "{approach}");
    }
}
