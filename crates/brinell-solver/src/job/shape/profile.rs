//! A face given by points.

use strum::{IntoStaticStr, VariantArray};

use crate::job::fields::{Field, Known, NumberKind, record, unless};
use crate::job::{Domain, FieldError, Named, PositiveF64};

record! {
    /// A block whose upper face passes through points, smooth or straight between them.
    pub struct Profile("profile", "Profile") where rules {
        /// Points `[x, height]`, x rising and passing 0. A face that starts or ends at x = 0 is
        /// completed by its mirror image.
        pub points: Vec<[f64; 2]> = Field::points(
            [
                ("x, tangential.", NumberKind::Quantity(Domain::Position)),
                ("Height.", NumberKind::Quantity(Domain::Position)),
            ],
            2..=Profile::MAX_POINTS,
        )
        .label("Points", "x, height")
        .example_points(&[[-10.0, -2.5], [-4.0, -0.4], [0.0, 0.0], [4.0, -0.4], [10.0, -2.5]]),
        /// From height 0 to the base; every height is above it.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
        /// What the face is like between its points: `smooth` to the first derivative, without
        /// overshoot, or `linear`, so that points are corners. If it is left out, the face is
        /// smooth, and refused where that would round off a corner in the contact.
        pub interpolation: Option<Interpolation> = Field::choice::<Interpolation>("Interpolation").label("Between points", ""),
    }
}

/// The shape of a profile between its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum Interpolation {
    /// Smooth to the first derivative, without overshoot.
    Smooth,
    /// Straight, so that points may be corners.
    Linear,
}

impl Named for Interpolation {}

impl Profile {
    /// Most points of a profile.
    pub const MAX_POINTS: usize = 10_000;

    /// Returns the greatest height of a point \[mm\].
    pub fn top(&self) -> f64 {
        self.points.iter().map(|[_, height]| *height).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Refuses points of an outline along an axis that do not rise, or do not pass its `middle`.
pub(super) fn outline_faults(points: &[[f64; 2]], axis: &str, middle: &str) -> Vec<FieldError> {
    let falls = |(index, pair): (usize, &[[f64; 2]])| {
        let detail = format!("must be greater than the {axis} of the point before");
        unless(pair[1][0] > pair[0][0], &format!("/points/{}/0", index + 1), &detail)
    };
    let mut faults: Vec<_> = points.windows(2).enumerate().filter_map(falls).collect();
    let passes = points.first().is_some_and(|[first, _]| *first <= 0.0)
        && points.last().is_some_and(|[last, _]| *last >= 0.0);
    let detail = format!("must reach from {axis} <= 0 to {axis} >= 0, {middle}");
    faults.extend(unless(passes, "/points", &detail));
    faults
}

/// Refuses points that do not form an outline, and points at or below the base.
fn rules(known: &Known) -> Vec<FieldError> {
    let Some(points) = known.points("points") else { return Vec::new() };
    let mut faults = outline_faults(points, "x", "because the contact starts at x = 0");
    let depth = known.figure("depth").unwrap_or(f64::INFINITY);
    let thin = points.iter().enumerate().filter(|(_, [_, height])| *height <= -depth);
    faults.extend(thin.map(|(index, _)| {
        let pointer = format!("/points/{index}/1");
        FieldError::new(pointer, "must be above the base, which lies at -`depth`")
    }));
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::fields::faults_of;

    fn pointers(points: &[[f64; 2]]) -> Vec<String> {
        let depth = PositiveF64::new(5.0).unwrap();
        let profile = Profile { points: points.to_vec(), depth, interpolation: None };
        faults_of(&profile, &[]).into_iter().map(|fault| fault.pointer).collect()
    }

    #[test]
    fn a_crown_is_a_profile() {
        assert!(pointers(&[[-3.0, -0.1], [0.0, 0.0], [3.0, -0.1]]).is_empty());
        assert!(pointers(&[[0.0, 0.0], [3.0, -0.1]]).is_empty(), "half a face is enough");
    }

    #[test]
    fn x_increases_and_spans_the_origin() {
        assert_eq!(pointers(&[[1.0, 0.0], [2.0, 0.0]]), ["/points"]);
        assert_eq!(
            pointers(&[[-1.0, 0.0], [0.0, 0.0], [0.0, 0.0], [-1.0, 0.0]])[..2],
            ["/points/2/0", "/points/3/0"]
        );
    }

    #[test]
    fn the_body_has_thickness() {
        assert_eq!(pointers(&[[-1.0, -5.0], [1.0, -4.9]]), ["/points/0/1"]);
    }
}
