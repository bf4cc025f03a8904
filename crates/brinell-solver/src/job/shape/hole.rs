//! The hole around a pin.

use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

record! {
    /// A round hole in the middle of a disc or of a square plate, which holds a `cylinder` with
    /// clearance; in axisymmetry the spherical socket of a ball. Its outer edge is the support.
    /// Give `outer_radius` or `width`.
    #[derive(Copy)]
    pub struct Hole("hole", "Hole") where rules {
        /// Radius of the hole, larger than that of the cylinder in it.
        pub radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(20.1),
        /// Radius of the disc, larger than that of the hole.
        pub outer_radius: Option<PositiveF64> =
            Field::quantity(Domain::Length).label("Outer radius", "R_o").example(200.0),
        /// Width of the square plate, in place of `outer_radius`; only in plane analyses.
        pub width: Option<PositiveF64> = Field::quantity(Domain::Length).label("Width of a square plate", "w"),
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

impl Hole {
    /// Returns the least thickness of the body around the hole \[mm\].
    pub fn wall(&self) -> f64 {
        let square = self.width.map(|width| 0.5 * width.get());
        let edge = square.or(self.outer_radius.map(f64::from));
        edge.unwrap_or(f64::INFINITY) - self.radius.get()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::fields::faults_of;

    #[test]
    fn a_hole_has_one_outer_edge_around_it() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let hole = |outer_radius: Option<f64>, width: Option<f64>| Hole {
            radius: mm(10.0),
            outer_radius: outer_radius.map(mm),
            width: width.map(mm),
        };
        let pointers = |hole: Hole| {
            faults_of(&hole, &[]).into_iter().map(|fault| fault.pointer).collect::<Vec<_>>()
        };
        let plate = hole(None, Some(60.0));
        assert!(pointers(hole(Some(30.0), None)).is_empty() && pointers(plate).is_empty());
        assert!((plate.wall() - 20.0).abs() < 1e-12);
        assert_eq!(pointers(hole(Some(10.0), None)), ["/outer_radius"]);
        assert_eq!(pointers(hole(None, Some(20.0))), ["/width"]);
    }
}
