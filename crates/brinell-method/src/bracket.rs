//! The bracket of the wanted force, between forces that are too small and too large.

/// Largest change of a force from one trial to the next, as a logarithm.
const LARGEST_STEP: f64 = 2.0;
/// Change of the logarithm of the force while the figure is zero; the number of zeros after which
/// the change grows; the factor of this growth.
const STEP_FROM_NOTHING: f64 = 0.7;
const PATIENCE: usize = 3;
const IMPATIENCE: f64 = 1.5;
/// Least part of a bracket that an interpolated force keeps from its ends.
const MARGIN: f64 = 0.1;
/// Range of the forces that are tried \[N/mm or N\].
const FORCES: (f64, f64) = (1e-9, 1e9);
/// Width of a bracket, as a logarithm, within which the figure jumps, because the contact gains or
/// loses a node; distance from the smallest force that could not be solved at which the search ends.
const CLOSED: f64 = 0.01;
/// Largest distance of trials from a force, as a logarithm, in the fit of the slope there; the
/// second constant is their least spread.
const SLOPE_RANGE: f64 = 0.7;
const SLOPE_SPREAD: f64 = 0.08;
/// Least slope that a force is extrapolated with.
const LEAST_SLOPE: f64 = 0.05;

/// All trials, as logarithms of the force and of the figure over its wanted value; minus infinity
/// where the figure is zero.
#[derive(Debug, Clone)]
pub struct Bracket {
    /// Last trials with too small and with too large a figure.
    below: Option<[f64; 2]>,
    above: Option<[f64; 2]>,
    /// The smallest force that could not be solved.
    limit: Option<f64>,
    /// All trials with a figure above zero.
    trials: Vec<[f64; 2]>,
    /// Number of trials with a figure of zero.
    zeros: usize,
    /// Expected slope of the logarithms.
    expected_slope: f64,
}

/// The next move of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Next {
    /// Try this force.
    Force(f64),
    /// The figure is too small up to the largest force that can be solved.
    AtLimit,
    /// The figure is too large down to the smallest force.
    NoSmaller,
}

impl Bracket {
    /// Makes a bracket without trials; `expected_slope` is the expected `d ln figure / d ln
    /// force`.
    pub fn new(expected_slope: f64) -> Self {
        Self {
            below: None,
            above: None,
            limit: None,
            trials: Vec::new(),
            zeros: 0,
            expected_slope,
        }
    }

    /// Returns the slope of the logarithms at a force, by the straight line of least squares
    /// through the trials around it; `None` where these are too few or too close together.
    pub fn slope_at(&self, force: f64) -> Option<f64> {
        let near = || self.trials.iter().filter(|[x, _]| (x - force.ln()).abs() <= SLOPE_RANGE);
        let count = near().count() as f64;
        let [x, y] = [0, 1].map(|k| near().map(|at| at[k]).sum::<f64>() / count);
        let (lowest, highest) = near()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
                (low.min(at[0]), high.max(at[0]))
            });
        let spread: f64 = near().map(|at| (at[0] - x).powi(2)).sum();
        let slope = near().map(|at| (at[0] - x) * (at[1] - y)).sum::<f64>() / spread;
        (highest - lowest >= SLOPE_SPREAD).then_some(slope)
    }

    /// Returns the smaller of two nearly equal forces between which the figure jumps over its
    /// wanted value.
    pub fn jump(&self) -> Option<f64> {
        let (Some([low, _]), Some([high, _])) = (self.below, self.above) else { return None };
        (high - low <= CLOSED).then(|| low.exp())
    }

    /// Returns the largest figure over its wanted value, with its force; if all figures are zero,
    /// the largest force.
    pub fn largest(&self) -> Option<(f64, f64)> {
        let largest = self.trials.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1]));
        largest.or(self.below).map(|[force, ratio]| (force.exp(), ratio.exp()))
    }

    /// The largest force that was solved.
    pub fn largest_force(&self) -> Option<f64> {
        self.trials.iter().map(|[force, _]| force.exp()).reduce(f64::max)
    }

    /// Records a force that was solved; `ratio` is the figure over its wanted value.
    pub fn record(&mut self, force: f64, ratio: f64) {
        let at = [force.ln(), if ratio > 0.0 { ratio.ln() } else { f64::NEG_INFINITY }];
        if at[1].is_finite() {
            self.trials.push(at);
        } else {
            self.zeros += 1;
        }
        if at[1] >= 0.0 {
            self.above = Some(at);
            // A figure may fall again under larger forces, or scatter: the answer is the smallest
            // force.
            self.below = self.below.filter(|below| below[0] < at[0]);
        } else if self.above.is_none_or(|above| at[0] < above[0]) {
            self.below = Some(at);
        }
    }

    /// Records a force that is too large to be solved. Returns whether it is the smallest one so
    /// far.
    pub fn limit(&mut self, force: f64) -> bool {
        let is_smallest = self.limit.is_none_or(|limit| force.ln() <= limit);
        if is_smallest {
            self.limit = Some(force.ln());
        }
        is_smallest
    }

    /// Returns the next move.
    pub fn next(&self) -> Next {
        let slope = match self.trials[..] {
            [.., [x1, y1], [x2, y2]] if (x2 - x1).abs() >= SLOPE_SPREAD => (y2 - y1) / (x2 - x1),
            _ => self.expected_slope,
        };
        let slope = slope.max(LEAST_SLOPE);
        let next = match (self.below, self.above) {
            (Some([low, y_low]), Some([high, y_high])) => {
                let part = if y_low.is_finite() {
                    -y_low / (y_high - y_low)
                } else {
                    1.0 - y_high / (slope * (high - low))
                };
                low + (high - low) * part.clamp(MARGIN, 1.0 - MARGIN)
            }
            (Some([low, y]), None) => {
                let growth = IMPATIENCE.powf(self.zeros.saturating_sub(PATIENCE) as f64);
                let step = if y.is_finite() { -y / slope } else { STEP_FROM_NOTHING * growth };
                let step = step.min(LARGEST_STEP);
                match self.limit {
                    Some(limit) if limit - low < CLOSED => return Next::AtLimit,
                    Some(limit) => (low + step).min(f64::midpoint(low, limit)),
                    None => low + step,
                }
            }
            (None, Some([high, y])) => high - (y / slope).min(LARGEST_STEP),
            (None, None) => self.limit.map_or(0.0, |limit| limit - LARGEST_STEP),
        };
        let force = next.exp();
        if force < FORCES.0 {
            Next::NoSmaller
        } else if force > FORCES.1 {
            Next::AtLimit
        } else {
            Next::Force(force)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Searches a figure that is zero up to a force of 2 and fails above a limit. Returns the last
    /// move and the number of trials.
    fn search(mut force: f64, wanted: f64, limit: f64) -> (Next, usize) {
        let mut bracket = Bracket::new(1.0);
        for trial in 1..60 {
            if force > limit {
                bracket.limit(force);
            } else {
                let ratio = (force - 2.0_f64).max(0.0).powi(2) / wanted;
                bracket.record(force, ratio);
                if (ratio - 1.0).abs() < 0.01 {
                    return (Next::Force(force), trial);
                }
            }
            match bracket.next() {
                Next::Force(next) => force = next,
                end => return (end, trial),
            }
        }
        panic!("no end");
    }

    #[test]
    fn finds_a_force_from_either_side() {
        for start in [0.01, 1.0, 5.0, 100.0, 1e6] {
            let (end, trials) = search(start, 9.0, 1e7);
            assert!(
                matches!(end, Next::Force(force) if (force - 5.0).abs() < 0.05),
                "{start}: {end:?}"
            );
            assert!(trials <= 25, "{start}: {trials}");
        }
    }

    /// The search starts nine orders of magnitude below the first force with a figure.
    #[test]
    fn finds_a_force_from_next_to_nothing() {
        let (end, trials) = search(2e-9, 9.0, 1e7);
        assert!(matches!(end, Next::Force(force) if (force - 5.0).abs() < 0.05), "{end:?}");
        assert!(trials <= 25, "{trials}");
    }

    #[test]
    fn stops_at_the_largest_force_that_can_be_solved() {
        for start in [0.01, 1.0, 3.9, 100.0] {
            let (end, trials) = search(start, 9.0, 4.0);
            assert_eq!(end, Next::AtLimit);
            assert!(trials <= 25, "{start}: {trials}");
        }
    }

    #[test]
    fn the_smallest_limit_counts() {
        let mut bracket = Bracket::new(1.0);
        assert!(bracket.limit(5.0) && !bracket.limit(7.0) && bracket.limit(4.0));
    }

    #[test]
    fn stops_at_the_smallest_force() {
        let mut bracket = Bracket::new(0.5);
        let mut force = 1.0;
        loop {
            bracket.record(force, 7.0);
            match bracket.next() {
                Next::Force(next) => force = next,
                end => return assert_eq!(end, Next::NoSmaller),
            }
        }
    }
}
