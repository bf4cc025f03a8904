//! Surfaces of half-spaces: the ball, the surface with two curvatures and the plane. They exist
//! only in three dimensions, but for the ball, which is a body of revolution too.
//!
//! Both bodies share the x and y of the contact plane.

use super::turned;
use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

/// Smallest radius of curvature \[mm\].
const MIN_RADIUS: f64 = Domain::Length.range().0;

/// The field of the rotation about the normal.
const ROTATION: Field = Field::pure(-360.0..=360.0).label("Rotation", "φ");

record! {
    /// A ball: in axisymmetry half a sphere, held at its diametral plane; in three dimensions a
    /// half-space with its curvature.
    #[derive(Copy)]
    pub struct Sphere("sphere", "Sphere") {
        /// Radius.
        pub radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(20.0),
        /// Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out.
        /// Only in three dimensions.
        pub rotation: Option<f64> = ROTATION,
    }
}

record! {
    /// A half-space whose surface has a curvature along its x and one along its y: roller,
    /// raceway, crowned part; only in three dimensions.
    #[derive(Copy)]
    pub struct Curved("curved", "Curved surface") where rules {
        /// Radius of curvature along its x; negative is concave, left out is straight.
        pub radius_x: Option<f64> = Field::quantity(Domain::Position).label("Radius along x", "R_x").example(10.0),
        /// Radius of curvature along its y; negative is concave, left out is straight.
        pub radius_y: Option<f64> = Field::quantity(Domain::Position).label("Radius along y", "R_y").example(50.0),
        /// Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is left
        /// out.
        pub rotation: Option<f64> = ROTATION,
    }
}

record! {
    /// A plane half-space; only in three dimensions.
    #[derive(Copy)]
    pub struct Flat("flat", "Plane surface") {
        /// Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out.
        pub rotation: Option<f64> = ROTATION,
    }
}

/// Refuses a radius of zero.
fn rules(known: &Known) -> Vec<FieldError> {
    let detail = "must be at least 1e-6 mm in size, negative if the surface is concave; leave it \
                  out where the surface is straight";
    let is_round = |key: &str| known.figure(key).is_none_or(|radius| radius.abs() >= MIN_RADIUS);
    let of = |key: &str| unless(is_round(key), &format!("/{key}"), detail);
    [of("radius_x"), of("radius_y")].into_iter().flatten().collect()
}

impl Curved {
    /// Returns the curvatures `[k_xx, k_yy, k_xy]` of the surface in the contact plane, positive
    /// where convex \[1/mm\]. The height of the surface is `-(k_xx x² + k_yy y² + 2 k_xy x y)/2`.
    pub fn curvatures(&self) -> [f64; 3] {
        let [along, across] =
            [self.radius_x, self.radius_y].map(|radius| radius.map_or(0.0, f64::recip));
        turned([along, across], self.rotation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curved(radius_x: f64, radius_y: Option<f64>, rotation: f64) -> [f64; 3] {
        Curved { radius_x: Some(radius_x), radius_y, rotation: Some(rotation) }.curvatures()
    }

    fn assert_near(found: [f64; 3], expected: [f64; 3]) {
        found
            .iter()
            .zip(expected)
            .for_each(|(a, b)| assert!((a - b).abs() < 1e-15, "{found:?} {expected:?}"));
    }

    #[test]
    fn curvatures_turn_with_the_body() {
        assert_near(curved(10.0, Some(-40.0), 0.0), [0.1, -0.025, 0.0]);
        assert_near(curved(10.0, Some(-40.0), 90.0), [-0.025, 0.1, 0.0]);
        // A cylinder whose axis is turned by 45°.
        assert_near(curved(10.0, None, 45.0), [0.05, 0.05, 0.05]);
        // The height falls fastest along the turned x.
        let [xx, yy, xy] = curved(10.0, None, 30.0);
        let (sine, cosine) = 30_f64.to_radians().sin_cos();
        let along = xx * cosine * cosine + yy * sine * sine + 2.0 * xy * sine * cosine;
        assert!((along - 0.1).abs() < 1e-15);
    }
}
