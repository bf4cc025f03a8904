//! The curve of force over approach that a sweep traces.

use serde::{Deserialize, Serialize};

use super::units::UnitConverter;

/// Approaches closer together than this part of the larger one count as one point of the curve.
const SAME: f64 = 1e-9;

/// Force over approach, only of converged steps: in order of the approach or, of a history, in the order of the increments
/// with the bodies at rest before them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LoadApproach {
    /// Contact force P \[force\].
    pub force: Vec<f64>,
    /// Approach α \[length\].
    pub approach: Vec<f64>,
    /// dP/dα along this curve: of the loading, with the plastic flow that it brings; the contact stiffness of each step. Between
    /// the ends of the loads of a history it is the slope of the parabola through a point and its neighbours \[stiffness\].
    pub stiffness: Vec<f64>,
}

/// The curve through points `[approach, force, contact stiffness]` of converged steps; `None` of fewer than two different approaches.
///
/// Deformation theory has no memory, so the order in which the loads were applied does not matter.
pub(super) fn curve(mut points: Vec<[f64; 3]>, write: UnitConverter) -> Option<LoadApproach> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    points.dedup_by(|b, a| b[0] - a[0] <= SAME * b[0].abs());
    if points.len() < 2 {
        return None;
    }
    Some(LoadApproach {
        force: points.iter().map(|[_, p, _]| write.force(*p)).collect(),
        approach: points.iter().map(|[alpha, ..]| write.length(*alpha)).collect(),
        stiffness: points.iter().map(|[.., slope]| write.stiffness(*slope)).collect(),
    })
}

/// The way of a history through points `[approach, force, contact stiffness]` of its increments, from rest. Where no stiffness is
/// known it is the slope within the run that rises or falls.
pub(super) fn history(points: &[[f64; 3]], write: UnitConverter) -> Option<LoadApproach> {
    let mut way = vec![[0.0; 3]];
    way.extend(points);
    // Of two points at one place the later one knows more.
    way.dedup_by(|b, a| {
        let is_same = (b[0] - a[0]).abs() <= SAME * b[0].abs();
        if is_same {
            *a = *b;
        }
        is_same
    });
    if way.len() < 2 {
        return None;
    }
    let known: Vec<f64> = way.iter().map(|point| point[2]).collect();
    let way: Vec<[f64; 2]> = way.into_iter().map(|[approach, force, _]| [approach, force]).collect();
    let mut stiffness: Vec<f64> = Vec::with_capacity(way.len());
    let mut first = 0;
    while first + 1 < way.len() {
        let rises = way[first + 1][0] > way[first][0];
        let same_way = |pair: &&[[f64; 2]]| (pair[1][0] > pair[0][0]) == rises;
        let length = way[first..].windows(2).take_while(same_way).count();
        let run = slopes(&way[first..=first + length]);
        // A turning point belongs to the run that ends there.
        stiffness.extend(run.into_iter().skip(usize::from(first > 0)));
        first += length;
    }
    for (slope, known) in stiffness.iter_mut().zip(known) {
        if known > 0.0 {
            *slope = known;
        }
    }
    Some(LoadApproach {
        force: way.iter().map(|[_, p]| write.force(*p)).collect(),
        approach: way.iter().map(|[alpha, _]| write.length(*alpha)).collect(),
        stiffness: stiffness.into_iter().map(|slope| write.stiffness(slope)).collect(),
    })
}

/// Slopes of a curve through at least two points of different abscissae.
fn slopes(points: &[[f64; 2]]) -> Vec<f64> {
    let secant = |a: [f64; 2], b: [f64; 2]| (b[1] - a[1]) / (b[0] - a[0]);
    if let [a, b] = points {
        return vec![secant(*a, *b); 2];
    }
    let last = points.len() - 1;
    (0..=last)
        .map(|k| {
            let middle = k.clamp(1, last - 1);
            let [a, b, c] = [points[middle - 1], points[middle], points[middle + 1]];
            // Newton's form of the parabola: its slope at x is s_ab + c₂ (2x - x_a - x_b).
            let curvature = (secant(b, c) - secant(a, b)) / (c[0] - a[0]);
            secant(a, b) + curvature * (2.0 * points[k][0] - a[0] - b[0])
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_differentiated_exactly() {
        let points = [0.1, 0.4, 0.5, 1.3].map(|x| [x, 1.0 + 2.0 * x + 3.0 * x * x]);
        for (slope, [x, _]) in slopes(&points).iter().zip(points) {
            assert!((slope - 2.0 - 6.0 * x).abs() < 1e-12, "{slope} at {x}");
        }
    }

    #[test]
    fn a_history_keeps_its_order_and_turns_where_it_turns() {
        use crate::job::{Analysis, Units};
        let write = UnitConverter::new(Units::MmNMpa, Analysis::PlaneStrain);
        let way =
            history(&[[1.0, 2.0, 0.0], [2.0, 4.0, 1.9], [1.5, 1.0, 0.0], [1.0, 0.0, 0.0]], write).unwrap();
        assert_eq!(way.approach, [0.0, 1.0, 2.0, 1.5, 1.0]);
        assert_eq!(way.stiffness[..3], [2.0, 2.0, 1.9]);
        assert!(way.stiffness.len() == 5 && way.stiffness[3] > 2.0);
    }

    #[test]
    fn two_points_have_one_slope() {
        assert_eq!(slopes(&[[1.0, 1.0], [2.0, 4.0]]), [3.0, 3.0]);
    }
}
