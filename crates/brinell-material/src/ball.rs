//! The smallest ball round the path of a stress.

/// A point of a path of deviators, in coordinates whose sum of squares is a norm.
type Point<const D: usize> = [f64; D];

/// A ball among the points of D coordinates, in their unit.
#[derive(Debug, Clone, Copy)]
pub struct Ball<const D: usize> {
    /// Its centre.
    pub centre: Point<D>,
    /// Its radius.
    pub radius: f64,
}

impl<const D: usize> Ball<D> {
    fn distance(&self, point: &Point<D>) -> f64 {
        distance(&self.centre, point)
    }
}

fn distance<const D: usize>(a: &Point<D>, b: &Point<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// Relative excess that is rounding.
const ROUNDING: f64 = 1e-12;
/// Balls that are tried; each is larger than the one before, and ten are usual.
const MOST_BALLS: usize = 200;

/// The smallest ball round points: that of a few of them, to which the farthest point is added
/// until none lies outside. Without points it is the origin.
pub fn smallest_ball<const D: usize>(points: &[Point<D>]) -> Ball<D> {
    let Some(first) = points.first() else { return Ball { centre: [0.0; D], radius: 0.0 } };
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

/// The smallest ball round at most `D + 2` points; leaves those that it needs.
fn ball_of_few<const D: usize>(points: &mut Vec<Point<D>>) -> Ball<D> {
    let mut best: Option<(Ball<D>, u32)> = None;
    for subset in 1u32..1 << points.len() {
        if subset.count_ones() as usize > D + 1 {
            continue;
        }
        let chosen: Vec<Point<D>> =
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
fn through<const D: usize>(points: &[Point<D>]) -> Option<Ball<D>> {
    let (first, others) = points.split_first()?;
    let n = others.len();
    let mut d = [[0.0; D]; D];
    for (d, point) in d.iter_mut().zip(others) {
        *d = std::array::from_fn(|k| point[k] - first[k]);
    }
    let dot = |a: &Point<D>, b: &Point<D>| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // At most D equations, by elimination with pivots.
    let mut rows: [(Point<D>, f64); D] = std::array::from_fn(|i| {
        (std::array::from_fn(|j| 2.0 * dot(&d[i], &d[j])), dot(&d[i], &d[i]))
    });
    let scale = rows.iter().map(|(_, right)| *right).fold(0.0, f64::max);
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| rows[*a].0[k].abs().total_cmp(&rows[*b].0[k].abs()))?;
        rows.swap(k, pivot);
        let (reduced, right) = rows[k];
        if reduced[k].abs() <= ROUNDING * scale {
            return None;
        }
        for (_, (row, side)) in rows[..n].iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k] / reduced[k];
            for (value, of_pivot) in row.iter_mut().zip(reduced).skip(k) {
                *value -= factor * of_pivot;
            }
            *side -= factor * right;
        }
    }
    let mut centre = *first;
    for (i, d) in d[..n].iter().enumerate() {
        let lambda = rows[i].1 / rows[i].0[i];
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
        assert!(smallest_ball::<3>(&[]).radius <= 0.0);
        assert!(smallest_ball(&[[3.0, 1.0, 2.0]; 4]).radius <= 0.0);
        let segment = smallest_ball(&[[0.0; 3], [1.0, 0.0, 0.0], [4.0, 0.0, 0.0]]);
        assert!((segment.radius - 2.0).abs() < 1e-12, "{segment:?}");
        // An obtuse triangle has the ball of its longest side.
        let obtuse = smallest_ball(&[[0.0; 3], [4.0, 0.0, 0.0], [2.0, 0.5, 0.0]]);
        assert!((obtuse.radius - 2.0).abs() < 1e-12, "{obtuse:?}");
        let equilateral = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!((smallest_ball(&equilateral).radius - (2.0f64 / 3.0).sqrt()).abs() < 1e-12);
        let cube: Vec<Point<3>> =
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
        let points: Vec<Point<3>> = (0..400).flat_map(|k| [of(k, 2.0), of(k, 1.1)]).collect();
        let ball = smallest_ball(&points);
        assert!((ball.radius - 2.0).abs() < 1e-9, "{ball:?}");
    }
}
