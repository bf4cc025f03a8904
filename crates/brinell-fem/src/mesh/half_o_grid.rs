//! The half-O-grid: a block of squares under the contact zone, wrapped in rings that reach the
//! outer boundary.
//!
//! Rings are interpolated transfinitely between the block's perimeter and the outer boundary, in
//! the plane of `(ln r, φ)` about the middle of the zone. That plane is a conformal image of the
//! body, so rings turn into arcs and rays stay normal to them, and a geometric growth of the ring
//! thickness is an even step there.
//!
//! Rings in a body that is much deeper than wide would be thin along its walls and fold at its
//! base. They end two widths below the surface, where the stress is even across the body, and rows
//! of elements as wide as it is go on to the support: the shaft.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "the limits of a job keep node and equation counts far below 2^31"
)]

use std::f64::consts::PI;

use super::{ContactZone, Mesh, MeshError, Outline, ROUNDING, SurfaceFrame};
use sparse_cholesky::LatticePoint;

/// How fine the rings are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refinement {
    /// Ratio of the thicknesses of neighbouring rings, above 1.
    pub growth: f64,
}

/// Largest part of the body's depth that the block may take.
const MAX_BLOCK_DEPTH: f64 = 0.5;

/// Where the ray from a lower corner of the block meets the base at least, on the way from below
/// the corner to the end of the base.
const CORNER_RAY: f64 = 0.3;

/// Depth over width from which a body has a shaft, and that of its rings then.
const SLENDER: f64 = 4.0;
const RINGS: f64 = 2.0;
/// Ratio of the thicknesses of neighbouring rows of the shaft, and that of the first one over the
/// width of the body.
const SHAFT_GROWTH: f64 = 1.5;
const SHAFT_ROW: f64 = 0.25;

/// A point in the plane of the interpolation: `(ln r, φ)` about the centre.
#[derive(Clone, Copy)]
struct Polar {
    log_radius: f64,
    angle: f64,
}

/// Makes a mesh. The deviation of the free surface from its chord fades along the rings with the
/// power `fade` of the distance from it.
pub(super) fn generate(
    outline: &Outline,
    zone: &ContactZone,
    refinement: Refinement,
    fade: i32,
) -> Result<Mesh, MeshError> {
    if !zone.fits(outline) {
        let half_width = zone.x_max().max(-zone.x_min());
        return Err(MeshError::ZoneBeyondBody {
            half_width,
            available: ContactZone::available(outline),
        });
    }
    let rows = block_rows(outline, zone);
    let mut grid = Builder::new(outline, zone, rows);
    grid.block();
    let base = grid.rings(refinement, fade);
    grid.shaft(base);
    Ok(grid.finish())
}

/// Depth at which the rings end: that of the body, unless it has a shaft.
fn ring_depth(outline: &Outline) -> f64 {
    let width = outline.span().1 - outline.span().0;
    let lowest = outline.end(1.0)[1].min(outline.end(-1.0)[1]);
    if outline.depth() + lowest > SLENDER * width {
        RINGS * width - lowest
    } else {
        outline.depth()
    }
}

/// Depths of the rows of the shaft, the last one that of the body; none without a shaft.
fn shaft_rows(outline: &Outline) -> Vec<f64> {
    let (begin, end) = (ring_depth(outline), outline.depth());
    let mut thickness = SHAFT_ROW * (outline.span().1 - outline.span().0);
    let (mut rows, mut depth) = (Vec::new(), begin);
    while depth < end * (1.0 - ROUNDING) {
        depth += thickness;
        thickness *= SHAFT_GROWTH;
        rows.push(depth);
    }
    // Compressed so that the last one ends on the support.
    let part = (end - begin) / (depth - begin);
    rows.iter().map(|row| begin + part * (row - begin)).collect()
}

/// Rows of the block: about as deep as one half of the zone is wide, but never more than a part of
/// the body.
fn block_rows(outline: &Outline, zone: &ContactZone) -> usize {
    let wanted = zone.half_width().min(MAX_BLOCK_DEPTH * ring_depth(outline));
    ((wanted / zone.spacing()).round() as usize).max(2)
}

/// About how many nodes [`generate`] will make.
pub(super) fn estimated_nodes(
    outline: &Outline,
    zone: &ContactZone,
    refinement: Refinement,
) -> usize {
    let rows = zone.row_depths(block_rows(outline, zone)).len() - 1;
    let sides = if zone.is_symmetric() { 1 } else { 2 };
    let columns = zone.columns();
    // Thickness h g, h g², …: the sum over k rings is about h g^(k+1) / (g - 1).
    let (growth, distance) = (refinement.growth, ring_depth(outline).max(outline.span().1));
    let rings = (1.0 + distance * (growth - 1.0) / zone.spacing()).ln() / growth.ln();
    let outer = (rings - ROUNDING).ceil().max(1.0) as usize + shaft_rows(outline).len();
    (columns + 1) * (rows + 1) + outer * (columns + sides * rows + 1)
}

struct Builder<'a> {
    outline: &'a Outline,
    zone: &'a ContactZone,
    /// Depths of the block's rows as a part of its own, from 0 to 1.
    depths: Vec<f64>,
    /// y of the block's base, negative.
    base: f64,
    /// Depth at which the rings end \[mm\].
    ring_depth: f64,
    mesh: Mesh,
}

impl<'a> Builder<'a> {
    fn new(outline: &'a Outline, zone: &'a ContactZone, rows: usize) -> Self {
        let lowest =
            zone.abscissae().iter().map(|&x| outline.height(x)).fold(f64::INFINITY, f64::min);
        let mesh = Mesh {
            nodes: Vec::new(),
            elements: Vec::new(),
            contact_nodes: Vec::new(),
            contact_normals: Vec::new(),
            free_surface_nodes: Vec::new(),
            support_nodes: Vec::new(),
            axis_nodes: Vec::new(),
            lattice: Vec::new(),
            zone: zone.clone(),
            frame: SurfaceFrame::Tangent,
        };
        let ring_depth = ring_depth(outline);
        let depth = (zone.spacing() * rows as f64).min(MAX_BLOCK_DEPTH * (ring_depth + lowest));
        let base = lowest - depth;
        Self { outline, zone, depths: zone.row_depths(rows), base, ring_depth, mesh }
    }

    /// The block, column by column from the surface down.
    fn block(&mut self) {
        for i in 0..=self.zone.columns() {
            let x = self.zone.abscissa(i);
            let top = self.outline.height(x);
            self.mesh.contact_nodes.push(self.block_node(i, 0));
            self.mesh.free_surface_nodes.push(self.block_node(i, 0));
            for (j, &t) in self.depths.iter().enumerate() {
                self.mesh.nodes.push([x, (1.0 - t) * top + t * self.base]);
                self.mesh.lattice.push(LatticePoint { patch: 0, i: i as i32, j: j as i32 });
                if i == 0 && self.zone.is_symmetric() {
                    self.mesh.axis_nodes.push(self.block_node(i, j));
                }
            }
        }
        for i in 0..self.zone.columns() {
            for j in 0..self.rows() {
                let [a, b] = [self.block_node(i, j), self.block_node(i, j + 1)];
                let [d, c] = [self.block_node(i + 1, j), self.block_node(i + 1, j + 1)];
                self.mesh.elements.push([a, b, c, d]);
            }
        }
    }

    fn rows(&self) -> usize {
        self.depths.len() - 1
    }

    fn block_node(&self, column: usize, row: usize) -> u32 {
        (column * self.depths.len() + row) as u32
    }

    /// Block nodes met going round from the right end of the zone, down, along the base and, in a
    /// full model, up to the left end.
    fn perimeter(&self) -> Vec<u32> {
        let right = (0..self.rows()).map(|j| self.block_node(self.zone.columns(), j));
        let base = (0..=self.zone.columns()).rev().map(|i| self.block_node(i, self.rows()));
        let left = (0..self.rows()).rev().map(|j| self.block_node(0, j));
        if self.zone.is_symmetric() {
            right.chain(base).collect()
        } else {
            right.chain(base).chain(left).collect()
        }
    }

    /// Points on the outer boundary that face the perimeter, and which of them are held.
    ///
    /// Each lies at nearly the angle about the centre at which its perimeter node lies, so that
    /// rays stay straight and rings cannot fold; angles are stretched as a whole where the free
    /// surface bends down, and the rays next to the corners of the body are turned into them.
    fn outer_boundary(&self, inner: &[Polar], centre: [f64; 2]) -> Vec<([f64; 2], bool)> {
        let mut angles = self.boundary_angles(inner, centre);
        let [right, left] = self.turn_into_corners(&mut angles, centre);
        let place = |(s, &angle): (usize, &f64)| {
            let point = if s == 0 {
                self.outline.end(1.0)
            } else if s + 1 == angles.len() && !self.zone.is_symmetric() {
                self.outline.end(-1.0)
            } else if s < right {
                self.on_wall(1.0, angle, centre)
            } else if s > left {
                self.on_wall(-1.0, angle, centre)
            } else if s == right && right > 0 {
                [self.outline.end(1.0)[0], -self.ring_depth]
            } else if s == left && left + 1 < angles.len() {
                [self.outline.end(-1.0)[0], -self.ring_depth]
            } else {
                [self.base_x(angle, centre), -self.ring_depth]
            };
            (point, (right..=left).contains(&s))
        };
        let mut points: Vec<_> = angles.iter().enumerate().map(place).collect();
        if let (true, Some(axis)) = (self.zone.is_symmetric(), points.last_mut()) {
            axis.0 = [0.0, -self.ring_depth];
        }
        points
    }

    /// Whether the body has a side between its surface and its base: at x > 0 for a sign of 1, at
    /// x < 0 for -1.
    fn has_wall(&self, sign: f64) -> bool {
        self.outline.end(sign)[1] + self.ring_depth > 1e-9 * self.ring_depth
    }

    /// Where a ray of an angle about the centre meets the base.
    fn base_x(&self, angle: f64, centre: [f64; 2]) -> f64 {
        centre[0] - (centre[1] + self.ring_depth) * angle.cos() / angle.sin()
    }

    /// Where a ray of an angle about the centre meets the side of a sign.
    fn on_wall(&self, sign: f64, angle: f64, centre: [f64; 2]) -> [f64; 2] {
        let x = self.outline.end(sign)[0];
        let (sin, cos) = angle.sin_cos();
        [x, centre[1] + (x - centre[0]) * sin / cos]
    }

    /// The angles about the centre of the points on the outer boundary, before some of them are
    /// turned into corners.
    fn boundary_angles(&self, inner: &[Polar], centre: [f64; 2]) -> Vec<f64> {
        let is_symmetric = self.zone.is_symmetric();
        let end = |sign: f64| self.outline.end(sign);
        let last = if is_symmetric { -0.5 * PI } else { angle_about(centre, end(-1.0)) };
        let ends = [(0, angle_about(centre, end(1.0))), (inner.len() - 1, last)];
        let angles = stretched(inner, &ends);
        // Rays from the sides of a block that nearly fills the body must not turn under it.
        let mut bends = Vec::new();
        for (corner, sign) in [(self.rows(), 1.0), (inner.len() - 1 - self.rows(), -1.0)] {
            if self.has_wall(sign) || (sign < 0.0 && is_symmetric) {
                continue;
            }
            let block = centre[0] + inner[corner].log_radius.exp() * inner[corner].angle.cos();
            let least = block + CORNER_RAY * (end(sign)[0] - block);
            if (self.base_x(angles[corner], centre) - least) * sign < 0.0 {
                bends.push((corner, angle_about(centre, [least, -self.ring_depth])));
            }
        }
        if bends.is_empty() {
            return angles;
        }
        let knots: Vec<_> = ends[..1].iter().chain(&bends).chain(&ends[1..]).copied().collect();
        stretched(inner, &knots)
    }

    /// Turns the nearest rays into the corners between sides and base; returns the places of the
    /// right and of the left one, the ends where there is no side.
    fn turn_into_corners(&self, angles: &mut [f64], centre: [f64; 2]) -> [usize; 2] {
        let last = angles.len() - 1;
        let mut turned = |sign: f64, without: usize| {
            let has_corner = self.has_wall(sign) && (sign > 0.0 || !self.zone.is_symmetric());
            let corner = angle_about(centre, [self.outline.end(sign)[0], -self.ring_depth]);
            if has_corner { turn_nearest(angles, corner) } else { without }
        };
        [turned(1.0, 0), turned(-1.0, last)]
    }

    /// The rings, from the block outward. Returned are the nodes of their base, with the rays on
    /// which they lie.
    fn rings(&mut self, refinement: Refinement, fade: i32) -> Vec<(usize, u32)> {
        let perimeter = self.perimeter();
        let centre = [self.zone.centre(), self.outline.height(self.zone.centre())];
        let polar = |p: [f64; 2]| Polar {
            log_radius: (p[0] - centre[0]).hypot(p[1] - centre[1]).ln(),
            angle: angle_about(centre, p),
        };
        let inner: Vec<Polar> =
            perimeter.iter().map(|&n| polar(self.mesh.nodes[n as usize])).collect();
        let outer = self.outer_boundary(&inner, centre);
        let outer_polar: Vec<Polar> = outer.iter().map(|&(p, _)| polar(p)).collect();
        let steps = ring_steps(&inner, &outer_polar, self.zone, refinement);
        let last = perimeter.len() - 1;

        let mut base = Vec::new();
        let mut previous = perimeter;
        for (k, &eta) in steps.iter().enumerate() {
            let is_outermost = k + 1 == steps.len();
            let sides = [
                self.side_correction(&inner, &outer_polar, 0, eta, centre),
                if self.zone.is_symmetric() {
                    0.0
                } else {
                    self.side_correction(&inner, &outer_polar, last, eta, centre)
                },
            ];
            let mut current = Vec::with_capacity(previous.len());
            for s in 0..=last {
                let node = self.mesh.nodes.len() as u32;
                let xi = s as f64 / last as f64;
                let log_radius =
                    (1.0 - eta) * inner[s].log_radius + eta * outer_polar[s].log_radius;
                let angle = (1.0 - eta) * inner[s].angle
                    + eta * outer_polar[s].angle
                    + (1.0 - xi).powi(fade) * sides[0]
                    + xi.powi(fade) * sides[1];
                let on_axis = self.zone.is_symmetric() && s == last;
                let position = if is_outermost {
                    outer[s].0
                } else if on_axis {
                    [0.0, centre[1] - log_radius.exp()]
                } else {
                    let (sin, cos) = angle.sin_cos();
                    [centre[0] + log_radius.exp() * cos, centre[1] + log_radius.exp() * sin]
                };
                self.mesh.nodes.push(position);
                self.mesh.lattice.push(LatticePoint { patch: 1, i: s as i32, j: k as i32 });
                if is_outermost && outer[s].1 {
                    base.push((s, node));
                }
                if on_axis {
                    self.mesh.axis_nodes.push(node);
                } else if s == 0 || s == last {
                    self.mesh.free_surface_nodes.push(node);
                }
                current.push(node);
            }
            for s in 0..last {
                self.mesh.elements.push([
                    previous[s],
                    previous[s + 1],
                    current[s + 1],
                    current[s],
                ]);
            }
            previous = current;
        }
        base
    }

    /// The rows below the rings, down to the support.
    fn shaft(&mut self, base: Vec<(usize, u32)>) {
        let mut previous = base;
        for (j, depth) in shaft_rows(self.outline).into_iter().enumerate() {
            let mut current = Vec::with_capacity(previous.len());
            for (s, above) in &previous {
                let node = self.mesh.nodes.len() as u32;
                self.mesh.nodes.push([self.mesh.nodes[*above as usize][0], -depth]);
                self.mesh.lattice.push(LatticePoint { patch: 2, i: *s as i32, j: j as i32 });
                current.push((*s, node));
            }
            if self.zone.is_symmetric() {
                self.mesh.axis_nodes.extend(current.last().map(|(_, node)| node));
            }
            for (above, below) in previous.windows(2).zip(current.windows(2)) {
                self.mesh.elements.push([above[0].1, above[1].1, below[1].1, below[0].1]);
            }
            previous = current;
        }
        self.mesh.support_nodes.extend(previous.iter().map(|(_, node)| node));
    }

    /// By how much the free surface at one end of the rings deviates in angle from the straight
    /// line between its two ends, at the ring of parameter `eta`.
    fn side_correction(
        &self,
        inner: &[Polar],
        outer: &[Polar],
        s: usize,
        eta: f64,
        centre: [f64; 2],
    ) -> f64 {
        let radius = ((1.0 - eta) * inner[s].log_radius + eta * outer[s].log_radius).exp();
        let sign = if s == 0 { 1.0 } else { -1.0 };
        let [x, y] = self.outline.surface_point_at(centre, radius, sign);
        angle_about(centre, [x, y]) - ((1.0 - eta) * inner[s].angle + eta * outer[s].angle)
    }

    fn finish(self) -> Mesh {
        self.mesh
    }
}

/// Angle of a point about a centre, from 0 (right) through -π/2 (below) to -π (left); a surface
/// that rises a little on the left goes on below -π instead of jumping to +π.
fn angle_about(centre: [f64; 2], point: [f64; 2]) -> f64 {
    let angle = (point[1] - centre[1]).atan2(point[0] - centre[0]);
    if angle > 0.5 * PI { angle - 2.0 * PI } else { angle }
}

/// The angles of the inner rays, stretched from knot to knot: at each, given by its index, the
/// angle is as given.
fn stretched(inner: &[Polar], knots: &[(usize, f64)]) -> Vec<f64> {
    let mut angles = vec![knots[0].1; inner.len()];
    for pair in knots.windows(2) {
        let ((from, start), (to, end)) = (pair[0], pair[1]);
        for s in from + 1..=to {
            let part =
                (inner[s].angle - inner[from].angle) / (inner[to].angle - inner[from].angle);
            angles[s] = start + part * (end - start);
        }
    }
    angles
}

/// Sets the inner angle nearest to `target` to it and returns its index; angles fall and stay in
/// order.
fn turn_nearest(angles: &mut [f64], target: f64) -> usize {
    let distance = |s: &usize| (angles[*s] - target).abs();
    let inner = 1..angles.len().saturating_sub(1);
    let nearest = inner.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
    // A target beyond the last inner ray leaves that ray on the near side of its neighbour.
    if let Some(angle) = angles.get_mut(nearest) {
        *angle = target;
    }
    nearest
}

/// Parameters `0 < η_1 < … < η_n = 1` of the rings: the first ring is about as thick as a block
/// element, each further one `growth` times thicker.
fn ring_steps(
    inner: &[Polar],
    outer: &[Polar],
    zone: &ContactZone,
    refinement: Refinement,
) -> Vec<f64> {
    let spacing = zone.spacing();
    // Of both sides of the axis, also where only one is meshed, so that half and full models have
    // the same rings.
    let mean = |curve: &[Polar]| {
        let sum: f64 = curve.iter().map(|p| p.log_radius).sum();
        match curve.last() {
            Some(axis) if zone.is_symmetric() => {
                (2.0 * sum - axis.log_radius) / (2 * curve.len() - 1) as f64
            }
            _ => sum / curve.len() as f64,
        }
    };
    let (first, last) = (mean(inner).exp(), mean(outer).exp());
    let growth = refinement.growth;
    let (mut radii, mut radius, mut thickness) = (Vec::new(), first, spacing);
    while radius < last * (1.0 - ROUNDING) {
        thickness *= growth;
        radius += thickness;
        radii.push(radius);
    }
    // Stretch the series a little so that it ends on the boundary instead of beyond it.
    let end = radii.last().copied().unwrap_or(last);
    let mut steps: Vec<f64> =
        radii.iter().map(|r| (r / first).ln() / (end / first).ln()).collect();
    if steps.is_empty() {
        steps.push(1.0);
    }
    if let Some(step) = steps.last_mut() {
        *step = 1.0;
    }
    steps
}
