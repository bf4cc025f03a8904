//! A mesh of quadrilaterals.

use super::frame::SurfaceFrame;
use super::zone::ContactZone;
use sparse_cholesky::LatticePoint;

/// A mesh of 4-node quadrilaterals with the boundary sets that mechanics needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Node coordinates `[x, y]` \[mm\].
    pub nodes: Vec<[f64; 2]>,
    /// Nodes of each element, counter-clockwise.
    pub elements: Vec<[u32; 4]>,
    /// Candidate contact nodes in order of x.
    pub contact_nodes: Vec<u32>,
    /// Outward unit vectors along the normals of the contact at these nodes; none where all of
    /// them are `[0, 1]`.
    pub contact_normals: Vec<[f64; 2]>,
    /// Nodes of the free surface, the contact zone included, in ascending order.
    pub free_surface_nodes: Vec<u32>,
    /// Nodes of the far boundary.
    pub support_nodes: Vec<u32>,
    /// Nodes on the symmetry axis `x = 0`; empty for a full model.
    pub axis_nodes: Vec<u32>,
    /// Place of each node in the structured patches, for the fill-reducing ordering.
    pub lattice: Vec<LatticePoint>,
    /// The contact zone the mesh was made for.
    pub zone: ContactZone,
    /// How places on and below the surface are described.
    pub frame: SurfaceFrame,
}

impl Mesh {
    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let node_lists =
            [&self.contact_nodes, &self.free_surface_nodes, &self.support_nodes, &self.axis_nodes];
        size_of_val(self.nodes.as_slice())
            + size_of_val(self.elements.as_slice())
            + size_of_val(self.lattice.as_slice())
            + size_of_val(self.contact_normals.as_slice())
            + node_lists.map(|list| size_of_val(list.as_slice())).iter().sum::<usize>()
    }

    /// Nodes of the grid line that runs from a contact node down to the support, through block and
    /// rings, in ascending order.
    pub fn grid_line_below(&self, contact_node: u32) -> Vec<u32> {
        let column = self.lattice[contact_node as usize].i;
        let block = || self.lattice.iter().filter(|p| p.patch == 0);
        let rows = block().map(|p| p.j).max().unwrap_or(0);
        let columns = block().map(|p| p.i).max().unwrap_or(0);
        // Rings are numbered from the right end of the zone, down the block's side and back along
        // its base.
        let ray = rows + columns - column;
        (0u32..)
            .zip(&self.lattice)
            .filter(|(_, p)| if p.patch == 0 { p.i == column } else { p.i == ray })
            .map(|(node, _)| node)
            .collect()
    }

    /// Coordinates of the four corners of an element \[mm\].
    pub fn corners(&self, element: usize) -> [[f64; 2]; 4] {
        self.elements[element].map(|node| self.nodes[node as usize])
    }
}
