//! Strays of a history: the scatter of the figures of its increments about a smooth curve.
//!
//! A contact on a mesh grows by whole nodes. Between two nodes figures go off the smooth curve and
//! come back; a coarser mesh need not show by how much at this load. While a load rises, logarithms
//! of the figures over that of the load are close to a parabola.

use super::figures::{BodyFigures, Figures};
use super::increments::Leg;
use super::steps::IncrementRecord;

/// Least number of increments that tell a scatter.
const LEAST: usize = 6;
/// Largest deviation over the standard deviation, of one that is spread evenly.
const LARGEST: f64 = 1.732_050_807_568_877_2;

/// The increments of a history since rest that bring the bodies beyond all before.
#[derive(Debug, Default)]
pub struct Rising(Vec<IncrementRecord>);

impl Rising {
    /// Most increments that are kept, the last ones.
    const MOST: usize = 1000;

    /// Takes the last of these increments, if it rises.
    pub fn extend(&mut self, increments: &[IncrementRecord]) {
        let Some(next) = increments.last() else { return };
        let is_beyond =
            |last: &IncrementRecord| next.force > last.force && next.approach > last.approach;
        if next.plastic_points > 0 && self.0.last().is_none_or(is_beyond) {
            if self.0.len() == Self::MOST {
                self.0.remove(0);
            }
            self.0.push(*next);
        }
    }

    /// Returns the largest relative deviations of pressures, half-width, approach and force from a
    /// parabola in the logarithms, over the later half of the increments: before, the contact has
    /// few nodes. The dents go with the approach. Zeros if there are too few increments, or if the
    /// load falls. The measure of the load has none.
    pub fn strays(&self, leg: &Leg) -> Figures {
        let Self(all) = self;
        if all.len() < LEAST || leg.falls() {
            return Figures::default();
        }
        let later = &all[all.len() - LEAST.max(all.len() / 2)..];
        let measure =
            |record: &IncrementRecord| if leg.is_force { record.force } else { record.approach };
        let of = |figure: fn(&IncrementRecord) -> f64| {
            let points = later.iter().map(|record| [measure(record), figure(record)]);
            if points.clone().flatten().any(|value| value <= 0.0) {
                return 0.0;
            }
            let logarithms: Vec<_> = points.map(|point| point.map(f64::ln)).collect();
            LARGEST * deviation(&logarithms)
        };
        let [force, approach] = if leg.is_force {
            [0.0, of(|record| record.approach)]
        } else {
            [of(|record| record.force), 0.0]
        };
        Figures {
            peak_pressure: of(|record| record.peak_pressure),
            middle_pressure: of(|record| record.middle_pressure),
            half_width: of(|record| record.half_width),
            approach,
            force,
            bodies: [BodyFigures { dent: approach, ..BodyFigures::default() }; 2],
            ..Figures::default()
        }
    }
}

/// Standard deviation of points `[x, y]` from the parabola of least squares.
fn deviation(points: &[[f64; 2]]) -> f64 {
    let n = points.len() as f64;
    let mut left: Vec<f64> = points.iter().map(|[_, y]| *y).collect();
    // Polynomials that are orthogonal on these abscissae, one after the other.
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for degree in 0..3 {
        let mut next: Vec<f64> = points.iter().map(|[x, _]| x.powi(degree)).collect();
        for known in &basis {
            remove(&mut next, known);
        }
        remove(&mut left, &next);
        basis.push(next);
    }
    (left.iter().map(|value| value * value).sum::<f64>() / (n - 3.0)).sqrt()
}

/// Removes the part along `known`.
fn remove(vector: &mut [f64], known: &[f64]) {
    let dot = |v: &[f64], w: &[f64]| v.iter().zip(w).map(|(v, w)| v * w).sum::<f64>();
    let part = dot(vector, known) / dot(known, known).max(f64::MIN_POSITIVE);
    vector.iter_mut().zip(known).for_each(|(value, known)| *value -= part * known);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::increments::Growth;
    use crate::observer::SolveStatus;

    /// A force that rises.
    fn force() -> Leg {
        let growth = Growth { onset: None, exponent: 2.0 };
        Leg { is_force: true, from: 0.0, to: 1.0, reached: 0.0, growth }
    }

    fn rising(number: u32, half_width: impl Fn(f64) -> f64) -> Rising {
        let record = |k: u32| {
            let force = 10.0 * 1.2_f64.powi(k.cast_signed());
            IncrementRecord {
                force,
                approach: force.powf(0.9),
                peak_pressure: 500.0 * force.powf(0.1),
                middle_pressure: 500.0,
                half_width: half_width(force),
                iterations: 3,
                plastic_points: 8,
                status: SolveStatus::Converged,
            }
        };
        let mut rising = Rising::default();
        (0..number).for_each(|k| rising.extend(&[record(k)]));
        rising
    }

    #[test]
    fn a_smooth_curve_has_no_strays() {
        let smooth = rising(30, |force| force.powf(0.5 + 0.02 * force.ln()));
        let found = smooth.strays(&force());
        assert!(found.values().iter().all(|value| *value < 1e-9), "{found:?}");
    }

    #[test]
    fn steps_of_an_element_are_strays_of_half_an_element() {
        // From 30 to 50 elements.
        let steps = |force: f64| (30.0 * (force / 10.0).powf(0.1)).round();
        let found = rising(30, steps).strays(&force());
        assert!((0.007..0.02).contains(&found.half_width), "{found:?}");
        assert!(found.force.abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn few_increments_tell_nothing() {
        let few = rising(5, |force| (3.0 * force.sqrt()).round());
        assert_eq!(few.strays(&force()), Figures::default());
    }

    #[test]
    fn what_falls_or_comes_back_is_left_out() {
        let mut rising = rising(30, f64::sqrt);
        let count = rising.0.len();
        let last = *rising.0.last().unwrap();
        rising.extend(&[IncrementRecord { force: 0.5 * last.force, ..last }]);
        rising.extend(&[last]);
        assert_eq!(rising.0.len(), count);
    }
}
