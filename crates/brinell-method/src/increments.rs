//! The division of a load of a history into increments.

use brinell_contact::ContactLoad;

/// Growth of the contact in one increment of the coarsest division, over its final size.
const GROWTH: f64 = 0.12;
/// Assumed onset of plastic flow over the load, where the onset is unknown.
const UNKNOWN_ONSET: f64 = 0.05;

/// The division of every load of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Division {
    /// A number of equal increments for each load.
    Fixed(u32),
    /// Increments of equal growth of the contact. Each level halves this growth.
    Level(u32),
}

impl Division {
    /// Returns the division with increments half as large, for comparison.
    #[must_use]
    pub fn finer(self) -> Self {
        match self {
            Self::Fixed(n) => Self::Fixed(2 * n),
            Self::Level(level) => Self::Level(level + 1),
        }
    }
}

/// The last increment of a load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LastIncrement {
    /// Its start over the larger load of the two ends of the leg.
    pub from: f64,
    /// Its size over the same load.
    pub size: f64,
    /// Whether an earlier increment has not converged.
    pub inherits_error: bool,
}

/// The growth of a contact with its load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Load measure at the onset of plastic flow under first loading, if known.
    pub onset: Option<f64>,
    /// Exponent n of the growth `measure ∝ half-widthⁿ`.
    pub exponent: f64,
}

/// One load of a history, in its own measure: force or approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Whether the measure is the force.
    pub is_force: bool,
    /// The measure where the leg begins.
    pub from: f64,
    /// The measure where it ends.
    pub to: f64,
    /// Largest measure that the history has reached so far.
    pub reached: f64,
    /// How the contact grows on the way.
    pub growth: Growth,
}

impl Leg {
    /// Whether it unloads.
    pub fn falls(&self) -> bool {
        self.to < self.from
    }

    /// The increment from one measure to another, as parts of the larger end of the leg.
    pub fn increment(&self, from: f64, to: f64, inherits_error: bool) -> LastIncrement {
        let whole = self.from.max(self.to).max(f64::MIN_POSITIVE);
        LastIncrement { from: from / whole, size: (to - from).abs() / whole, inherits_error }
    }

    /// Returns the part of the leg that is applied at a measure.
    pub fn part(&self, measure: f64) -> f64 {
        let range = self.to - self.from;
        if range.abs() > 0.0 { (measure - self.from) / range } else { 1.0 }
    }

    /// Returns a measure as a load.
    pub fn load(&self, measure: f64) -> ContactLoad {
        if self.is_force { ContactLoad::Force(measure) } else { ContactLoad::Approach(measure) }
    }

    /// Returns the measures at the ends of the increments; the last one is the end of the leg.
    ///
    /// Unloading is one increment. Loading up to the largest earlier load, or up to the onset of
    /// plastic flow, is one increment too. In the rest the contact grows by about the same width
    /// in each increment.
    pub fn ends(&self, division: Division) -> Vec<f64> {
        let n = match division {
            Division::Fixed(n) => {
                let n = n.max(1);
                let part =
                    |k: u32| self.from + (self.to - self.from) * f64::from(k) / f64::from(n);
                return (1..n).map(part).chain([self.to]).collect();
            }
            Division::Level(level) => f64::from(1u32 << level.min(16)),
        };
        let onset = self.growth.onset.unwrap_or(UNKNOWN_ONSET * self.to);
        let start = self.from.max(self.reached).max(onset);
        if self.to <= start {
            return vec![self.to];
        }
        let mut ends = Vec::new();
        if start > self.from {
            ends.push(start);
        }
        // Half-width at the start over that at the end.
        let first = (start / self.to).powf(self.growth.exponent.recip());
        let count = (n * (1.0 - first) / GROWTH).ceil().clamp(1.0, 10_000.0);
        let mut k = 1.0;
        while k < count {
            ends.push(self.to * (first + (1.0 - first) * k / count).powf(self.growth.exponent));
            k += 1.0;
        }
        ends.push(self.to);
        ends
    }
}

/// Halvings of an increment that does not converge, at most.
const MAX_HALVINGS: u32 = 5;

/// The ends of the increments of a leg. Halving an increment adds an end.
#[derive(Debug, Clone, PartialEq)]
pub struct IncrementEnds {
    /// Measure at each end and the number of halvings of its increment.
    ends: Vec<(f64, u32)>,
}

impl IncrementEnds {
    /// Ends of the increments of a leg.
    pub fn of(leg: &Leg, division: Division) -> Self {
        Self { ends: leg.ends(division).into_iter().map(|end| (end, 0)).collect() }
    }

    /// Returns the number of increments.
    pub fn count(&self) -> usize {
        self.ends.len()
    }

    /// The measure at the end of an increment.
    pub fn measure(&self, k: usize) -> f64 {
        self.ends[k].0
    }

    /// Halves the increment that begins at the measure `from`, if it is not yet the smallest.
    pub fn halve(&mut self, k: usize, from: f64) -> bool {
        let (to, halvings) = self.ends[k];
        if halvings >= MAX_HALVINGS {
            return false;
        }
        self.ends[k].1 += 1;
        self.ends.insert(k, (f64::midpoint(from, to), halvings + 1));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn leg(from: f64, to: f64, reached: f64) -> Leg {
        Leg {
            is_force: true,
            from,
            to,
            reached,
            growth: Growth { onset: Some(100.0), exponent: 1.6 },
        }
    }

    #[test]
    fn loading_is_divided_beyond_the_onset_of_yield() {
        let ends = leg(0.0, 500.0, 0.0).ends(Division::Level(1));
        assert_eq!((ends[0], ends[ends.len() - 1]), (100.0, 500.0));
        assert_eq!(ends.len(), 12);
        let width = |k: usize| ends[k].powf(1.0 / 1.6);
        assert!((1..11).all(|k| (width(k) - width(k - 1) - width(1) + width(0)).abs() < 1e-9));
        assert_eq!(leg(0.0, 500.0, 0.0).ends(Division::Level(2)).len(), 23);
    }

    #[test]
    fn unloading_and_loading_within_what_has_been_is_one_increment() {
        assert_eq!(leg(500.0, 0.0, 500.0).ends(Division::Level(3)), [0.0]);
        assert_eq!(leg(0.0, 500.0, 500.0).ends(Division::Level(3)), [500.0]);
        assert_eq!(leg(0.0, 80.0, 0.0).ends(Division::Level(3)), [80.0]);
        assert_eq!(leg(0.0, 550.0, 500.0).ends(Division::Level(0)), [500.0, 550.0]);
    }

    #[test]
    fn an_increment_is_halved_some_times() {
        let mut ends = IncrementEnds::of(&leg(0.0, 320.0, 0.0), Division::Fixed(2));
        let mut halvings = 0;
        while ends.halve(1, 160.0) {
            halvings += 1;
        }
        assert_eq!(halvings, MAX_HALVINGS);
        let measures: Vec<_> = (0..ends.count()).map(|k| ends.measure(k)).collect();
        assert_eq!(measures, [160.0, 165.0, 170.0, 180.0, 200.0, 240.0, 320.0]);
        // What comes after it can still be halved, but for the smallest.
        assert!(!ends.clone().halve(2, 165.0) && ends.halve(3, 170.0));
    }

    #[test]
    fn a_fixed_division_is_even() {
        assert_eq!(leg(500.0, 0.0, 500.0).ends(Division::Fixed(2)), [250.0, 0.0]);
        assert_eq!(leg(0.0, 300.0, 0.0).ends(Division::Fixed(3)), [100.0, 200.0, 300.0]);
    }
}
