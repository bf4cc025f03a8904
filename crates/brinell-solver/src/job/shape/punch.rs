//! The flat punch.

use crate::job::fields::{Field, Known, faults_of, record, unless};
use crate::job::{Domain, FieldError, NonNegativeF64, PositiveF64};

record! {
    /// A rigid flat punch with sharp or rounded edges.
    #[derive(Copy)]
    pub struct Punch("punch", "Flat punch") where rules {
        /// Full width with the edges, the diameter in axisymmetry.
        width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(10.0),
        /// Radius of the edges, less than half the width; sharp if it is 0 or left out.
        edge_radius: Option<NonNegativeF64> = Field::quantity(Domain::Depth).label("Edge radius", "ρ"),
        /// Height of the side walls, more than the edge radius.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(20.0),
    }
}

/// Refuses edge arcs that leave no flat between them or do not end on the side walls.
fn rules(known: &Known) -> Vec<FieldError> {
    let Some(radius) = known.figure("edge_radius") else { return Vec::new() };
    let is_flat = known.figure("width").is_none_or(|width| radius < 0.5 * width);
    let has_walls = known.figure("depth").is_none_or(|depth| radius < depth);
    let flat = unless(is_flat, "/edge_radius", "must be less than half the `width`");
    flat.into_iter()
        .chain(unless(has_walls, "/edge_radius", "must be less than `depth`"))
        .collect()
}

impl Punch {
    /// Builds the punch from the full width, the radius of the edges, 0 for sharp edges, and the
    /// height of the side walls \[mm\].
    ///
    /// # Errors
    /// Every fault, with a pointer relative to the shape.
    pub fn new(
        width: PositiveF64,
        edge_radius: NonNegativeF64,
        depth: PositiveF64,
    ) -> Result<Self, Vec<FieldError>> {
        let punch = Self { width, edge_radius: Some(edge_radius), depth };
        let faults = faults_of(&punch, &[]);
        if faults.is_empty() { Ok(punch) } else { Err(faults) }
    }

    /// Returns the full width, or the diameter in axisymmetry \[mm\].
    pub const fn width(&self) -> PositiveF64 {
        self.width
    }

    /// Returns the radius of the edges \[mm\]; 0 for sharp edges.
    pub fn edge_radius(&self) -> f64 {
        self.edge_radius.map_or(0.0, f64::from)
    }

    /// Returns the height of the side walls \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_punch_has_a_flat() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let faults = |width: f64, radius: f64, depth: f64| {
            let built = Punch::new(mm(width), NonNegativeF64::new(radius).unwrap(), mm(depth));
            built.map_or_else(|faults| faults.len(), |_| 0)
        };
        assert_eq!(faults(2.0, 0.0, 5.0) + faults(2.0, 0.9, 5.0), 0);
        assert_eq!(
            (faults(2.0, 1.0, 5.0), faults(20.0, 6.0, 5.0), faults(2.0, 6.0, 5.0)),
            (1, 1, 2)
        );
    }
}
