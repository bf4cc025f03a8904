//! First contact of two surfaces: the smallest gap between them.

/// Even samples beside the knots.
const SAMPLES: u32 = 4000;
/// Steps of the golden section, each of which leaves 0.618 of the interval.
const REFINEMENTS: u32 = 80;
/// Gaps that differ by less, relative to the span, are equal.
const EQUAL: f64 = 1e-12;

/// The place and the size of the smallest gap over `[left, right]` \[mm\]; where it is reached
/// again and again, the place nearest to the origin.
///
/// The gap is evaluated at every knot and at even samples. Where it might become smaller between
/// two of these, a golden section finds the minimum, so that the answer does not depend on where
/// samples fall. `knots` are ascending.
pub(crate) fn smallest_gap(
    gap: impl Fn(f64) -> f64,
    left: f64,
    right: f64,
    knots: &[f64],
) -> (f64, f64) {
    let even = (0..=SAMPLES).map(|k| left + (right - left) * f64::from(k) / f64::from(SAMPLES));
    let inside = knots.iter().copied().chain([0.0]).filter(|x| (left..=right).contains(x));
    let mut places: Vec<f64> = even.chain(inside).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let found: Vec<(f64, f64)> = places.iter().map(|&x| (x, gap(x))).collect();
    let tolerance = EQUAL * (right - left);
    let better = |best: (f64, f64), other: (f64, f64)| {
        let is_same = (other.1 - best.1).abs() <= tolerance;
        let is_better = if is_same { other.0.abs() < best.0.abs() } else { other.1 < best.1 };
        if is_better { other } else { best }
    };
    let Some(best) = found.iter().copied().reduce(better) else { return (0.0, gap(0.0)) };
    found.windows(3).fold(best, |best, three| {
        let [before, here, after] = [three[0], three[1], three[2]];
        let is_minimum = here.1 <= before.1 && here.1 <= after.1;
        // A smooth gap falls between two samples by no more than it has risen to the next ones.
        let rise = (before.1 - here.1).max(after.1 - here.1);
        if is_minimum && here.1 - rise < best.1 {
            better(best, refine(&gap, before.0, here, after.0))
        } else {
            best
        }
    })
}

/// The smallest value between `left` and `right`, by golden section, or the one that is `known` in
/// between.
fn refine(gap: impl Fn(f64) -> f64, left: f64, known: (f64, f64), right: f64) -> (f64, f64) {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (left, right);
    let (mut a, mut b) = (high - golden * (high - low), low + golden * (high - low));
    let (mut gap_a, mut gap_b) = (gap(a), gap(b));
    for _ in 0..REFINEMENTS {
        if gap_a < gap_b {
            (high, b, gap_b) = (b, a, gap_a);
            a = high - golden * (high - low);
            gap_a = gap(a);
        } else {
            (low, a, gap_a) = (a, b, gap_b);
            b = low + golden * (high - low);
            gap_b = gap(b);
        }
    }
    let middle = 0.5 * (low + high);
    let smallest = gap(middle);
    if smallest < known.1 { (middle, smallest) } else { known }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A spike far narrower than the samples is found by its knots.
    #[test]
    fn a_spike_between_samples_is_found() {
        let (at, width) = (3.001_23, 1e-5);
        let gap = |x: f64| 1e-3 * x * x - 0.02 * (1.0 - (x - at).abs() / width).max(0.0);
        let knots = [at - width, at, at + width];
        let (x, smallest) = smallest_gap(gap, -10.0, 10.0, &knots);
        assert!((x - at).abs() < 1e-12 && (smallest - gap(at)).abs() < 1e-15);
    }

    /// The minimum of a smooth gap is found to rounding, wherever samples fall.
    #[test]
    fn the_minimum_does_not_depend_on_the_samples() {
        for at in [0.0, 0.123, 1.000_7, -2.345_678] {
            let gap = |x: f64| 5.0 * (x - at) * (x - at) + 0.25;
            let (x, smallest) = smallest_gap(gap, -3.0, 4.0, &[]);
            assert!((x - at).abs() < 1e-7 && (smallest - 0.25).abs() < 1e-14, "{x} for {at}");
        }
    }

    #[test]
    fn of_equal_gaps_the_nearest_to_the_origin_counts() {
        let (x, smallest) = smallest_gap(|x: f64| (x.abs() - 1.0).max(0.0), -5.0, 5.0, &[]);
        assert!(x == 0.0 && smallest == 0.0);
    }
}
