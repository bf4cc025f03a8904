//! The verdict of a track out of those of its bodies.

use std::cmp::Ordering;

use brinell_halfspace::track::Verdict;

use super::document::TrackVerdict;

/// Returns the worst verdict and the body that has it; elastic where none can yield, and no body
/// where plastic flow dies out in both.
pub(super) fn worst(verdicts: &[Option<Verdict>; 2]) -> (Option<usize>, Verdict) {
    match *verdicts {
        [None, None] => (None, Verdict::Elastic),
        [Some(upper), None] => (Some(0), upper),
        [None, Some(lower)] => (Some(1), lower),
        [Some(upper), Some(lower)] => match word(upper).cmp(&word(lower)) {
            Ordering::Greater => (Some(0), upper),
            Ordering::Less => (Some(1), lower),
            Ordering::Equal => match (rate(upper), rate(lower)) {
                (Some(one), Some(other)) if one > other => (Some(0), upper),
                (Some(_), Some(_)) => (Some(1), lower),
                _ => (None, lower),
            },
        },
    }
}

/// Returns the plastic strain of a steady pass, where there is any.
const fn rate(verdict: Verdict) -> Option<f64> {
    match verdict {
        Verdict::ClosedCycle { strain: rate, .. } | Verdict::Ratchets { rate, .. } => Some(rate),
        Verdict::Elastic | Verdict::ShakesDown { .. } | Verdict::Undecided { .. } => None,
    }
}

/// Returns the word of a verdict.
pub(super) const fn word(verdict: Verdict) -> TrackVerdict {
    match verdict {
        Verdict::Elastic => TrackVerdict::Elastic,
        Verdict::ShakesDown { .. } => TrackVerdict::ShakesDown,
        Verdict::ClosedCycle { .. } => TrackVerdict::ClosedCycle,
        Verdict::Undecided { .. } => TrackVerdict::Undecided,
        Verdict::Ratchets { .. } => TrackVerdict::Ratchets,
    }
}
