//! The flat punch.

use crate::job::fields::{Field, Known, record, unless};
use crate::job::{Domain, FieldError, NonNegativeF64, PositiveF64};

record! {
    /// A rigid flat punch with sharp or rounded edges.
    #[derive(Copy)]
    pub struct Punch("punch", "Flat punch") where rules {
        /// Full width with the edges, the diameter in axisymmetry.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(10.0),
        /// Radius of the edges, less than half the width; sharp if it is 0 or left out.
        pub edge_radius: Option<NonNegativeF64> = Field::quantity(Domain::Depth).label("Edge radius", "ρ"),
        /// Height of the side walls, more than the edge radius.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(20.0),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::fields::faults_of;

    #[test]
    fn a_punch_has_a_flat() {
        let mm = |value: f64| PositiveF64::new(value).unwrap();
        let faults = |width: f64, radius: f64, depth: f64| {
            let edge_radius = NonNegativeF64::new(radius).ok();
            faults_of(&Punch { width: mm(width), edge_radius, depth: mm(depth) }, &[]).len()
        };
        assert_eq!(faults(2.0, 0.0, 5.0) + faults(2.0, 0.9, 5.0), 0);
        assert_eq!(
            (faults(2.0, 1.0, 5.0), faults(20.0, 6.0, 5.0), faults(2.0, 6.0, 5.0)),
            (1, 1, 2)
        );
    }
}
