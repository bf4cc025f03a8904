//! The parabola of least squares.

/// The parabola of least squares through points, at x = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parabola {
    /// Its value.
    pub value: f64,
    /// Its slope.
    pub slope: f64,
    /// Standard error of the value.
    pub error: f64,
    /// Standard deviation of the points from it.
    pub deviation: f64,
}

impl Parabola {
    /// Takes more than three points `[x, y]`.
    pub fn through(points: &[[f64; 2]]) -> Self {
        let at = |of: &[f64; 3], x: f64| (of[2] * x + of[1]) * x + of[0];
        let dot = |a: &[f64; 3], b: &[f64; 3]| -> f64 {
            points.iter().map(|[x, _]| at(a, *x) * at(b, *x)).sum()
        };
        // Polynomials that are orthonormal on these points.
        let (mut fit, mut spread) = ([0.0; 3], 0.0);
        let mut basis: Vec<[f64; 3]> = Vec::new();
        for degree in 0..3 {
            let mut next = [0.0; 3];
            next[degree] = 1.0;
            for known in &basis {
                let part = dot(&next, known);
                next = std::array::from_fn(|k| next[k] - part * known[k]);
            }
            let size = dot(&next, &next).sqrt().max(f64::MIN_POSITIVE);
            let next = next.map(|coefficient| coefficient / size);
            let part: f64 = points.iter().map(|[x, y]| y * at(&next, *x)).sum();
            fit = std::array::from_fn(|k| fit[k] + part * next[k]);
            spread += next[0] * next[0];
            basis.push(next);
        }
        let off: f64 = points.iter().map(|[x, y]| (y - at(&fit, *x)).powi(2)).sum();
        let deviation = (off / (points.len() as f64 - 3.0)).sqrt();
        let [value, slope, _] = fit;
        Self { value, slope, error: deviation * f64::sqrt(spread), deviation }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_found_and_what_scatters_about_it() {
        let of = |x: f64| 3.0 + 2.0 * x - 0.5 * x * x;
        let points: Vec<_> = (-3..=4).map(|k| [f64::from(k), of(f64::from(k))]).collect();
        let exact = Parabola::through(&points);
        assert!((exact.value - 3.0).abs().max((exact.slope - 2.0).abs()) < 1e-12, "{exact:?}");
        assert!(exact.deviation < 1e-12);
        let scattered: Vec<_> = points
            .iter()
            .enumerate()
            .map(|(k, [x, y])| [*x, y + if k % 2 == 0 { 0.1 } else { -0.1 }])
            .collect();
        let found = Parabola::through(&scattered);
        assert!((0.1..0.14).contains(&found.deviation) && found.error < found.deviation);
        assert!((found.value - 3.0).abs() < 2.0 * found.error, "{found:?}");
    }
}
