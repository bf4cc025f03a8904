//! Undeformed outlines. Each file holds one shape, or a few similar ones: the dimensions with
//! their table, and the conditions between them.
//!
//! Every shape has its own frame: the contact starts at the origin, `x` is tangential, and heights
//! are positive along the outward normal. Both bodies follow this convention, so that an exchange
//! of `upper` and `lower` mirrors the problem.

mod block;
mod cylinder;
mod groove;
mod hole;
mod power;
mod profile;
mod punch;
mod quadric;
mod roller;
mod wedge;

pub use block::Block;
pub use cylinder::Cylinder;
pub use groove::Groove;
pub use hole::Hole;
pub use power::{Ellipse, Parabola, Power};
pub use profile::{Interpolation, Profile};
pub use punch::Punch;
pub use quadric::{Curved, Flat, Sphere};
pub use roller::{Roller, RollerProfile};
pub use wedge::{Cone, Wedge};

use super::Analysis;
use super::fields::tagged;

tagged! {
    /// The undeformed outline of a body.
    pub enum Shape by "type" {
        Cylinder, Block, Groove, Hole, Profile, Wedge, Cone, Punch, Parabola, Ellipse, Power, Sphere, Curved,
        Roller, Flat
    }
}

impl Shape {
    /// Returns the radius of a cylinder or a ball \[mm\]; `None` for other shapes.
    pub fn round_radius(&self) -> Option<f64> {
        match self {
            Self::Cylinder(Cylinder { radius }) | Self::Sphere(Sphere { radius, .. }) => {
                Some(radius.get())
            }
            _ => None,
        }
    }

    /// Returns the name of the shape in an analysis: a cylinder of revolution is a sphere.
    pub fn label(&self, analysis: Analysis) -> &'static str {
        match (analysis, self) {
            (Analysis::Axisymmetric, Self::Cylinder(_)) => "Sphere",
            (Analysis::Axisymmetric, Self::Hole(_)) => "Socket",
            _ => self.table().label,
        }
    }

    /// Returns the curvatures `[k_xx, k_yy, k_xy]` of a half-space's surface in the contact plane,
    /// positive where convex \[1/mm\]; `None` for other shapes.
    pub fn curvatures(&self) -> Option<[f64; 3]> {
        match self {
            Self::Sphere(Sphere { radius, .. }) => {
                Some([radius.get().recip(), radius.get().recip(), 0.0])
            }
            Self::Curved(curved) => Some(curved.curvatures()),
            Self::Roller(roller) => Some(turned(roller.curvatures(), roller.rotation)),
            Self::Flat(_) => Some([0.0; 3]),
            _ => None,
        }
    }
}

/// Returns the curvatures `[k_xx, k_yy, k_xy]` of a surface with these principal curvatures,
/// turned by an angle in degrees.
fn turned([along, across]: [f64; 2], rotation: Option<f64>) -> [f64; 3] {
    let (mean, half) = (0.5 * (along + across), 0.5 * (along - across));
    let (sine, cosine) = (2.0 * rotation.unwrap_or(0.0)).to_radians().sin_cos();
    [mean + half * cosine, mean - half * cosine, half * sine]
}
