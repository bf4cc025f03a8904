//! A face given by points.

use strum::{IntoStaticStr, VariantArray};

use crate::job::fields::{Field, Known, NumberKind, faults_of, record};
use crate::job::{Domain, FieldError, Named, PositiveF64};

record! {
    /// A block whose upper face passes through points, smooth or straight between them.
    pub struct Profile("profile", "Profile") where rules {
        /// Points `[x, height]`, x rising and passing 0. A face that starts or ends at x = 0 is
        /// completed by its mirror image.
        points: Vec<[f64; 2]> = Field::points(
            [
                ("x, tangential.", NumberKind::Quantity(Domain::Position)),
                ("Height.", NumberKind::Quantity(Domain::Position)),
            ],
            2..=Profile::MAX_POINTS,
        )
        .label("Points", "x, height")
        .example_points(&[[-10.0, -2.5], [-4.0, -0.4], [0.0, 0.0], [4.0, -0.4], [10.0, -2.5]]),
        /// From height 0 to the base; every height is above it.
        depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(50.0),
        /// What the face is like between its points: `smooth` to the first derivative, without
        /// overshoot, or `linear`, so that points are corners. If it is left out, the face is
        /// smooth, and refused where that would round off a corner in the contact.
        interpolation: Option<Interpolation> = Field::choice::<Interpolation>("Interpolation").label("Between points", ""),
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

    /// Takes `[x, height]` points and the depth from height 0 to the base \[mm\].
    ///
    /// # Errors
    /// Every fault, with a pointer relative to the shape, e.g. `/points/3/0`.
    pub fn new(points: Vec<[f64; 2]>, depth: PositiveF64) -> Result<Self, Vec<FieldError>> {
        let profile = Self { points, depth, interpolation: None };
        let faults = faults_of(&profile, &[]);
        if faults.is_empty() { Ok(profile) } else { Err(faults) }
    }

    /// Returns the profile with this interpolation between its points.
    #[must_use]
    pub fn interpolated(self, interpolation: Interpolation) -> Self {
        Self { interpolation: Some(interpolation), ..self }
    }

    /// Returns the greatest height of a point \[mm\].
    pub fn top(&self) -> f64 {
        self.points.iter().map(|[_, height]| *height).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Returns the interpolation between the points. `None` if the job leaves it out: the face is
    /// smooth, and refused if that would round off a corner in the contact.
    pub const fn interpolation(&self) -> Option<Interpolation> {
        self.interpolation
    }

    /// Returns the points `[x, height]` \[mm\], x strictly increasing.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Returns the depth from height 0 to the base \[mm\].
    pub const fn depth(&self) -> PositiveF64 {
        self.depth
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
            faults
                .push(FieldError::new(pointer, "must be greater than the x of the point before"));
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

/// Refuses points that do not form an outline, and points at or below the base.
fn rules(known: &Known) -> Vec<FieldError> {
    let Some(points) = known.points("points") else { return Vec::new() };
    let mut faults = outline_faults(points);
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

    fn pointers(points: &[[f64; 2]]) -> Vec<String> {
        let built = Profile::new(points.to_vec(), PositiveF64::new(5.0).unwrap());
        built.map_or_else(
            |faults| faults.into_iter().map(|fault| fault.pointer).collect(),
            |_| Vec::new(),
        )
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
