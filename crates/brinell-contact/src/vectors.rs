//! Sums over vectors, compiled with several partial sums.

/// Partial sums of a reduction.
const LANES: usize = 8;

/// `Σ term(k)` over `0..n`.
#[inline(always)]
pub(crate) fn sum(n: usize, term: impl Fn(usize) -> f64) -> f64 {
    let mut partial = [0.0; LANES];
    let whole = n / LANES * LANES;
    for start in (0..whole).step_by(LANES) {
        for (lane, s) in partial.iter_mut().enumerate() {
            *s += term(start + lane);
        }
    }
    let rest: f64 = (whole..n).map(&term).sum();
    partial.iter().sum::<f64>() + rest
}

/// `aᵀb`.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let n = a.len().min(b.len());
    let (a, b) = (&a[..n], &b[..n]);
    sum(n, |k| a[k] * b[k])
}

/// `Σ a`.
pub(crate) fn total(a: &[f64]) -> f64 {
    sum(a.len(), |k| a[k])
}

/// `y += factor x`.
pub(crate) fn add_scaled(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}

/// `max |a|`.
pub(crate) fn largest(a: &[f64]) -> f64 {
    a.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}
