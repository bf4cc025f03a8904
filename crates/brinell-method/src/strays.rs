//! Strays of a history: the scatter of the figures of its increments about a smooth curve.
//!
//! A contact on a mesh grows by whole nodes. Between two nodes figures go off the smooth curve and
//! come back; a coarser mesh need not show by how much at this load. While a load rises, logarithms
//! of the figures over that of the load are close to a parabola.

use brinell_contact::ContactLoad;

use super::figures::{BodyFigures, Figures};
use super::steps::IncrementRecord;

/// Least number of increments that tell a scatter.
const LEAST: usize = 6;
/// Largest deviation over the standard deviation, of one that is spread evenly.
const LARGEST: f64 = 1.732_050_807_568_877_2;

/// Returns the largest relative deviations of pressures, half-width, approach and force from a
/// parabola in the logarithms, over the later half of the increments in which the bodies have
/// yielded: before, the contact has few nodes. The dents go with the approach. Zeros if there are
/// too few increments or if the load falls. The measure of the load has none.
pub fn strays(increments: &[IncrementRecord], load: ContactLoad) -> Figures {
    let measure = |record: &IncrementRecord| match load {
        ContactLoad::Force(_) => record.force,
        ContactLoad::Approach(_) => record.approach,
    };
    let yielded: Vec<_> = increments.iter().filter(|record| record.plastic_points > 0).collect();
    let yielded = &yielded[yielded.len().saturating_sub(LEAST.max(yielded.len() / 2))..];
    let rises = yielded.windows(2).all(|pair| measure(pair[1]) > measure(pair[0]));
    if yielded.len() < LEAST || !rises {
        return Figures::default();
    }
    let of = |figure: fn(&IncrementRecord) -> f64| {
        let points = yielded.iter().map(|record| [measure(record), figure(record)]);
        if points.clone().flatten().any(|value| value <= 0.0) {
            return 0.0;
        }
        let logarithms: Vec<_> = points.map(|point| point.map(f64::ln)).collect();
        LARGEST * deviation(&logarithms)
    };
    let [force, approach] = match load {
        ContactLoad::Force(_) => [0.0, of(|record| record.approach)],
        ContactLoad::Approach(_) => [of(|record| record.force), 0.0],
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
    use crate::observer::SolveStatus;

    fn records(half_width: impl Fn(f64) -> f64) -> Vec<IncrementRecord> {
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
        (0..30).map(record).collect()
    }

    #[test]
    fn a_smooth_curve_has_no_strays() {
        let records = records(|force| force.powf(0.5 + 0.02 * force.ln()));
        let found = strays(&records, ContactLoad::Force(1.0));
        assert!(found.values().iter().all(|value| *value < 1e-9), "{found:?}");
    }

    #[test]
    fn steps_of_an_element_are_strays_of_half_an_element() {
        // From 30 to 50 elements.
        let steps = |force: f64| (30.0 * (force / 10.0).powf(0.1)).round();
        let found = strays(&records(steps), ContactLoad::Force(1.0));
        assert!((0.007..0.02).contains(&found.half_width), "{found:?}");
        assert!(found.force.abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn few_increments_and_falling_loads_tell_nothing() {
        let mut records = records(|force| (3.0 * force.sqrt()).round());
        assert_eq!(strays(&records[..5], ContactLoad::Force(1.0)), Figures::default());
        records.reverse();
        assert_eq!(strays(&records, ContactLoad::Force(1.0)), Figures::default());
    }
}
