//! The verdict of a track out of those of its bodies.

use std::cmp::Ordering;

use brinell_halfspace::track::SteadyState;

use super::document::TrackVerdict;

/// Returns the worst verdict and the body that has it; elastic where none can yield, and no body
/// where plastic flow dies out in both.
pub(super) fn worst(verdicts: &[Option<SteadyState>; 2]) -> (Option<usize>, SteadyState) {
    match *verdicts {
        [None, None] => (None, SteadyState::Elastic),
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
const fn rate(verdict: SteadyState) -> Option<f64> {
    match verdict {
        SteadyState::ClosedCycle { strain: rate, .. } | SteadyState::Ratchets { rate, .. } => {
            Some(rate)
        }
        SteadyState::Elastic | SteadyState::ShakesDown { .. } | SteadyState::Undecided { .. } => {
            None
        }
    }
}

/// Returns the word of a verdict.
pub(super) const fn word(verdict: SteadyState) -> TrackVerdict {
    match verdict {
        SteadyState::Elastic => TrackVerdict::Elastic,
        SteadyState::ShakesDown { .. } => TrackVerdict::ShakesDown,
        SteadyState::ClosedCycle { .. } => TrackVerdict::ClosedCycle,
        SteadyState::Undecided { .. } => TrackVerdict::Undecided,
        SteadyState::Ratchets { .. } => TrackVerdict::Ratchets,
    }
}
