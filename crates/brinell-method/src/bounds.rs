//! Bounds of the errors of figures by a system of half the density.

/// How the error of a figure goes with the size h of elements or cells over the half-width a of the
/// contact: `bound = |x(h) − x(2h)| + least (h/a)^order · scale`. The contact ends anywhere between
/// two nodes and errors scatter with its place, so that the difference is now and then far below
/// the error: the second term is for that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    least: f64,
    order: i32,
}

/// Of figures that hardly feel where the contact ends.
pub const SECOND_ORDER: Bound = Bound { least: 0.1, order: 2 };
/// Of figures that feel it.
pub const AT_ENDS: Bound = Bound { least: 0.5, order: 2 };
/// Of plastic strains, and of pressures on the axis of a circle.
pub const FIRST_ORDER: Bound = Bound { least: 0.1, order: 1 };
/// Of what single elements decide: the area of the points that have yielded, the largest strain, a
/// stress beside the axis of a circle.
pub const BY_ELEMENTS: Bound = Bound { least: 0.3, order: 1 };
/// Of plastic figures in plane stress, where flow gathers in bands of the width of an element.
pub const IN_BANDS: Bound = Bound { least: 1.0, order: 1 };

impl Bound {
    /// Returns the bound of an error from the difference between both systems. `size` is h/a.
    pub fn of(self, difference: f64, size: f64, scale: f64) -> f64 {
        difference.abs() + self.least * size.powi(self.order) * scale.abs()
    }
}
