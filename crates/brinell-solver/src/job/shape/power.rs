//! Surfaces that fall off with a power of the distance, and the ellipse.

use crate::job::fields::{Field, Known, record, unless};
use crate::job::reader::text::five_digits;
use crate::job::{Domain, FieldError, PositiveF64};

record! {
    /// A block with the surface y = −x²/2R.
    #[derive(Copy)]
    pub struct Parabola("parabola", "Parabola") where parabola_rules {
        /// Radius of curvature at the vertex.
        pub radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(20.0),
        /// Full width.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(30.0),
        /// From the vertex to the base, more than the fall of the surface at its ends.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

record! {
    /// A block with the surface y = −L (|x|/L)^n.
    #[derive(Copy)]
    pub struct Power("power", "Power law") where power_rules {
        /// Exponent n; 2 is a parabola, a large one nearly a flat punch.
        pub exponent: f64 = Field::pure(1.05..=50.0).label("Exponent", "n").example(4.0),
        /// Length L, the distance at which the surface has fallen by as much.
        pub scale: PositiveF64 = Field::quantity(Domain::Length).label("Scale", "L").example(30.0),
        /// Full width.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(30.0),
        /// From the vertex to the base, more than the fall of the surface at its ends.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

record! {
    /// Half an ellipse, held at its axis along x.
    #[derive(Copy)]
    pub struct Ellipse("ellipse", "Ellipse") {
        /// Half its extent along x.
        pub semi_axis_x: PositiveF64 = Field::quantity(Domain::Length).label("Semi-axis along x", "a_x").example(30.0),
        /// Half its extent along y.
        pub semi_axis_y: PositiveF64 = Field::quantity(Domain::Length).label("Semi-axis along y", "a_y").example(20.0),
    }
}

fn parabola_rules(known: &Known) -> Vec<FieldError> {
    let (radius, width, depth) =
        (known.figure("radius"), known.figure("width"), known.figure("depth"));
    let is_thick =
        |((radius, width), depth): ((f64, f64), f64)| width * width < 8.0 * radius * depth;
    let holds = radius.zip(width).zip(depth).is_none_or(is_thick);
    let detail = "must exceed the fall of the surface at its ends, `width`²/(8 `radius`)";
    unless(holds, "/depth", detail).into_iter().collect()
}

fn power_rules(known: &Known) -> Vec<FieldError> {
    let (Some(exponent), Some(scale)) = (known.figure("exponent"), known.figure("scale")) else {
        return Vec::new();
    };
    let Some((width, depth)) = known.figure("width").zip(known.figure("depth")) else {
        return Vec::new();
    };
    let fall = scale * (0.5 * width / scale).powf(exponent);
    let detail = format!(
        "must exceed the fall of the surface at its ends, `scale` (`width`/(2 \
         `scale`))^`exponent`: it is {} of that",
        five_digits(depth / fall)
    );
    unless(fall < depth, "/depth", &detail).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::fields::faults_of;

    #[test]
    fn surfaces_end_above_the_base() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let power = |exponent, scale, width, depth| {
            let (scale, width, depth) = (mm(scale), mm(width), mm(depth));
            faults_of(&Power { exponent, scale, width, depth }, &[]).is_empty()
        };
        assert!(power(1.2, 100.0, 20.0, 20.0) && power(10.0, 30.0, 20.0, 20.0));
        assert!(!power(1.0, 100.0, 20.0, 20.0) && !power(2.0, 1.0, 20.0, 20.0));
        let parabola = |depth| {
            let parabola = Parabola { radius: mm(20.0), width: mm(30.0), depth: mm(depth) };
            faults_of(&parabola, &[]).is_empty()
        };
        assert!(parabola(6.0) && !parabola(5.0));
    }
}
