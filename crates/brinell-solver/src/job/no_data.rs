//! Heights that stand for no data. Instruments mark pixels without a signal by figures far from
//! all others: -9999, the least number of a type, a multiple of the range.

/// Gap over the range of the other heights beyond which heights are none: no instrument resolves
/// 10⁴ times the roughness it was set to.
const GAP: f64 = 1e4;
/// The same where the figure itself is one of [`MARKS`].
const GAP_OF_MARK: f64 = 10.0;
/// Figures that programs write for missing heights.
const MARKS: [f64; 8] =
    [-9999.0, 9999.0, -99_999.0, 99_999.0, -32_768.0, -32_767.0, 32_767.0, 65_535.0];
/// Fewest heights of one value that are a block; of more than 1600 heights it is a hundredth.
const BLOCK: usize = 16;
/// Most places that are named.
const NAMED: usize = 3;

/// Heights that stand for no data, or may.
#[derive(Debug, Clone, PartialEq)]
pub struct NoData {
    /// The first of these heights \[mm\].
    pub height: f64,
    /// Their number.
    pub count: usize,
    /// Number of all heights.
    pub of: usize,
    /// Range of the others \[mm\].
    pub range: f64,
    /// Indices `[i, j]` of the first ones.
    pub places: Vec<[usize; 2]>,
}

/// Finds heights far from all others. `mark` converts a figure of the wire to millimetres.
pub(super) fn far_off(
    heights: &[f64],
    columns: usize,
    mark: impl Fn(f64) -> f64,
) -> Option<NoData> {
    let mut sorted = heights.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let marks = MARKS.map(mark);
    let is_mark = |height: f64| marks.iter().any(|mark| mark.to_bits() == height.to_bits());
    let outside = |gap: f64| {
        let (low, high) = connected(&sorted, gap);
        move |height: f64| !(low..=high).contains(&height)
    };
    let is_marked = outside(GAP_OF_MARK);
    let marked = |height: f64| is_mark(height) && is_marked(height);
    let found = named(heights, columns, marked);
    if found.is_some() {
        return found;
    }
    // Of a plane with a few bumps no height is far off.
    let (low, high) = densest(&sorted);
    if low.to_bits() == high.to_bits() { None } else { named(heights, columns, outside(GAP)) }
}

/// Finds a block of heights of exactly one value among others that all differ.
pub(super) fn of_one_value(heights: &[f64], columns: usize) -> Option<NoData> {
    let mut sorted = heights.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let runs = || sorted.chunk_by(|a, b| a.to_bits() == b.to_bits());
    let longest = runs().max_by_key(|run| run.len())?;
    let least = BLOCK.max(heights.len() / 100);
    let rest = heights.len() - longest.len();
    let differ = runs().count() - 1;
    // Computed shapes have symmetries, and coarse steps repeat.
    if longest.len() < least || 2 * differ < rest || rest < least {
        return None;
    }
    let value = longest[0];
    named(heights, columns, |height| height.to_bits() == value.to_bits())
}

/// Returns the ends of the shortest interval that holds half of the heights.
fn densest(sorted: &[f64]) -> (f64, f64) {
    let half = sorted.len() / 2;
    let interval = |k: usize| (sorted[k], sorted[k + half]);
    (0..sorted.len() - half)
        .map(interval)
        .min_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))
        .unwrap_or((0.0, 0.0))
}

/// Returns the ends of the heights that no gap of `gap` times their range parts from the densest
/// half.
fn connected(sorted: &[f64], gap: f64) -> (f64, f64) {
    let (mut low, mut high) = densest(sorted);
    loop {
        let reach = gap * (high - low);
        let above = sorted.partition_point(|height| *height <= high);
        let below = sorted.partition_point(|height| *height < low);
        match (sorted.get(above), below.checked_sub(1).map(|k| sorted[k])) {
            (Some(next), _) if next - high <= reach => high = *next,
            (_, Some(next)) if low - next <= reach => low = next,
            _ => return (low, high),
        }
    }
}

fn named(heights: &[f64], columns: usize, is_none: impl Fn(f64) -> bool) -> Option<NoData> {
    let found: Vec<usize> = (0..heights.len()).filter(|k| is_none(heights[*k])).collect();
    let first = *found.first()?;
    let (low, high) = heights
        .iter()
        .filter(|height| !is_none(**height))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), h| (h.min(a), h.max(b)));
    Some(NoData {
        height: heights[first],
        count: found.len(),
        of: heights.len(),
        range: high - low,
        places: found.iter().take(NAMED).map(|k| [k / columns, k % columns]).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rough heights that all differ, `[16 * i + j]`.
    fn rough() -> Vec<f64> {
        (0..256).map(|k| 0.001 * (f64::from(k) * 0.7).sin() + 1e-6 * f64::from(k)).collect()
    }

    fn found(heights: &[f64]) -> Option<(f64, usize, Vec<[usize; 2]>)> {
        far_off(heights, 16, |mark| mark).map(|no| (no.height, no.count, no.places))
    }

    #[test]
    fn heights_far_from_all_others_are_named() {
        assert_eq!(found(&rough()), None);
        for (mark, share) in [(-9999.0, 12), (-32_768.0, 1), (55.5, 3), (-120.0, 100), (1e6, 1)] {
            let mut heights = rough();
            heights[20..20 + share].fill(mark);
            let (height, count, places) = found(&heights).unwrap();
            assert_eq!((height, count, places[0]), (mark, share, [1, 4]));
        }
        // Two marks, one on each side.
        let mut heights = rough();
        (heights[3], heights[250]) = (-500.0, 500.0);
        assert_eq!(found(&heights).unwrap().1, 2);
        // Heights in micrometres whose mark is not 10⁴ times the range.
        let mut heights: Vec<f64> = rough().iter().map(|h| 3000.0 * h).collect();
        heights[9] = -9999.0;
        assert_eq!(found(&heights).unwrap().1, 1);
    }

    #[test]
    fn shapes_are_heights() {
        let bump =
            |k: i32| (1.0 - f64::from((k % 16 - 8).pow(2) + (k / 16 - 8).pow(2)) / 20.0).max(0.0);
        let punch = |k: i32| if (k % 16 - 8).abs() < 4 { 0.0 } else { -1.0 };
        let rough = |k: i32| 0.001 * (f64::from(k) * 0.7).sin() + 1e-6 * f64::from(k);
        let worn = |k: i32| rough(k).min(0.0005);
        let scratch = |k: i32| rough(k) - if k % 16 == 5 { 0.5 } else { 0.0 };
        let linear = |k: i32| 1000.0 * f64::from(k);
        let shapes: [&dyn Fn(i32) -> f64; 5] = [&bump, &punch, &worn, &scratch, &linear];
        for (n, shape) in shapes.iter().enumerate() {
            assert_eq!(found(&(0..256).map(shape).collect::<Vec<_>>()), None, "{n}");
        }
        assert_eq!(found(&[0.5; 64]), None);
    }

    #[test]
    fn a_block_of_one_value_is_told() {
        let mut filled = rough();
        filled[40..60].fill(4e-4);
        let found = of_one_value(&filled, 16).unwrap();
        assert_eq!((found.count, found.of, found.places[0]), (20, 256, [2, 8]));
        assert_eq!(of_one_value(&rough(), 16), None);
        let steps: Vec<f64> = rough().iter().map(|h| (h * 2e4).round()).collect();
        assert_eq!(of_one_value(&steps, 16), None);
        assert_eq!(of_one_value(&[0.0; 256], 16), None);
    }
}
