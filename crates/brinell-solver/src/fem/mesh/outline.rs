//! The undeformed outline of a body, as the mesh generator and the gap function see it.

use super::interpolation::MonotoneCubic;
use crate::job::{Block, Cylinder, Shape};

/// Surface, width and depth of a body in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    surface: Surface,
    /// Least and greatest x on the contact surface \[mm\].
    span: (f64, f64),
    /// Depth of the far boundary below the origin \[mm\].
    depth: f64,
}

#[derive(Debug, Clone, PartialEq)]
enum Surface {
    /// Circular arc through the origin with curvature κ \[1/mm\]: convex positive, flat 0, concave negative.
    Arc { curvature: f64 },
    /// Through points.
    Points(MonotoneCubic),
}

impl Outline {
    /// Outline of a shape of the job.
    pub fn of(shape: &Shape) -> Self {
        match shape {
            Shape::Cylinder(Cylinder { radius }) => {
                Self::arc(radius.get().recip(), radius.get(), radius.get())
            }
            Shape::Block(Block { width, depth }) => Self::arc(0.0, 0.5 * width.get(), depth.get()),
            Shape::Groove(groove) => {
                Self::arc(-groove.radius().get().recip(), 0.5 * groove.width().get(), groove.depth().get())
            }
            Shape::Profile(profile) => {
                let curve = MonotoneCubic::new(whole_face(profile.points()));
                let span = curve.range();
                Self { surface: Surface::Points(curve), span, depth: profile.depth().get() }
            }
        }
    }

    fn arc(curvature: f64, half_span: f64, depth: f64) -> Self {
        Self { surface: Surface::Arc { curvature }, span: (-half_span, half_span), depth }
    }

    /// Height of the surface over the tangent at the origin, along the outward normal \[mm\]; a convex surface
    /// falls below zero.
    pub fn height(&self, x: f64) -> f64 {
        match &self.surface {
            // -R + √(R² - x²), written without cancellation for x << R.
            Surface::Arc { curvature } => {
                let slope = (curvature * x).clamp(-1.0, 1.0);
                -curvature * x * x / (1.0 + (1.0 - slope * slope).sqrt())
            }
            Surface::Points(curve) => curve.value(x),
        }
    }

    /// Curvature of the surface at the origin \[1/mm\], convex positive; `None` where the surface is no arc.
    pub fn curvature(&self) -> Option<f64> {
        match self.surface {
            Surface::Arc { curvature } => Some(curvature),
            Surface::Points(_) => None,
        }
    }

    /// Least and greatest x on the contact surface \[mm\].
    pub fn span(&self) -> (f64, f64) {
        self.span
    }

    /// Depth of the far boundary below the origin \[mm\].
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Whether the outline equals its mirror image in x = 0.
    pub fn is_symmetric(&self) -> bool {
        match &self.surface {
            Surface::Arc { .. } => true,
            Surface::Points(curve) => curve.is_even(),
        }
    }

    /// End of the surface on the side of `sign`.
    pub(super) fn end(&self, sign: f64) -> [f64; 2] {
        let x = if sign > 0.0 { self.span.1 } else { self.span.0 };
        [x, self.height(x)]
    }

    /// Point of the free surface at distance `radius` from `centre`, on the side of `sign`, by bisection along
    /// the surface; the distance must lie between those of the contact zone's edge and of the surface's end.
    pub(super) fn surface_point_at(&self, centre: [f64; 2], radius: f64, sign: f64) -> [f64; 2] {
        let end = self.end(sign)[0];
        let point = |t: f64| -> [f64; 2] {
            let x = match &self.surface {
                // Equal angles for equal steps of t, so that the end of a cylinder, where the surface is parallel
                // to y, is resolved as well as the bottom.
                Surface::Arc { curvature } if *curvature != 0.0 => {
                    (t * (curvature * end).clamp(-1.0, 1.0).asin()).sin() / curvature
                }
                Surface::Arc { .. } => t * end,
                Surface::Points(_) => centre[0] + t * (end - centre[0]),
            };
            [x, self.height(x)]
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let [x, y] = point(middle);
            let is_behind = (x - centre[0]) * sign < 0.0;
            if is_behind || (x - centre[0]).hypot(y - centre[1]) < radius {
                low = middle;
            } else {
                high = middle;
            }
        }
        point(0.5 * (low + high))
    }
}

/// Points from end to end: a face given from x = 0 to one side is completed by its mirror image.
fn whole_face(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mirrored = |[x, y]: &[f64; 2]| [-x, *y];
    match points {
        [[0.0, _], right @ ..] => right.iter().rev().map(mirrored).chain(points.iter().copied()).collect(),
        [left @ .., [0.0, _]] => points.iter().copied().chain(left.iter().rev().map(mirrored)).collect(),
        _ => points.to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{PositiveF64, Profile};

    fn outline(points: &[[f64; 2]]) -> Outline {
        let depth = PositiveF64::new(10.0).unwrap();
        Outline::of(&Shape::Profile(Profile::new(points.to_vec(), depth).unwrap()))
    }

    #[test]
    fn half_a_face_is_completed_by_its_mirror_image() {
        let right = outline(&[[0.0, 0.0], [1.0, -0.1], [4.0, -2.0]]);
        let left = outline(&[[-4.0, -2.0], [-1.0, -0.1], [0.0, 0.0]]);
        assert_eq!(right, left);
        assert!(right.is_symmetric());
        assert_eq!(right.span(), (-4.0, 4.0));
        assert!((right.height(-2.5) - right.height(2.5)).abs() < 1e-15);
        assert!(!outline(&[[-1.0, 0.0], [3.0, 0.0]]).is_symmetric());
    }

    #[test]
    fn surface_points_lie_at_their_distance() {
        let arc = Outline::arc(0.05, 20.0, 20.0);
        for radius in [0.1, 3.0, 15.0, 28.0] {
            for sign in [-1.0, 1.0] {
                let [x, y] = arc.surface_point_at([0.0, 0.0], radius, sign);
                assert!((x.hypot(y) - radius).abs() < 1e-12 * radius.max(1.0) && x * sign > 0.0);
                assert!((y - arc.height(x)).abs() < 1e-12);
            }
        }
    }
}
