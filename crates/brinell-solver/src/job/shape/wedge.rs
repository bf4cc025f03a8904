//! The wedge and the cone.

use crate::job::fields::{Field, Known, faults_of, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

/// Largest angle of the flanks to the tangential plane \[degrees\].
const MAX_ANGLE: f64 = 60.0;

record! {
    /// Two plane flanks that meet in a tip; only in plane analyses.
    #[derive(Copy)]
    pub struct Wedge("wedge", "Wedge") where rules {
        /// Angle β of the flanks to the tangential plane, in degrees.
        angle: PositiveF64 = Field::pure(0.001..=MAX_ANGLE).label("Angle of the flanks", "β").example(5.0),
        /// Radius of the tip; sharp if it is left out.
        tip_radius: Option<PositiveF64> = Field::quantity(Domain::Length).label("Tip radius", "ρ"),
        /// Full width.
        width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(40.0),
        /// From the tip to the base, more than the height of the flanks.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

record! {
    /// A flank of revolution that ends in a tip; only in axisymmetry.
    #[derive(Copy)]
    pub struct Cone("cone", "Cone") where rules {
        /// Angle β of the flank to the tangential plane, in degrees.
        angle: PositiveF64 = Field::pure(0.001..=MAX_ANGLE).label("Angle of the flank", "β").example(5.0),
        /// Radius of the tip; sharp if it is left out.
        tip_radius: Option<PositiveF64> = Field::quantity(Domain::Length).label("Tip radius", "ρ"),
        /// Diameter of the base.
        width: PositiveF64 = Field::quantity(Domain::Length).label("Diameter", "w").example(40.0),
        /// From the tip to the base, more than the height of the flank.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
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

macro_rules! flanks {
    ($name:ident) => {
        impl $name {
            /// Builds the shape from the angle between flanks and tangential plane \[degrees\],
            /// the radius of the tip or none for a sharp tip, the full width, and the depth from
            /// the tip to the base \[mm\].
            ///
            /// # Errors
            /// Every fault, with a pointer relative to the shape.
            pub fn new(
                angle: PositiveF64,
                tip_radius: Option<PositiveF64>,
                width: PositiveF64,
                depth: PositiveF64,
            ) -> Result<Self, Vec<FieldError>> {
                let shape = Self { angle, tip_radius, width, depth };
                let faults = faults_of(&shape, &[]);
                if faults.is_empty() { Ok(shape) } else { Err(faults) }
            }

            /// Returns the slope of the flanks, the tangent of the angle.
            pub fn slope(&self) -> f64 {
                self.angle.get().to_radians().tan()
            }

            /// Returns the radius of the tip \[mm\]; 0 for a sharp tip.
            pub fn tip_radius(&self) -> f64 {
                self.tip_radius.map_or(0.0, f64::from)
            }

            /// Returns the full width \[mm\].
            pub const fn width(&self) -> PositiveF64 {
                self.width
            }

            /// Returns the depth from the tip to the base \[mm\].
            pub const fn depth(&self) -> PositiveF64 {
                self.depth
            }
        }
    };
}

flanks!(Wedge);
flanks!(Cone);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wedge_has_flanks_above_its_base() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let faults = |angle: f64, radius: Option<f64>, width: f64, depth: f64| {
            let built = Wedge::new(mm(angle), radius.map(mm), mm(width), mm(depth));
            built.map_or_else(
                |faults| faults.into_iter().map(|fault| fault.pointer).collect(),
                |_| Vec::new(),
            )
        };
        assert!(faults(5.0, None, 20.0, 10.0).is_empty());
        assert!(faults(5.0, Some(3.0), 20.0, 10.0).is_empty());
        assert_eq!(faults(61.0, None, 20.0, 50.0), ["/angle"]);
        assert_eq!(faults(45.0, Some(20.0), 20.0, 9.0), ["/tip_radius", "/depth"]);
    }
}
