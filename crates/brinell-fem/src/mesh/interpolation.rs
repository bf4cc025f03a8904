//! Shape-preserving cubic interpolation.

/// A piecewise cubic through points that is smooth to the first derivative and never overshoots:
/// monotone data give a monotone curve, and a flat stays flat.
///
/// # Reference
/// F. N. Fritsch, R. E. Carlson, *Monotone piecewise cubic interpolation*, SIAM J. Numer. Anal. 17
/// (1980) 238–246; slopes by the weighted harmonic mean of F. N. Fritsch, J. Butland (1984).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MonotoneCubic {
    line: Polyline,
    slopes: Vec<f64>,
}

/// Straight lines from point to point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polyline {
    points: Vec<[f64; 2]>,
}

impl Polyline {
    /// Takes at least two points, x strictly rising.
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        Self { points }
    }

    /// The points.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Value at x; beyond the ends the outermost lines go on.
    pub fn value(&self, x: f64) -> f64 {
        let right = self.points.partition_point(|p| p[0] <= x).clamp(1, self.points.len() - 1);
        let ([x0, y0], [x1, y1]) = (self.points[right - 1], self.points[right]);
        y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    }

    /// First and last x.
    pub fn range(&self) -> (f64, f64) {
        (self.points[0][0], self.points[self.points.len() - 1][0])
    }

    /// Inner points `[x, slope to the left, slope to the right]`.
    pub fn bends(&self) -> impl Iterator<Item = [f64; 3]> {
        let slope = |p: &[f64; 2], q: &[f64; 2]| (q[1] - p[1]) / (q[0] - p[0]);
        self.points.windows(3).map(move |p| [p[1][0], slope(&p[0], &p[1]), slope(&p[1], &p[2])])
    }

    /// Whether the curve equals its mirror image in x = 0.
    #[expect(clippy::float_cmp, reason = "a face is symmetric if its points are, to the last bit")]
    pub fn is_even(&self) -> bool {
        self.points
            .iter()
            .zip(self.points.iter().rev())
            .all(|(p, q)| p[0] == -q[0] && p[1] == q[1])
    }
}

impl MonotoneCubic {
    /// Takes at least two points, x strictly rising.
    pub fn new(points: Vec<[f64; 2]>) -> Self {
        let secants: Vec<[f64; 2]> = points
            .windows(2)
            .map(|p| [p[1][0] - p[0][0], (p[1][1] - p[0][1]) / (p[1][0] - p[0][0])])
            .collect();
        let last = points.len() - 1;
        let slopes = (0..=last)
            .map(|k| match (k.checked_sub(1).and_then(|j| secants.get(j)), secants.get(k)) {
                (Some(left), Some(right)) => inner_slope(*left, *right),
                (None, Some(near)) => end_slope(*near, secants.get(1)),
                (Some(near), None) => {
                    end_slope(*near, last.checked_sub(2).and_then(|j| secants.get(j)))
                }
                (None, None) => 0.0,
            })
            .collect();
        Self { line: Polyline::new(points), slopes }
    }

    /// Value at x; beyond the ends the curve goes on straight.
    pub fn value(&self, x: f64) -> f64 {
        let points = self.line.points();
        let last = points.len() - 1;
        let (first_point, last_point) = (points[0], points[last]);
        if x <= first_point[0] {
            return first_point[1] + self.slopes[0] * (x - first_point[0]);
        }
        if x >= last_point[0] {
            return last_point[1] + self.slopes[last] * (x - last_point[0]);
        }
        let right = points.partition_point(|p| p[0] <= x);
        let left = right - 1;
        let ([x0, y0], [x1, y1]) = (points[left], points[right]);
        let h = x1 - x0;
        let t = (x - x0) / h;
        let (m0, m1) = (h * self.slopes[left], h * self.slopes[right]);
        let s = 1.0 - t;
        y0 * s * s * (1.0 + 2.0 * t) + y1 * t * t * (3.0 - 2.0 * t) + m0 * t * s * s
            - m1 * t * t * s
    }

    /// The straight lines through the same points.
    pub fn line(&self) -> &Polyline {
        &self.line
    }
}

/// Slope between two intervals `[h, secant]`: zero at an extremum, else the weighted harmonic
/// mean.
fn inner_slope([h0, s0]: [f64; 2], [h1, s1]: [f64; 2]) -> f64 {
    if s0 * s1 <= 0.0 {
        return 0.0;
    }
    let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
    (w0 + w1) / (w0 / s0 + w1 / s1)
}

/// Slope at an end: of the parabola through the three nearest points, limited so that nothing
/// overshoots.
fn end_slope([h0, s0]: [f64; 2], next: Option<&[f64; 2]>) -> f64 {
    let Some([h1, s1]) = next else { return s0 };
    let slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
    if slope * s0 <= 0.0 {
        0.0
    } else if s0 * s1 <= 0.0 && slope.abs() > 3.0 * s0.abs() {
        3.0 * s0
    } else {
        slope
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn passes_through_its_points_and_keeps_a_flat_flat() {
        let points = vec![[-2.0, -0.5], [-1.0, 0.0], [1.0, 0.0], [3.0, -2.0]];
        let curve = MonotoneCubic::new(points.clone());
        for [x, y] in points {
            assert!((curve.value(x) - y).abs() < 1e-15);
        }
        for k in 0..=20 {
            assert!(curve.value(-1.0 + 0.1 * f64::from(k)).abs() < 1e-15);
        }
        assert!(!curve.line().is_even());
    }

    #[test]
    fn a_finely_sampled_parabola_is_close() {
        let points = (-20..=20).map(|k| f64::from(k) * 0.1).map(|x| [x, -0.5 * x * x]).collect();
        let curve = MonotoneCubic::new(points);
        assert!(curve.line().is_even());
        for k in -40..=40 {
            let x = 0.05 * f64::from(k);
            assert!((curve.value(x) + 0.5 * x * x).abs() < 1e-3);
        }
    }

    proptest! {
        #[test]
        fn never_overshoots(
            heights in prop::collection::vec(-1.0..1.0f64, 2..12), t in 0.0..1.0f64
        ) {
            let points: Vec<[f64; 2]> =
                (0u32..).zip(&heights).map(|(k, y)| [f64::from(k), *y]).collect();
            let curve = MonotoneCubic::new(points.clone());
            for pair in points.windows(2) {
                let y = curve.value(pair[0][0] + t);
                let (low, high) = (pair[0][1].min(pair[1][1]), pair[0][1].max(pair[1][1]));
                prop_assert!(y >= low - 1e-12 && y <= high + 1e-12);
            }
        }
    }
}
