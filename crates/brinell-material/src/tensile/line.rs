//! The first slope of a test.
//!
//! The rise ends where the record is furthest above the chord from its first to its last point.
//! Among all parts of the rise those are straight whose slope changes by no more than
//! [`CURVATURE`] from end to end, and whose scatter is that of the record. The longest of those
//! nearly as steep as the steepest is taken: a toe and what follows yield are less steep.

use super::noise;

/// Most intervals that the rise is averaged over.
const INTERVALS: usize = 150;
/// Change of the slope from end to end of a straight part, over the slope.
const CURVATURE: f64 = 0.02;
/// Scatter about the line over its range of stress that counts as none.
const SCATTER: f64 = 2e-3;
/// Range of stress of a straight part over that of the rise.
const SHORTEST: f64 = 0.15;
/// Stress where a straight part begins over that where it ends: what begins higher is hardening.
const FOOT: f64 = 0.5;
/// Standard error of a slope above which a part is too noisy to have one.
const NOISIEST: f64 = 0.03;
/// Slope over the steepest one above which a part belongs to the same line.
const STEEP: f64 = 0.95;

/// The line of the first slope.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    pub slope: f64,
    /// Standard error of the slope over the slope.
    pub slope_error: f64,
    /// Strain at which the line meets the axis.
    pub toe: f64,
    /// Standard deviation of the stress about the line.
    pub scatter: f64,
    pub straight: Option<[f64; 2]>,
    /// Number of points on it.
    pub points: usize,
    /// Number of points before its end.
    pub end: usize,
}

/// Returns the line of a given slope that touches the record from the left.
pub(super) fn of_modulus(points: &[[f64; 2]], slope: f64) -> Line {
    let toe = points
        .iter()
        .map(|[strain, stress]| strain - stress / slope)
        .fold(f64::INFINITY, f64::min);
    Line { slope, slope_error: 0.0, toe, scatter: 0.0, straight: None, points: 0, end: 0 }
}

/// Returns the line of the longest straight part of the rise; `None` if there is none.
pub(super) fn of_rise(points: &[[f64; 2]]) -> Option<Line> {
    let rise = &points[..=knee(points)?];
    if rise.len() == 2 {
        return through(rise);
    }
    let bins = averaged(rise);
    let scale = [span(&bins, 0), span(&bins, 1)];
    if scale.iter().any(|size| *size <= 0.0) {
        return None;
    }
    let noise = noise::of_points(&bins.iter().map(|bin| bin.mean).collect::<Vec<_>>());
    let sums = Sums::of(&bins, scale);
    let fewest = if bins.len() > 8 { 4 } else { 3 };
    let mut parts = Vec::new();
    for i in 0..bins.len() {
        for j in i + fewest..=bins.len() {
            let [from, to] = [i, j - 1].map(|k| bins[k].mean[1] - bins[0].mean[1]);
            let range = (to - from) / scale[1];
            if range >= SHORTEST
                && from <= FOOT * to
                && let Some(part) = sums.part(i, j, range, noise / scale[1])
            {
                parts.push(part);
            }
        }
    }
    let steepest = parts.iter().map(|part| part.slope).fold(0.0, f64::max);
    let is_steep = |part: &&Part| part.slope + 2.0 * part.error >= STEEP * steepest;
    let best = parts.iter().filter(is_steep).max_by(|a, b| a.range.total_cmp(&b.range))?;
    line_of(rise, &bins[best.from], &bins[best.to - 1])
}

/// Returns the index of the point furthest above the chord from the first to the highest point.
fn knee(points: &[[f64; 2]]) -> Option<usize> {
    let first = *points.first()?;
    let top = points.iter().copied().fold(first, |a, b| if b[1] > a[1] { b } else { a });
    let size = [top[0] - first[0], top[1] - first[1]];
    if !(size[0] > 0.0 && size[1] > 0.0) {
        return None;
    }
    let above = |p: &[f64; 2]| (p[1] - first[1]) / size[1] - (p[0] - first[0]) / size[0];
    let furthest = points.iter().enumerate().max_by(|a, b| above(a.1).total_cmp(&above(b.1)))?;
    // A record that never leaves its line has no knee.
    if above(furthest.1) < 1e-3 {
        Some(points.len() - 1)
    } else {
        Some(furthest.0).filter(|k| *k > 0)
    }
}

/// Returns the line through two points.
fn through(points: &[[f64; 2]]) -> Option<Line> {
    let [[x0, y0], [x1, y1]] = [points[0], points[1]];
    let slope = (y1 - y0) / (x1 - x0);
    (x1 > x0 && slope > 0.0).then(|| Line {
        slope,
        slope_error: 0.0,
        toe: x0 - y0 / slope,
        scatter: 0.0,
        straight: Some([y0, y1]),
        points: 2,
        end: 1,
    })
}

/// Least-squares line through the points of a part.
fn line_of(rise: &[[f64; 2]], first: &Bin, last: &Bin) -> Option<Line> {
    let part = &rise[first.from..last.to];
    let n = part.len() as f64;
    let mean = |axis: usize| part.iter().map(|point| point[axis]).sum::<f64>() / n;
    let (x, y) = (mean(0), mean(1));
    let (mut xx, mut xy) = (0.0, 0.0);
    for point in part {
        xx += (point[0] - x).powi(2);
        xy += (point[0] - x) * (point[1] - y);
    }
    let slope = xy / xx;
    if !(slope.is_finite() && slope > 0.0) {
        return None;
    }
    let residual: f64 =
        part.iter().map(|point| (point[1] - y - slope * (point[0] - x)).powi(2)).sum();
    let scatter = (residual / (n - 2.0).max(1.0)).sqrt();
    Some(Line {
        slope,
        slope_error: scatter / xx.sqrt() / slope,
        toe: x - y / slope,
        scatter,
        straight: Some([part[0][1], part[part.len() - 1][1]]),
        points: part.len(),
        end: last.to,
    })
}

/// Consecutive points and their mean.
struct Bin {
    from: usize,
    to: usize,
    mean: [f64; 2],
}

fn averaged(points: &[[f64; 2]]) -> Vec<Bin> {
    let n = points.len();
    let count = n.min(INTERVALS);
    let bin = |k: usize| {
        let (from, to) = (k * n / count, (k + 1) * n / count);
        let mean = |axis: usize| {
            points[from..to].iter().map(|point| point[axis]).sum::<f64>() / (to - from) as f64
        };
        Bin { from, to, mean: [mean(0), mean(1)] }
    };
    (0..count).map(bin).collect()
}

fn span(bins: &[Bin], axis: usize) -> f64 {
    let values = || bins.iter().map(|bin| bin.mean[axis]);
    values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
}

/// A straight part, in scaled figures.
struct Part {
    from: usize,
    to: usize,
    range: f64,
    slope: f64,
    error: f64,
}

/// Sums of `1, x, x², x³, x⁴, y, xy, x²y, y²` over the first bins, so that each part is fitted in
/// constant time.
struct Sums(Vec<[f64; 9]>);

impl Sums {
    fn of(bins: &[Bin], scale: [f64; 2]) -> Self {
        let mut sums = vec![[0.0; 9]];
        for bin in bins {
            let x = (bin.mean[0] - bins[0].mean[0]) / scale[0];
            let y = (bin.mean[1] - bins[0].mean[1]) / scale[1];
            let mut next = sums[sums.len() - 1];
            let terms = [1.0, x, x * x, x.powi(3), x.powi(4), y, x * y, x * x * y, y * y];
            for (sum, term) in next.iter_mut().zip(terms) {
                *sum += term;
            }
            sums.push(next);
        }
        Self(sums)
    }

    /// Fits line and parabola to the bins `from..to`; `None` if they are not straight.
    fn part(&self, from: usize, to: usize, range: f64, noise: f64) -> Option<Part> {
        let (low, high) = (self.0[from], self.0[to]);
        let mut s = [0.0; 9];
        for (sum, (a, b)) in s.iter_mut().zip(low.iter().zip(high)) {
            *sum = b - a;
        }
        let [n, x, x2, x3, x4, y, xy, x2y, y2] = s;
        // Central moments.
        let m = x / n;
        let v = x2 - n * m * m;
        let third = x3 - 3.0 * m * x2 + 3.0 * m * m * x - n * m.powi(3);
        let fourth = x4 - 4.0 * m * x3 + 6.0 * m * m * x2 - 4.0 * m.powi(3) * x + n * m.powi(4);
        let covariance = xy - m * y;
        let square = x2y - 2.0 * m * xy + m * m * y;
        if v <= 0.0 {
            return None;
        }
        let slope = covariance / v;
        let residual = (y2 - y * y / n - slope * covariance).max(0.0);
        // The parabola orthogonal to the line: p = x² - (third/v) x - v/n.
        let size = fourth - third * third / v - v * v / n;
        let bend = square - third / v * covariance - v / n * y;
        if size <= 0.0 || slope <= 0.0 {
            return None;
        }
        let curvature = bend / size;
        let left = (residual - curvature * bend).max(0.0) / (n - 3.0).max(1.0);
        let length = range / slope;
        let change = (2.0 * curvature * length / slope).abs();
        let uncertain = 2.0 * (2.0 * (left / size).sqrt() * length / slope);
        let scatter = (residual / (n - 2.0).max(1.0)).sqrt();
        let error = (residual / (n - 2.0).max(1.0) / v).sqrt();
        let is_straight = change <= CURVATURE + uncertain.min(4.0 * CURVATURE)
            && scatter <= (1.5 * noise).max(SCATTER * range)
            && error <= NOISIEST * slope;
        is_straight.then_some(Part { from, to, range, slope, error })
    }
}
