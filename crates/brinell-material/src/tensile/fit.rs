//! A curve that never falls through noisy points.
//!
//! The points are pooled until none falls (isotonic regression); corners of a polygon are chosen
//! on the pooled points so that it stays within the noise of them (Douglas and Peucker); its
//! stresses are then fitted to the points themselves.

use super::noise;

/// Distance of polygon and points, over the largest stress, that no use of a curve notices.
const FINE: f64 = 1e-3;
/// Most corners.
const MOST: usize = 200;

/// A fitted curve and its distance from the points.
pub(super) struct Fitted {
    pub points: Vec<[f64; 2]>,
    pub rms: f64,
    pub largest: f64,
}

/// Fits a curve that never falls to points `[plastic strain, stress]`. It starts at the plastic
/// strain `offset`, with the stress `first` or the lower one that the points behind have.
pub(super) fn monotone(first: f64, offset: f64, mut points: Vec<[f64; 2]>) -> Fitted {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let noise = noise::of_points(&points);
    points.insert(0, [offset, first]);
    let pooled = never_falling(&merged(&points));
    let largest = pooled.last().map_or(0.0, |point| point[1]);
    let mut tolerance = (2.0 * noise).max(FINE * largest);
    let mut corners = corners_within(&pooled, tolerance);
    while corners.len() > MOST {
        tolerance *= 1.5;
        corners = corners_within(&pooled, tolerance);
    }
    let stresses = fitted_to(&corners, &points);
    let weighted: Vec<([f64; 2], f64)> =
        corners.iter().zip(stresses).map(|(corner, stress)| ([corner[0], stress], 1.0)).collect();
    let curve = never_falling(&weighted);
    let distances = points.iter().map(|[p, stress]| (stress - at(&curve, *p)).abs());
    let (mut sum, mut worst) = (0.0, 0.0);
    for distance in distances {
        sum += distance * distance;
        worst = f64::max(worst, distance);
    }
    Fitted { rms: (sum / points.len() as f64).sqrt(), largest: worst, points: curve }
}

/// Merges points of the same plastic strain to their mean, with their number.
fn merged(points: &[[f64; 2]]) -> Vec<([f64; 2], f64)> {
    let mut merged: Vec<([f64; 2], f64)> = Vec::new();
    for &[p, stress] in points {
        match merged.last_mut() {
            Some((last, count)) if p - last[0] <= 1e-12 => {
                last[1] += (stress - last[1]) / (*count + 1.0);
                *count += 1.0;
            }
            _ => merged.push(([p, stress], 1.0)),
        }
    }
    merged
}

/// Isotonic regression: neighbours that fall are pooled to their weighted mean.
fn never_falling(points: &[([f64; 2], f64)]) -> Vec<[f64; 2]> {
    let mut pools: Vec<(f64, f64, usize)> = Vec::new();
    for (point, weight) in points {
        let mut pool = (point[1], *weight, 1);
        while let Some(before) = pools.last().filter(|before| before.0 > pool.0).copied() {
            pools.pop();
            let sum = before.1 + pool.1;
            pool = ((before.0 * before.1 + pool.0 * pool.1) / sum, sum, before.2 + pool.2);
        }
        pools.push(pool);
    }
    let stresses =
        pools.iter().flat_map(|(stress, _, count)| std::iter::repeat_n(*stress, *count));
    points.iter().zip(stresses).map(|((point, _), stress)| [point[0], stress]).collect()
}

/// Returns the corners of a polygon that stays within a distance in stress of the points.
fn corners_within(points: &[[f64; 2]], tolerance: f64) -> Vec<[f64; 2]> {
    let last = points.len() - 1;
    let mut is_corner = vec![false; points.len()];
    (is_corner[0], is_corner[last]) = (true, true);
    let mut parts = vec![(0, last)];
    while let Some((from, to)) = parts.pop() {
        let [a, b] = [points[from], points[to]];
        let distance = |k: usize| {
            let t = (points[k][0] - a[0]) / (b[0] - a[0]);
            (points[k][1] - a[1] - t * (b[1] - a[1])).abs()
        };
        let furthest = (from + 1..to).max_by(|i, j| distance(*i).total_cmp(&distance(*j)));
        if let Some(k) = furthest.filter(|k| distance(*k) > tolerance) {
            is_corner[k] = true;
            parts.extend([(from, k), (k, to)]);
        }
    }
    let kept = points.iter().zip(is_corner).filter(|(_, is_corner)| *is_corner);
    kept.map(|(point, _)| *point).collect()
}

/// Returns the stresses at the corners of the polygon that is nearest to the points in the sense
/// of least squares. Its normal matrix is tridiagonal.
fn fitted_to(corners: &[[f64; 2]], points: &[[f64; 2]]) -> Vec<f64> {
    let n = corners.len();
    if n == 1 {
        return vec![corners[0][1]];
    }
    // A little weight of the pooled stress keeps corners without points of their own.
    let (mut diagonal, mut off, mut right) = (vec![1e-9; n], vec![0.0; n], vec![0.0; n]);
    for (k, corner) in corners.iter().enumerate() {
        right[k] = 1e-9 * corner[1];
    }
    let mut k = 0;
    for &[p, stress] in points {
        while k + 2 < n && p > corners[k + 1][0] {
            k += 1;
        }
        let t = ((p - corners[k][0]) / (corners[k + 1][0] - corners[k][0])).clamp(0.0, 1.0);
        diagonal[k] += (1.0 - t) * (1.0 - t);
        diagonal[k + 1] += t * t;
        off[k] += t * (1.0 - t);
        right[k] += (1.0 - t) * stress;
        right[k + 1] += t * stress;
    }
    for k in 1..n {
        let factor = off[k - 1] / diagonal[k - 1];
        diagonal[k] -= factor * off[k - 1];
        right[k] -= factor * right[k - 1];
    }
    let mut stresses = vec![0.0; n];
    for k in (0..n).rev() {
        let next = if k + 1 < n { off[k] * stresses[k + 1] } else { 0.0 };
        stresses[k] = (right[k] - next) / diagonal[k];
    }
    stresses
}

/// Returns the stress of the polygon, constant beyond its ends.
fn at(curve: &[[f64; 2]], p: f64) -> f64 {
    let k = curve.partition_point(|corner| corner[0] < p);
    match (k.checked_sub(1).map(|k| curve[k]), curve.get(k)) {
        (Some(a), Some(b)) => a[1] + (b[1] - a[1]) * (p - a[0]) / (b[0] - a[0]),
        (None, Some(b)) => b[1],
        (Some(a), None) => a[1],
        (None, None) => 0.0,
    }
}
