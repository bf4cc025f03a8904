//! Strays of a history: the scatter of the figures of its increments about a smooth curve.
//!
//! A contact on a mesh grows by whole nodes. Between two nodes figures go off the smooth curve and
//! come back; a coarser mesh need not show by how much at this load. While a load rises, logarithms
//! of the figures over that of the load are close to a parabola.
//!
//! What a load has done to the bodies stays, and so does the error of it, also where the meshes of
//! a later load agree by chance.

use super::figures::{Figure, Values};
use super::increments::Leg;
use super::parabola::Parabola;
use super::steps::{IncrementRecord, Step};
use super::words::Quantity;

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
    /// few nodes. The dents go with the approach. None if there are too few increments, or if the
    /// load falls. The measure of the load has none.
    pub fn strays(&self, leg: &Leg) -> Values {
        let Self(all) = self;
        let mut strays = Values::default();
        if all.len() < LEAST || leg.falls() {
            return strays;
        }
        let later = &all[all.len() - LEAST.max(all.len() / 2)..];
        let measure =
            |record: &IncrementRecord| if leg.is_force { record.force } else { record.approach };
        let of = |figure: fn(&IncrementRecord) -> Option<f64>| {
            let logarithms: Option<Vec<_>> = later
                .iter()
                .map(|record| {
                    let point = [measure(record), figure(record)?];
                    point.iter().all(|value| *value > 0.0).then(|| point.map(f64::ln))
                })
                .collect();
            logarithms.map(|logarithms| LARGEST * Parabola::through(&logarithms).deviation)
        };
        strays.set(Figure::PeakPressure, 0, of(|record| Some(record.peak_pressure)));
        strays.set(Figure::MiddlePressure, 0, of(|record| record.middle_pressure));
        strays.set(Figure::HalfWidth, 0, of(|record| Some(record.half_width)));
        if leg.is_force {
            let approach = of(|record| Some(record.approach));
            strays.set(Figure::Approach, 0, approach);
            (0..2).for_each(|side| strays.set(Figure::Dent, side, approach));
        } else {
            strays.set(Figure::Force, 0, of(|record| Some(record.force)));
        }
        strays
    }
}

/// The differences to the coarse system that the loads of a history have shown so far. That of a
/// pressure goes with the element over the half-width; those of stresses in the bodies count under
/// their own load alone; every other one remains.
#[derive(Debug, Default)]
pub(super) struct Shown {
    /// Sums of the squares.
    squares: Values,
    /// Numbers of loads, without those under which a figure is zero.
    loads: Values,
}

impl Shown {
    /// Takes the end of a load. Returns the least relative error of each figure there: the root of
    /// the mean square of the differences so far, or the strays of the load. Zeros of a figure that
    /// is zero.
    pub fn by<F>(&mut self, step: &Step<F>) -> Values {
        let Step { figures, coarse: Some(coarse), path, .. } = step else {
            return step.path.shown;
        };
        let width = if figures.half_width > 0.0 { figures.half_width } else { path.reached[1] };
        let values = figures.values();
        let scales = values.map(|figure, _, value| match figure.quantity() {
            Quantity::Stress if figure.is_of_body() => 0.0,
            Quantity::Stress => width,
            _ => value.abs(),
        });
        let now = values.zip(&coarse.values(), |fine, coarse| ratio(fine - coarse, fine));
        let now = now.zip(&scales, |part, scale| part * scale);
        self.squares = self.squares.with(&now, |sum, now| sum + now * now);
        self.loads = self.loads.with(&values, |loads, figure| loads + f64::from(figure != 0.0));
        let mean = self.squares.zip(&self.loads, |sum, loads| ratio(sum, loads).sqrt());
        mean.zip(&scales, ratio).with(&path.shown, f64::max)
    }
}

/// Returns `part / whole`, zero over zero.
fn ratio(part: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { part / whole }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::Figures;
    use crate::increments::Growth;
    use crate::observer::SolveStatus;
    use crate::steps::{Checks, Path, Search};
    use brinell_contact::ContactLoad;

    /// A force that rises.
    fn force() -> Leg {
        let growth = Growth { onset: None, exponent: 2.0 };
        Leg { is_force: true, from: 0.0, to: 1.0, reached: 0.0, growth, times: 1 }
    }

    fn rising(number: u32, half_width: impl Fn(f64) -> f64) -> Rising {
        let record = |k: u32| {
            let force = 10.0 * 1.2_f64.powi(k.cast_signed());
            IncrementRecord {
                force,
                approach: force.powf(0.9),
                peak_pressure: 500.0 * force.powf(0.1),
                middle_pressure: Some(500.0),
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
        let is_small = |figure: &Figure| found.largest(*figure).is_none_or(|stray| stray < 1e-9);
        assert!(Figure::ALL.iter().all(is_small), "{found:?}");
        assert!(found.get(Figure::Dent, 1).is_some() && found.get(Figure::Force, 0).is_none());
    }

    #[test]
    fn steps_of_an_element_are_strays_of_half_an_element() {
        // From 30 to 50 elements.
        let steps = |force: f64| (30.0 * (force / 10.0).powf(0.1)).round();
        let found = rising(30, steps).strays(&force());
        assert!((0.007..0.02).contains(&found.largest(Figure::HalfWidth).unwrap()), "{found:?}");
    }

    fn step(half_width: f64, approach: [f64; 2], peak: [f64; 2]) -> Step<()> {
        let figures = |k: usize| Figures {
            peak_pressure: peak[k],
            middle_pressure: None,
            half_width,
            semi_axis_y: None,
            contact_area: None,
            contact_ratio: None,
            approach: approach[k],
            force: 1.0,
            bodies: [None; 2],
        };
        Step {
            status: SolveStatus::Converged,
            load: ContactLoad::Force(1.0),
            figures: figures(0),
            coarse: Some(figures(1)),
            increment_error: None,
            checks: Checks::default(),
            history: Vec::new(),
            path: Path { reached: [1.0, 2.0], ..Path::default() },
            search: Search::default(),
            contact_stiffness: None,
            enlargements: 0,
            is_preliminary: false,
            field: (),
        }
    }

    #[test]
    fn errors_remain_and_those_of_pressures_go_with_the_half_width() {
        let mut shown = Shown::default();
        let near = |a: Option<f64>, b: f64| (a.unwrap() - b).abs() < 1e-12;
        let [approach, peak] = [Figure::Approach, Figure::PeakPressure];
        let loaded = shown.by(&step(2.0, [1.0, 0.97], [500.0, 490.0]));
        assert!(
            near(loaded.largest(approach), 0.03) && near(loaded.largest(peak), 0.02),
            "{loaded:?}"
        );
        // The meshes agree by chance.
        let less = shown.by(&step(1.0, [0.5, 0.5], [300.0, 300.0]));
        assert!(near(less.largest(approach), 0.06 / 2f64.sqrt()), "{less:?}");
        assert!(near(less.largest(peak), 0.04 / 2f64.sqrt()), "{less:?}");
        // Nothing touches: the pressure tells nothing.
        let apart = shown.by(&step(0.0, [0.2, 0.2], [0.0, 0.0]));
        assert!(near(apart.largest(approach), 0.15 / 3f64.sqrt()), "{apart:?}");
        let more = shown.by(&step(4.0, [2.0, 2.0], [600.0, 600.0]));
        assert!(near(more.largest(approach), 0.015 / 2.0), "{more:?}");
        assert!(near(more.largest(peak), 0.01 / 3f64.sqrt()), "{more:?}");
    }

    #[test]
    fn few_increments_tell_nothing() {
        let few = rising(5, |force| (3.0 * force.sqrt()).round());
        assert_eq!(few.strays(&force()), Values::default());
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
