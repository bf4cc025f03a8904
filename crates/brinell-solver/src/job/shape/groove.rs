//! The concave circular trough.

use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

record! {
    /// A block with a concave circular trough across its whole upper face.
    #[derive(Copy)]
    pub struct Groove("groove", "Groove") where rules {
        /// Radius of the trough.
        pub radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(30.0),
        /// Full width, at most twice the radius.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(40.0),
        /// From the bottom of the trough to the base.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

/// Refuses a trough that does not reach from side to side, with `width > 2 R`.
fn rules(known: &Known) -> Vec<FieldError> {
    let (radius, width) = (known.figure("radius"), known.figure("width"));
    let spans = radius.zip(width).is_none_or(|(radius, width)| width <= 2.0 * radius);
    unless(spans, "/width", "must be at most twice `radius`").into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::fields::faults_of;

    #[test]
    fn spans_at_most_its_diameter() {
        let mm = |value| PositiveF64::new(value).unwrap();
        let faults =
            |width| faults_of(&Groove { radius: mm(10.0), width: mm(width), depth: mm(5.0) }, &[]);
        assert_eq!(faults(20.0), []);
        assert_eq!(faults(20.1), [FieldError::new("/width", "must be at most twice `radius`")]);
    }
}
