//! The curve of force over approach, through the load steps of a job.

use serde::{Deserialize, Serialize};

use crate::job::Job;
use crate::solver::IncrementRecord;
use crate::units::UnitConverter;

/// Number of elements by which the contact grows between two loads of a difference quotient. While
/// the contact grows by one element, the error of the approach changes its sign, and closer loads
/// give a wrong slope.
const GROWTH: f64 = 2.0;

/// Force over approach, only of converged steps: in order of the approach or, of a history, in the
/// order of the increments with the bodies at rest before them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct LoadApproach {
    /// Contact force P \[force\].
    pub force: Vec<f64>,
    /// Approach α \[length\].
    pub approach: Vec<f64>,
    /// dP/dα along this curve: the contact stiffness of a step that has one, else the difference
    /// between two points of the curve \[stiffness\].
    pub stiffness: Vec<f64>,
    /// Force from which on each slope was taken, that of the point itself where the contact
    /// stiffness of the step is known. Up to `stiffness_to` the contact grows by two elements or
    /// more, where the curve is long enough. Empty before version 0.3 \[force\].
    #[serde(default)]
    pub stiffness_from: Vec<f64>,
    /// Force up to which it was taken. Empty before version 0.3 \[force\].
    #[serde(default)]
    pub stiffness_to: Vec<f64>,
}

/// A point of the curve.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct CurvePoint {
    /// Approach \[mm\].
    pub approach: f64,
    /// Force \[N/mm, or N\].
    pub force: f64,
    /// Half-width of the contact over the size of its elements.
    pub elements: f64,
    /// Contact stiffness, where it is known \[N/mm per mm, or N per mm\].
    pub stiffness: Option<f64>,
}

impl CurvePoint {
    /// Returns whether the approaches of two points differ by rounding only.
    fn is_at(&self, other: &Self) -> bool {
        (self.approach - other.approach).abs() <= f64::EPSILON.sqrt() * self.approach.abs()
    }
}

/// Returns the points of a load step: the ends of its increments or, without increments, its own
/// end `[approach, force, half-width]`. The last point has the contact stiffness of the load step.
pub(super) fn points(
    increments: &[IncrementRecord],
    end: [f64; 3],
    spacing: f64,
    stiffness: Option<f64>,
) -> Vec<CurvePoint> {
    let ends = increments.iter().map(|end| [end.approach, end.force, end.half_width]);
    let mut ends: Vec<_> = ends.collect();
    if ends.is_empty() {
        ends.push(end);
    }
    let point = |[approach, force, half_width]: [f64; 3]| CurvePoint {
        approach,
        force,
        elements: half_width / spacing,
        stiffness: None,
    };
    let mut points: Vec<_> = ends.into_iter().map(point).collect();
    if let Some(last) = points.last_mut() {
        last.stiffness = stiffness;
    }
    points
}

/// Returns the curve of a job through the points of its converged load steps. Of bodies with a
/// memory it begins at rest; loads from rest are points of one rising curve.
pub(super) fn of_job(
    job: &Job,
    mut points: Vec<CurvePoint>,
    write: UnitConverter,
) -> Option<LoadApproach> {
    if !job.has_memory() {
        return curve(points, write);
    }
    if !job.load.is_history() {
        points.sort_by(|a, b| a.approach.total_cmp(&b.approach));
    }
    history(&points, write)
}

/// Returns the curve through points of converged load steps, or `None` for fewer than two
/// different approaches.
///
/// Deformation theory has no memory, so that the order of the loads does not matter.
fn curve(mut points: Vec<CurvePoint>, write: UnitConverter) -> Option<LoadApproach> {
    points.sort_by(|a, b| a.approach.total_cmp(&b.approach));
    points.dedup_by(|b, a| b.is_at(a));
    (points.len() >= 2).then(|| written(&points, &slopes(&points), write))
}

/// Returns the path of a history from rest through the ends of its increments. Slopes are computed
/// within each rising or falling branch.
fn history(points: &[CurvePoint], write: UnitConverter) -> Option<LoadApproach> {
    let mut way = vec![CurvePoint::default()];
    way.extend(points);
    // The later one of two points at the same approach may have a stiffness.
    way.dedup_by(|b, a| {
        let is_same = b.is_at(a);
        if is_same {
            *a = *b;
        }
        is_same
    });
    if way.len() < 2 {
        return None;
    }
    let mut all: Vec<Slope> = Vec::with_capacity(way.len());
    let mut first = 0;
    while first + 1 < way.len() {
        let rises = way[first + 1].approach > way[first].approach;
        let same_way = |pair: &&[CurvePoint]| (pair[1].approach > pair[0].approach) == rises;
        let length = way[first..].windows(2).take_while(same_way).count();
        let run = slopes(&way[first..=first + length]);
        // A turning point belongs to the branch that ends there.
        all.extend(run.into_iter().skip(usize::from(first > 0)));
        first += length;
    }
    Some(written(&way, &all, write))
}

fn written(points: &[CurvePoint], slopes: &[Slope], write: UnitConverter) -> LoadApproach {
    LoadApproach {
        force: points.iter().map(|point| write.force(point.force)).collect(),
        approach: points.iter().map(|point| write.length(point.approach)).collect(),
        stiffness: slopes.iter().map(|slope| write.stiffness(slope.value)).collect(),
        stiffness_from: slopes.iter().map(|slope| write.force(slope.between[0])).collect(),
        stiffness_to: slopes.iter().map(|slope| write.force(slope.between[1])).collect(),
    }
}

/// A slope and the forces between which it is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Slope {
    value: f64,
    between: [f64; 2],
}

/// Returns the slope at each point of a rising or falling branch of at least two points.
fn slopes(points: &[CurvePoint]) -> Vec<Slope> {
    (0..points.len()).map(|k| slope(points, k)).collect()
}

fn slope(points: &[CurvePoint], k: usize) -> Slope {
    let here = points[k];
    if let Some(value) = here.stiffness {
        return Slope { value, between: [here.force; 2] };
    }
    let last = points.len() - 1;
    let span = |by: usize| [points[k.saturating_sub(by)], points[(k + by).min(last)]];
    let is_wide = |[a, b]: &[CurvePoint; 2]| (b.elements - a.elements).abs() >= GROWTH;
    let [from, to] = (1..=last).map(span).find(is_wide).unwrap_or([points[0], points[last]]);
    let value = match secant_exponent(from, to) {
        Some(exponent) if here.approach > 0.0 => exponent * here.force / here.approach,
        _ => (to.force - from.force) / (to.approach - from.approach),
    };
    Slope { value, between: [from.force, to.force] }
}

/// Returns the exponent of the power law through two points. The slope of a power law is accurate
/// at the ends of the span too, unlike a difference quotient.
fn secant_exponent(from: CurvePoint, to: CurvePoint) -> Option<f64> {
    let is_power = [from, to].iter().all(|point| point.force > 0.0 && point.approach > 0.0);
    is_power.then(|| (to.force / from.force).ln() / (to.approach / from.approach).ln())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Analysis, Units};

    fn points(of: &[[f64; 3]]) -> Vec<CurvePoint> {
        let point = |&[approach, force, elements]: &[f64; 3]| CurvePoint {
            approach,
            force,
            elements,
            stiffness: None,
        };
        of.iter().map(point).collect()
    }

    /// A sphere, `P ∝ α^1.5`, whose approaches deviate by a thousandth from one point to the next.
    #[test]
    fn slopes_span_two_elements() {
        let sphere: Vec<[f64; 3]> = (0..21)
            .map(|k| {
                let approach = 0.9 + 0.01 * f64::from(k);
                let deviation = if k % 2 == 0 { 1e-3 } else { -1e-3 };
                [approach * (1.0 + deviation), approach.powf(1.5), 20.0 * approach.sqrt()]
            })
            .collect();
        for (found, [approach, force, _]) in slopes(&points(&sphere)).iter().zip(sphere) {
            let exact = 1.5 * force / approach;
            assert!((found.value / exact - 1.0).abs() < 0.02, "{found:?} {exact}");
            let growth = (found.between[1].cbrt() - found.between[0].cbrt()) * 20.0;
            assert!((GROWTH..2.0 * GROWTH).contains(&growth), "{growth}");
        }
    }

    #[test]
    fn a_history_keeps_its_order_and_turns_where_it_turns() {
        let write = UnitConverter::new(Units::MmNMpa, Analysis::PlaneStrain);
        let mut way =
            points(&[[1.0, 2.0, 9.0], [2.0, 4.0, 12.0], [1.5, 1.0, 6.0], [1.0, 0.0, 0.0]]);
        way[1].stiffness = Some(1.9);
        let way = history(&way, write).unwrap();
        assert_eq!(way.approach, [0.0, 1.0, 2.0, 1.5, 1.0]);
        assert_eq!(way.stiffness, [2.0, 2.0, 1.9, 4.0, 2.0]);
        assert_eq!(
            (&way.stiffness_from[2..4], &way.stiffness_to[2..4]),
            (&[4.0, 4.0][..], &[4.0, 0.0][..])
        );
    }

    #[test]
    fn two_points_have_one_exponent() {
        let found = slopes(&points(&[[1.0, 1.0, 5.0], [2.0, 4.0, 5.1]]));
        assert!((found[0].value - 2.0).abs() < 1e-12 && (found[1].value - 4.0).abs() < 1e-12);
        let [from, to] = found[1].between;
        assert!((from - 1.0).abs() < 1e-12 && (to - 4.0).abs() < 1e-12);
    }
}
