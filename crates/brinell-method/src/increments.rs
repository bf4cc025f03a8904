//! The division of a load of a history into increments.

use brinell_contact::ContactLoad;

/// Growth of the contact in one increment, over its width at the onset of plastic flow, at most: two
/// increments at an elastic peak of 2 yield stresses of a ball, 4 to 5 at 3 and 7 to 9 at 4.
const GROWTH: f64 = 0.25;
/// Most increments, from which smaller ones do not help what the mesh leaves.
const MOST: f64 = 32.0;
/// Increments up to which a finer system follows the path of a coarser one: an elastic peak of 4
/// yield stresses. Beyond, strain gathers at the ends of the contact, where the paths of two meshes
/// differ.
const MOST_FOLLOWED: f64 = 8.0;
/// Assumed onset of plastic flow over the load, where the onset is unknown: that of a ball pressed in
/// by 100 times the approach at its onset.
const UNKNOWN_ONSET: f64 = 0.01;

/// The increments of the loads of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Increments {
    /// So many for each load, of equal size.
    Given(u32),
    /// Chosen by the solve, so many times as many as by default.
    Chosen(u32),
}

impl Default for Increments {
    fn default() -> Self {
        Self::Chosen(1)
    }
}

/// The division of every load of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Division {
    /// A number of equal increments for each load.
    Fixed(u32),
    /// Increments of equal growth of the contact.
    Grown,
    /// Half as many of them, for comparison.
    Halved,
    /// Those of a path that a finer system follows: twice as many where they are few and the onset
    /// of plastic flow is known.
    Path,
    /// Half as many as those of a path, for comparison.
    HalvedPath,
    /// Half as many, within which the bodies follow the path of a coarser system; all of them where
    /// they are many or the onset of plastic flow is not known.
    Followed,
}

impl Division {
    /// Returns the division with which this one is compared: all increments, or half of those given.
    #[must_use]
    pub const fn finer(self) -> Self {
        match self {
            Self::Fixed(n) => Self::Fixed(2 * n),
            Self::Grown | Self::Halved => Self::Grown,
            Self::Path | Self::HalvedPath | Self::Followed => Self::Path,
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
    /// Increments over those by default.
    pub times: u32,
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
    /// Unloading is one increment, and so is loading up to the largest earlier load. Beyond it, or
    /// from rest past the onset of plastic flow, the contact grows by about the same width in each
    /// increment.
    pub fn ends(&self, division: Division) -> Vec<f64> {
        let Growth { onset, exponent } = self.growth;
        if let Division::Fixed(n) = division {
            let n = n.max(1);
            let part = |k: u32| self.from + (self.to - self.from) * f64::from(k) / f64::from(n);
            return (1..n).map(part).chain([self.to]).collect();
        }
        let at_onset = onset.unwrap_or(UNKNOWN_ONSET * self.to);
        let start = self.from.max(self.reached).max(at_onset);
        if self.to <= start {
            return vec![self.to];
        }
        let mut ends = Vec::new();
        if self.reached > self.from {
            ends.push(self.reached);
        }
        let width = |measure: f64| measure.powf(exponent.recip());
        let (first, last) = (width(start), width(self.to));
        let all = ((last - first) / (GROWTH * width(at_onset))).min(MOST);
        let is_smooth = |most: f64| onset.is_some() && all.ceil() <= most;
        let (is_followed, is_short) = (is_smooth(MOST_FOLLOWED), is_smooth(MOST_FOLLOWED / 2.0));
        let all = (f64::from(self.times) * all).ceil();
        let part = match (division, is_short, is_followed) {
            (Division::Path, true, _) => 2.0,
            (Division::Halved, ..)
            | (Division::HalvedPath, false, _)
            | (Division::Followed, _, true) => 0.5,
            _ => 1.0,
        };
        let count = (part * all).ceil();
        let mut k = 1.0;
        while k < count {
            ends.push((first + (last - first) * k / count).powf(exponent));
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
            times: 1,
        }
    }

    #[test]
    fn loading_is_divided_beyond_the_onset_of_yield() {
        let ends = |to: f64, division| leg(0.0, to, 0.0).ends(division);
        let width = |measure: f64| f64::powf(measure, 1.0 / 1.6);
        let all = ends(500.0, Division::Grown);
        assert_eq!((all.len(), all[6]), (7, 500.0));
        let growth = |k: usize| width(all[k]) - width(if k > 0 { all[k - 1] } else { 100.0 });
        assert!((0..7).all(|k| (growth(k) - growth(0)).abs() < 1e-9));
        assert!(growth(0) <= GROWTH * width(100.0));
        let counts = |to: f64| {
            [
                Division::Halved,
                Division::Grown,
                Division::HalvedPath,
                Division::Path,
                Division::Followed,
            ]
            .map(|by| ends(to, by).len())
        };
        assert_eq!([110.0, 300.0].map(counts), [[1, 1, 1, 2, 1], [2, 4, 4, 8, 2]]);
        assert_eq!([500.0, 1e3].map(counts), [[4, 7, 4, 7, 4], [7, 13, 7, 13, 13]]);
        assert_eq!(counts(1e6), [16, 32, 16, 32, 32]);
        let finer = Leg { times: 3, ..leg(0.0, 300.0, 0.0) };
        assert_eq!(finer.ends(Division::Followed).len(), 6);
        let growth = Growth { onset: None, exponent: 1.6 };
        let unknown = Leg { growth, ..leg(0.0, 500.0, 0.0) };
        assert_eq!(unknown.ends(Division::Followed), unknown.ends(Division::Grown));
    }

    #[test]
    fn unloading_and_loading_within_what_has_been_is_one_increment() {
        let all = Division::Grown;
        assert_eq!(leg(500.0, 0.0, 500.0).ends(all), [0.0]);
        assert_eq!(leg(0.0, 500.0, 500.0).ends(all), [500.0]);
        assert_eq!(leg(0.0, 80.0, 0.0).ends(all), [80.0]);
        assert_eq!(leg(0.0, 510.0, 500.0).ends(all), [500.0, 510.0]);
        assert_eq!(leg(450.0, 510.0, 450.0).ends(all), [510.0]);
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
