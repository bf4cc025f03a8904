//! A face given by points.

use super::reader::{Cursor, Object};
use super::shape::length;
use super::{FieldError, PositiveF64, Quantity, Units};

/// A block whose upper face passes through points and is interpolated between them without overshoot.
///
/// Invariants: two to [`MAX_POINTS`](Self::MAX_POINTS) finite points, x strictly increasing, from `x <= 0` to
/// `x >= 0` so that the face exists where the contact starts, and every height above `-depth`, so that the body
/// has thickness everywhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    points: Vec<[f64; 2]>,
    depth: PositiveF64,
}

impl Profile {
    /// Most points of a profile.
    pub const MAX_POINTS: usize = 10_000;

    /// Takes `[x, height]` points and the depth from height 0 to the base \[mm\].
    ///
    /// # Errors
    /// Every fault, with a pointer relative to the shape, e.g. `/points/3/0`.
    pub fn new(points: Vec<[f64; 2]>, depth: PositiveF64) -> Result<Self, Vec<FieldError>> {
        let mut faults = outline_faults(&points);
        faults.extend(thickness_faults(&points, depth));
        if faults.is_empty() { Ok(Self { points, depth }) } else { Err(faults) }
    }

    /// `[x, height]` \[mm\], x strictly increasing.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Depth from height 0 to the base \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
    }

    pub(super) fn read(object: &Object<'_>, units: Option<Units>) -> Option<Self> {
        object.only(&["type", "points", "depth"]);
        let position = |c: Cursor<'_>| c.quantity(Quantity::Position, units);
        let points = object
            .required("points", |c| c.array(2..=Self::MAX_POINTS, |item| item.pair(position, position)));
        let depth = length(object, "depth", units);
        match (points, depth) {
            (Some(points), Some(depth)) => object.checked(Self::new(points, depth)),
            (points, _) => {
                object.report(outline_faults(&points?));
                None
            }
        }
    }
}

fn outline_faults(points: &[[f64; 2]]) -> Vec<FieldError> {
    let mut faults = Vec::new();
    if !(2..=Profile::MAX_POINTS).contains(&points.len()) {
        let detail = format!("must have between 2 and {} points", Profile::MAX_POINTS);
        return vec![FieldError::new("/points", detail)];
    }
    for (index, point) in points.iter().enumerate() {
        for (axis, value) in point.iter().enumerate() {
            if !value.is_finite() {
                faults.push(FieldError::new(format!("/points/{index}/{axis}"), "must be finite"));
            }
        }
    }
    for (index, pair) in points.windows(2).enumerate() {
        if let [[left, _], [right, _]] = pair
            && right <= left
        {
            let pointer = format!("/points/{}/0", index + 1);
            faults.push(FieldError::new(pointer, "must be greater than the x of the point before"));
        }
    }
    let starts_behind = points.first().is_some_and(|[x, _]| *x > 0.0);
    let ends_before = points.last().is_some_and(|[x, _]| *x < 0.0);
    if starts_behind || ends_before {
        let detail = "must reach from x <= 0 to x >= 0, because the contact starts at x = 0";
        faults.push(FieldError::new("/points", detail));
    }
    faults
}

fn thickness_faults(points: &[[f64; 2]], depth: PositiveF64) -> impl Iterator<Item = FieldError> {
    points.iter().enumerate().filter(move |(_, [_, height])| *height <= -depth.get()).map(|(index, _)| {
        let pointer = format!("/points/{index}/1");
        FieldError::new(pointer, "must be above the base, which lies at -`depth`")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pointers(points: &[[f64; 2]]) -> Vec<String> {
        let built = Profile::new(points.to_vec(), PositiveF64::new(5.0).unwrap());
        built.map_or_else(|faults| faults.into_iter().map(|fault| fault.pointer).collect(), |_| Vec::new())
    }

    #[test]
    fn a_crown_is_a_profile() {
        assert!(pointers(&[[-3.0, -0.1], [0.0, 0.0], [3.0, -0.1]]).is_empty());
        assert!(pointers(&[[0.0, 0.0], [3.0, -0.1]]).is_empty(), "half a face is enough");
    }

    #[test]
    fn x_increases_and_spans_the_origin() {
        assert_eq!(pointers(&[[0.0, 0.0]]), ["/points"]);
        assert_eq!(pointers(&[[1.0, 0.0], [2.0, 0.0]]), ["/points"]);
        assert_eq!(
            pointers(&[[-1.0, 0.0], [0.0, 0.0], [0.0, 0.0], [-1.0, 0.0]])[..2],
            ["/points/2/0", "/points/3/0"]
        );
        assert_eq!(pointers(&[[0.0, f64::NAN], [1.0, 0.0]]), ["/points/0/1"]);
    }

    #[test]
    fn the_body_has_thickness() {
        assert_eq!(pointers(&[[-1.0, -5.0], [1.0, -4.9]]), ["/points/0/1"]);
    }
}
