//! A hardening curve given by points.

use std::sync::Arc;

use super::Curve;
use crate::job::fields::{Field, FieldValue, Member, NumberKind, record};
use crate::job::reader::Cursor;
use crate::job::{Domain, FieldError, Units};
use crate::material::{HardeningLaw, hardening};

record! {
    /// A measured curve.
    pub struct Table("table", "Table") {
        /// Points `[plastic_strain, stress]`, joined by straight lines, constant beyond the last.
        pub points: TablePoints = Field::points(
            [
                ("Plastic strain, rising; the first is 0.", NumberKind::Pure(0.0..=100.0)),
                ("Stress, never falling.", NumberKind::Quantity(Domain::Stress)),
            ],
            1..=TablePoints::MAX_POINTS,
        )
        .label("Points", "ε_p, q")
        .example_points(&[[0.0, 500.0], [0.01, 600.0], [0.05, 750.0]]),
    }
}

impl Curve for Table {
    fn law(&self, _: f64) -> Arc<dyn HardeningLaw> {
        Arc::new(hardening::PolyLine { points: self.points.as_slice().to_vec() })
    }
}

/// Points `[plastic_strain, stress]` of a hardening curve.
///
/// Invariants: one to [`MAX_POINTS`](Self::MAX_POINTS) finite points, the first at zero plastic
/// strain, plastic strain strictly increasing, stress \[MPa\] positive and not falling.
#[derive(Debug, Clone, PartialEq)]
pub struct TablePoints(Vec<[f64; 2]>);

impl TablePoints {
    /// Most points of a curve.
    pub const MAX_POINTS: usize = 10_000;

    /// Builds the list from points that form a hardening curve.
    ///
    /// # Errors
    /// Every fault, with a pointer relative to the list of points, e.g. `/3/1`.
    pub fn new(points: Vec<[f64; 2]>) -> Result<Self, Vec<FieldError>> {
        let faults = faults(&points);
        if faults.is_empty() { Ok(Self(points)) } else { Err(faults) }
    }

    /// Returns the points `[plastic_strain, stress]`, stress in MPa; at least one.
    pub fn as_slice(&self) -> &[[f64; 2]] {
        &self.0
    }
}

impl Member for TablePoints {
    fn read(cursor: Cursor<'_>, field: &Field, units: Option<Units>) -> Option<Self> {
        cursor.checked(Self::new(Vec::read(cursor, field, units)?))
    }

    fn value(&self) -> Option<FieldValue> {
        self.0.value()
    }
}

fn faults(points: &[[f64; 2]]) -> Vec<FieldError> {
    if !(1..=TablePoints::MAX_POINTS).contains(&points.len()) {
        let detail = format!("must have between 1 and {} points", TablePoints::MAX_POINTS);
        return vec![FieldError::new("", detail)];
    }
    let mut faults = Vec::new();
    let mut fault = |index: usize, axis: usize, detail: &str| {
        faults.push(FieldError::new(format!("/{index}/{axis}"), detail));
    };
    let mut previous: Option<[f64; 2]> = None;
    for (index, &[strain, stress]) in points.iter().enumerate() {
        match previous {
            _ if !strain.is_finite() => fault(index, 0, "must be finite"),
            None if strain != 0.0 => {
                fault(
                    index,
                    0,
                    "must be 0: the first point of the curve is where yielding starts",
                );
            }
            Some([before, _]) if strain <= before => {
                fault(index, 0, "must be greater than the plastic strain of the point before");
            }
            _ => {}
        }
        match previous {
            _ if !(stress.is_finite() && stress > 0.0) => {
                fault(index, 1, "must be finite and greater than 0");
            }
            Some([_, before]) if stress < before => {
                fault(
                    index,
                    1,
                    "must be at least the stress of the point before: softening is not covered",
                );
            }
            _ => {}
        }
        previous = Some([strain, stress]);
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pointers(points: &[[f64; 2]]) -> Vec<String> {
        let built = TablePoints::new(points.to_vec());
        built.map_or_else(
            |faults| faults.into_iter().map(|fault| fault.pointer).collect(),
            |_| Vec::new(),
        )
    }

    #[test]
    fn accepts_curves() {
        assert!(pointers(&[[0.0, 250.0]]).is_empty(), "one point is perfectly plastic");
        assert!(pointers(&[[0.0, 250.0], [0.01, 300.0], [0.1, 300.0]]).is_empty());
    }

    #[test]
    fn refuses_what_is_no_curve() {
        assert_eq!(pointers(&[]), [""]);
        assert_eq!(pointers(&vec![[0.0, 1.0]; TablePoints::MAX_POINTS + 1]), [""]);
        assert_eq!(pointers(&[[0.1, 250.0]]), ["/0/0"]);
        assert_eq!(pointers(&[[0.0, 250.0], [0.0, 240.0], [0.2, 0.0]]), ["/1/0", "/1/1", "/2/1"]);
        assert_eq!(pointers(&[[0.0, f64::INFINITY], [f64::NAN, 1.0]]), ["/0/1", "/1/0", "/1/1"]);
    }
}
