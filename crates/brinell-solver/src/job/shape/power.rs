//! Surfaces that fall off with a power of the distance, and the ellipse.

use crate::job::fields::{Field, Known, faults_of, record, unless};
use crate::job::reader::text::five_digits;
use crate::job::{Domain, FieldError, PositiveF64};

record! {
    /// A block with the surface y = −x²/2R.
    #[derive(Copy)]
    pub struct Parabola("parabola", "Parabola") where parabola_rules {
        /// Radius of curvature at the vertex.
        radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(20.0),
        /// Full width.
        width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(30.0),
        /// From the vertex to the base, more than the fall of the surface at its ends.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

record! {
    /// A block with the surface y = −L (|x|/L)^n.
    #[derive(Copy)]
    pub struct Power("power", "Power law") where power_rules {
        /// Exponent n; 2 is a parabola, a large one nearly a flat punch.
        exponent: f64 = Field::pure(1.05..=50.0).label("Exponent", "n").example(4.0),
        /// Length L, the distance at which the surface has fallen by as much.
        scale: PositiveF64 = Field::quantity(Domain::Length).label("Scale", "L").example(30.0),
        /// Full width.
        width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(30.0),
        /// From the vertex to the base, more than the fall of the surface at its ends.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
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

impl Parabola {
    /// Builds the shape from the radius at the vertex, the full width, and the depth from the
    /// vertex to the base \[mm\].
    ///
    /// # Errors
    /// The fault, with a pointer relative to the shape.
    pub fn new(
        radius: PositiveF64,
        width: PositiveF64,
        depth: PositiveF64,
    ) -> Result<Self, Vec<FieldError>> {
        let parabola = Self { radius, width, depth };
        let faults = faults_of(&parabola, &[]);
        if faults.is_empty() { Ok(parabola) } else { Err(faults) }
    }

    /// Returns the radius at the vertex \[mm\].
    pub const fn radius(&self) -> PositiveF64 {
        self.radius
    }

    /// Returns the full width \[mm\].
    pub const fn width(&self) -> PositiveF64 {
        self.width
    }

    /// Returns the depth from the vertex to the base \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
    }
}

impl Power {
    /// Builds the shape from the exponent n, the length L at which the surface has fallen by L,
    /// the full width, and the depth from the vertex to the base \[mm\].
    ///
    /// # Errors
    /// Every fault, with a pointer relative to the shape.
    pub fn new(
        exponent: f64,
        scale: PositiveF64,
        width: PositiveF64,
        depth: PositiveF64,
    ) -> Result<Self, Vec<FieldError>> {
        let power = Self { exponent, scale, width, depth };
        let faults = faults_of(&power, &[]);
        if faults.is_empty() { Ok(power) } else { Err(faults) }
    }

    /// Returns the exponent n.
    pub const fn exponent(&self) -> f64 {
        self.exponent
    }

    /// Returns the length L at which the surface has fallen by L \[mm\].
    pub const fn scale(&self) -> PositiveF64 {
        self.scale
    }

    /// Returns the full width \[mm\].
    pub const fn width(&self) -> PositiveF64 {
        self.width
    }

    /// Returns the depth from the vertex to the base \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_end_above_the_base() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let power = |exponent: f64, scale: f64, width: f64, depth: f64| {
            Power::new(exponent, mm(scale), mm(width), mm(depth)).is_ok()
        };
        assert!(power(1.2, 100.0, 20.0, 20.0) && power(10.0, 30.0, 20.0, 20.0));
        assert!(!power(1.0, 100.0, 20.0, 20.0) && !power(2.0, 1.0, 20.0, 20.0));
        assert!(Parabola::new(mm(20.0), mm(30.0), mm(6.0)).is_ok());
        assert!(Parabola::new(mm(20.0), mm(30.0), mm(5.0)).is_err());
    }
}
