//! The outlines of the shapes of a job.

use crate::fem::mesh::{FarBoundary, Outline};
use crate::job::{
    Block, Cone, Cylinder, Ellipse, Groove, Interpolation, Parabola, Power, Profile, Punch, Shape,
    Sphere, Wedge,
};

/// Outline of a shape.
pub fn outline_of(shape: &Shape) -> Outline {
    match shape {
        Shape::Cylinder(Cylinder { radius }) | Shape::Sphere(Sphere { radius, .. }) => {
            Outline::arc(radius.get().recip(), radius.get(), radius.get())
        }
        Shape::Block(Block { width, depth }) => Outline::arc(0.0, 0.5 * width.get(), depth.get()),
        Shape::Groove(Groove { radius, width, depth }) => {
            Outline::arc(-radius.get().recip(), 0.5 * width.get(), depth.get())
        }
        Shape::Hole(hole) => {
            let radius = hole.radius.get();
            Outline::arc(-radius.recip(), radius, hole.wall())
        }
        Shape::Profile(Profile { points, depth, interpolation }) => {
            let is_smooth = *interpolation != Some(Interpolation::Linear);
            Outline::through(points, is_smooth, depth.get())
        }
        Shape::Wedge(Wedge { angle, tip_radius, width, depth })
        | Shape::Cone(Cone { angle, tip_radius, width, depth }) => {
            let (slope, tip) = (angle.get().to_radians().tan(), tip_radius.map_or(0.0, f64::from));
            Outline::wedge(slope, tip, width.get(), depth.get())
        }
        Shape::Punch(Punch { width, edge_radius, depth }) => {
            let edge = edge_radius.map_or(0.0, f64::from);
            Outline::punch(0.5 * width.get(), edge, depth.get())
        }
        Shape::Parabola(Parabola { radius, width, depth }) => {
            Outline::power(2.0, 2.0 * radius.get(), width.get(), depth.get())
        }
        Shape::Ellipse(Ellipse { semi_axis_x, semi_axis_y }) => {
            Outline::ellipse([semi_axis_x.get(), semi_axis_y.get()])
        }
        Shape::Power(Power { exponent, scale, width, depth }) => {
            Outline::power(*exponent, scale.get(), width.get(), depth.get())
        }
        // The section along x of a half-space, which no analysis meshes.
        Shape::Curved(_) | Shape::Roller(_) | Shape::Flat(_) => {
            let [curvature, ..] = shape.curvatures().unwrap_or_default();
            Outline::arc(curvature, curvature.abs().recip(), f64::INFINITY)
        }
    }
}

/// Outlines of both bodies of a job: those of a pin and its hole know of each other.
pub(crate) fn outlines_of(shapes: [&Shape; 2]) -> [Outline; 2] {
    let outlines = shapes.map(outline_of);
    let radius = |shape: &Shape| match shape {
        Shape::Hole(hole) => Some(-hole.radius.get()),
        shape => shape.round_radius(),
    };
    let held = shapes.into_iter().find_map(|shape| match shape {
        Shape::Hole(hole) => {
            let square = hole.width.map(|width| FarBoundary::Square(0.5 * width.get()));
            square.or(hole.outer_radius.map(|radius| FarBoundary::Circle(radius.get())))
        }
        _ => None,
    });
    match (shapes.map(radius), held) {
        ([Some(upper), Some(lower)], Some(held)) if upper * lower < 0.0 => {
            Outline::as_pin_and_hole(outlines, [upper, lower], held)
        }
        _ => outlines,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_sphere_has_the_outline_of_the_cylinder_that_turns_to_it() {
        let [sphere, cylinder] = ["sphere", "cylinder"].map(|word| {
            let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
            let job = json!({
                "analysis": "axisymmetric",
                "upper": {"shape": {"type": word, "radius": 10}, "material": steel},
                "lower": {"shape": {"type": "hole", "radius": 10.1, "outer_radius": 40},
                    "material": steel},
                "load": {"force": 100},
            });
            let job = crate::job::Job::from_value(&job).unwrap();
            outlines_of([&job.upper.shape, &job.lower.shape])
        });
        assert_eq!(sphere, cylinder);
    }
}
