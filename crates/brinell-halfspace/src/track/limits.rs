//! Limits of shakedown of a track, from its elastic stresses.
//!
//! Residual stress of a uniform track is `(σxx, σyy)(z)` alone. It cannot touch σxz, so that a
//! perfectly plastic layer shakes down only while `max |σxz| <= k`. A backstress without bound may
//! be any deviator: then a layer shakes down if and only if the path of `dev σ(x)` fits into a ball
//! of radius σ_y, in the norm of von Mises.
//!
//! # Reference
//! K. L. Johnson, *Contact Mechanics* (1985), section 9.2; A. R. S. Ponter, *A general shakedown
//! theorem for elastic/plastic bodies with work hardening*, Proc. 3rd Int. Conf. Struct. Mech.
//! Reactor Technol. (1975), for balls as elastic domains that move.

use super::body::ISOMETRIC;
use super::figures::AtDepth;
use super::space::TrackSpace;
use super::sweep::ROWS;
use crate::stop::{Stop, Stopped};

/// Load factors of layers, the least of which is the limit of the track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackLimits {
    /// Factor of the pressure up to which perfect plasticity shakes down on these layers, and the
    /// layer that decides: `min k/max|σxz|`.
    ///
    /// Stresses of layers are means over them. The limit lies above that of a continuum, by 1.1,
    /// 0.3 and 0.08 % at 10, 20 and 40 columns a half-width.
    pub perfect: AtDepth,
    /// The same with kinematic hardening without bound: σ_y over the radius of the smallest ball.
    pub kinematic: AtDepth,
}

impl TrackLimits {
    /// Limits under a pressure in the window \[MPa\], with a traction μ p, for a yield stress of
    /// each layer \[MPa\].
    ///
    /// # Errors
    /// [`Stopped`].
    pub fn new(
        space: &TrackSpace,
        pressure: &[f64],
        friction: f64,
        yield_stress: impl Fn(usize) -> f64,
        stop: &mut Stop<'_>,
    ) -> Result<Self, Stopped> {
        let n = space.grid().n_columns();
        let mut stress = vec![0.0; space.field_len()];
        space.stress(pressure, friction, &mut space.work(), &mut stress, stop)?;
        let none = AtDepth { value: f64::INFINITY, ..AtDepth::default() };
        let mut limits = Self { perfect: none, kinematic: none };
        for (layer, rows) in stress.chunks_exact(ROWS * n).enumerate() {
            let strength = yield_stress(layer);
            let (xx, rest) = rows.split_at(n);
            let (zz, xz) = rest.split_at(n);
            let shear = xz.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            let path = xx.iter().zip(zz).zip(xz).map(|((xx, zz), xz)| {
                let values = [xx + zz, xx - zz, *xz];
                std::array::from_fn(|k| 1.5f64.sqrt() * ISOMETRIC[k] * values[k])
            });
            let radius = smallest_ball(&path.collect::<Vec<_>>()).radius;
            for (limit, value) in [
                (&mut limits.perfect, strength / (3f64.sqrt() * shear)),
                (&mut limits.kinematic, strength / radius),
            ] {
                if value < limit.value {
                    *limit =
                        AtDepth { value, depth: space.layers().middle(layer), across: 0.0, layer };
                }
            }
        }
        Ok(limits)
    }
}

type Point = [f64; 3];

#[derive(Debug, Clone, Copy)]
struct Ball {
    centre: Point,
    radius: f64,
}

impl Ball {
    fn distance(&self, point: &Point) -> f64 {
        distance(&self.centre, point)
    }
}

fn distance(a: &Point, b: &Point) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Relative excess that is rounding.
const ROUNDING: f64 = 1e-12;
/// Balls that are tried; each is larger than the one before, and ten are usual.
const MOST_BALLS: usize = 200;

/// The smallest ball round points: that of a few of them, to which the farthest point is added
/// until none lies outside.
fn smallest_ball(points: &[Point]) -> Ball {
    let Some(first) = points.first() else { return Ball { centre: [0.0; 3], radius: 0.0 } };
    let mut ball = Ball { centre: *first, radius: 0.0 };
    let mut support = vec![*first];
    for _ in 0..MOST_BALLS {
        let farthest = points
            .iter()
            .max_by(|a, b| ball.distance(a).total_cmp(&ball.distance(b)))
            .unwrap_or(first);
        if ball.distance(farthest) <= ball.radius * (1.0 + ROUNDING) {
            break;
        }
        support.push(*farthest);
        ball = ball_of_few(&mut support);
    }
    ball
}

/// The smallest ball round at most five points; leaves those that it needs.
fn ball_of_few(points: &mut Vec<Point>) -> Ball {
    let mut best: Option<(Ball, u32)> = None;
    for subset in 1u32..1 << points.len() {
        if subset.count_ones() > 4 {
            continue;
        }
        let chosen: Vec<Point> =
            (0..points.len()).filter(|k| subset & (1 << k) != 0).map(|k| points[k]).collect();
        let Some(ball) = through(&chosen) else { continue };
        let holds = points.iter().all(|p| ball.distance(p) <= ball.radius * (1.0 + 1e-10));
        if holds && best.is_none_or(|(best, _)| ball.radius < best.radius) {
            best = Some((ball, subset));
        }
    }
    let (ball, subset) = best.unwrap_or((Ball { centre: points[0], radius: 0.0 }, 1));
    let mut k = 0;
    points.retain(|_| {
        k += 1;
        subset & (1 << (k - 1)) != 0
    });
    ball
}

/// The smallest ball with all these points on its surface, if there is one.
///
/// Its centre is `p_0 + Σ λ_i d_i`, `d_i = p_i - p_0`, with `2 Σ_j (d_i·d_j) λ_j = d_i·d_i`.
fn through(points: &[Point]) -> Option<Ball> {
    let (first, others) = points.split_first()?;
    let d: Vec<Point> = others.iter().map(|p| std::array::from_fn(|k| p[k] - first[k])).collect();
    let dot = |a: &Point, b: &Point| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let n = d.len();
    // At most three equations, by elimination with pivots.
    let mut rows: Vec<[f64; 4]> = (0..n)
        .map(|i| {
            let mut row = [0.0; 4];
            for j in 0..n {
                row[j] = 2.0 * dot(&d[i], &d[j]);
            }
            row[3] = dot(&d[i], &d[i]);
            row
        })
        .collect();
    let scale = rows.iter().map(|row| row[3]).fold(0.0, f64::max);
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))?;
        rows.swap(k, pivot);
        if rows[k][k].abs() <= ROUNDING * scale {
            return None;
        }
        let reduced = rows[k];
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / reduced[k];
            for (value, of_pivot) in row.iter_mut().zip(reduced).skip(k) {
                *value -= factor * of_pivot;
            }
        }
    }
    let mut centre = *first;
    for (i, d) in d.iter().enumerate() {
        let lambda = rows[i][3] / rows[i][i];
        for (c, d) in centre.iter_mut().zip(d) {
            *c += lambda * d;
        }
    }
    Some(Ball { centre, radius: distance(&centre, first) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn balls_of_points_whose_ball_is_known() {
        assert!(smallest_ball(&[]).radius <= 0.0);
        assert!(smallest_ball(&[[3.0, 1.0, 2.0]; 4]).radius <= 0.0);
        let segment = smallest_ball(&[[0.0; 3], [1.0, 0.0, 0.0], [4.0, 0.0, 0.0]]);
        assert!((segment.radius - 2.0).abs() < 1e-12, "{segment:?}");
        // An obtuse triangle has the ball of its longest side.
        let obtuse = smallest_ball(&[[0.0; 3], [4.0, 0.0, 0.0], [2.0, 0.5, 0.0]]);
        assert!((obtuse.radius - 2.0).abs() < 1e-12, "{obtuse:?}");
        let equilateral = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!((smallest_ball(&equilateral).radius - (2.0f64 / 3.0).sqrt()).abs() < 1e-12);
        let cube: Vec<Point> =
            (0..8u8).map(|k| std::array::from_fn(|b| f64::from(k >> b & 1))).collect();
        assert!((smallest_ball(&cube).radius - 0.75f64.sqrt()).abs() < 1e-12);
    }

    /// Points on a sphere and many inside it.
    #[test]
    fn a_ball_of_many_points_is_found() {
        let of = |k: u32, r: f64| {
            let (a, b) = (2.399_963 * f64::from(k), 1.0 - 2.0 * (f64::from(k) + 0.5) / 400.0);
            let s = (1.0 - b * b).sqrt();
            [5.0 + r * s * a.cos(), -2.0 + r * s * a.sin(), 1.0 + r * b]
        };
        let points: Vec<Point> = (0..400).flat_map(|k| [of(k, 2.0), of(k, 1.1)]).collect();
        let ball = smallest_ball(&points);
        assert!((ball.radius - 2.0).abs() < 1e-9, "{ball:?}");
    }
}
