//! The concave circular trough.

use crate::job::fields::{Field, Known, faults_of, record, unless};
use crate::job::{Domain, FieldError, PositiveF64};

record! {
    /// A block with a concave circular trough across its whole upper face.
    #[derive(Copy)]
    pub struct Groove("groove", "Groove") where rules {
        /// Radius of the trough.
        radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(30.0),
        /// Full width, at most twice the radius.
        width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(40.0),
        /// From the bottom of the trough to the base.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
    }
}

/// Refuses a trough that does not reach from side to side, with `width > 2 R`.
fn rules(known: &Known) -> Vec<FieldError> {
    let (radius, width) = (known.figure("radius"), known.figure("width"));
    let spans = radius.zip(width).is_none_or(|(radius, width)| width <= 2.0 * radius);
    unless(spans, "/width", "must be at most twice `radius`").into_iter().collect()
}

impl Groove {
    /// Builds the groove \[mm\] if a trough of this radius spans this width.
    ///
    /// # Errors
    /// The fault, with a pointer relative to the shape.
    pub fn new(
        radius: PositiveF64,
        width: PositiveF64,
        depth: PositiveF64,
    ) -> Result<Self, Vec<FieldError>> {
        let groove = Self { radius, width, depth };
        let faults = faults_of(&groove, &[]);
        if faults.is_empty() { Ok(groove) } else { Err(faults) }
    }

    /// Returns the radius of the trough \[mm\].
    pub const fn radius(&self) -> PositiveF64 {
        self.radius
    }

    /// Returns the full width \[mm\].
    pub const fn width(&self) -> PositiveF64 {
        self.width
    }

    /// Returns the depth from the bottom of the trough to the base \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_at_most_its_diameter() {
        let mm = |value| PositiveF64::new(value).unwrap();
        assert!(Groove::new(mm(10.0), mm(20.0), mm(5.0)).is_ok());
        let faults = Groove::new(mm(10.0), mm(20.1), mm(5.0)).unwrap_err();
        assert_eq!(faults, [FieldError::new("/width", "must be at most twice `radius`")]);
    }
}
