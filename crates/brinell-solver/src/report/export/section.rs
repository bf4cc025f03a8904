//! The section through both bodies that other programs draw: half models are completed, and the bodies are put where
//! they are relative to each other.
//!
//! ```text
//! image of a half model:  x → -x,  u_x → -u_x,  τ_xy → -τ_xy,  corners in reverse order (still counter-clockwise)
//! upper body:             u_y → u_y - α, so that the support of the lower body is at rest
//! ```
//!
//! Nodes on the axis are shared by both halves. Of a body of revolution, x is the radius, and there is no image.

use super::ExportError;
use crate::job::{Analysis, Named};
use crate::report::{FieldsReport, Report};

/// Nodes and elements of the bodies that deform, the lower one first.
#[derive(Debug, Default)]
pub(super) struct Section {
    pub nodes: Vec<Node>,
    /// Corners, counter-clockwise.
    pub elements: Vec<[u32; 4]>,
    /// Body of each element.
    pub body: Vec<u8>,
}

/// Values at a node, `y` upward.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    pub position: [f64; 2],
    pub displacement: [f64; 2],
    /// `[σ_xx, σ_yy, σ_zz, τ_xy]`.
    pub stress: [f64; 4],
    pub von_mises: f64,
    pub equivalent_plastic_strain: f64,
}

/// What [`Section::body`] says of elements of the lower body.
pub(super) const LOWER: u8 = 0;
/// And of those of the upper one.
pub(super) const UPPER: u8 = 1;

impl Section {
    /// The section of a step, counted from 0.
    pub fn of(report: &Report, step: usize) -> Result<Self, ExportError> {
        let step = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
        let fields = step.fields.as_ref().ok_or(ExportError::NoFields)?;
        let is_half = report.mesh.symmetric && report.analysis != Analysis::Axisymmetric.name();
        let mut section = Self::default();
        for (body, fields, descent) in [(LOWER, &fields.lower, 0.0), (UPPER, &fields.upper, step.approach)] {
            let Some(fields) = fields else { continue };
            section.add(body, &nodes(fields, descent), &fields.elements, is_half);
        }
        Ok(section)
    }

    fn add(&mut self, body: u8, nodes: &[Node], elements: &[[u32; 4]], is_half: bool) {
        let mut next = index(self.nodes.len());
        let first = next;
        next += index(nodes.len());
        self.elements.extend(elements.iter().map(|corners| corners.map(|node| first + node)));
        self.nodes.extend(nodes);
        if is_half {
            let image_of: Vec<u32> = (first..)
                .zip(nodes)
                .map(|(node, values)| {
                    if values.position[0] == 0.0 {
                        return node;
                    }
                    next += 1;
                    next - 1
                })
                .collect();
            self.nodes.extend(nodes.iter().filter(|node| node.position[0] != 0.0).map(Node::image));
            self.elements.extend(elements.iter().map(|corners| {
                let [a, b, c, d] = corners.map(|node| image_of[node as usize]);
                [d, c, b, a]
            }));
        }
        self.body.resize(self.elements.len(), body);
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "meshes number their nodes by u32, and two bodies stay below too"
)]
fn index(n: usize) -> u32 {
    n as u32
}

fn nodes(fields: &FieldsReport, descent: f64) -> Vec<Node> {
    let node = |(k, position): (usize, &[f64; 2])| {
        let [u_x, u_y] = fields.displacement[k];
        Node {
            position: *position,
            displacement: [u_x, u_y - descent],
            stress: [fields.sigma_x[k], fields.sigma_y[k], fields.sigma_z[k], fields.tau_xy[k]],
            von_mises: fields.von_mises[k],
            equivalent_plastic_strain: fields.equivalent_plastic_strain[k],
        }
    };
    fields.nodes.iter().enumerate().map(node).collect()
}

impl Node {
    fn image(&self) -> Self {
        let ([x, y], [u_x, u_y], [s_x, s_y, s_z, t_xy]) = (self.position, self.displacement, self.stress);
        Self { position: [-x, y], displacement: [-u_x, u_y], stress: [s_x, s_y, s_z, -t_xy], ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit_square() -> Vec<Node> {
        let node = |position| Node {
            position,
            displacement: [0.5, -1.0],
            stress: [1.0, 2.0, 3.0, 4.0],
            von_mises: 5.0,
            equivalent_plastic_strain: 6.0,
        };
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(node).to_vec()
    }

    #[test]
    fn a_half_is_completed_by_its_image() {
        let mut section = Section::default();
        section.add(LOWER, &unit_square(), &[[0, 1, 2, 3]], true);
        section.add(UPPER, &unit_square(), &[[0, 1, 2, 3]], false);
        assert_eq!(section.nodes.len(), 6 + 4);
        assert_eq!(section.elements, [[0, 1, 2, 3], [3, 5, 4, 0], [6, 7, 8, 9]]);
        assert_eq!(section.body, [LOWER, LOWER, UPPER]);
        let image = section.nodes[4];
        assert_eq!((image.position, image.displacement), ([-1.0, 0.0], [-0.5, -1.0]));
        assert_eq!((image.stress, image.von_mises), ([1.0, 2.0, 3.0, -4.0], 5.0));
    }
}
