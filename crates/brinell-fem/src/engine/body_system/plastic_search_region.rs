//! The extent of plastic flow, and the plastic region of a body around it.

use std::f64::consts::PI;

use crate::mesh::Mesh;

/// Directions in which distances are known, from +x down and round to -x.
const DIRECTIONS: usize = 25;

/// The outline of a plastic zone: how far it reaches from the middle of the contact \[mm\], linear
/// in the angle between two directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RadialEnvelope {
    radius: [f64; DIRECTIONS],
}

impl RadialEnvelope {
    /// The outline of an elastic body.
    pub const NONE: Self = Self { radius: [0.0; DIRECTIONS] };

    /// An outline that holds points `[x, y]` around `[centre, 0]`.
    pub fn around(centre: f64, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let mut outline = Self::NONE;
        for [x, y] in points {
            let distance = (x - centre).hypot(y);
            let (k, _) = direction(x - centre, y);
            for radius in &mut outline.radius[k..=k + 1] {
                *radius = radius.max(distance);
            }
        }
        outline
    }

    /// An outline that holds this one and another around the same middle.
    pub fn joined(self, other: &Self) -> Self {
        Self { radius: std::array::from_fn(|k| self.radius[k].max(other.radius[k])) }
    }

    /// This outline with all distances scaled.
    pub fn scaled(self, factor: f64) -> Self {
        Self { radius: self.radius.map(|radius| factor * radius) }
    }

    fn contains(&self, x: f64, y: f64) -> bool {
        let (k, t) = direction(x, y);
        x.hypot(y) < (1.0 - t) * self.radius[k] + t * self.radius[k + 1]
    }
}

/// Index of the sampled direction at or before that of a point, and the fraction of the step to
/// the next one.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "between 0 and the number of directions"
)]
fn direction(x: f64, y: f64) -> (usize, f64) {
    let position = (-y).max(0.0).atan2(x) / PI * (DIRECTIONS - 1) as f64;
    let before = (position as usize).min(DIRECTIONS - 2);
    (before, position - before as f64)
}

/// The choice of the plastic region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PlasticSearchRegion {
    /// The elements within this outline, and a margin.
    Within(RadialEnvelope),
    /// The whole body.
    WholeBody,
}

/// Layers of elements around the expected plastic zone, as a margin for its growth.
const SPARE_LAYERS: usize = 3;

impl PlasticSearchRegion {
    /// The elements of a mesh that are in the plastic region.
    pub fn elements(&self, mesh: &Mesh) -> Vec<bool> {
        let Self::Within(outline) = self else { return vec![true; mesh.elements.len()] };
        let centre = mesh.zone.centre();
        let mut nodes: Vec<bool> =
            mesh.nodes.iter().map(|[x, y]| outline.contains(x - centre, *y)).collect();
        let mut inside = touched(mesh, &nodes);
        for _ in 0..SPARE_LAYERS {
            nodes = nodes_of(mesh, &inside);
            inside = touched(mesh, &nodes);
        }
        inside
    }
}

/// The elements with at least one of these nodes.
fn touched(mesh: &Mesh, nodes: &[bool]) -> Vec<bool> {
    mesh.elements.iter().map(|corners| corners.iter().any(|&node| nodes[node as usize])).collect()
}

/// The nodes of elements.
pub(crate) fn nodes_of(mesh: &Mesh, elements: &[bool]) -> Vec<bool> {
    let mut nodes = vec![false; mesh.nodes.len()];
    for (corners, _) in mesh.elements.iter().zip(elements).filter(|(_, inside)| **inside) {
        for &node in corners {
            nodes[node as usize] = true;
        }
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_contains_its_points_and_nothing_beyond_their_distance() {
        let points = [[1.3, -0.2], [0.9, -1.1], [-0.4, -0.7]];
        let outline = RadialEnvelope::around(0.5, points);
        let grown = outline.scaled(1.01);
        for [x, y] in points {
            assert!(grown.contains(x - 0.5, y));
            assert!(!grown.contains(1.1 * (x - 0.5), 1.1 * y));
        }
        assert!(!grown.contains(0.0, -2.0) && !grown.contains(-1.0, -1e-3));
        assert!(!RadialEnvelope::NONE.contains(1e-6, -1e-6));
    }
}
