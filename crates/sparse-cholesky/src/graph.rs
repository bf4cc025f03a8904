//! Adjacency of nodes.

#![expect(
    clippy::cast_possible_truncation,
    reason = "nodes are numbered by u32, so that there are fewer than 2^32 of them"
)]

/// An undirected graph in compressed form; a node is not its own neighbour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Graph {
    offsets: Vec<u32>,
    neighbours: Vec<u32>,
}

impl Graph {
    /// The graph in which the nodes of each cell are all joined to one another. Cost `O(cells)`.
    pub fn from_cells<const N: usize>(n_nodes: usize, cells: &[[u32; N]]) -> Self {
        let mut cells_of_node = vec![0u32; n_nodes + 1];
        for &node in cells.iter().flatten() {
            cells_of_node[node as usize + 1] += 1;
        }
        for k in 0..n_nodes {
            cells_of_node[k + 1] += cells_of_node[k];
        }
        let mut next = cells_of_node.clone();
        let mut incident = vec![0u32; N * cells.len()];
        for (cell, nodes) in (0u32..).zip(cells) {
            for &node in nodes {
                incident[next[node as usize] as usize] = cell;
                next[node as usize] += 1;
            }
        }
        let mut graph = Self { offsets: vec![0], neighbours: Vec::with_capacity(9 * n_nodes) };
        let mut seen_by = vec![u32::MAX; n_nodes];
        for (node, cells_here) in (0u32..).zip(cells_of_node.windows(2)) {
            seen_by[node as usize] = node;
            for &cell in &incident[cells_here[0] as usize..cells_here[1] as usize] {
                for &other in &cells[cell as usize] {
                    if seen_by[other as usize] != node {
                        seen_by[other as usize] = node;
                        graph.neighbours.push(other);
                    }
                }
            }
            graph.offsets.push(graph.neighbours.len() as u32);
        }
        graph
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Neighbours of a node, in no particular order.
    pub fn neighbours(&self, node: u32) -> &[u32] {
        let node = node as usize;
        &self.neighbours[self.offsets[node] as usize..self.offsets[node + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_quadrilaterals_share_an_edge() {
        let graph = Graph::from_cells(6, &[[0, 1, 4, 3], [1, 2, 5, 4]]);
        let sorted = |node| {
            let mut list = graph.neighbours(node).to_vec();
            list.sort_unstable();
            list
        };
        assert_eq!(graph.len(), 6);
        assert_eq!(sorted(0), [1, 3, 4]);
        assert_eq!(sorted(1), [0, 2, 3, 4, 5]);
        assert_eq!(sorted(5), [1, 2, 4]);
    }
}
