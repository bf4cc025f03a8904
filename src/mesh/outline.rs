//! The undeformed outline of a body, as the mesh generator and the gap function see it.

use crate::model::Shape;

/// Surface, width and depth of a body in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    surface: Surface,
    /// Largest |x| on the contact surface \[mm\].
    half_span: f64,
    /// Depth of the far boundary below the origin \[mm\].
    depth: f64,
}

#[derive(Debug, Clone, PartialEq)]
enum Surface {
    /// Circular arc through the origin with curvature κ \[1/mm\]: convex positive, flat 0, concave negative.
    Arc { curvature: f64 },
}

impl Outline {
    /// Outline of a shape of the job.
    pub fn of(shape: &Shape) -> Self {
        match shape {
            Shape::Cylinder { radius } => Self {
                surface: Surface::Arc { curvature: radius.get().recip() },
                half_span: radius.get(),
                depth: radius.get(),
            },
            Shape::Block { width, depth } => Self {
                surface: Surface::Arc { curvature: 0.0 },
                half_span: 0.5 * width.get(),
                depth: depth.get(),
            },
            Shape::Groove(groove) => Self {
                surface: Surface::Arc { curvature: -groove.radius().get().recip() },
                half_span: 0.5 * groove.width().get(),
                depth: groove.depth().get(),
            },
            Shape::Profile(_) => unreachable!("profiles are refused before meshing"),
        }
    }

    /// Height of the surface over the tangent at the origin, along the outward normal \[mm\]; a convex surface
    /// falls below zero.
    pub fn height(&self, x: f64) -> f64 {
        match self.surface {
            // -R + √(R² - x²), written without cancellation for x << R.
            Surface::Arc { curvature } => {
                let slope = (curvature * x).clamp(-1.0, 1.0);
                -curvature * x * x / (1.0 + (1.0 - slope * slope).sqrt())
            }
        }
    }

    /// Curvature of the surface at the origin \[1/mm\], convex positive.
    pub fn curvature(&self) -> f64 {
        match self.surface {
            Surface::Arc { curvature } => curvature,
        }
    }

    /// Largest |x| on the contact surface \[mm\].
    pub fn half_span(&self) -> f64 {
        self.half_span
    }

    /// Depth of the far boundary below the origin \[mm\].
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Whether the outline equals its mirror image in x = 0.
    pub fn is_symmetric(&self) -> bool {
        match self.surface {
            Surface::Arc { .. } => true,
        }
    }

    /// Point of the free surface at distance `radius` from `centre`, on the side of `sign`, by bisection along
    /// the surface; the distance must lie between those of the contact zone's edge and of the surface's end.
    pub(super) fn surface_point_at(&self, centre: [f64; 2], radius: f64, sign: f64) -> [f64; 2] {
        // Equal angles of the arc for equal steps of t, so that the end of a cylinder, where the surface is
        // parallel to y, is resolved as well as the bottom.
        let point = |t: f64| -> [f64; 2] {
            let x = match self.surface {
                Surface::Arc { curvature } => {
                    let end = (curvature * self.half_span).clamp(-1.0, 1.0);
                    if end == 0.0 { t * self.half_span } else { (t * end.asin()).sin() / curvature }
                }
            };
            [sign * x, self.height(sign * x)]
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let [x, y] = point(middle);
            if (x - centre[0]).hypot(y - centre[1]) < radius && (x - centre[0]) * sign >= 0.0
                || (x - centre[0]) * sign < 0.0
            {
                low = middle;
            } else {
                high = middle;
            }
        }
        point(0.5 * (low + high))
    }
}
