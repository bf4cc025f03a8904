//! Numbering of the unknown displacements.

#![expect(
    clippy::cast_possible_truncation,
    reason = "the limits of a job keep node and equation counts far below 2^31"
)]

use crate::mesh::Mesh;
use sparse_cholesky::{EliminationOrder, Graph, SymmetricPattern};

/// The support of the far boundary of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Support {
    /// Both components of its displacement are zero.
    Clamped,
    /// The component along the approach is zero.
    Roller,
}

/// The displacement components `[x, y]` of each node that are held at zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Restraint {
    held: Vec<[bool; 2]>,
}

impl From<Vec<[bool; 2]>> for Restraint {
    /// Holds the components of each node that are marked.
    fn from(held: Vec<[bool; 2]>) -> Self {
        Self { held }
    }
}

impl Restraint {
    /// Holds the support and, on a half model, the tangential component along the symmetry axis.
    ///
    /// A roller support of a full model leaves the body free to slide; its node nearest the middle
    /// is held tangentially, with a reaction of zero.
    pub fn new(mesh: &Mesh, support: Support) -> Self {
        let mut held = vec![[false; 2]; mesh.nodes.len()];
        for &node in &mesh.support_nodes {
            held[node as usize] = [support == Support::Clamped, true];
        }
        for &node in &mesh.axis_nodes {
            held[node as usize][0] = true;
        }
        if mesh.axis_nodes.is_empty() && support == Support::Roller {
            let offset = |node: &u32| mesh.nodes[*node as usize][0].abs();
            if let Some(&middle) =
                mesh.support_nodes.iter().min_by(|a, b| offset(a).total_cmp(&offset(b)))
            {
                held[middle as usize][0] = true;
            }
        }
        Self { held }
    }
}

/// Equation number of every free displacement component, in elimination order.
///
/// The components of the contact nodes along y come last, in order of x, and before them those
/// along x, so that the trailing block of the inverse stiffness gives the flexibility of the
/// contact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equations {
    /// `[x, y]` for each node; held components have the number one past the last equation.
    number: Vec<[u32; 2]>,
    /// Node and component of each equation.
    origin: Vec<(u32, u8)>,
}

impl Equations {
    /// Bytes held.
    pub fn bytes(&self) -> usize {
        size_of_val(self.number.as_slice()) + size_of_val(self.origin.as_slice())
    }

    /// Numbers the free components node by node in elimination order; the last `contact_count`
    /// nodes of the order are the contact nodes, whose normal components follow after all else.
    pub fn new(order: &EliminationOrder, restraint: &Restraint, contact_count: usize) -> Self {
        let nodes = order.nodes();
        let (body, contact) = nodes.split_at(nodes.len() - contact_count);
        let both = body.iter().flat_map(|&node| [(node, 0), (node, 1)]);
        let tangential = contact.iter().map(|&node| (node, 0));
        let normal = contact.iter().map(|&node| (node, 1));
        let is_free =
            |&(node, component): &(u32, u8)| !restraint.held[node as usize][component as usize];
        let origin: Vec<(u32, u8)> =
            both.chain(tangential).chain(normal).filter(is_free).collect();
        let held = origin.len() as u32;
        let mut number = vec![[held; 2]; nodes.len()];
        for (equation, &(node, component)) in (0u32..).zip(&origin) {
            number[node as usize][component as usize] = equation;
        }
        Self { number, origin }
    }

    /// Number of equations.
    pub fn len(&self) -> usize {
        self.origin.len()
    }

    /// Whether all components are held.
    pub fn is_empty(&self) -> bool {
        self.origin.is_empty()
    }

    /// Equation numbers `[x, y]` of a node; [`Self::len`] stands for a held component. Vectors
    /// that are addressed by these numbers have one entry more than there are equations, always
    /// zero.
    pub fn of_node(&self, node: u32) -> [u32; 2] {
        self.number[node as usize]
    }

    /// Node of an equation, and its component: 0 along x, 1 along y.
    pub fn origin(&self, equation: u32) -> (u32, u8) {
        self.origin[equation as usize]
    }

    /// Returns the equations of the nodes for which `wanted` is true, in ascending order.
    pub fn of_nodes(&self, wanted: &[bool]) -> Vec<u32> {
        (0u32..)
            .zip(&self.origin)
            .filter(|(_, (node, _))| wanted[*node as usize])
            .map(|(equation, _)| equation)
            .collect()
    }

    /// Sparsity of the stiffness matrix: two components are coupled if their nodes share an
    /// element.
    pub fn pattern(&self, graph: &Graph) -> SymmetricPattern {
        let held = self.len() as u32;
        let mut offsets = Vec::with_capacity(self.len() + 1);
        let mut rows = Vec::with_capacity(10 * self.len());
        offsets.push(0);
        for (equation, &(node, _)) in (0u32..).zip(&self.origin) {
            let start = rows.len();
            for &other in std::iter::once(&node).chain(graph.neighbours(node)) {
                for row in self.of_node(other) {
                    if (equation..held).contains(&row) {
                        rows.push(row);
                    }
                }
            }
            rows[start..].sort_unstable();
            offsets.push(rows.len() as u32);
        }
        SymmetricPattern::from_columns(offsets, rows)
    }
}
