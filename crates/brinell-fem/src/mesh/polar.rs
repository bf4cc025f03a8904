//! The polar grid of a pin or of the body around a hole: columns along the rays about the centre
//! of the circle, rows along circles.
//!
//! Columns are even in the contact zone and grow geometrically from there to the far side. Rows
//! are as thick as columns are wide down to a depth, and then grow. Both bodies have their nodes
//! at the same arc lengths. One half is meshed: both ends of the grid lie on the axis of symmetry.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "the limits of a job keep node and equation counts far below 2^31"
)]

use std::f64::consts::{FRAC_PI_4, PI};

use super::outline::{FarBoundary, Ring};
use super::{ContactZone, Mesh, MeshError, Outline, ROUNDING, Refinement, SurfaceFrame};
use sparse_cholesky::LatticePoint;

/// Part of the radius down to which rows are as thick as columns are wide at most.
const EVEN_DEPTH: f64 = 0.3;
/// Thickness of a row over its radius at most, in units of what one ring grows by.
const LARGEST_ROW: f64 = 2.5;

pub(super) fn generate(
    outline: &Outline,
    ring: &Ring,
    zone: &ContactZone,
    refinement: Refinement,
) -> Result<Mesh, MeshError> {
    if !zone.fits(outline) {
        return Err(MeshError::ZoneBeyondBody {
            half_width: zone.x_max(),
            available: outline.span().1,
        });
    }
    let angles = ray_angles(ring, zone, refinement);
    let parts = row_parts(ring, zone, refinement);
    let far_angles = far_angles(ring, &angles);
    let sense = ring.radius.signum();
    let (rays, rows) = (angles.len(), parts.len());
    let node = |i: usize, j: usize| (i * rows + j) as u32;
    let mut mesh = Mesh {
        nodes: Vec::with_capacity(rays * rows),
        elements: Vec::with_capacity((rays - 1) * (rows - 1)),
        contact_nodes: (0..=zone.columns()).map(|i| node(i, 0)).collect(),
        contact_normals: Vec::with_capacity(zone.columns() + 1),
        free_surface_nodes: (0..rays).map(|i| node(i, 0)).collect(),
        support_nodes: (0..rays).map(|i| node(i, rows - 1)).collect(),
        axis_nodes: [0, rays - 1]
            .into_iter()
            .flat_map(|i| (0..rows).map(move |j| node(i, j)))
            .collect(),
        lattice: Vec::with_capacity(rays * rows),
        zone: zone.clone(),
        frame: SurfaceFrame::Circle { radius: ring.radius },
    };
    for (i, (&angle, &far)) in angles.iter().zip(&far_angles).enumerate() {
        let reach = (ring.far_distance(far) / ring.radius.abs()).ln();
        for (j, &part) in parts.iter().enumerate() {
            let distance = ring.radius.abs() * (part * reach).exp();
            let (sin, cos) = ((1.0 - part) * angle + part * far).sin_cos();
            let x = if i == 0 || i + 1 == rays { 0.0 } else { distance * sin };
            mesh.nodes.push([x, sense * distance * cos - ring.radius]);
            mesh.lattice.push(LatticePoint { patch: 0, i: i as i32, j: j as i32 });
            if i + 1 < rays && j + 1 < rows {
                mesh.elements.push([
                    node(i, j),
                    node(i, j + 1),
                    node(i + 1, j + 1),
                    node(i + 1, j),
                ]);
            }
        }
    }
    mesh.contact_normals.extend(zone.abscissae().iter().map(|s| {
        let (sin, cos) = (s / ring.common_radius).sin_cos();
        [sense * sin, cos]
    }));
    Ok(mesh)
}

/// Returns the number of nodes of [`generate`].
pub(super) fn estimated_nodes(ring: &Ring, zone: &ContactZone, refinement: Refinement) -> usize {
    ray_angles(ring, zone, refinement).len() * row_parts(ring, zone, refinement).len()
}

/// Angles of the rays from the middle of the contact to the far side.
fn ray_angles(ring: &Ring, zone: &ContactZone, refinement: Refinement) -> Vec<f64> {
    let radius = ring.radius.abs();
    let mut angles: Vec<f64> = zone.abscissae().iter().map(|s| s / radius).collect();
    let (start, mut width) = (zone.x_max() / radius, zone.spacing() / radius);
    let (mut ends, mut end) = (Vec::new(), 0.0);
    while end < (PI - start) * (1.0 - ROUNDING) {
        width *= refinement.growth;
        end += width;
        ends.push(end);
    }
    angles.extend(ends.iter().map(|part| start + part / end * (PI - start)));
    angles
}

/// Places of the rows between the surface, 0, and the far boundary, 1, even in the logarithm of
/// the radius.
fn row_parts(ring: &Ring, zone: &ContactZone, refinement: Refinement) -> Vec<f64> {
    let radius = ring.radius.abs();
    let whole = (ring.far_distance(0.0) / radius).ln();
    let (inward, spacing) = (whole < 0.0, zone.spacing());
    let even = zone.x_max().min(EVEN_DEPTH * radius.min((ring.far_distance(0.0) - radius).abs()));
    let (mut parts, mut depth, mut thickness) = (vec![0.0], 0.0, spacing);
    let mut part = 0.0;
    while part < 1.0 - ROUNDING {
        if depth >= even * (1.0 - ROUNDING) {
            thickness *= refinement.growth;
        }
        let here = radius * (part * whole).exp();
        let row = thickness.min(LARGEST_ROW * (refinement.growth - 1.0) * here);
        depth += row;
        let next = if inward { here / (1.0 + row / here) } else { here + row };
        part += (next / here).ln() / whole;
        parts.push(part);
    }
    for value in &mut parts {
        *value /= part;
    }
    parts
}

/// Angles at which the rays meet the far boundary: the corners of a square are nodes.
fn far_angles(ring: &Ring, angles: &[f64]) -> Vec<f64> {
    let mut far = angles.to_vec();
    if matches!(ring.far, FarBoundary::Square(_)) {
        for corner in [FRAC_PI_4, 3.0 * FRAC_PI_4] {
            let distance = |i: &usize| (angles[*i] - corner).abs();
            let nearest = (1..angles.len() - 1).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            if let Some(angle) = nearest.and_then(|i| far.get_mut(i)) {
                *angle = corner;
            }
        }
    }
    far
}
