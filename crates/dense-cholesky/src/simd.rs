//! Plain loops, compiled for the vector units of the machine they run on.

/// Runs `work` compiled once for each level of vector instructions that is worth it, and picks the
/// best one that the processor has. Functions it calls take part only if they are inlined.
///
/// Results do not depend on the level: the compiler neither reorders nor fuses floating-point
/// operations.
#[inline(always)]
pub fn simd_dispatch<T>(work: impl FnOnce() -> T) -> T {
    pulp::Arch::new().dispatch(work)
}

/// Scalar product with eight running sums, so that it vectorizes; the order of summation is fixed.
#[inline(always)]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let mut tail = 0.0;
    for (x, y) in a8.remainder().iter().zip(b8.remainder()) {
        tail += x * y;
    }
    for (x, y) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += x[k] * y[k];
        }
    }
    ((sums[0] + sums[4]) + (sums[1] + sums[5]))
        + ((sums[2] + sums[6]) + (sums[3] + sums[7]))
        + tail
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_over_whole_and_broken_chunks() {
        for n in [0, 1, 7, 8, 9, 40, 43] {
            let a: Vec<f64> = (0..n).map(f64::from).collect();
            let expected: f64 = a.iter().map(|x| x * x).sum();
            assert!((simd_dispatch(|| dot(&a, &a)) - expected).abs() < 1e-12 * expected.max(1.0));
        }
    }
}
