//! Hardening curves from tensile and compression tests.
//!
//! A test gives strain and stress with the elastic part in them: `ε = ε_0 + σ/S + ε_p`. The toe
//! ε_0 and the first slope S are those of the longest straight part of the rise ([`line`]). What
//! is left is plastic strain, whether S is exactly Young's modulus or not: an extensometer is a
//! few per cent off, the way of a crosshead by a factor. Noise is fitted by a curve that never
//! falls (`fit`).
//!
//! Engineering figures e, s become true ones by `ε = ln(1 + e)`, `σ = s (1 + e)`, which holds as
//! long as the specimen stretches evenly. Points beyond its necking, where s falls for good, are
//! left out.

mod fit;
mod line;
mod noise;

use fit::Fitted;
use line::Line;

/// What strain and stress of a test are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Measure {
    /// Change of length over the first length, force over the first section.
    #[default]
    Engineering,
    /// Logarithmic strain, force over the section of the moment.
    True,
}

/// The place on the record that counts as yield.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum YieldRule {
    /// Where the record meets the line of the first slope moved by this strain: `1e-4` is R_p0.01,
    /// `2e-3` is R_p0.2.
    Offset(f64),
    /// Where the record leaves the line for good, by three times the scatter about it.
    Departure,
}

/// Meaning of the figures of a record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TestSettings {
    /// What strain and stress are.
    pub measure: Measure,
    /// What counts as yield.
    pub yield_rule: YieldRule,
    /// Young's modulus \[MPa\], which takes the place of a first slope where the record has none.
    pub young_modulus: Option<f64>,
}

/// A hardening curve from a test. Compression counts positive.
#[derive(Debug, Clone, PartialEq)]
pub struct TestCurve {
    /// Points `[plastic strain, true stress]`, the first at 0, stress never falling \[MPa\].
    pub points: Vec<[f64; 2]>,
    /// The line of the first slope.
    pub line: ElasticLine,
    /// Stress at the place that counts as yield, before the fit \[MPa\]. It exceeds the first
    /// point where the stress drops at yield.
    pub yield_stress: f64,
    /// Root of the mean square, and largest distance of the points used from the curve \[MPa\].
    pub fit_error: [f64; 2],
    /// Engineering strain and stress at which the specimen necks \[-, MPa\].
    pub necking: Option<[f64; 2]>,
    /// Whether the test is one in compression.
    pub is_compression: bool,
    /// What became of the points of the record.
    pub counts: PointCounts,
}

/// The line of the first slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticLine {
    /// Slope of true stress over true strain \[MPa\].
    pub slope: f64,
    /// Standard error of the slope over the slope; 0 of an exact record.
    pub slope_error: f64,
    /// Strain at which the line meets the axis, the toe that is removed.
    pub toe: f64,
    /// Stresses between which the record is straight; `None` where Young's modulus was taken.
    pub straight: Option<[f64; 2]>,
    /// Number of points on it.
    pub points: usize,
}

/// What became of the points of a record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PointCounts {
    /// Points of the record.
    pub all: usize,
    /// Points of unloading and reloading.
    pub set_back: usize,
    /// Points beyond necking.
    pub beyond_necking: usize,
    /// Points up to yield.
    pub elastic: usize,
    /// Points that the curve is fitted to.
    pub plastic: usize,
}

/// The reason why a record gives no curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TestFault {
    /// There are fewer points than [`LEAST_POINTS`].
    TooFewPoints,
    /// A figure is not finite.
    NotFinite(usize),
    /// An engineering strain of -1 or less.
    NoLengthLeft(usize),
    /// The largest stress and its strain have opposite signs.
    OppositeSigns(usize),
    /// A stress far above that of both neighbours, or next to nothing between them: a figure that
    /// stands for no data.
    Stray(usize),
    /// Strain or stress are zero throughout, or nothing rises.
    NoRise,
    /// No part of the rise is straight, and no Young's modulus is given.
    NoStraightPart,
    /// First slope \[MPa\] that differs from Young's modulus by such a power of ten as units do:
    /// the modulus over the slope is near `10^power`.
    Units {
        /// First slope \[MPa\].
        slope: f64,
        /// Decimal logarithm of the modulus over the slope, rounded.
        power: i32,
    },
    /// First slope \[MPa\] that no machine and no specimen of this Young's modulus has, or no solid.
    Slope(f64),
    /// The record ends before yield.
    NoYield {
        /// First slope \[MPa\].
        slope: f64,
        /// Largest true stress \[MPa\].
        largest: f64,
    },
}

/// Least number of points of a record.
pub const LEAST_POINTS: usize = 3;
/// Ratio of slope and power of ten within which units are at fault: extensometers are off by less,
/// and the way of a crosshead has no round ratio.
const NEAR: f64 = 1.25;
/// Strain below which a largest stress may be an upper yield point.
const EARLY: f64 = 0.03;
/// Fall of the stress over its largest value that counts as necking.
const FALL: f64 = 0.01;

/// Stress over that of its neighbours beyond which it is none: the largest stress of a test has
/// others near it.
const STRAY: f64 = 5.0;

/// Stress over that of both neighbours below which a recorder has dropped out, where the strain
/// goes on.
const DROPOUT: f64 = 0.02;
/// First slopes over Young's modulus: the give of a machine takes away most of it, and nothing
/// adds half of it.
const SLOPES: [f64; 2] = [0.02, 1.5];
/// Slope \[MPa\] that no solid has; diamond has 1.2e6.
const STIFFEST: f64 = 1.5e6;

/// A point of a record in all of its measures.
#[derive(Debug, Clone, Copy)]
struct Sample {
    engineering: [f64; 2],
    strain: f64,
    stress: f64,
}

/// Computes the hardening curve of a test from points `[strain, stress]` \[-, MPa\] in the order
/// of their recording. Compression is negative strain and stress.
///
/// Costs `O(n log n)` beside a fit of the first slope that does not grow with n.
///
/// # Errors
/// [`TestFault`].
pub fn hardening_curve(
    record: &[[f64; 2]],
    settings: TestSettings,
) -> Result<TestCurve, TestFault> {
    let (samples, is_compression) = oriented(record, settings.measure)?;
    let mut counts = PointCounts { all: record.len(), ..PointCounts::default() };
    let forward = going_forward(&samples);
    counts.set_back = samples.len() - forward.len();
    let necks = settings.measure == Measure::Engineering && !is_compression;
    let last = if necks { necking(&forward) } else { None };
    let used = &forward[..=last.unwrap_or(forward.len() - 1)];
    counts.beyond_necking = forward.len() - used.len();
    let line = first_line(used, settings.young_modulus)?;

    let slope = line.slope;
    let plastic_strain = |sample: &Sample| sample.strain - line.toe - sample.stress / slope;
    let offset = match settings.yield_rule {
        YieldRule::Offset(offset) => offset,
        YieldRule::Departure => 3.0 * line.scatter / slope,
    };
    // Yield is behind the straight part: a toe lies off the line as well.
    let elastic = used.iter().rposition(|sample| plastic_strain(sample) <= offset);
    let from = elastic.map_or(0, |k| k + 1).max(line.end.min(used.len() - 1));
    let largest = used.iter().map(|sample| sample.stress).fold(0.0, f64::max);
    if from + 1 >= used.len() && !used.last().is_some_and(|last| plastic_strain(last) > offset) {
        return Err(TestFault::NoYield { slope, largest });
    }
    let behind: Vec<[f64; 2]> =
        used[from..].iter().map(|s| [plastic_strain(s).max(offset), s.stress]).collect();
    counts.elastic = from;
    counts.plastic = behind.len();
    let yield_stress = crossing(used, from, offset, plastic_strain);
    let Fitted { mut points, rms, largest: worst } = fit::monotone(yield_stress, offset, behind);
    // Up to the offset the curve is flat, beyond it is that of the test.
    if points.len() == 1 || offset <= 0.0 {
        points[0][0] = 0.0;
    } else {
        points.insert(0, [0.0, points[0][1]]);
    }
    Ok(TestCurve {
        points,
        line: ElasticLine {
            slope,
            slope_error: line.slope_error,
            toe: line.toe,
            straight: line.straight,
            points: line.points,
        },
        yield_stress,
        fit_error: [rms, worst],
        necking: last.map(|k| forward[k].engineering),
        is_compression,
        counts,
    })
}

/// Returns the stress at which the plastic strain passes `offset` before the sample `from`.
fn crossing(
    used: &[Sample],
    from: usize,
    offset: f64,
    plastic_strain: impl Fn(&Sample) -> f64,
) -> f64 {
    let after = &used[from];
    let Some(before) = from.checked_sub(1).map(|k| &used[k]) else { return after.stress };
    let (p0, p1) = (plastic_strain(before), plastic_strain(after));
    if p1 <= p0 || p1 <= offset {
        return after.stress;
    }
    let share = ((offset - p0) / (p1 - p0)).clamp(0.0, 1.0);
    before.stress + share * (after.stress - before.stress)
}

/// Checks a record and brings it to true figures; compression becomes positive.
fn oriented(record: &[[f64; 2]], measure: Measure) -> Result<(Vec<Sample>, bool), TestFault> {
    if let Some(k) = record.iter().position(|point| !point.iter().all(|v| v.is_finite())) {
        return Err(TestFault::NotFinite(k));
    }
    if record.len() < LEAST_POINTS {
        return Err(TestFault::TooFewPoints);
    }
    let by_size =
        |a: &(usize, &[f64; 2]), b: &(usize, &[f64; 2])| a.1[1].abs().total_cmp(&b.1[1].abs());
    let (k, &[strain, stress]) =
        record.iter().enumerate().max_by(by_size).ok_or(TestFault::TooFewPoints)?;
    if stress == 0.0 || strain == 0.0 {
        return Err(TestFault::NoRise);
    }
    if strain.signum() * stress.signum() < 0.0 {
        return Err(TestFault::OppositeSigns(k));
    }
    let neighbours = [k.checked_sub(1), Some(k + 1)].into_iter().flatten();
    let beside = neighbours.filter_map(|k| record.get(k)).map(|point| point[1].abs());
    if record.len() > 3 && stress.abs() > STRAY * beside.fold(0.0, f64::max) {
        return Err(TestFault::Stray(k));
    }
    let drops = |w: &[[f64; 2]]| {
        let least = w[0][1].abs().min(w[2][1].abs());
        let goes_on = w[1][0].abs() > w[0][0].abs() && w[2][0].abs() > w[1][0].abs();
        goes_on && least > 0.1 * stress.abs() && w[1][1].abs() < DROPOUT * least
    };
    if let Some(k) = record.windows(3).position(drops) {
        return Err(TestFault::Stray(k + 1));
    }
    let sign = stress.signum();
    let sample = |(k, &[e, s]): (usize, &[f64; 2])| match measure {
        Measure::Engineering if e <= -1.0 => Err(TestFault::NoLengthLeft(k)),
        Measure::Engineering => Ok(Sample {
            engineering: [sign * e, sign * s],
            strain: sign * e.ln_1p(),
            stress: sign * s * (1.0 + e),
        }),
        Measure::True => Ok(Sample {
            engineering: [sign * e.exp_m1(), sign * s * (-e).exp()],
            strain: sign * e,
            stress: sign * s,
        }),
    };
    Ok((record.iter().enumerate().map(sample).collect::<Result<_, _>>()?, sign < 0.0))
}

/// Leaves out unloading and reloading: samples whose strain is below that of one before them, by
/// more than the noise of the strains.
fn going_forward(samples: &[Sample]) -> Vec<Sample> {
    let strains: Vec<f64> = samples.iter().map(|sample| sample.strain).collect();
    let tolerance = 4.0 * noise::of_series(&strains);
    let mut most = f64::NEG_INFINITY;
    let is_forward = |sample: &&Sample| {
        most = most.max(sample.strain);
        sample.strain >= most - tolerance
    };
    samples.iter().filter(is_forward).copied().collect()
}

/// Returns the last sample before the specimen necks: that of the largest force. A largest force
/// at an upper yield point is none.
fn necking(samples: &[Sample]) -> Option<usize> {
    let stress: Vec<f64> = samples.iter().map(|sample| sample.engineering[1]).collect();
    let width = (stress.len() / 100) | 1;
    let smooth = noise::moving_mean(&stress, width);
    let scatter = noise::of_series(&stress);
    let top = smooth.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let is_top = |value: &f64| *value >= top - 2.0 * scatter / (width as f64).sqrt();
    let falls = |from: f64, to: f64| from - to > (FALL * top).max(6.0 * scatter);
    let at = smooth.iter().rposition(is_top)?;
    let lowest = smooth[at..].iter().copied().fold(f64::INFINITY, f64::min);
    if !falls(top, lowest) {
        return None;
    }
    let drop = (at..smooth.len() - 1).find(|k| smooth[k + 1] >= smooth[*k]);
    let drop = drop.unwrap_or(smooth.len() - 1);
    let bottom = smooth[drop];
    let rises_again = smooth[drop..].iter().any(|value| falls(*value, bottom));
    let middle = smooth[usize::midpoint(drop, smooth.len() - 1)];
    let is_flat = falls(top, bottom) && bottom - middle < 0.2 * (top - bottom);
    if samples[at].strain > EARLY || !(rises_again || is_flat) {
        return Some(at);
    }
    // Behind an upper yield point the specimen necks where the stress falls to the very end.
    let (mut highest, mut begin) = (f64::NEG_INFINITY, smooth.len() - 1);
    for k in (drop..smooth.len()).rev() {
        if smooth[k] < highest - 2.0 * scatter {
            break;
        }
        if smooth[k] >= highest {
            (highest, begin) = (smooth[k], k);
        }
    }
    falls(highest, smooth[smooth.len() - 1]).then_some(begin)
}

/// Returns the line of the first slope, or that of Young's modulus where the rise has no straight
/// part.
fn first_line(samples: &[Sample], young_modulus: Option<f64>) -> Result<Line, TestFault> {
    let points: Vec<[f64; 2]> = samples.iter().map(|s| [s.strain, s.stress]).collect();
    let found = line::of_rise(&points);
    let Some(modulus) = young_modulus else {
        let found = found.ok_or(TestFault::NoStraightPart)?;
        return if found.slope > STIFFEST {
            Err(TestFault::Slope(found.slope))
        } else {
            Ok(found)
        };
    };
    let is_possible = |slope: f64| (SLOPES[0]..=SLOPES[1]).contains(&(slope / modulus));
    let Some(found) = found else {
        return match foot(&points) {
            Some(slope) if !is_possible(slope) => Err(TestFault::Slope(slope)),
            _ => Ok(line::of_modulus(&points, modulus)),
        };
    };
    let power = (modulus / found.slope).log10().round();
    let off = modulus / found.slope / 10f64.powf(power);
    // Records have their strain in per cent, parts per thousand or per million, or their stress
    // in another unit.
    if power.abs() > 1.5 && off < NEAR && off > NEAR.recip() {
        #[expect(clippy::cast_possible_truncation, reason = "a logarithm is small")]
        return Err(TestFault::Units { slope: found.slope, power: power as i32 });
    }
    // Two points are a straight line whatever they are of.
    if found.points == 2 && !(NEAR.recip()..NEAR).contains(&(found.slope / modulus)) {
        return Ok(line::of_modulus(&points, modulus));
    }
    if !is_possible(found.slope) {
        return Err(TestFault::Slope(found.slope));
    }
    Ok(found)
}

/// Returns the slope from the first point to a tenth of the largest stress, where a record that
/// begins without stress has several points on the way.
fn foot(points: &[[f64; 2]]) -> Option<f64> {
    let most = points.iter().map(|point| point[1]).fold(0.0, f64::max);
    let [strain, stress] = *points.first()?;
    let at = points.iter().position(|point| point[1] >= 0.1 * most)?;
    (at >= 4 && stress <= 0.02 * most && points[at][0] > strain)
        .then(|| (points[at][1] - stress) / (points[at][0] - strain))
}

#[cfg(test)]
mod tests;
