//! The hole around a pin.

use crate::job::fields::{Field, Known, faults_of, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

record! {
    /// A round hole in the middle of a disc or of a square plate, which holds a `cylinder` with
    /// clearance; in axisymmetry the spherical socket of a ball. Its outer edge is the support.
    /// Give `outer_radius` or `width`.
    #[derive(Copy)]
    pub struct Hole("hole", "Hole") where rules {
        /// Radius of the hole, larger than that of the cylinder in it.
        radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(20.1),
        /// Radius of the disc, larger than that of the hole.
        outer_radius: Option<PositiveF64> =
            Field::quantity(Domain::Length).label("Outer radius", "R_o").example(200.0),
        /// Width of the square plate, in place of `outer_radius`; only in plane analyses.
        width: Option<PositiveF64> = Field::quantity(Domain::Length).label("Width of a square plate", "w"),
    }
}

/// Refuses a body with no outer edge, with two, or with an outer edge inside the hole.
fn rules(known: &Known) -> Vec<FieldError> {
    let (radius, outer) = (known.figure("radius"), known.figure("outer_radius"));
    let width = known.figure("width");
    let is_one = outer.is_some() != width.is_some();
    let holds = |edge: Option<f64>| radius.zip(edge).is_none_or(|(radius, edge)| edge > radius);
    let faults = [
        unless(is_one, "/outer_radius", "give either `outer_radius` or `width`"),
        unless(holds(outer), "/outer_radius", "must be greater than `radius`"),
        unless(
            holds(width.map(|width| 0.5 * width)),
            "/width",
            "must be greater than twice the `radius`",
        ),
    ];
    faults.into_iter().flatten().collect()
}

/// The outer edge of the body around a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OuterEdge {
    /// A circle of this radius \[mm\].
    Circle(PositiveF64),
    /// A square of this width \[mm\].
    Square(PositiveF64),
}

impl Hole {
    /// Builds the hole from its radius \[mm\] and the outer edge, if the edge lies around the
    /// hole.
    ///
    /// # Errors
    /// The fault, with a pointer relative to the shape.
    pub fn new(radius: PositiveF64, edge: OuterEdge) -> Result<Self, Vec<FieldError>> {
        let (outer_radius, width) = match edge {
            OuterEdge::Circle(radius) => (Some(radius), None),
            OuterEdge::Square(width) => (None, Some(width)),
        };
        let hole = Self { radius, outer_radius, width };
        let faults = faults_of(&hole, &[]);
        if faults.is_empty() { Ok(hole) } else { Err(faults) }
    }

    /// Returns the radius of the hole \[mm\].
    pub const fn radius(&self) -> PositiveF64 {
        self.radius
    }

    /// Returns the outer edge, which is held.
    pub fn edge(&self) -> OuterEdge {
        match (self.outer_radius, self.width) {
            (_, Some(width)) => OuterEdge::Square(width),
            (Some(radius), None) => OuterEdge::Circle(radius),
            // The rules exclude a hole without an outer edge.
            (None, None) => OuterEdge::Circle(self.radius),
        }
    }

    /// Returns the least thickness of the body around the hole \[mm\].
    pub fn wall(&self) -> f64 {
        let edge = match self.edge() {
            OuterEdge::Circle(radius) => radius.get(),
            OuterEdge::Square(width) => 0.5 * width.get(),
        };
        edge - self.radius.get()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hole_has_one_outer_edge_around_it() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        assert!(Hole::new(mm(10.0), OuterEdge::Circle(mm(30.0))).is_ok());
        let plate = Hole::new(mm(10.0), OuterEdge::Square(mm(60.0))).unwrap();
        assert!((plate.wall() - 20.0).abs() < 1e-12);
        let pointer = |edge| Hole::new(mm(10.0), edge).unwrap_err().remove(0).pointer;
        assert_eq!(pointer(OuterEdge::Circle(mm(10.0))), "/outer_radius");
        assert_eq!(pointer(OuterEdge::Square(mm(20.0))), "/width");
    }
}
