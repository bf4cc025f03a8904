//! The undeformed outline of a body, as the mesh generator and the gap function see it.

use std::f64::consts::FRAC_PI_2;

use super::corner::Corner;
use super::error::{MESHED_SLOPE, MeshError};
use super::interpolation::{MonotoneCubic, Polyline};
use super::rounding::ROUNDING;
use brinell_material::Depth;

/// Surface, width and depth of a body in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    surface: Surface,
    /// Least and greatest x on the contact surface \[mm\].
    span: (f64, f64),
    /// Depth of the far boundary below the origin \[mm\].
    depth: f64,
    /// What makes it a pin in a hole, or the body around one.
    ring: Option<Ring>,
}

/// A whole pin, or the body around a hole. Abscissae are arc lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Radius of the surface, negative for a hole \[mm\].
    pub(super) radius: f64,
    /// Geometric mean of the radii of pin and hole: an arc length over it is the angle of the
    /// common normal \[mm\].
    pub(super) common_radius: f64,
    /// Where the body is held.
    pub(super) far: FarBoundary,
}

/// The boundary on which a pin or the body around a hole is held, around the centre of the circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FarBoundary {
    /// A circle of this radius \[mm\].
    Circle(f64),
    /// A square of this half-width \[mm\].
    Square(f64),
}

impl Ring {
    /// Radius of the surface, negative for a hole \[mm\].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Geometric mean of the radii of pin and hole \[mm\].
    pub fn common_radius(&self) -> f64 {
        self.common_radius
    }

    /// Distance of the far boundary from the centre, at an angle from the middle of the contact
    /// \[mm\].
    pub(super) fn far_distance(&self, angle: f64) -> f64 {
        match self.far {
            FarBoundary::Circle(radius) => radius,
            FarBoundary::Square(half) => half / angle.cos().abs().max(angle.sin().abs()),
        }
    }
}

/// Largest angle of a contact zone to each side of the middle \[degrees\]; beyond it an approach
/// would hardly close gaps.
const MAX_ZONE_ANGLE: f64 = 87.0;
/// Radius of the rigid core of a pin over its own. The forces that hold the pin are spread over
/// its section, so that the core carries nothing.
const PIN_CORE: f64 = 0.05;

#[derive(Debug, Clone, PartialEq)]
enum Surface {
    /// Circular arc through the origin with curvature κ \[1/mm\]: convex positive, flat 0, concave
    /// negative.
    Arc { curvature: f64 },
    /// The upper half of an ellipse with these semi-axes along x and y \[mm\].
    Ellipse { semi_axes: [f64; 2] },
    /// `y = -L (|x|/L)^n`, with the length L \[mm\].
    Power { exponent: f64, scale: f64 },
    /// Two flanks that fall by `slope` from a tip, which is an arc of `tip_radius` \[mm\] or, at
    /// 0, a corner.
    Wedge { slope: f64, tip_radius: f64 },
    /// A flat whose edges are arcs of `edge_radius` \[mm\] or, at 0, corners; beyond `half_width`
    /// it drops to `-drop`.
    Punch { half_width: f64, edge_radius: f64, drop: f64 },
    /// Smooth, through points.
    Smooth(MonotoneCubic),
    /// Straight between points.
    Linear(Polyline),
}

/// Slope jump between two points beyond which a smooth curve through them is taken to imitate a
/// corner: 0.05, but for rounding, so that points given in other units have the same corners.
const CORNER: f64 = 0.05 * (1.0 + ROUNDING);
/// How much more a face turns at a point than at those beside for that to be a corner and not the
/// course of a curve.
const ALONE: f64 = 4.0;
/// Slope of a surface given by points beyond which a contact on it is not solved where it deforms:
/// with an angle of 56° vertical gaps say nothing, whatever a mesh can follow.
const CONTACT_SLOPE: f64 = 1.5;
/// Slope of a vertical drop.
const VERTICAL: f64 = 1e9;

/// The inner points of a line as corners, which a smooth curve through them rounds off.
fn bends(line: &Polyline, is_rounded: bool) -> impl Iterator<Item = Corner> {
    line.bends().map(move |[x, left, right]| Corner { x, slopes: [left, right], is_rounded })
}

/// The edges of a punch, beyond which its surface drops.
fn edges(half_width: f64, is_rounded: bool) -> [Corner; 2] {
    [(-half_width, [VERTICAL, 0.0]), (half_width, [0.0, -VERTICAL])].map(|(x, slopes)| Corner {
        x,
        slopes,
        is_rounded,
    })
}

impl Depth for Outline {
    fn depth_below(&self, position: [f64; 2]) -> f64 {
        self.foot(position).0
    }
}

impl Outline {
    /// A circular arc through the origin: curvature \[1/mm\], convex positive, 0 for a plane; half
    /// of its span and the depth below it \[mm\].
    pub fn arc(curvature: f64, half_span: f64, depth: f64) -> Self {
        Self::of_width(Surface::Arc { curvature }, 2.0 * half_span, depth)
    }

    /// The upper half of an ellipse: its semi-axes along x and y \[mm\].
    pub fn ellipse(semi_axes: [f64; 2]) -> Self {
        Self::of_width(Surface::Ellipse { semi_axes }, 2.0 * semi_axes[0], semi_axes[1])
    }

    /// `y = -L (|x|/L)^n` with the length L, on a width and above a depth \[mm\].
    pub fn power(exponent: f64, scale: f64, width: f64, depth: f64) -> Self {
        Self::of_width(Surface::Power { exponent, scale }, width, depth)
    }

    /// Two flanks that fall by `slope` from a tip, which is an arc of `tip_radius` or, at 0, a
    /// corner; width and depth \[mm\].
    pub fn wedge(slope: f64, tip_radius: f64, width: f64, depth: f64) -> Self {
        Self::of_width(Surface::Wedge { slope, tip_radius }, width, depth)
    }

    /// A rigid flat whose edges are arcs of `edge_radius` or, at 0, corners; beyond `half_width`
    /// it drops to `-depth` \[mm\].
    pub fn punch(half_width: f64, edge_radius: f64, depth: f64) -> Self {
        let surface = Surface::Punch { half_width, edge_radius, drop: depth };
        // Nothing of a rigid body is meshed: its side walls and base bound no contact.
        Self { surface, span: (f64::NEG_INFINITY, f64::INFINITY), depth, ring: None }
    }

    /// Through points `[x, height]` in ascending order of x, smooth or straight between them;
    /// points from x = 0 to one side are completed by their mirror image. The depth is counted
    /// below the highest point \[mm\].
    pub fn through(points: &[[f64; 2]], is_smooth: bool, depth: f64) -> Self {
        // Heights count from the highest place, near which it touches, as those of other shapes
        // do.
        let top = points.iter().map(|[_, height]| *height).fold(f64::NEG_INFINITY, f64::max);
        let points = whole_face(points).into_iter().map(|[x, y]| [x, y - top]).collect();
        let line = Polyline::new(points);
        let span = line.range();
        let surface = if is_smooth {
            Surface::Smooth(MonotoneCubic::new(line.points().to_vec()))
        } else {
            Surface::Linear(line)
        };
        Self { surface, span, depth: depth + top, ring: None }
    }

    fn of_width(surface: Surface, width: f64, depth: f64) -> Self {
        Self { surface, span: (-0.5 * width, 0.5 * width), depth, ring: None }
    }

    /// A pin and its hole, which know of each other: their outlines, their radii, negative for the
    /// hole \[mm\], and where the body around the hole is held.
    #[must_use]
    pub fn as_pin_and_hole(
        mut outlines: [Self; 2],
        radii: [f64; 2],
        held: FarBoundary,
    ) -> [Self; 2] {
        let common_radius = (-radii[0] * radii[1]).sqrt();
        let reach = MAX_ZONE_ANGLE.to_radians() * common_radius;
        for (outline, radius) in outlines.iter_mut().zip(radii) {
            let far = if radius < 0.0 { held } else { FarBoundary::Circle(PIN_CORE * radius) };
            outline.span = (-reach, reach);
            outline.ring = Some(Ring { radius, common_radius, far });
        }
        outlines
    }

    /// What makes it a pin in a hole, or the body around one.
    pub fn ring(&self) -> Option<&Ring> {
        self.ring.as_ref()
    }

    /// Height of the surface over the tangent at the origin, along the outward normal \[mm\]; a
    /// convex surface falls below zero.
    pub fn height(&self, x: f64) -> f64 {
        match &self.surface {
            Surface::Arc { curvature } => arc_height(*curvature, x),
            Surface::Ellipse { semi_axes: [a, b] } => b / a * arc_height(a.recip(), x),
            Surface::Power { exponent, scale } => -scale * (x.abs() / scale).powf(*exponent),
            Surface::Wedge { slope, tip_radius } => {
                let sin = slope / slope.hypot(1.0);
                let tip = tip_radius * sin;
                if x.abs() < tip {
                    arc_height(tip_radius.recip(), x)
                } else {
                    // The flanks meet above the arc that rounds them off.
                    -slope * x.abs() + tip_radius * (slope.hypot(1.0) - 1.0)
                }
            }
            Surface::Punch { half_width, edge_radius, drop } => {
                let beyond_flat = x.abs() - (half_width - edge_radius);
                if x.abs() > *half_width {
                    -drop
                } else if beyond_flat > 0.0 && *edge_radius > 0.0 {
                    arc_height(edge_radius.recip(), beyond_flat)
                } else {
                    0.0
                }
            }
            Surface::Smooth(curve) => curve.value(x),
            Surface::Linear(line) => line.value(x),
        }
    }

    /// Curvature of the surface at the origin \[1/mm\], convex positive; `None` where the surface
    /// has none there, or only in a small part of it.
    pub fn curvature(&self) -> Option<f64> {
        match self.surface {
            Surface::Arc { curvature } => Some(curvature),
            Surface::Ellipse { semi_axes: [a, b] } => Some(b / (a * a)),
            Surface::Power { exponent, scale } => {
                ((exponent - 2.0).abs() < f64::EPSILON).then(|| 2.0 / scale)
            }
            _ => None,
        }
    }

    /// Whether the whole surface is a plane.
    pub fn is_flat(&self) -> bool {
        matches!(self.surface, Surface::Arc { curvature } if curvature == 0.0)
    }

    /// Whether the whole surface is one circular arc or a plane.
    pub fn is_arc(&self) -> bool {
        matches!(self.surface, Surface::Arc { .. })
    }

    /// Where a surface given by points is steepest, and its slope there `[x, slope]`.
    pub(super) fn steepest(&self) -> Option<[f64; 2]> {
        self.steepest_within(f64::NEG_INFINITY, f64::INFINITY)
    }

    /// The same of the straight lines between points that lie at least in part in `[left, right]`.
    fn steepest_within(&self, left: f64, right: f64) -> Option<[f64; 2]> {
        let line = match &self.surface {
            Surface::Smooth(curve) => curve.line(),
            Surface::Linear(line) => line,
            _ => return None,
        };
        let inside = line.points().windows(2).filter(|p| p[1][0] > left && p[0][0] < right);
        let slopes = inside.map(|p| [p[0][0], ((p[1][1] - p[0][1]) / (p[1][0] - p[0][0])).abs()]);
        slopes.max_by(|a, b| a[1].total_cmp(&b[1]))
    }

    /// Whether a surface given by points is flat enough in `[left, right]` for a contact there.
    ///
    /// # Errors
    /// [`MeshError::TooSteep`], whether or not there is a mesh that follows it.
    pub fn require_contact_slope(&self, left: f64, right: f64) -> Result<(), MeshError> {
        match self.steepest_within(left, right) {
            Some([x, slope]) if slope > CONTACT_SLOPE => Err(MeshError::TooSteep { x, slope }),
            _ => Ok(()),
        }
    }

    /// Whether a surface given by points is so steep somewhere that it may not be meshed.
    pub fn is_steep(&self) -> bool {
        self.steepest().is_some_and(|[_, slope]| slope > MESHED_SLOPE)
    }

    /// Places where the surface may not be as smooth as between them \[mm\], ascending: points of
    /// a profile, ends of arcs.
    pub fn knots(&self) -> Vec<f64> {
        match &self.surface {
            Surface::Arc { .. } | Surface::Ellipse { .. } => Vec::new(),
            Surface::Power { .. } => vec![0.0],
            Surface::Wedge { slope, tip_radius } => {
                let tip = tip_radius * slope / slope.hypot(1.0);
                vec![-tip, 0.0, tip]
            }
            Surface::Punch { half_width, edge_radius, .. } => {
                let flat = half_width - edge_radius;
                vec![-half_width, -flat, flat, *half_width]
            }
            Surface::Smooth(curve) => abscissae(curve.line()),
            Surface::Linear(line) => abscissae(line),
        }
    }

    /// Distance of the side walls of a punch from its middle \[mm\].
    pub fn wall(&self) -> Option<f64> {
        if let Surface::Punch { half_width, .. } = self.surface { Some(half_width) } else { None }
    }

    /// Radius of the edges of a punch, if they are rounded \[mm\].
    pub fn edge_radius(&self) -> Option<f64> {
        match self.surface {
            Surface::Punch { edge_radius, .. } if edge_radius > 0.0 => Some(edge_radius),
            _ => None,
        }
    }

    /// Half of the width of the arc that rounds off a tip, if one does \[mm\].
    pub fn tip_arc(&self) -> Option<f64> {
        match self.surface {
            Surface::Wedge { slope, tip_radius } if tip_radius > 0.0 => {
                Some(tip_radius * slope / slope.hypot(1.0))
            }
            _ => None,
        }
    }

    /// The exponent of a power below 2, whose curvature is infinite at the tip.
    pub fn pointed_exponent(&self) -> Option<f64> {
        match self.surface {
            Surface::Power { exponent, .. } if exponent < 2.0 => Some(exponent),
            _ => None,
        }
    }

    /// The rounded edges of a punch as corners, if their radius is smaller than a length: elements
    /// of it do not see the arcs.
    pub fn edges_rounded_below(&self, length: f64) -> Vec<Corner> {
        match self.surface {
            Surface::Punch { half_width, edge_radius, .. }
                if edge_radius > 0.0 && edge_radius < length =>
            {
                edges(half_width, true).to_vec()
            }
            _ => Vec::new(),
        }
    }

    /// Corners of the surface, ascending.
    pub fn corners(&self) -> Vec<Corner> {
        let corner =
            |x: f64, left: f64, right: f64| Corner { x, slopes: [left, right], is_rounded: false };
        match &self.surface {
            Surface::Wedge { slope, tip_radius } if *tip_radius == 0.0 => {
                vec![corner(0.0, *slope, -slope)]
            }
            Surface::Punch { half_width, edge_radius, .. } if *edge_radius == 0.0 => {
                edges(*half_width, false).to_vec()
            }
            Surface::Smooth(curve) => {
                let corners = bends(curve.line(), true);
                corners.filter(|corner| corner.opening().abs() > CORNER).collect()
            }
            Surface::Linear(line) => {
                bends(line, false).filter(|corner| corner.opening().abs() > 0.0).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Corners that a smooth curve through points may have rounded off: those that
    /// [`Outline::corners`] are, and points at which the face turns much more than at the points
    /// beside, however little that is.
    pub fn possible_corners(&self) -> Vec<Corner> {
        let Surface::Smooth(curve) = &self.surface else { return self.corners() };
        let bends: Vec<Corner> = bends(curve.line(), true).collect();
        let opening = |k: usize| bends.get(k).map_or(0.0, |corner| corner.opening().max(0.0));
        let is_possible = |(k, corner): &(usize, &Corner)| {
            let beside = opening(k.wrapping_sub(1)).max(opening(k + 1));
            corner.opening().abs() > CORNER || corner.opening() > ALONE * beside
        };
        bends.iter().enumerate().filter(is_possible).map(|(_, corner)| *corner).collect()
    }

    /// Largest distance over `[left, right]` between a smooth curve through points and the
    /// straight lines between them \[mm\]; 0 for any other surface.
    pub fn rounding(&self, left: f64, right: f64) -> f64 {
        let Surface::Smooth(curve) = &self.surface else { return 0.0 };
        let line = curve.line();
        let points = line.points();
        let first = points.partition_point(|[x, _]| *x <= left).saturating_sub(1);
        let end = points.partition_point(|[x, _]| *x < right) + 1;
        let between =
            points.get(first..end.min(points.len())).unwrap_or(&[]).windows(2).flat_map(|pair| {
                [0.25, 0.5, 0.75]
                    .map(|t| pair[0][0] + t * (pair[1][0] - pair[0][0]))
                    .map(|x| x.clamp(left, right))
            });
        between.map(|x| (curve.value(x) - line.value(x)).abs()).fold(0.0, f64::max)
    }

    /// Least and greatest x on the contact surface \[mm\].
    pub fn span(&self) -> (f64, f64) {
        self.span
    }

    /// Depth of the far boundary below the origin \[mm\].
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Distance from the surface as in [`Self::depth_below`], and the unit vector along its
    /// outward normal there.
    pub fn foot(&self, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
        match &self.surface {
            Surface::Arc { curvature } if *curvature == 0.0 => (-y, [0.0, 1.0]),
            Surface::Arc { curvature } => {
                // From the centre of the circle, which lies below a convex surface and above a
                // concave one.
                let radius = curvature.recip();
                let (dx, dy) = (x, y + radius);
                let distance = dx.hypot(dy).copysign(radius);
                let normal =
                    if distance == 0.0 { [0.0, 1.0] } else { [dx / distance, dy / distance] };
                (radius - distance, normal)
            }
            _ => self.foot_on_curve([x, y]),
        }
    }

    /// Foot on a surface of any form: the nearest of many points, then golden section between its
    /// neighbours.
    fn foot_on_curve(&self, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
        const SAMPLES: u32 = 32;
        // The foot to 1e-7 of the depth, and the depth to rounding.
        const SECTIONS: u32 = 30;
        let below = self.height(x) - y;
        let reach = below.abs();
        let (left, right) = ((x - reach).max(self.span.0), (x + reach).min(self.span.1));
        let square = |s: f64| {
            let (along, down) = (s - x, self.height(s) - y);
            along * along + down * down
        };
        let step = (right - left) / f64::from(SAMPLES);
        let samples = (0..=SAMPLES).map(|k| left + step * f64::from(k)).map(|s| (s, square(s)));
        let (nearest, _) =
            samples.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((x, below * below));
        let section = 0.5 * (5f64.sqrt() - 1.0);
        let (mut low, mut high) = ((nearest - step).max(left), (nearest + step).min(right));
        let inner =
            |low: f64, high: f64| (high - section * (high - low), low + section * (high - low));
        let (mut a, mut b) = inner(low, high);
        let (mut at_a, mut at_b) = (square(a), square(b));
        for _ in 0..SECTIONS {
            if at_a < at_b {
                (high, b, at_b) = (b, a, at_a);
                a = inner(low, high).0;
                at_a = square(a);
            } else {
                (low, a, at_a) = (a, b, at_b);
                b = inner(low, high).1;
                at_b = square(b);
            }
        }
        let foot = 0.5 * (low + high);
        let depth = square(foot).sqrt().min(reach).copysign(below);
        let normal = [foot - x, self.height(foot) - y].map(|component| component / depth);
        if normal.iter().all(|component| component.is_finite()) {
            (depth, normal)
        } else {
            (depth, [0.0, 1.0])
        }
    }

    /// Whether the outline equals its mirror image in x = 0.
    pub fn is_symmetric(&self) -> bool {
        match &self.surface {
            Surface::Smooth(curve) => curve.line().is_even(),
            Surface::Linear(line) => line.is_even(),
            _ => true,
        }
    }

    /// End of the surface on the side of `sign`.
    pub(super) fn end(&self, sign: f64) -> [f64; 2] {
        let x = if sign > 0.0 { self.span.1 } else { self.span.0 };
        [x, self.height(x)]
    }

    /// Point of the free surface at distance `radius` from `centre`, on the side of `sign`, by
    /// bisection along the surface; the distance must lie between those of the contact zone's edge
    /// and of the surface's end.
    pub(super) fn surface_point_at(&self, centre: [f64; 2], radius: f64, sign: f64) -> [f64; 2] {
        let end = self.end(sign)[0];
        let point = |t: f64| -> [f64; 2] {
            let x = match &self.surface {
                // Equal angles for equal steps of t, so that the end of a cylinder, where the
                // surface is parallel to y, is resolved as well as the bottom.
                Surface::Arc { curvature } if *curvature != 0.0 => {
                    (t * (curvature * end).clamp(-1.0, 1.0).asin()).sin() / curvature
                }
                Surface::Ellipse { .. } => end * (t * FRAC_PI_2).sin(),
                Surface::Arc { .. } => t * end,
                _ => centre[0] + t * (end - centre[0]),
            };
            [x, self.height(x)]
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let [x, y] = point(middle);
            let is_behind = (x - centre[0]) * sign < 0.0;
            if is_behind || (x - centre[0]).hypot(y - centre[1]) < radius {
                low = middle;
            } else {
                high = middle;
            }
        }
        point(0.5 * (low + high))
    }
}

/// Height of a circular arc `-R + √(R² - x²)`, written without cancellation for x << R.
fn arc_height(curvature: f64, x: f64) -> f64 {
    let slope = (curvature * x).clamp(-1.0, 1.0);
    -curvature * x * x / (1.0 + (1.0 - slope * slope).sqrt())
}

fn abscissae(line: &Polyline) -> Vec<f64> {
    line.points().iter().map(|[x, _]| *x).collect()
}

/// Points from end to end: a face given from x = 0 to one side is completed by its mirror image.
fn whole_face(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mirrored = |[x, y]: &[f64; 2]| [-x, *y];
    match points {
        [[0.0, _], right @ ..] => {
            right.iter().rev().map(mirrored).chain(points.iter().copied()).collect()
        }
        [left @ .., [0.0, _]] => {
            points.iter().copied().chain(left.iter().rev().map(mirrored)).collect()
        }
        _ => points.to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(points: &[[f64; 2]]) -> Outline {
        Outline::through(points, true, 10.0)
    }

    #[test]
    fn half_a_face_is_completed_by_its_mirror_image() {
        let right = outline(&[[0.0, 0.0], [1.0, -0.1], [4.0, -2.0]]);
        let left = outline(&[[-4.0, -2.0], [-1.0, -0.1], [0.0, 0.0]]);
        assert_eq!(right, left);
        assert!(right.is_symmetric());
        assert_eq!(right.span(), (-4.0, 4.0));
        assert!((right.height(-2.5) - right.height(2.5)).abs() < 1e-15);
        assert!(!outline(&[[-1.0, 0.0], [3.0, 0.0]]).is_symmetric());
    }

    #[test]
    fn depth_is_counted_along_the_normal() {
        for curvature in [0.05, 0.0, -0.05] {
            let arc = Outline::arc(curvature, 18.0, 20.0);
            for x in [-6.0, 0.0, 3.0] {
                for depth in [0.0, 0.3, 4.0] {
                    let slope = curvature * x;
                    let normal = [slope, (1.0 - slope * slope).sqrt()];
                    let point = [x - depth * normal[0], arc.height(x) - depth * normal[1]];
                    let (found, direction) = arc.foot(point);
                    assert!((found - depth).abs() < 1e-12, "{curvature} {x} {depth}: {found}");
                    assert!(normal.iter().zip(direction).all(|(a, b)| (a - b).abs() < 1e-12));
                }
            }
        }
        // The same arc through points.
        let arc = Outline::arc(0.05, 18.0, 20.0);
        let points: Vec<[f64; 2]> =
            (-400..=400).map(|k| 0.02 * f64::from(k)).map(|x| [x, arc.height(x)]).collect();
        let curve = outline(&points);
        for point in [[0.0, -0.4], [1.0, -0.1], [-3.0, -2.0], [0.5, -4.0]] {
            let ((a, n), (b, m)) = (arc.foot(point), curve.foot(point));
            assert!((a - b).abs() < 1e-6, "{point:?}: {a} {b}");
            assert!(n.iter().zip(m).all(|(n, m)| (n - m).abs() < 1e-3), "{point:?}: {n:?} {m:?}");
        }
        assert!(curve.foot([0.0, 0.0]).1[1] > 1.0 - 1e-12);
    }

    #[test]
    fn surface_points_lie_at_their_distance() {
        let arc = Outline::arc(0.05, 20.0, 20.0);
        for radius in [0.1, 3.0, 15.0, 28.0] {
            for sign in [-1.0, 1.0] {
                let [x, y] = arc.surface_point_at([0.0, 0.0], radius, sign);
                assert!((x.hypot(y) - radius).abs() < 1e-12 * radius.max(1.0) && x * sign > 0.0);
                assert!((y - arc.height(x)).abs() < 1e-12);
            }
        }
    }
}
