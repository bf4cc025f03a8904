//! Measures of element quality.

use super::{Mesh, MeshError};

/// The worst figures over a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// Smallest ratio of the least to the greatest Jacobian determinant at the corners of one
    /// element; 1 for a parallelogram, 0 for a triangle, negative for a folded element.
    pub min_jacobian_ratio: f64,
    /// Largest ratio of the longest to the shortest side of one element.
    pub max_aspect_ratio: f64,
}

impl Quality {
    /// Measures a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let mut worst = Self { min_jacobian_ratio: 1.0, max_aspect_ratio: 1.0 };
        let mut worst_squared = 1.0;
        for element in 0..mesh.elements.len() {
            let corners = mesh.corners(element);
            let determinants = corner_determinants(&corners);
            let (low, high) = range(&determinants);
            worst.min_jacobian_ratio = worst.min_jacobian_ratio.min(low / high);
            let sides: [[f64; 2]; 4] = std::array::from_fn(|k| {
                let (p, q) = (corners[k], corners[(k + 1) % 4]);
                [q[0] - p[0], q[1] - p[1]]
            });
            // Roots of the few that matter.
            let (short, long) = range(&sides.map(|[x, y]| x * x + y * y));
            if long / short > worst_squared {
                worst_squared = long / short;
                let (short, long) = range(&sides.map(|[x, y]| x.hypot(y)));
                worst.max_aspect_ratio = worst.max_aspect_ratio.max(long / short);
            }
        }
        worst
    }
}

pub(super) fn require_positive_jacobians(mesh: &Mesh) -> Result<(), MeshError> {
    match (0..mesh.elements.len()).find(|&element| is_folded(mesh, element)) {
        Some(element) => Err(MeshError::Inverted { element }),
        None => Ok(()),
    }
}

/// Whether the Jacobian is not positive everywhere in an element.
pub(super) fn is_folded(mesh: &Mesh, element: usize) -> bool {
    !corner_determinants(&mesh.corners(element)).iter().all(|&d| d > 0.0)
}

/// Twice the signed areas of the triangles at the corners, in proportion to the Jacobian
/// determinants there. The determinant is linear over the element, so four positive corners mean a
/// positive determinant everywhere.
fn corner_determinants(corners: &[[f64; 2]; 4]) -> [f64; 4] {
    std::array::from_fn(|k| {
        let (previous, here, next) = (corners[(k + 3) % 4], corners[k], corners[(k + 1) % 4]);
        (next[0] - here[0]) * (previous[1] - here[1])
            - (next[1] - here[1]) * (previous[0] - here[0])
    })
}

fn range(values: &[f64]) -> (f64, f64) {
    values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)))
}
