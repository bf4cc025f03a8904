//! Limits of a contact that rolls and slides over a half-space, from the elastic stress of Hertz's
//! pressure p and of a traction μ p along the travel.
//!
//! A place of the track sees the stress along a line in x, from far ahead to far behind. It stays
//! elastic while no point of this path leaves the ball of radius σ_y round the initial stress, in
//! the norm of von Mises. A backstress without bound may put the ball anywhere: the track of a body
//! that hardens kinematically shakes down while the path fits into a ball of radius σ_y.
//!
//! Stresses are sums over cells of Hertz's pressure ([`passing`](crate::passing)).

use crate::passing::Passing;
use crate::tensors::{self, COMPONENTS, DEVIATOR_COMPONENTS};
use brinell_material::smallest_ball;

/// Cells over a semi-axis, those along the travel near the surface, where friction makes σxx steep at
/// the ends of the contact, and strips over a half-width.
const CELLS: usize = 12;
const FINE_CELLS: usize = 48;
const STRIPS: usize = 80;
/// A depth over the shorter semi-axis from which cells are coarse.
const COARSE_FROM: f64 = 0.05;
/// Depths over the shorter semi-axis.
const DEPTHS: [f64; 26] = [
    0.0, 0.03, 0.06, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75,
    0.8, 0.9, 1.0, 1.15, 1.3, 1.5, 1.75, 2.1, 2.5,
];

/// The elastic contact and the body that it rolls over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingContact {
    /// Semi-axis along the travel \[mm\].
    pub along: f64,
    /// Semi-axis across it \[mm\]; `None` of a line.
    pub across: Option<f64>,
    /// Poisson's ratio of the body.
    pub poisson: f64,
}

/// Peak pressures up to which a body bears a contact of these semi-axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingLimit {
    /// Up to which nothing yields \[MPa\].
    pub elastic: f64,
    /// Up to which kinematic hardening without bound shakes down \[MPa\].
    pub kinematic: f64,
}

/// A stress in the norm of von Mises.
type Isometric = [f64; DEVIATOR_COMPONENTS];

/// Stress under a pressure of peak 1 along a line in x, and that under a traction of the same.
struct Path {
    depth: f64,
    points: Vec<[Isometric; 2]>,
}

impl SlidingContact {
    /// Returns the limits under each of some frictions, for the yield stress \[MPa\] and the
    /// initial stress σxx, σyy \[MPa\] over depth \[mm\].
    pub fn limits(
        &self,
        frictions: &[f64],
        yield_stress: impl Fn(f64) -> f64,
        initial: impl Fn(f64) -> [f64; 2],
    ) -> Vec<SlidingLimit> {
        let paths = self.paths();
        let of_friction = |friction: &f64| {
            let with_friction = |path: &Path| -> Vec<Isometric> {
                let sum =
                    |[p, q]: &[Isometric; 2]| std::array::from_fn(|k| p[k] + friction * q[k]);
                path.points.iter().map(sum).collect()
            };
            let paths: Vec<(f64, Vec<Isometric>)> =
                paths.iter().map(|path| (path.depth, with_friction(path))).collect();
            let elastic = paths.iter().map(|(depth, points)| {
                let [xx, yy] = initial(*depth);
                let rest = isometric(&[xx, yy, 0.0, 0.0, 0.0, 0.0]);
                first_yield(points, rest, yield_stress(*depth))
            });
            SlidingLimit {
                elastic: elastic.fold(f64::INFINITY, f64::min),
                kinematic: kinematic(&paths, &yield_stress),
            }
        };
        frictions.iter().map(of_friction).collect()
    }

    fn paths(&self) -> Vec<Path> {
        let at = |depth: &f64| -> Vec<Path> {
            let shorter = self.along.min(self.across.unwrap_or(self.along));
            let depth = depth * shorter;
            let Some(passing) = self.passing(depth) else { return Vec::new() };
            let level = passing.at(depth);
            let points = |row: usize| {
                level.path(row).iter().map(|both| both.each_ref().map(isometric)).collect()
            };
            passing.rows().map(|(row, _)| Path { depth, points: points(row) }).collect()
        };
        DEPTHS.iter().flat_map(at).collect()
    }

    /// Hertz's pressure of peak 1 in cells that resolve a depth.
    fn passing(&self, depth: f64) -> Option<Passing> {
        let Self { along, across, poisson } = *self;
        let passing = match across {
            None => Passing::hertz_line(along, STRIPS, poisson),
            Some(across) => {
                let fine = depth < COARSE_FROM * along.min(across);
                let cells = [if fine { FINE_CELLS } else { CELLS }, CELLS];
                Passing::hertz_ellipse([along, across], cells, poisson)
            }
        };
        passing.map(Passing::sliding)
    }
}

/// A stress `xx yy zz xy xz yz` as numbers whose sum of squares is that of von Mises's stress.
fn isometric(&[xx, yy, zz, xy, xz, yz]: &[f64; COMPONENTS]) -> Isometric {
    let mean = (xx + yy + zz) / 3.0;
    let deviator = tensors::isometric([xx - mean, yy - mean, xy, xz, yz]);
    deviator.map(|value| 1.5f64.sqrt() * value)
}

fn dot(a: &Isometric, b: &Isometric) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The least factor of a path at which one of its points leaves the ball of `strength`, from a
/// stress at rest.
fn first_yield(path: &[Isometric], rest: Isometric, strength: f64) -> f64 {
    let room = (strength * strength - dot(&rest, &rest)).max(0.0);
    let factor = |point: &Isometric| {
        let (square, along) = (dot(point, point), dot(point, &rest));
        // |rest + f point| = strength
        (square > 0.0).then(|| ((along * along + square * room).sqrt() - along) / square)
    };
    path.iter().filter_map(factor).fold(f64::INFINITY, f64::min)
}

/// The least of `strength over radius` of the smallest balls round the paths.
///
/// Half the distance between two points far apart bounds a radius from below, and a ball round
/// their middle from above: most paths are never looked at.
fn kinematic(paths: &[(f64, Vec<Isometric>)], yield_stress: &impl Fn(f64) -> f64) -> f64 {
    let mut bounds: Vec<(f64, f64, &[Isometric])> = paths
        .iter()
        .map(|(depth, points)| {
            let strength = yield_stress(*depth);
            (strength / radius_of_some_ball(points).max(f64::MIN_POSITIVE), strength, &points[..])
        })
        .collect();
    bounds.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = f64::INFINITY;
    for (bound, strength, points) in bounds {
        if bound > least {
            break;
        }
        least = least.min(strength / smallest_ball(points).radius);
    }
    least
}

/// The radius of a ball that holds the points: that round the middle of two that are far apart.
fn radius_of_some_ball(points: &[Isometric]) -> f64 {
    let distance = |a: &Isometric, b: &Isometric| {
        let difference: Isometric = std::array::from_fn(|k| a[k] - b[k]);
        dot(&difference, &difference)
    };
    let farthest = |from: &Isometric| {
        let most = points.iter().max_by(|a, b| distance(from, a).total_cmp(&distance(from, b)));
        *most.unwrap_or(from)
    };
    let one = farthest(&[0.0; DEVIATOR_COMPONENTS]);
    let other = farthest(&one);
    let middle: Isometric = std::array::from_fn(|k| 0.5 * (one[k] + other[k]));
    distance(&middle, &farthest(&middle)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const YIELD: f64 = 500.0;

    fn limits(across: Option<f64>, frictions: &[f64]) -> Vec<[f64; 2]> {
        let contact = SlidingContact { along: 0.4, across, poisson: 0.3 };
        let over_k = 3f64.sqrt() / YIELD;
        let found = contact.limits(frictions, |_| YIELD, |_| [0.0; 2]);
        found
            .into_iter()
            .map(|limit| [limit.elastic, limit.kinematic].map(|p| p * over_k))
            .collect()
    }

    #[track_caller]
    fn near(found: f64, expected: f64, tolerance: f64) {
        assert!((found / expected - 1.0).abs() < tolerance, "{found} for {expected}");
    }

    /// Kinematic limits of `docs/theory_rolling.md`, and the first yield of a line, 3.10 k. From a
    /// friction of 0.3 on the surface decides: σxx between ±2 μ p0 there, in plane strain.
    #[test]
    fn a_line_has_the_limits_of_its_layers() {
        let found = limits(None, &[0.0, 0.1, 0.2, 0.3, 0.4]);
        for ([_, kinematic], expected) in found.iter().zip([4.00, 3.98, 3.94]) {
            near(*kinematic, expected, 0.01);
        }
        near(found[0][0], 3.10, 0.01);
        let of_surface = |friction: f64| 3f64.sqrt() / (0.79f64.sqrt() * 2.0 * friction);
        near(found[3][1], of_surface(0.3), 0.04);
        near(found[4][1], of_surface(0.4), 0.04);
        // Within the contact the traction adds to σxx.
        assert!(found[4][0] < of_surface(0.4), "{found:?}");
        assert!(found.windows(2).all(|pair| pair[1][0] <= pair[0][0]), "{found:?}");
    }

    /// A ball yields from 1.60 σ_y on; an ellipse that is long across the travel is a line.
    #[test]
    fn ellipses_lie_between_balls_and_lines() {
        let ball = limits(Some(0.4), &[0.0, 0.2, 0.4]);
        near(ball[0][0], 1.60 * 3f64.sqrt(), 0.015);
        let (long, line) = (limits(Some(8.0), &[0.0, 0.4]), limits(None, &[0.0, 0.4]));
        for (long, line) in long.iter().zip(&line) {
            near(long[0], line[0], 0.04);
            near(long[1], line[1], 0.04);
        }
        for [elastic, kinematic] in ball.iter().chain(&long) {
            assert!(elastic < kinematic, "{ball:?} {long:?}");
        }
    }

    /// A pressure that the initial stress raises to the yield stress leaves nothing.
    #[test]
    fn initial_stress_enters_first_yield_alone() {
        let contact = SlidingContact { along: 0.4, across: Some(0.6), poisson: 0.3 };
        let with = |initial: f64| contact.limits(&[0.1], |_| YIELD, |_| [initial; 2])[0];
        let (none, pressed, full) = (with(0.0), with(-200.0), with(-500.0));
        assert!(pressed.elastic > none.elastic && full.elastic < 0.01 * none.elastic);
        assert_eq!(none.kinematic.to_bits(), pressed.kinematic.to_bits());
    }
}
