//! The grid of a layer: columns through the whole depth of a body that is thin compared with the
//! contact or with its own width.
//!
//! Rings about the middle of the contact would be flat in a layer and fold. The columns have the
//! width of the contact zone's columns there and grow geometrically to both ends of the body. Rows
//! are about as thick as these columns are wide, and grow below.

#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "the limits of a job keep node and equation counts far below 2^31"
)]

use super::{ContactZone, Mesh, MeshError, Outline, ROUNDING, Refinement, SurfaceFrame};
use sparse_cholesky::LatticePoint;

/// Depth over the half-width of the contact zone below which a body is a layer.
const THIN: f64 = 0.25;

/// Rows at least: stresses in a layer vary over its depth like a polynomial of low degree.
const LEAST_ROWS: usize = 4;

/// Least depth of the ends of a layer over the depth of its middle; shallower layers end in
/// wedges.
const LEAST_WALL: f64 = 0.05;

/// Depth over the width of a body up to which rings may fold below a contact of any size.
const FLAT: f64 = 0.1;

/// Whether a body is thin compared with the contact.
pub(super) fn is_layer(outline: &Outline, zone: &ContactZone) -> bool {
    thickness(outline, zone) < THIN * zone.half_width() && has_walls(outline)
}

/// Whether a body is thin compared with its own width.
pub(super) fn is_flat(outline: &Outline) -> bool {
    let (left, right) = outline.span();
    outline.depth() < FLAT * (right - left) && has_walls(outline)
}

/// Whether the ends of a body are walls, not wedges, so that columns can replace folded rings.
pub(super) fn has_walls(outline: &Outline) -> bool {
    let depth = outline.depth();
    [1.0, -1.0].into_iter().all(|sign| outline.end(sign)[1] + depth > LEAST_WALL * depth)
}

/// Depth below the lowest place of the contact zone \[mm\].
fn thickness(outline: &Outline, zone: &ContactZone) -> f64 {
    let lowest = zone.abscissae().iter().map(|&x| outline.height(x)).fold(f64::INFINITY, f64::min);
    outline.depth() + lowest
}

/// Depths of the rows as parts of the whole, from 0 to 1.
fn rows(outline: &Outline, zone: &ContactZone, refinement: Refinement) -> Vec<f64> {
    let (depth, spacing) = (thickness(outline, zone), zone.spacing());
    let count = |depth: f64| ((depth / spacing).round() as usize).max(LEAST_ROWS);
    let even = count(zone.half_width());
    if count(depth) <= even {
        return zone.row_depths(count(depth));
    }
    let (mut end, mut row) = (spacing * even as f64, spacing);
    let mut depths: Vec<f64> = zone.row_depths(even).into_iter().map(|part| part * end).collect();
    while end < depth * (1.0 - ROUNDING) {
        row *= refinement.growth;
        end += row;
        depths.push(end);
    }
    depths.iter().map(|depth| depth / end).collect()
}

/// Distances of the columns beyond the zone from its end, up to `room`.
fn columns_beyond(room: f64, zone: &ContactZone, refinement: Refinement) -> Vec<f64> {
    let (mut ends, mut end, mut width) = (Vec::new(), 0.0, zone.spacing());
    while end < room * (1.0 - ROUNDING) {
        width *= refinement.growth;
        end += width;
        ends.push(end);
    }
    // Compressed so that the last one ends on the wall.
    ends.iter().map(|place| place / end * room).collect()
}

/// Abscissae of all columns in order, and how many of them lie on the left of the zone.
fn columns(outline: &Outline, zone: &ContactZone, refinement: Refinement) -> (Vec<f64>, usize) {
    let (left_end, right_end) = outline.span();
    let beyond = |room: f64| columns_beyond(room, zone, refinement);
    let left = if zone.is_symmetric() { Vec::new() } else { beyond(zone.x_min() - left_end) };
    let right = beyond(right_end - zone.x_max());
    let mut abscissae: Vec<f64> =
        left.iter().rev().map(|distance| zone.x_min() - distance).collect();
    abscissae.extend(zone.abscissae());
    abscissae.extend(right.iter().map(|distance| zone.x_max() + distance));
    (abscissae, left.len())
}

/// Returns the number of nodes of [`generate`].
pub(super) fn estimated_nodes(
    outline: &Outline,
    zone: &ContactZone,
    refinement: Refinement,
) -> usize {
    columns(outline, zone, refinement).0.len() * rows(outline, zone, refinement).len()
}

pub(super) fn generate(
    outline: &Outline,
    zone: &ContactZone,
    refinement: Refinement,
) -> Result<Mesh, MeshError> {
    if !zone.fits(outline) {
        let half_width = zone.x_max().max(-zone.x_min());
        return Err(MeshError::ZoneBeyondBody {
            half_width,
            available: ContactZone::available(outline),
        });
    }
    let (abscissae, left) = columns(outline, zone, refinement);
    let parts = rows(outline, zone, refinement);
    let (columns, rows) = (abscissae.len(), parts.len());
    let node = |i: usize, j: usize| (i * rows + j) as u32;
    let axis = if zone.is_symmetric() { rows } else { 0 };
    let mut mesh = Mesh {
        nodes: Vec::with_capacity(columns * rows),
        elements: Vec::with_capacity((columns - 1) * (rows - 1)),
        contact_nodes: (left..=left + zone.columns()).map(|i| node(i, 0)).collect(),
        contact_normals: Vec::new(),
        free_surface_nodes: (0..columns).map(|i| node(i, 0)).collect(),
        support_nodes: (0..columns).map(|i| node(i, rows - 1)).collect(),
        axis_nodes: (0..axis).map(|j| node(0, j)).collect(),
        lattice: Vec::with_capacity(columns * rows),
        zone: zone.clone(),
        frame: SurfaceFrame::Tangent,
    };
    for (i, &x) in abscissae.iter().enumerate() {
        let top = outline.height(x);
        for (j, part) in parts.iter().enumerate() {
            mesh.nodes.push([x, (1.0 - part) * top - part * outline.depth()]);
            mesh.lattice.push(LatticePoint { patch: 0, i: i as i32 - left as i32, j: j as i32 });
            if i + 1 < columns && j + 1 < rows {
                mesh.elements.push([
                    node(i, j),
                    node(i, j + 1),
                    node(i + 1, j + 1),
                    node(i + 1, j),
                ]);
            }
        }
    }
    Ok(mesh)
}
