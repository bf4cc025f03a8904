//! Noise of a series, from its second differences.
//!
//! Of values with independent noise of variance σ² the second differences
//! `d_k = v_k - (v_(k-1) + v_(k+1))/2` have the covariance -σ² with their neighbours; those of a
//! smooth curve have a positive one, so that curvature is not taken for noise.

/// Part of the products left out: those at corners and at single stray values.
const STRAY: usize = 50;

/// Returns the standard deviation of the noise of a series.
pub(super) fn of_series(values: &[f64]) -> f64 {
    of_differences(&values.windows(3).map(|v| v[1] - 0.5 * (v[0] + v[2])).collect::<Vec<_>>())
}

/// Returns the noise of ordinates over abscissas that do not fall: distances from the line through
/// both neighbours, in the scale of second differences.
pub(super) fn of_points(points: &[[f64; 2]]) -> f64 {
    let distance = |p: &[[f64; 2]]| {
        let width = p[2][0] - p[0][0];
        let t = if width > 0.0 { ((p[1][0] - p[0][0]) / width).clamp(0.0, 1.0) } else { 0.5 };
        let weight = (1.0 + t * t + (1.0 - t) * (1.0 - t)).sqrt();
        (p[1][1] - (1.0 - t) * p[0][1] - t * p[2][1]) * 1.5f64.sqrt() / weight
    };
    of_differences(&points.windows(3).map(distance).collect::<Vec<_>>())
}

fn of_differences(differences: &[f64]) -> f64 {
    let mut products: Vec<f64> = differences.windows(2).map(|d| -d[0] * d[1]).collect();
    products.sort_unstable_by(|a, b| a.abs().total_cmp(&b.abs()));
    products.truncate(products.len() - products.len().div_ceil(STRAY));
    if products.is_empty() {
        return 0.0;
    }
    (products.iter().sum::<f64>() / products.len() as f64).max(0.0).sqrt()
}

/// Returns the means over `width` values about each, fewer at the ends.
pub(super) fn moving_mean(values: &[f64], width: usize) -> Vec<f64> {
    let half = width / 2;
    let mut sums = vec![0.0];
    for value in values {
        sums.push(sums[sums.len() - 1] + value);
    }
    let mean = |k: usize| {
        let reach = half.min(k).min(values.len() - 1 - k);
        if reach == 0 {
            return values[k];
        }
        (sums[k + reach + 1] - sums[k - reach]) / (2 * reach + 1) as f64
    };
    (0..values.len()).map(mean).collect()
}
