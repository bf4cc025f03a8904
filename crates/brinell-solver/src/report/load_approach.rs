//! The curve of force over approach that a sweep traces.

use serde::{Deserialize, Serialize};

use super::units::UnitConverter;

/// Approaches closer together than this part of the larger one count as one point of the curve.
const SAME: f64 = 1e-9;

/// Force over approach, in order of the approach; only converged steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LoadApproach {
    /// Contact force P.
    pub force: Vec<f64>,
    /// Approach α.
    pub approach: Vec<f64>,
    /// dP/dα along this curve: of the loading, with the plastic flow that it brings. Second order: the slope of the
    /// parabola through a point and its neighbours, at the ends through the three outermost points.
    pub stiffness: Vec<f64>,
}

/// The curve through points `[approach, force]` of converged steps; `None` of fewer than two different approaches.
///
/// Deformation theory has no memory, so the order in which the loads were applied does not matter.
pub(super) fn curve(mut points: Vec<[f64; 2]>, write: UnitConverter) -> Option<LoadApproach> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    points.dedup_by(|b, a| b[0] - a[0] <= SAME * b[0].abs());
    if points.len() < 2 {
        return None;
    }
    Some(LoadApproach {
        force: points.iter().map(|[_, p]| write.force(*p)).collect(),
        approach: points.iter().map(|[alpha, _]| write.length(*alpha)).collect(),
        stiffness: slopes(&points).into_iter().map(|slope| write.stiffness(slope)).collect(),
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
    fn two_points_have_one_slope() {
        assert_eq!(slopes(&[[1.0, 1.0], [2.0, 4.0]]), [3.0, 3.0]);
    }
}
