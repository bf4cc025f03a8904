//! The wedge and the cone.

use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

/// Largest angle of the flanks to the tangential plane \[degrees\].
const MAX_ANGLE: f64 = 60.0;

record! {
    /// Two plane flanks that meet in a tip; only in plane analyses.
    #[derive(Copy)]
    pub struct Wedge("wedge", "Wedge") where rules {
        /// Angle β of the flanks to the tangential plane, in degrees.
        pub angle: PositiveF64 = Field::pure(0.001..=MAX_ANGLE).label("Angle of the flanks", "β").example(5.0),
        /// Radius of the tip; sharp if it is left out.
        pub tip_radius: Option<PositiveF64> = Field::quantity(Domain::Length).label("Tip radius", "ρ"),
        /// Full width.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(40.0),
        /// From the tip to the base, more than the height of the flanks.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

record! {
    /// A flank of revolution that ends in a tip; only in axisymmetry.
    #[derive(Copy)]
    pub struct Cone("cone", "Cone") where rules {
        /// Angle β of the flank to the tangential plane, in degrees.
        pub angle: PositiveF64 = Field::pure(0.001..=MAX_ANGLE).label("Angle of the flank", "β").example(5.0),
        /// Radius of the tip; sharp if it is left out.
        pub tip_radius: Option<PositiveF64> = Field::quantity(Domain::Length).label("Tip radius", "ρ"),
        /// Diameter of the base.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Diameter", "w").example(40.0),
        /// From the tip to the base, more than the height of the flank.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

/// Refuses a tip arc that does not end on the flanks, and flanks that end below the base.
fn rules(known: &Known) -> Vec<FieldError> {
    let (Some(angle), Some(width)) = (known.figure("angle"), known.figure("width")) else {
        return Vec::new();
    };
    let (half, angle) = (0.5 * width, angle.to_radians());
    let rounded = known.figure("tip_radius").is_none_or(|radius| radius * angle.sin() < half);
    let above = known.figure("depth").is_none_or(|depth| half * angle.tan() < depth);
    let on_flanks = unless(
        rounded,
        "/tip_radius",
        "must end on the flanks, `tip_radius` sin(`angle`) < `width`/2",
    );
    let thick =
        unless(above, "/depth", "must exceed the height of the flanks, `width`/2 tan(`angle`)");
    on_flanks.into_iter().chain(thick).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::fields::faults_of;

    #[test]
    fn a_wedge_has_flanks_above_its_base() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let faults = |angle: f64, tip_radius: Option<f64>, width: f64, depth: f64| {
            let (angle, tip_radius) = (mm(angle), tip_radius.map(mm));
            let wedge = Wedge { angle, tip_radius, width: mm(width), depth: mm(depth) };
            faults_of(&wedge, &[]).into_iter().map(|fault| fault.pointer).collect::<Vec<_>>()
        };
        assert!(faults(5.0, None, 20.0, 10.0).is_empty());
        assert!(faults(5.0, Some(3.0), 20.0, 10.0).is_empty());
        assert_eq!(faults(61.0, None, 20.0, 50.0), ["/angle"]);
        assert_eq!(faults(45.0, Some(20.0), 20.0, 9.0), ["/tip_radius", "/depth"]);
    }
}
