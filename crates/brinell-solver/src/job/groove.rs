//! The concave circular trough.

use super::reader::Object;
use super::shape::length;
use super::{FieldError, PositiveF64, Units};

/// A block with a concave circular trough across its whole upper face.
///
/// Invariant: the trough of radius R reaches from side to side, `width <= 2 R`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groove {
    radius: PositiveF64,
    width: PositiveF64,
    depth: PositiveF64,
}

impl Groove {
    /// Takes the dimensions \[mm\] if a trough of this radius spans this width.
    ///
    /// # Errors
    /// The fault, with a pointer relative to the shape.
    pub fn new(radius: PositiveF64, width: PositiveF64, depth: PositiveF64) -> Result<Self, Vec<FieldError>> {
        match too_wide(radius, width) {
            Some(fault) => Err(vec![fault]),
            None => Ok(Self { radius, width, depth }),
        }
    }

    /// Radius of the trough \[mm\].
    pub const fn radius(&self) -> PositiveF64 {
        self.radius
    }

    /// Full width \[mm\].
    pub const fn width(&self) -> PositiveF64 {
        self.width
    }

    /// Depth from the bottom of the trough to the base \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
    }

    pub(super) fn read(object: &Object<'_>, units: Option<Units>) -> Option<Self> {
        object.only(&["type", "radius", "width", "depth"]);
        let radius = length(object, "radius", units);
        let width = length(object, "width", units);
        let depth = length(object, "depth", units);
        if depth.is_none() {
            object.report(radius.zip(width).and_then(|(radius, width)| too_wide(radius, width)));
        }
        object.checked(Self::new(radius?, width?, depth?))
    }
}

fn too_wide(radius: PositiveF64, width: PositiveF64) -> Option<FieldError> {
    (width.get() > 2.0 * radius.get()).then(|| FieldError::new("/width", "must be at most twice `radius`"))
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
